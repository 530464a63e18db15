// SPDX-License-Identifier: Apache-2.0
// What a plan does to the measures of a face, beside their norms:
//   measures FACE [PLAN.json]
#include <cstdio>

#include "myoface/cases/case_file.h"
#include "myoface/io/text_file.h"
#include "myoface/measure/measurement.h"
#include "myoface/sim/plan_file.h"

int main(int argc, char** argv) {
    using namespace myoface;
    try {
        OpenedFace opened = open_face(argc > 1 ? argv[1] : "generic");
        find_missing_landmarks(opened);
        const auto simulator = make_simulator(opened);
        const Points before = simulator->state().positions;
        RecordedPlan plan;
        if (argc > 2) {
            plan = recorded_plan_from_json(read_file(argv[2]), argv[2]);
        } else {
            plan.edits = {parse_target("tip projection by -2"), parse_volume("at=pg; ml=1")};
        }
        const Replay done = replay(*simulator, plan);
        std::printf("%s\n", replay_in_words(done).c_str());
        const LandmarksOnSkin places(simulator->shared_face());
        for (const Measurement& row :
             measure_all(places, before, simulator->state().positions, Population())) {
            std::printf("%-40s %7.1f %7.1f", row.measure.title.c_str(), row.value,
                        row.other.value_or(row.value));
            if (row.norm) {
                std::printf("   norm %.1f ± %.1f", row.norm->mean, row.norm->sd);
            }
            std::puts("");
        }
        return done.refused.empty() ? 0 : 1;
    } catch (const Error& problem) {
        std::fprintf(stderr, "measures: %s\n", problem.what());
        return 1;
    }
}
