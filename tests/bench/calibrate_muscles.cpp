// SPDX-License-Identifier: Apache-2.0
// Sets the "gain" of every muscle in assets/muscles.json so that, after relaxation, its skin end
// goes "pull_mm" on the average head at full contraction. Run again when kernels, tissue constants
// or the head change:  myoface-calibrate assets/muscles.json
#include <algorithm>
#include <cstdio>
#include <map>

#include "myoface/base/error.h"
#include "myoface/face/generic_face.h"
#include "myoface/io/text_file.h"
#include "myoface/sim/simulator.h"

using namespace myoface;

namespace {

/// How far the skin over a muscle's end goes; for a ring, the furthest skin within it.
double skin_way(const Simulator& sim, const Muscle& muscle) {
    const FaceModel& face = sim.face();
    const Points& rest = face.skin.mesh.vertices;
    double way = 0.0;
    double nearest = 1e9;
    const Vec3 end = muscle.path.col(muscle.path.cols() - 1);
    for (int i = 0; i < face.node_count(); ++i) {
        const double moved = (sim.state().positions.col(i) - rest.col(i)).norm();
        if (muscle.traits.kind == MuscleKind::Sphincter) {
            if (face.tissue[i].tissue == Tissue::Skin) {
                way = std::max(way, moved);
            }
        } else if ((rest.col(i) - end).norm() < nearest) {
            nearest = (rest.col(i) - end).norm();
            way = moved;
        }
    }
    return way;
}

/// Replaces the gain that follows a muscle's id in the atlas' text.
void write_gain(std::string& text, const std::string& id, double gain) {
    const std::size_t entry = text.find("\"id\": \"" + id + "\"");
    const std::string key = "\"gain\": ";
    const std::size_t begin = text.find(key, entry) + key.size();
    const std::size_t end = text.find_first_of(",}", begin);
    char number[32];
    std::snprintf(number, sizeof number, "%.3f", gain);
    text.replace(begin, end - begin, number);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) {
        std::fputs("usage: myoface-calibrate assets/muscles.json\n", stderr);
        return 2;
    }
    const GenericFace generic = make_generic_face();
    const auto fitted = fit_face(std::make_shared<const Scan>(generic.scan), generic.landmarks);
    std::map<std::string, double> gain;
    for (const Muscle& muscle : fitted->muscles) {
        gain[muscle.traits.base_name] = muscle.traits.gain;
    }
    for (int round = 0; round < 4; ++round) {
        auto face = std::make_shared<FaceModel>(*fitted);
        for (Muscle& muscle : face->muscles) {
            muscle.traits.gain = gain[muscle.traits.base_name];
        }
        for (std::size_t m = 0; m < face->muscles.size(); ++m) {
            const MuscleTraits& traits = face->muscles[m].traits;
            if (traits.side == Side::Right ||
                (traits.action != MuscleAction::Pull && traits.action != MuscleAction::Purse)) {
                continue;  // lids, jaw and bellies go by geometry
            }
            Simulator sim(face);
            sim.set_contraction(static_cast<int>(m), 1.0);
            const StepReport report = sim.settle();
            const double way = skin_way(sim, face->muscles[m]);
            double& g = gain[traits.base_name];
            std::printf("%d %-40s gain %.3f way %.2f of %.2f mm, strain %.2f%s\n", round,
                        traits.base_name.c_str(), g, way, traits.pull, report.max_strain,
                        report.converged ? "" : " NOT SETTLED");
            g = std::clamp(g * std::clamp(traits.pull / std::max(way, 0.05), 0.5, 2.0), 0.2, 6.0);
        }
    }
    std::string text = read_file(argv[1]);
    for (const auto& [id, value] : gain) {
        write_gain(text, id, value);
    }
    write_file(argv[1], text);
    return 0;
} catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
