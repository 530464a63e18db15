// SPDX-License-Identifier: Apache-2.0
// Learns how the landmarks of people vary from seeded individuals of the generator.
//   myoface-learn-people assets/people.json [individuals]
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>

#include "myoface/face/generic_face.h"
#include "myoface/face/smooth_warp.h"

using namespace myoface;

namespace {

constexpr double kKept = 0.95;  // of the variance

Points positions(const Landmarks& landmarks) {
    Points points(3, static_cast<Eigen::Index>(landmarks.size()));
    Eigen::Index i = 0;
    for (const auto& [name, landmark] : landmarks) {
        points.col(i++) = landmark.position;
    }
    return points;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fputs("myoface-learn-people FILE [individuals]\n", stderr);
        return 2;
    }
    const int people = argc > 2 ? std::stoi(argv[2]) : 300;
    const Points average = positions(generic_landmarks());
    const Eigen::VectorXd even = Eigen::VectorXd::Ones(average.cols());
    Eigen::MatrixXd offsets(average.size(), 2 * people);
    for (int k = 0; k < people; ++k) {
        GenericFaceOptions options;
        options.vertices = 3000;
        options.seed = static_cast<std::uint32_t>(50000 + k);
        options.sex = k % 2 == 0 ? Sex::Female : Sex::Male;
        options.age = 18.0 + 57.0 * std::fmod(0.618034 * k, 1.0);
        options.asymmetry = 1.0;
        const Points person = positions(make_generic_face(options).landmarks);
        const Similarity fit = fit_similarity(person, average, even);
        Points offset = ((fit.scale * fit.rotation * person).colwise() + fit.shift) - average;
        offsets.col(2 * k) = Eigen::Map<const Eigen::VectorXd>(offset.data(), offset.size());
        // Everybody's mirror image is a person too: the space is symmetric.
        Eigen::Index i = 0;
        for (const auto& [name, landmark] : generic_landmarks()) {
            const auto other = generic_landmarks().find(mirrored_name(name));
            const auto j = std::distance(generic_landmarks().begin(), other);
            offsets.block<3, 1>(3 * i++, 2 * k + 1) =
                Vec3(offset.col(j)).cwiseProduct(Vec3(-1.0, 1.0, 1.0));
        }
    }
    const Eigen::VectorXd mean = offsets.rowwise().mean();
    offsets.colwise() -= mean;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(offsets * offsets.transpose() /
                                                                (2 * people - 1));
    nlohmann::json file;
    file["note"] =
        "Modes of variation of the built-in head's landmarks, one standard deviation "
        "each [mm], most important first; made by myoface-learn-people.";
    const auto rounded = [](const Eigen::VectorXd& values) {
        nlohmann::json list = nlohmann::json::object();
        Eigen::Index i = 0;
        for (const auto& [name, landmark] : generic_landmarks()) {
            nlohmann::json at = nlohmann::json::array();
            for (int axis = 0; axis < 3; ++axis, ++i) {
                at.push_back(std::round(values[i] * 1000.0) / 1000.0);
            }
            list[name] = at;
        }
        return list;
    };
    file["mean"] = rounded(mean);
    const double total = solver.eigenvalues().sum();
    double kept = 0.0;
    for (Eigen::Index k = solver.eigenvalues().size() - 1; k >= 0 && kept < kKept * total; --k) {
        const double variance = solver.eigenvalues()[k];
        file["modes"].push_back(rounded(std::sqrt(variance) * solver.eigenvectors().col(k)));
        kept += variance;
    }
    std::ofstream(argv[1]) << file.dump() << '\n';
    std::printf("%d modes hold %.1f %% of the variance\n", static_cast<int>(file["modes"].size()),
                100.0 * kept / total);
    return 0;
}
