// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "myoface/cases/case_file.h"
#include "myoface/measure/measurement.h"
#include "myoface/sim/plan.h"

namespace myoface::cli {

/// FACE with --landmarks, --unit and --axes, as several commands take it.
struct FaceArguments {
    std::string face, landmarks, unit, axes, known, tissue;

    void add_to(CLI::App& command);
    /// Opens the face. @throws Error
    OpenedFace open() const;
};

/// --sex and --age: whose norms.
struct PopulationArguments {
    std::string sex;
    double age = 25.0;

    void add_to(CLI::App& command);
    Population chosen() const;
};

/// --muscle, --expression, --strength, --drag, --plan, in the order: plan, strengths, expressions,
/// muscles, protection, drags, volumes, targets.
struct EditArguments {
    std::vector<std::string> muscles, expressions, weakenings, strengths, drags, volumes, targets,
        protects;
    std::string plan;

    void add_to(CLI::App& command);
    /// @throws Error
    Plan edits() const;
};

}  // namespace myoface::cli
