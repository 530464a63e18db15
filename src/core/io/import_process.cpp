// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "myoface/base/error.h"
#include "myoface/io/interchange.h"

#include "readers.h"

extern char** environ;  // NOLINT: as POSIX names it

namespace myoface {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto kPatience = std::chrono::seconds(60);
constexpr std::size_t kMostBytes = 4'000'000'000;

/// The helper program: named by MYOFACE_IMPORT, beside this program, or where it is installed.
fs::path helper() {
    if (const char* named = std::getenv("MYOFACE_IMPORT")) {
        return named;
    }
    std::error_code error;
    const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& tried :
         {here / "myoface-import", here / "../libexec/myoface/myoface-import",
          here / "../lib/myoface/myoface-import"}) {
        if (fs::is_regular_file(tried, error)) {
            return tried;
        }
    }
    return {};
}

struct Pipe {
    std::array<int, 2> end{-1, -1};
    Pipe() {
        if (::pipe2(end.data(), O_CLOEXEC) != 0) {
            throw IoError("No process can be started for the import (too many open files).");
        }
    }
    ~Pipe() {
        close_end(0);
        close_end(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_end(std::size_t i) {
        if (end[i] >= 0) {
            ::close(end[i]);
            end[i] = -1;
        }
    }
};

/// A started helper; killed and buried with this object at the latest.
class Child {
public:
    Child(const fs::path& program, const fs::path& file, const Pipe& out, const Pipe& err) {
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, out.end[1], STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, err.end[1], STDERR_FILENO);
        std::string first = program.string();
        std::string second = file.string();
        std::array<char*, 3> arguments{first.data(), second.data(), nullptr};
        const int failed =
            ::posix_spawn(&id_, program.c_str(), &actions, nullptr, arguments.data(), environ);
        posix_spawn_file_actions_destroy(&actions);
        if (failed != 0) {
            id_ = -1;
            throw IoError(file.string() + ": the import program " + program.string() +
                          " cannot be started.");
        }
    }
    ~Child() {
        if (id_ > 0) {
            ::kill(id_, SIGKILL);
            wait();
        }
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    int wait() {
        int status = 0;
        while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
        }
        id_ = -1;
        return status;
    }

private:
    pid_t id_ = -1;
};

/// One line of what the helper complained.
std::string sentence(const std::string& complaint) {
    const std::size_t end = complaint.find('\n');
    return complaint.substr(0, std::min<std::size_t>(end, 300));
}

}  // namespace

void read_gltf(const fs::path& file, Scan& scan, const Progress* progress) {
    const fs::path program = helper();
    if (program.empty()) {
        throw IoError(file.string() +
                      ": reading glTF needs the program myoface-import, which is not installed "
                      "beside this one.");
    }
    Pipe out;
    Pipe err;
    Child child(program, file, out, err);
    out.close_end(1);
    err.close_end(1);
    std::array<std::string, 2> got;
    const Clock::time_point start = Clock::now();
    std::vector<char> buffer(1 << 18);
    while (out.end[0] >= 0 || err.end[0] >= 0) {
        const auto spent = Clock::now() - start;
        if (progress != nullptr) {  // nobody knows how long it takes: a slow approach to the end
            const double seconds = std::chrono::duration<double>(spent).count();
            progress->report("Reading", seconds / (seconds + 2.0));
        }
        if (spent > kPatience) {
            throw IoError(file.string() + ": takes longer to read than " +
                          std::to_string(kPatience.count()) + " seconds; it was given up.");
        }
        std::array<pollfd, 2> waits{{{out.end[0], POLLIN, 0}, {err.end[0], POLLIN, 0}}};
        ::poll(waits.data(), waits.size(), 100);
        for (std::size_t k = 0; k < 2; ++k) {
            Pipe& pipe = k == 0 ? out : err;
            if (pipe.end[0] < 0 || waits[k].revents == 0) {
                continue;
            }
            const ssize_t count = ::read(pipe.end[0], buffer.data(), buffer.size());
            if (count > 0 && got[k].size() + static_cast<std::size_t>(count) <= kMostBytes) {
                got[k].append(buffer.data(), static_cast<std::size_t>(count));
            } else if (count > 0) {
                throw IoError(file.string() + ": is larger than this program can hold.");
            } else if (count == 0 || errno != EINTR) {
                pipe.close_end(0);
            }
        }
    }
    const int status = child.wait();
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        const bool said = WIFEXITED(status) && WEXITSTATUS(status) == 1 && !got[1].empty();
        throw IoError(file.string() + ": " +
                      (said ? sentence(got[1])
                            : "cannot be read: the file is damaged or asks for too much memory."));
    }
    scan = decode_scan(got[0], file.string());
}

}  // namespace myoface
