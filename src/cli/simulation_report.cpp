// SPDX-License-Identifier: Apache-2.0
#include "simulation_report.h"

#include <cstdio>

#include "myoface/measure/volume.h"

namespace myoface::cli {
namespace {

nlohmann::ordered_json drag_json(const FaceModel& face, const DragReport& drag) {
    const int vertex = drag.node < 0 ? -1 : face.skin.vertex[static_cast<std::size_t>(drag.node)];
    const auto list = [](const Vec3& p) {
        return nlohmann::ordered_json::array({p.x(), p.y(), p.z()});
    };
    nlohmann::ordered_json json;
    json["mode"] = drag.mode == DragMode::MousePriority ? "mouse" : "constraint";
    json["vertex"] = vertex;
    json["target"] = list(face.scan->frame.to_file(drag.target));
    json["reached"] = list(face.scan->frame.to_file(drag.reached));
    json["off_ray_mm"] = drag.off_ray_mm;
    json["view_force_residual"] = drag.view_force_residual;
    json["force_mN"] = drag.force_mN;
    json["stage_skin_mN"] = drag.stage_skin_mN;
    json["stage_muscle_mN"] = drag.stage_muscle_mN;
    json["refused_mN"] = drag.refused_mN;
    json["kept_share"] = drag.kept_share;
    json["strain_share_of_limit"] = drag.strain_share;
    return json;
}

/// The deepest furrow of each group [mm].
nlohmann::ordered_json deepest_wrinkles(const Wrinkles& wrinkles) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (std::size_t g = 0; !wrinkles.none() && g < wrinkles.map->gauges.size(); ++g) {
        const WrinkleMap::Gauge& gauge = wrinkles.map->gauges[g];
        const std::string& group = furrow_atlas()[static_cast<std::size_t>(gauge.furrow)].group;
        const double depth = gauge.taper * wrinkles.depth[static_cast<Eigen::Index>(g)];
        if (depth > json.value(group, 0.0)) {
            json[group] = depth;
        }
    }
    return json;
}

}  // namespace

nlohmann::ordered_json simulation_report(const Simulator& simulator, const PlanReport& plan) {
    const FaceModel& face = simulator.face();
    nlohmann::ordered_json json;
    json["note"] = "A planning and communication aid, not a medical device.";
    json["vertices"] = face.own_vertices;
    json["nodes"] = simulator.system().model.node_count();
    json["springs"] = simulator.system().model.springs.size();
    for (std::size_t m = 0; m < face.muscles.size(); ++m) {
        json["muscles"][face.muscles[m].traits.name] = simulator.contractions().rate[m];
    }
    json["skin_age"] = simulator.skin_age();
    json["wrinkles_mm"] = deepest_wrinkles(simulator.wrinkles());
    json["max_displacement_mm"] = plan.last.max_displacement_mm;
    json["max_strain"] = plan.last.max_strain;
    json["solver"] = {{"name", plan.last.solver},
                      {"iterations", plan.last.iterations},
                      {"residual", plan.last.residual},
                      {"converged", plan.last.converged},
                      {"ms", plan.last.milliseconds}};
    json["drags"] = nlohmann::ordered_json::array();
    for (const DragReport& drag : plan.drags) {
        json["drags"].push_back(drag_json(face, drag));
    }
    for (const VolumeReport& volume : plan.volumes) {
        nlohmann::ordered_json entry{{"ml", volume.ml},
                                     {"pressure_kPa", volume.pressure_kPa},
                                     {"kept_share", volume.kept_share}};
        for (const auto& [region, ml] : volume.by_region) {
            entry["by_region_ml"][region_name(region)] = ml;
        }
        json["volumes"].push_back(entry);
    }
    for (const TargetReport& target : plan.targets) {
        std::string moved;
        for (const std::string& landmark : target.landmarks) {
            moved += (moved.empty() ? "" : ", ") + landmark;
        }
        json["targets"].push_back({{"landmark", moved},
                                   {"before", target.before},
                                   {"wanted", target.wanted},
                                   {"reached", target.reached},
                                   {"moved_mm", target.moved_mm},
                                   {"force_mN", target.force_mN}});
    }
    const Points& scan = face.skin.mesh.vertices;
    for (const auto& [region, ml] : volume_by_region(face, scan, simulator.skin_rest())) {
        json["shape_ml"][region_name(region)] = ml;
    }
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016llx",
                  static_cast<unsigned long long>(simulator.state_hash()));
    json["state_hash"] = hash;
    return json;
}

}  // namespace myoface::cli
