// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "myoface/sim/plan.h"

namespace myoface {

/// The face that a plan was recorded on.
struct PlanOrigin {
    std::uint64_t scan = 0;                 ///< of the scan's vertices in our frame
    std::uint64_t skin = 0;                 ///< of the simulated skin: the same bits, the same fit
    Mat3 axes = Mat3::Identity();           ///< FaceModel::axes
    std::map<std::string, Vec3> landmarks;  ///< [mm]
};
PlanOrigin plan_origin(const FaceModel& face);

/// Edits with the face they were recorded on. A plan that was written by hand has none.
struct RecordedPlan {
    std::optional<PlanOrigin> origin;
    Plan edits;
};

/// {"format": "myoface-plan", "schema": 1, "made_on": {…}, "plan": [edit, …]}; only "plan" is
/// needed. Edits are {"muscle": name, "rate": c}, {"muscle": name, "strength": s},
/// {"expression": name, "intensity": w}, {"drag": text}, {"volume": text}, {"target": text},
/// {"protect": text} and {"shape": …}; those with a place may hold it as
/// "place": {"triangle", "weights", "xyz", "head", "near", "off"}. See docs/dev/plan-format.md.
/// @throws IoError, InvalidInput with the name, the edit and what is wrong
RecordedPlan recorded_plan_from_json(const std::string& text, const std::string& name);
std::string recorded_plan_to_json(const RecordedPlan& plan);
/// The edits alone.
Plan plan_from_json(const std::string& text, const std::string& name);
std::string plan_to_json(const Plan& plan);

/// A place of this face as a recorded edit holds it.
PlanPlace plan_place(const FaceModel& face, const SurfacePoint& where);

/// A recorded plan on a face.
struct CarriedPlan {
    enum class Face { Unknown, Same, SameScan, Other };
    Face face = Face::Unknown;         ///< what it is to the one the plan was recorded on
    Plan edits;                        ///< those that could be carried over
    std::vector<int> number;           ///< per edit: which of the plan's it is, from 1
    std::vector<RefusedEdit> refused;  ///< those that could not
    double largest_doubt_mm = 0.0;     ///< between the places by the fit and by landmarks
    int most_doubtful = 0;             ///< that edit, from 1
};
/// From so much on a place that was carried over is to be looked at [mm].
inline constexpr double kDoubtfulPlace = 8.0;
/// Carries the places of a recorded plan to a face: the very triangle where it is the same face
/// fitted alike, the same point of the same scan, else the place that the fit says is the same;
/// views turn with the head, millimetres stay.
CarriedPlan carried(const RecordedPlan& plan, const FaceModel& face);
/// All edits of a plan on a face, for run_plan(). @throws InvalidInput for the first that cannot be
/// carried over
Plan plan_on(const FaceModel& face, const RecordedPlan& plan);

/// What came of a plan on a face.
struct Replay {
    CarriedPlan::Face face = CarriedPlan::Face::Unknown;
    int edits = 0, done = 0;
    std::vector<RefusedEdit> refused;
    double largest_doubt_mm = 0.0;
    int most_doubtful = 0;
    Plan made;  ///< the edits that were made, with their places on this face
    PlanReport report;
};
/// Carries a plan over and out.
Replay replay(Simulator& simulator, const RecordedPlan& plan,
              std::optional<double> seconds = std::nullopt);
/// The same as JSON: "face", "edits", "done", "refused" [{"edit", "what", "why"}],
/// "largest_doubt_mm".
std::string replay_to_json(const Replay& replay);
/// A few sentences for a person.
std::string replay_in_words(const Replay& replay);

}  // namespace myoface
