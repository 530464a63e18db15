// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include "myoface/sim/plan.h"

namespace myoface::cli {

/// What edits did to a face, as `simulate --report` writes it.
nlohmann::ordered_json simulation_report(const Simulator& simulator, const PlanReport& plan);

}  // namespace myoface::cli
