// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "myoface/base/error.h"

#include "commands.h"

namespace {

enum ExitCode { kGood = 0, kBadInput = 1, kWrongUsage = 2, kInternal = 3 };

/// One line, whatever the message was.
void complain(std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::cerr << "myoface-cli: " << message << '\n';
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{
        "Myoface without a window. A planning and communication aid, not a medical device."};
    app.require_subcommand(1);
    app.set_version_flag("--version", MYOFACE_VERSION);
    try {
        myoface::cli::add_info(app);
        myoface::cli::add_landmarks(app);
        myoface::cli::add_measure(app);
        myoface::cli::add_compare(app);
        myoface::cli::add_generate(app);
        myoface::cli::add_fit(app);
        myoface::cli::add_simulate(app);
        myoface::cli::add_replay(app);
        myoface::cli::add_render(app);
        myoface::cli::add_report(app);
        myoface::cli::add_animate(app);
        myoface::cli::add_section(app);
        myoface::cli::add_convert(app);
        myoface::cli::add_bench(app);
        app.parse(argc, argv);
        return kGood;
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        complain(std::string(error.what()) +
                 (argc > 1 ? std::string(" (in: ") + argv[1] + ")" : "") + "; try --help.");
        return kWrongUsage;
    } catch (const myoface::Error& error) {
        complain(error.what());
        return kBadInput;
    } catch (const std::bad_alloc&) {
        complain("There is not enough memory for this.");
        return kBadInput;
    } catch (const std::exception& error) {
        complain(std::string("internal error: ") + error.what());
        return kInternal;
    }
}
