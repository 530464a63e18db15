// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iomanip>
#include <memory>
#include <sstream>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/face/norms.h"
#include "myoface/sim/simulator.h"

#include "commands.h"
#include "face_arguments.h"
#include "output.h"

namespace myoface::cli {
namespace {

struct Arguments {
    FaceArguments face;
    std::string sex, compare, output;
    double age = 25.0;
};

struct Row {
    Norm norm;
    double value = 0.0;
    std::optional<double> other;
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
    if (face.shape.cols() == 0 && face.rates.empty()) {
        return *face.landmarks;
    }
    const auto simulator = make_simulator(face);
    simulator->settle();
    return carried(*face.landmarks, face.scan->mesh.vertices,
                   simulator->scan_vertices().leftCols(face.scan->mesh.vertices.cols()));
}

Landmarks other_landmarks(const Arguments& a, const OpenedFace& face, const Landmarks& here) {
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

std::string as_json(const Arguments& a, const std::vector<Row>& rows) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Row& row : rows) {
        nlohmann::ordered_json entry{{"id", row.norm.measure.id},
                                     {"title", row.norm.measure.title},
                                     {"unit", row.norm.measure.in_degrees() ? "deg" : "mm"},
                                     {"value", row.value}};
        if (row.other) {
            entry["other"] = *row.other;
            entry["difference"] = *row.other - row.value;
        }
        entry["norm_mean"] = row.norm.mean;
        entry["norm_sd"] = row.norm.sd;
        entry["z"] = (row.value - row.norm.mean) / row.norm.sd;
        entry["source"] = row.norm.source;
        list.push_back(entry);
    }
    nlohmann::ordered_json document{
        {"note", "A planning and communication aid, not a medical device."},
        {"population", "adults of European descent, 20 to 25 years"},
        {"sex", a.sex.empty() ? "both" : a.sex},
        {"age", a.age},
        {"measures", list}};
    return document.dump(1) + "\n";
}

std::string as_csv(const std::vector<Row>& rows) {
    std::ostringstream text;
    text << "id,title,unit,value,other,difference,norm_mean,norm_sd,z,source\n"
         << std::fixed << std::setprecision(3);
    for (const Row& row : rows) {
        text << row.norm.measure.id << ',' << row.norm.measure.title << ','
             << (row.norm.measure.in_degrees() ? "deg" : "mm") << ',' << row.value << ',';
        if (row.other) {
            text << *row.other << ',' << *row.other - row.value;
        } else {
            text << ',';
        }
        text << ',' << row.norm.mean << ',' << row.norm.sd << ','
             << (row.value - row.norm.mean) / row.norm.sd << ',' << row.norm.source << '\n';
    }
    return text.str();
}

void measure(const Arguments& a) {
    OpenedFace face = a.face.open();
    const Landmarks here = landmarks_of(face);
    const std::optional<Landmarks> there =
        a.compare.empty() ? std::nullopt : std::optional(other_landmarks(a, face, here));
    std::optional<Sex> sex;
    if (!a.sex.empty()) {
        sex = a.sex == "f" ? Sex::Female : Sex::Male;
    }
    std::vector<Row> rows;
    for (const Norm& norm : norms(sex, a.age)) {
        const std::optional<double> value = measured(norm.measure, here);
        if (value) {
            rows.push_back({norm, *value, there ? measured(norm.measure, *there) : std::nullopt});
        }
    }
    const bool csv = std::filesystem::path(a.output).extension() == ".csv";
    write_text(a.output, csv ? as_csv(rows) : as_json(a, rows));
}

}  // namespace

void add_measure(CLI::App& app) {
    auto* command = app.add_subcommand("measure", "Distances and angles beside their norms");
    auto a = std::make_shared<Arguments>();
    a->face.add_to(*command);
    command->add_option("--sex", a->sex, "f or m; both sexes' norms when absent")
        ->check(CLI::IsMember({"f", "m"}));
    command->add_option("--age", a->age, "years; the norms cover 20 to 25");
    command->add_option("--compare", a->compare, "another face, measured beside this one");
    command->add_option("-o", a->output, "JSON or CSV file, instead of standard output");
    command->callback([a] { measure(*a); });
}

}  // namespace myoface::cli
