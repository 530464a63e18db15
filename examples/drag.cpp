// SPDX-License-Identifier: Apache-2.0
// Two hands on a face: one shapes the tip of the nose, one pulls at the cheek to feel what holds
// it.
//   drag FACE
#include <cstdio>

#include "myoface/cases/case_file.h"
#include "myoface/sim/plan.h"

int main(int argc, char** argv) {
    using namespace myoface;
    try {
        OpenedFace opened = open_face(argc > 1 ? argv[1] : "generic");
        find_missing_landmarks(opened);
        const auto simulator = make_simulator(opened);
        // Mouse priority: the point goes where the hand is, and stays there.
        const Plan plan{parse_drag("at=prn; view=left; move=-2,2"),
                        // Constraint priority: the skin gives way first, then the muscle layer.
                        parse_drag("at=zy_l; view=front; move=0,12; mode=constraint")};
        const PlanReport report = run_plan(*simulator, plan);
        for (const DragReport& drag : report.drags) {
            std::printf(
                "%s: %.2f mm beside the hand, %.1f N (skin %.1f, muscle %.1f, refused %.1f)\n",
                drag.mode == DragMode::MousePriority ? "shape" : "feel", drag.off_ray_mm,
                drag.force_mN / 1000.0, drag.stage_skin_mN / 1000.0, drag.stage_muscle_mN / 1000.0,
                drag.refused_mN / 1000.0);
        }
        return report.drags.front().off_ray_mm < 0.1 ? 0 : 1;
    } catch (const Error& problem) {
        std::fprintf(stderr, "drag: %s\n", problem.what());
        return 1;
    }
}
