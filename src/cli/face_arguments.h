// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "myoface/cases/case_file.h"
#include "myoface/measure/measurement.h"
#include "myoface/sim/plan_file.h"

namespace myoface::cli {

/// FACE with --landmarks, --unit and --axes, as several commands take it.
struct FaceArguments {
    std::string face, landmarks, unit, axes, known, tissue, passphrase_file;
    std::optional<double> skin_age;

    void add_to(CLI::App& command);
    /// Opens the face. Cases that are written from it are protected where a passphrase was given.
    /// @throws Error
    OpenedFace open() const;
    /// From --passphrase-file or MYOFACE_PASSPHRASE; never from the command line itself, which
    /// other people on the machine can see. @throws Error
    std::string passphrase() const;
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
    RecordedPlan edits() const;
};

}  // namespace myoface::cli
