// SPDX-License-Identifier: Apache-2.0
// Makes a face, smiles, and tells how far the mouth corners went.
#include <cstdio>

#include "myoface/cases/case_file.h"
#include "myoface/face/muscle_atlas.h"
#include "myoface/measure/measurement.h"

int main() {
    using namespace myoface;
    const OpenedFace opened = open_face("generic");
    const auto simulator = make_simulator(opened);
    const Points before = simulator->state().positions;
    for (const int muscle : muscles_named("zygomaticus_major")) {
        simulator->set_contraction(muscle, 1.0);
    }
    simulator->settle();
    const LandmarksOnSkin places(simulator->shared_face());
    for (const Measurement& row :
         measure_all(places, before, simulator->state().positions, Population())) {
        if (row.measure.id == "ch-ch") {
            std::printf("mouth %.1f mm wider\n", row.difference());
            return row.difference() > 4.0 ? 0 : 1;
        }
    }
    return 1;
}
