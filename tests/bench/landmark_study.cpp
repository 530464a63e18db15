// SPDX-License-Identifier: Apache-2.0
// How well landmarks are found on spoiled scans of generated people.
//   myoface-landmark-study [people] [first seed]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "myoface/base/error.h"
#include "myoface/face/landmark_detection.h"

#include "spoiled_scan.h"

using namespace myoface;

namespace {

double share_at(std::vector<double> values, double share) {
    if (values.empty()) {
        return 0.0;
    }
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

int main(int argc, char** argv) {
    const int people = argc > 1 ? std::stoi(argv[1]) : 300;
    const int first = argc > 2 ? std::stoi(argv[2]) : 1000;
    std::vector<double> all;
    std::map<std::string, std::vector<double>> kinds;
    int within = 0;
    int refused = 0;
    int wrong = 0;
    int flagged = 0;
    double seconds = 0.0;
    for (int k = 0; k < people; ++k) {
        const test::SpoiledScan scan = test::spoiled_scan(static_cast<std::uint32_t>(first + k));
        const auto start = std::chrono::steady_clock::now();
        try {
            const DetectedLandmarks found = detect_landmarks(scan.mesh);
            seconds +=
                std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            std::vector<double> errors;
            for (const char* name : {"prn", "sn", "en_l", "en_r", "ex_l", "ex_r", "ch_l", "ch_r",
                                     "ls", "li", "sto", "pg"}) {
                const auto at = found.landmarks.find(name);
                if (at == found.landmarks.end()) {
                    continue;
                }
                const double error =
                    (at->second.position - scan.truth.at(name).position).norm() * scan.unit;
                errors.push_back(error);
                if (error > 5.0) {
                    const Vec3 off =
                        scan.unit * (scan.turn.transpose() *
                                     (at->second.position - scan.truth.at(name).position));
                    std::printf("    %d %s %.1f: %.1f %.1f %.1f (%s)\n", first + k, name, error,
                                off.x(), off.y(), off.z(), scan.story.c_str());
                }
                kinds[std::string(name).substr(0, std::string(name).find('_'))].push_back(error);
                within += error < 2.0 * at->second.error_mm * scan.unit ? 1 : 0;
            }
            all.insert(all.end(), errors.begin(), errors.end());
            const bool good = share_at(errors, 0.5) < 15.0;
            if (!good) {
                ++wrong;
                flagged += found.confidence < 0.5 ? 1 : 0;
            }
            if (!good || share_at(errors, 1.0) > 9.0) {
                std::printf("%d: confidence %.2f, median %.1f, worst %.1f (%s)\n", first + k,
                            found.confidence, share_at(errors, 0.5), share_at(errors, 1.0),
                            scan.story.c_str());
            }
        } catch (const Error& error) {
            ++refused;
            std::printf("%d: refused (%s)\n", first + k, scan.story.c_str());
        }
    }
    std::printf(
        "%d people: median %.2f mm, 90 %% %.2f mm, 95 %% %.2f mm; %.1f %% within twice the "
        "stated error; %d refused, %d wrong poses of which %d flagged; %.2f s each\n",
        people, share_at(all, 0.5), share_at(all, 0.9), share_at(all, 0.95),
        100.0 * within / std::max<double>(1.0, static_cast<double>(all.size())), refused, wrong,
        flagged, seconds / people);
    for (const auto& [kind, errors] : kinds) {
        std::printf("  %-4s median %.2f  95 %% %.2f\n", kind.c_str(), share_at(errors, 0.5),
                    share_at(errors, 0.95));
    }
    return 0;
}
