// SPDX-License-Identifier: Apache-2.0
#include "myoface/measure/measurement.h"

#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

namespace myoface {
namespace {

const char* unit_of(const Measure& measure) {
    return measure.in_degrees() ? "deg" : "mm";
}

double z_score(const Norm& norm, double value) {
    return (value - norm.mean) / norm.sd;
}

}  // namespace

const char* Population::name() {
    return "adults of European descent, 20 to 25 years";
}

std::vector<Measure> all_measures() {
    std::vector<Measure> measures;
    for (const Norm& norm : norms(std::nullopt, 25.0)) {
        measures.push_back(norm.measure);
    }
    for (const auto& [landmark, title] :
         {std::pair("prn", "tip projection"), std::pair("sn", "nasal base projection"),
          std::pair("ls", "upper lip projection"), std::pair("li", "lower lip projection"),
          std::pair("pg", "chin projection")}) {
        measures.push_back(
            {std::string(landmark) + "-front", title, MeasureKind::Projection, {landmark}});
    }
    return measures;
}

std::vector<Measurement> measure_all(const Landmarks& here, const Landmarks* other,
                                     const Population& population) {
    std::vector<Measurement> rows;
    for (const Norm& norm : norms(population.sex, population.age)) {
        if (const auto value = measured(norm.measure, here)) {
            rows.push_back({norm.measure, *value,
                            other != nullptr ? measured(norm.measure, *other) : std::nullopt,
                            norm});
        }
    }
    return rows;
}

std::vector<Measurement> measure_all(const LandmarksOnSkin& places, const Points& before,
                                     const Points& now, const Population& population) {
    const Landmarks was = places.at(before);
    const Landmarks is = places.at(now);
    std::vector<Measurement> rows = measure_all(was, &is, population);
    for (const Measure& measure : all_measures()) {
        if (measure.kind == MeasureKind::Projection) {
            const auto value = places.measure(measure, before);
            const auto other = places.measure(measure, now);
            if (value && other) {
                rows.push_back({measure, *value, other, std::nullopt});
            }
        }
    }
    return rows;
}

std::vector<std::pair<std::string, double>> asymmetries(const Landmarks& landmarks,
                                                        const Midplane& plane) {
    std::vector<std::pair<std::string, double>> result;
    for (const auto& [name, left] : landmarks) {
        if (name.size() < 3 || name.compare(name.size() - 2, 2, "_l") != 0) {
            continue;
        }
        const std::string plain = name.substr(0, name.size() - 2);
        const auto right = landmarks.find(plain + "_r");
        if (right != landmarks.end()) {
            result.emplace_back(plain,
                                (left.position - mirrored(plane, right->second.position)).norm());
        }
    }
    return result;
}

std::string measurements_json(const std::vector<Measurement>& rows,
                              const std::vector<std::pair<std::string, double>>& asymmetry,
                              const Population& population) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Measurement& row : rows) {
        nlohmann::ordered_json entry{{"id", row.measure.id},
                                     {"title", row.measure.title},
                                     {"unit", unit_of(row.measure)},
                                     {"value", row.value}};
        if (row.other) {
            entry["other"] = *row.other;
            entry["difference"] = row.difference();
        }
        if (row.norm) {
            entry["norm_mean"] = row.norm->mean;
            entry["norm_sd"] = row.norm->sd;
            entry["z"] = z_score(*row.norm, row.value);
            entry["source"] = row.norm->source;
        }
        list.push_back(entry);
    }
    nlohmann::ordered_json sides = nlohmann::ordered_json::object();
    for (const auto& [name, mm] : asymmetry) {
        sides[name] = mm;
    }
    const nlohmann::ordered_json document{
        {"note", "A planning and communication aid, not a medical device."},
        {"population", Population::name()},
        {"sex", !population.sex                  ? "both"
                : *population.sex == Sex::Female ? "f"
                                                 : "m"},
        {"age", population.age},
        {"measures", list},
        {"asymmetry_mm", sides}};
    return document.dump(1) + "\n";
}

std::string measurements_csv(const std::vector<Measurement>& rows) {
    std::ostringstream text;
    text << "id,title,unit,value,other,difference,norm_mean,norm_sd,z,source\n"
         << std::fixed << std::setprecision(3);
    for (const Measurement& row : rows) {
        text << row.measure.id << ',' << row.measure.title << ',' << unit_of(row.measure) << ','
             << row.value << ',';
        if (row.other) {
            text << *row.other << ',' << row.difference() << ',';
        } else {
            text << ",,";
        }
        if (row.norm) {
            text << row.norm->mean << ',' << row.norm->sd << ',' << z_score(*row.norm, row.value)
                 << ',' << row.norm->source;
        } else {
            text << ",,,";
        }
        text << '\n';
    }
    return text.str();
}

}  // namespace myoface
