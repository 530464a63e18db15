// SPDX-License-Identifier: Apache-2.0
#include "people.h"

#include <array>
#include <exception>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "myoface/base/error.h"
#include "myoface/base/resources.h"
#include "myoface/face/face_model.h"
#include "myoface/face/generic_face.h"
#include "myoface/face/tissue.h"
#include "myoface/io/text_file.h"

#include "face_template.h"
#include "head/head_variation.h"
#include "head/skull.h"

namespace myoface {
namespace {

constexpr double kUsualOpening = 0.2;  // of the jaw's full opening, one standard deviation

/// Spreads ways of the landmarks over the template's points.
class Spread {
public:
    Spread() {
        // The back of the head and the neck hold still.
        const std::array<Vec3, 8> anchors{{{0, 130, -10},
                                           {0, 40, -98},
                                           {62, 60, -45},
                                           {-62, 60, -45},
                                           {0, -150, 20},
                                           {0, -150, -78},
                                           {76, 5, -22},
                                           {-76, 5, -22}}};
        const Landmarks& landmarks = generic_landmarks();
        centres_.resize(3, static_cast<Eigen::Index>(landmarks.size() + anchors.size()));
        Eigen::Index i = 0;
        for (const auto& [name, landmark] : landmarks) {
            centres_.col(i++) = landmark.position;
        }
        for (const Vec3& anchor : anchors) {
            centres_.col(i++) = anchor;
        }
    }

    Points operator()(const nlohmann::json& ways) const {
        Points moved = centres_;
        Eigen::Index i = 0;
        for (const auto& [name, landmark] : generic_landmarks()) {
            const nlohmann::json& way = ways.at(name);
            moved.col(i++) +=
                Vec3(way.at(0).get<double>(), way.at(1).get<double>(), way.at(2).get<double>());
        }
        const SmoothWarp warp(centres_, moved, Eigen::VectorXd::Zero(centres_.cols()), 0.0);
        const Points& points = face_template().points;
        return warp(points) - points;
    }

private:
    Points centres_;
};

People load() {
    const nlohmann::json document =
        nlohmann::json::parse(read_file(resource_path("assets/people.json")), nullptr, false);
    const FaceTemplate& face = face_template();
    const Spread spread;
    std::vector<Points> modes;
    People people;
    try {
        people.mean = spread(document.at("mean"));
        for (const nlohmann::json& ways : document.at("modes")) {
            modes.push_back(spread(ways));
        }
    } catch (const std::exception& error) {
        throw IoError(std::string("assets/people.json is damaged: ") + error.what());
    }
    // What sex and age change between the landmarks.
    for (const HeadVariation& variation : {HeadVariation{0.7, 0.0}, HeadVariation{0.0, 0.5}}) {
        Points mode(3, face.points.cols());
        for (Eigen::Index i = 0; i < mode.cols(); ++i) {
            mode.col(i) = variation_shift(variation, face.points.col(i), face.normals.col(i));
        }
        modes.push_back(mode);
    }
    const JawHinge jaw = generic_jaw_hinge();
    Points opening(3, face.points.cols());
    for (Eigen::Index i = 0; i < opening.cols(); ++i) {
        const Vec3 p = face.points.col(i);
        opening.col(i) = jaw_share(p) * (opened(jaw, kUsualOpening, p) - p);
    }
    people.jaw = static_cast<Eigen::Index>(modes.size());
    modes.push_back(opening);

    people.modes.resize(face.points.size(), static_cast<Eigen::Index>(modes.size()));
    for (std::size_t k = 0; k < modes.size(); ++k) {
        people.modes.col(static_cast<Eigen::Index>(k)) =
            Eigen::Map<const Eigen::VectorXd>(modes[k].data(), modes[k].size());
    }
    return people;
}

}  // namespace

const People& people() {
    static const People kPeople = load();
    return kPeople;
}

}  // namespace myoface
