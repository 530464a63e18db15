// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>

#include "myoface/base/error.h"
#include "myoface/measure/measurement.h"
#include "myoface/sim/simulator.h"

#include "commands.h"
#include "face_arguments.h"
#include "output.h"

namespace myoface::cli {
namespace {

struct MeasureArguments {
    FaceArguments face;
    EditArguments edits;
    PopulationArguments population;
    std::string compare, output;
};

/// Landmarks of a case's changed face, or of another face with the same vertices: each goes with
/// the vertex next to it.
Landmarks carried(const Landmarks& landmarks, const Points& from, const Points& to) {
    Landmarks moved = landmarks;
    for (auto& [name, landmark] : moved) {
        Eigen::Index nearest = 0;
        (from.colwise() - landmark.position).colwise().squaredNorm().minCoeff(&nearest);
        landmark.position += to.col(nearest) - from.col(nearest);
    }
    return moved;
}

/// The landmarks of a face as it stands: found where none are given, moved with a case's shape.
Landmarks landmarks_of(OpenedFace& face) {
    if (!find_missing_landmarks(face)) {
        throw InvalidInput(face.name +
                           ": no face was found on it; give its landmarks with --landmarks.");
    }
    if (face.state.shape.cols() == 0 && face.state.rates.empty()) {
        return *face.landmarks;
    }
    const auto simulator = make_simulator(face);
    simulator->settle();
    return carried(*face.landmarks, face.scan->mesh.vertices,
                   simulator->scan_vertices().leftCols(face.scan->mesh.vertices.cols()));
}

Landmarks other_landmarks(const MeasureArguments& a, const OpenedFace& face,
                          const Landmarks& here) {
    OpenOptions options;
    options.mm_per_unit = face.scan->frame.mm_per_unit;
    options.axes = face.scan->frame.axes;
    OpenedFace other = open_face(a.compare, options);
    const Points& v = other.scan->mesh.vertices;
    if (!other.landmarks && v.cols() == face.scan->mesh.vertices.cols()) {
        return carried(here, face.scan->mesh.vertices, v);
    }
    return landmarks_of(other);
}

/// A face against another one.
std::string compared(const MeasureArguments& a, bool csv) {
    OpenedFace face = a.face.open();
    const Landmarks here = landmarks_of(face);
    const Landmarks other = other_landmarks(a, face, here);
    const Population population = a.population.chosen();
    const std::vector<Measurement> rows = measure_all(here, &other, population);
    return csv ? measurements_csv(rows)
               : measurements_json(rows, asymmetries(here, midplane_of(here)), population);
}

/// A face as the window measures it: before and, where something has changed, now.
std::string measured_alone(const MeasureArguments& a, bool csv) {
    const RecordedPlan plan = a.edits.edits();
    OpenedFace opened = a.face.open();
    if (!find_missing_landmarks(opened)) {
        throw InvalidInput(opened.name +
                           ": no face was found on it; give its landmarks with --landmarks.");
    }
    const auto simulator = make_simulator(opened);
    run_plan(*simulator, plan_on(simulator->face(), plan));
    simulator->settle();
    const std::shared_ptr<const FaceModel> face = simulator->shared_face();
    const LandmarksOnSkin places(face);
    const Population population = a.population.chosen();
    std::vector<Measurement> rows =
        measure_all(places, face->skin.mesh.vertices, simulator->state().positions, population);
    if (plan.edits.empty() && opened.state.shape.cols() == 0 && opened.state.rates.empty()) {
        for (Measurement& row : rows) {
            row.other.reset();
        }
    }
    return csv ? measurements_csv(rows)
               : measurements_json(
                     rows, asymmetries(places.at(simulator->state().positions), face->midplane),
                     population);
}

void measure(const MeasureArguments& a) {
    const bool csv = std::filesystem::path(a.output).extension() == ".csv";
    write_text(a.output, a.compare.empty() ? measured_alone(a, csv) : compared(a, csv));
}

}  // namespace

void add_measure(CLI::App& app) {
    auto* command = app.add_subcommand("measure", "Distances and angles beside their norms");
    auto a = std::make_shared<MeasureArguments>();
    a->face.add_to(*command);
    a->edits.add_to(*command);
    a->population.add_to(*command);
    command->add_option("--compare", a->compare, "another face, measured beside this one");
    command->add_option("-o", a->output, "JSON or CSV file, instead of standard output");
    command->callback([a] { measure(*a); });
}

}  // namespace myoface::cli
