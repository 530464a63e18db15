// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <nlohmann/json.hpp>

#include "myoface/face/face_model.h"
#include "myoface/io/mesh_file.h"

namespace myoface {

std::string muscles_to_json(const FaceModel& face) {
    nlohmann::json list = nlohmann::json::object();
    const FileFrame& frame = face.scan->frame;
    for (const Muscle& muscle : face.muscles) {
        nlohmann::json points = nlohmann::json::array();
        for (Eigen::Index i = 0; i < muscle.path.cols(); ++i) {
            const Vec3 p = frame.to_file(muscle.path.col(i));
            points.push_back({p.x(), p.y(), p.z()});
        }
        const bool linear = muscle.traits.kind != MuscleKind::Sphincter;
        if (!linear) {
            points.push_back(points.front());
        }
        nlohmann::json& entry = list[muscle.traits.name];
        entry = {{"kind", linear ? "linear" : "sphincter"}, {"points", points}};
        for (const Points& fibre : muscle.fibres) {
            nlohmann::json line = nlohmann::json::array();
            for (Eigen::Index i = 0; i < fibre.cols(); ++i) {
                const Vec3 p = frame.to_file(fibre.col(i));
                line.push_back({p.x(), p.y(), p.z()});
            }
            entry["fibres"].push_back(line);
        }
    }
    nlohmann::json document;
    const std::string unit = unit_name(frame.mm_per_unit);
    document["unit"] = unit == "other" ? nlohmann::json(frame.mm_per_unit) : nlohmann::json(unit);
    document["muscles"] = list;
    return document.dump(1) + "\n";
}

}  // namespace myoface
