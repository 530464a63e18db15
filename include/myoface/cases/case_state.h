// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "myoface/face/face_model.h"
#include "myoface/muscle/contraction.h"
#include "myoface/muscle/wrinkle.h"
#include "myoface/sim/plan_file.h"

namespace myoface {

/// One plan beside others: what muscles do, how strong they are, and the shape of the skin.
struct Variant {
    std::string name;
    std::map<std::string, double> rates, strengths;  ///< by muscle, only those off rest
    Points shape;                                    ///< see shape_of_scan()
};

/// What the user made of a face, by names and by vertices of the scan: independent of how the scan
/// is fitted and simulated.
struct CaseState {
    std::map<std::string, double> rates, strengths;  ///< by muscle, only those off rest
    Points shape;                                    ///< see shape_of_scan()
    Eigen::VectorXd protection;  ///< 0 … 1 per vertex that the scan came with, or nothing
    std::vector<Variant> variants;
    double skin_age = kUsualSkin;  ///< of the skin that wrinkles [a]
    std::string notes;             ///< UTF-8
    RecordedPlan plan;             ///< the edits that led here, as far as they were recorded
};
CaseState case_state(const FaceModel& face, const Contractions& contractions,
                     const Points& skin_rest);

/// The contractions that names stand for; unknown names, of another atlas, do nothing.
Contractions contractions_of(const FaceModel& face, const std::map<std::string, double>& rates,
                             const std::map<std::string, double>& strengths);

/// Protection per vertex of the scan from skin nodes, and back. Nothing stays nothing.
Eigen::VectorXd protection_of_scan(const FaceModel& face, const Eigen::VectorXd& of_nodes);
/// Nothing where it belongs to another scan.
Eigen::VectorXd protection_of_nodes(const FaceModel& face, const Eigen::VectorXd& of_scan);

/// A state as one JSON object (UTF-8) and numbers in binary parts by name.
struct StateParts {
    std::string json;
    std::map<std::string, std::string> parts;
};
StateParts to_parts(const CaseState& state);
/// @param part gives the bytes of a part, or nothing where it is missing
/// @param vertices of the scan: a state cannot hold more
/// @param name of the file, for the sentence @throws IoError
CaseState from_parts(const std::string& json_text,
                     const std::function<std::string(const std::string&)>& part,
                     std::int64_t vertices, const std::string& name);

}  // namespace myoface
