// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace myoface::cli {

/// Each adds one subcommand with its options and what it does.
void add_info(CLI::App& app);
void add_landmarks(CLI::App& app);
void add_measure(CLI::App& app);
void add_compare(CLI::App& app);
void add_generate(CLI::App& app);
void add_fit(CLI::App& app);
void add_simulate(CLI::App& app);
void add_replay(CLI::App& app);
void add_render(CLI::App& app);
void add_report(CLI::App& app);
void add_animate(CLI::App& app);
void add_section(CLI::App& app);
void add_convert(CLI::App& app);
void add_bench(CLI::App& app);

}  // namespace myoface::cli
