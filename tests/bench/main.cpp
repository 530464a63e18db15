// SPDX-License-Identifier: Apache-2.0
// Runs the benchmarks and, with --flat=FILE, writes the medians as one flat JSON object together
// with the ratios between peers: "a_vs_b_x" is how many times faster ours is. Counters are written
// beside the times.
#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "myoface/cases/case_file.h"

namespace {

class Collector final : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Iteration && !run.error_occurred) {
                const std::string name = run.run_name.function_name;
                times[name].push_back(run.GetAdjustedRealTime());
                for (const auto& [counter, value] : run.counters) {
                    times[counter].push_back(value);
                }
            }
        }
    }
    std::map<std::string, std::vector<double>> times;
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

struct Ratio {
    const char* name;
    const char* peer;
    const char* ours;
};
constexpr std::array kRatios{
    Ratio{"obj_vs_assimp_1m_x", "read_obj_1m_assimp_ms", "read_obj_1m_ms"},
    Ratio{"obj_vs_tinyobj_1m_x", "read_obj_1m_tinyobj_ms", "read_obj_1m_ms"},
    Ratio{"ply_binary_vs_assimp_1m_x", "read_ply_binary_1m_assimp_ms", "read_ply_binary_1m_ms"},
    Ratio{"ply_ascii_vs_assimp_1m_x", "read_ply_ascii_1m_assimp_ms", "read_ply_ascii_1m_ms"},
    Ratio{"stl_vs_assimp_1m_x", "read_stl_1m_assimp_ms", "read_stl_1m_ms"},
};

}  // namespace

int main(int argc, char** argv) {
    std::string flat;
    for (int i = 1; i < argc; ++i) {
        if (std::strncmp(argv[i], "--flat=", 7) == 0) {
            flat = argv[i] + 7;
            std::rotate(argv + i, argv + i + 1, argv + argc);
            --argc;
            break;
        }
    }
    if (argc == 2 && std::strncmp(argv[1], "--open=", 7) == 0) {
        myoface::OpenedFace opened = myoface::open_face(argv[1] + 7);
        myoface::find_missing_landmarks(opened);
        return myoface::make_simulator(opened)->step(1).finite ? 0 : 1;
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
        return 2;
    }
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    if (flat.empty()) {
        return 0;
    }
    std::map<std::string, double> values;
    for (const auto& [name, times] : collector.times) {
        values[name] = median(times);
    }
    for (const Ratio& ratio : kRatios) {
        if (values.count(ratio.peer) != 0 && values.count(ratio.ours) != 0) {
            values[ratio.name] = values[ratio.peer] / values[ratio.ours];
        }
    }
    std::ofstream out(flat);
    out << "{" << std::setprecision(5);
    const char* separator = "\n";
    for (const auto& [name, value] : values) {
        out << separator << " \"" << name << "\": " << value;
        separator = ",\n";
    }
    out << "\n}\n";
    return out ? 0 : 1;
}
