// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/measure/result_comparison.h"

#include "commands.h"
#include "face_arguments.h"
#include "output.h"

namespace myoface::cli {
namespace {

struct CompareArguments {
    FaceArguments face;
    EditArguments edits;
    std::string result, output;
};

void compare(const CompareArguments& a) {
    const RecordedPlan plan = a.edits.edits();
    OpenedFace opened = a.face.open();
    find_missing_landmarks(opened);
    const auto simulator = make_simulator(opened);
    run_plan(*simulator, plan_on(simulator->face(), plan));
    simulator->settle();
    OpenedFace after = open_face(a.result);
    if (!find_missing_landmarks(after)) {
        throw InvalidInput(a.result + ": no face was found on it; put a landmark file beside it.");
    }
    const ResultComparison comparison = compare_with_result(
        simulator->face(), simulator->state().positions, after.scan->mesh, *after.landmarks);
    nlohmann::ordered_json regions = nlohmann::ordered_json::array();
    for (const RegionDistance& row : comparison.regions) {
        regions.push_back({{"region", row.region},
                           {"nodes", row.nodes},
                           {"mean_mm", row.mean_mm},
                           {"mean_signed_mm", row.mean_signed_mm},
                           {"p90_mm", row.p90_mm},
                           {"share_below_2mm", row.share_below_2mm}});
    }
    const nlohmann::ordered_json document{
        {"note", "A planning and communication aid, not a medical device."},
        {"face", opened.name},
        {"result", after.name},
        {"registration_mm", comparison.registration_mm},
        {"regions", regions}};
    write_text(a.output, document.dump(1) + "\n");
}

}  // namespace

void add_compare(CLI::App& app) {
    auto* command = app.add_subcommand(
        "compare", "How far a plan is from a scan of afterwards, by region of the skin");
    auto a = std::make_shared<CompareArguments>();
    a->face.add_to(*command);
    a->edits.add_to(*command);
    command->add_option("--result", a->result, "scan taken after the operation")->required();
    command->add_option("-o", a->output, "JSON file, instead of standard output");
    command->callback([a] { compare(*a); });
}

}  // namespace myoface::cli
