// SPDX-License-Identifier: Apache-2.0
// Opens a scan, fits muscles and bone to it, smiles and writes the smiling face:
//   smile FACE.obj SMILE.obj
#include <cstdio>

#include "myoface/cases/case_file.h"
#include "myoface/sim/plan.h"
#include "myoface/sim/snapshot.h"

int main(int argc, char** argv) {
    using namespace myoface;
    if (argc != 3) {
        std::fputs("usage: smile FACE OUT.obj (FACE: a scan, a case, or the word generic)\n",
                   stderr);
        return 2;
    }
    try {
        OpenedFace opened = open_face(argv[1]);
        find_missing_landmarks(opened);  // where no landmark file lies beside the scan
        const auto simulator = make_simulator(opened);
        const PlanReport report = run_plan(*simulator, {ExpressionEdit{"full_smile", 1.0}});
        write_face(argv[2], *opened.scan, simulator->face(), simulator->state().positions, 0.0);
        std::printf("smiles by up to %.1f mm\n", report.last.max_displacement_mm);
        return report.last.converged ? 0 : 1;
    } catch (const Error& problem) {  // one sentence for a person
        std::fprintf(stderr, "smile: %s\n", problem.what());
        return 1;
    }
}
