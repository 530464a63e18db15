// SPDX-License-Identifier: Apache-2.0
// Expressions on many faces, and muscles at random:
//   myoface-expression-study [--people N] [--draws N] [--first N] [--vertices N] [SCAN...]
// Every muscle and every preset at full contraction on N generated individuals and on the scans:
// travel of the mouth corners, lids, lips, folds, what one side does on the other. Then N draws in
// which every muscle has a random contraction, on three of the faces. Ends with 1 if anything is
// out of bounds.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>

#include "myoface/cases/case_file.h"
#include "myoface/face/generic_face.h"
#include "myoface/muscle/expression.h"

#include "expression_checks.h"

namespace myoface {
namespace {

using test::CornerTravel;

constexpr double kLeastTravel = 11.0, kMostTravel = 14.0;          // of a mouth corner [mm]
constexpr double kLidGap = 0.3, kInEye = 0.1, kLipsCrossed = 0.3;  // [mm]
constexpr double kOtherSide = 0.03;
constexpr double kInBone = 0.2, kRestAgain = 1e-4;  // [mm]

struct Subject {
    std::string name;
    std::shared_ptr<const FaceModel> face;
};

struct Findings {
    int checks = 0, bad = 0;
    void check(bool good, const std::string& what) {
        ++checks;
        if (!good) {
            ++bad;
            std::printf("%s\n", what.c_str());
            std::fflush(stdout);
        }
    }
};

std::string text(const char* format, const std::string& name, double value) {
    char line[256];
    std::snprintf(line, sizeof line, format, name.c_str(), value);
    return line;
}

std::vector<double> rates_of(const Expression& expression, std::size_t muscles) {
    std::vector<double> rates(muscles, 0.0);
    add_expression(rates, expression, 1.0);
    return rates;
}

void check_smile(Simulator& simulator, const Subject& subject, Findings& found) {
    test::pose(simulator, rates_of(expression_named("full_smile"), subject.face->muscles.size()));
    for (const Side side : {Side::Left, Side::Right}) {
        const CornerTravel corner = test::corner_travel(simulator, side);
        const std::string where = subject.name + (side == Side::Left ? " left" : " right");
        std::printf("%s: corner %.1f mm, up %.1f, back %.1f, out %.1f\n", where.c_str(), corner.way,
                    corner.up, corner.back, corner.outwards);
        found.check(corner.way >= kLeastTravel && corner.way <= kMostTravel,
                    text("BAD %s: the corner goes %.1f mm", where, corner.way));
        found.check(corner.up > 1.0 && corner.back > 1.0 && corner.outwards > 1.0,
                    text("BAD %s: not up, back and outwards (up %.1f)", where, corner.up));
    }
}

void check_lids(Simulator& simulator, const Subject& subject, Findings& found) {
    for (const char* name : {"eyes_closed", "eyes_tight"}) {
        test::pose(simulator, rates_of(expression_named(name), subject.face->muscles.size()));
        const Points& nodes = simulator.state().positions;
        for (const Side side : {Side::Left, Side::Right}) {
            const auto gap = test::lid_gap(*subject.face, nodes, side);
            if (gap) {
                found.check(*gap < kLidGap,
                            text("BAD %s: lids %.2f mm apart", subject.name + " " + name, *gap));
            }
        }
        const double deep = test::deepest_in_eye(*subject.face, nodes);
        found.check(deep < kInEye,
                    text("BAD %s: lids %.2f mm in the eye", subject.name + " " + name, deep));
    }
}

void check_pose(const Simulator& simulator, const Subject& subject, const std::string& name,
                Findings& found) {
    const Points& nodes = simulator.state().positions;
    const std::string what = subject.name + " " + name;
    const int folds = turned_over(*subject.face, subject.face->skin.mesh.vertices, nodes);
    found.check(folds == 0, text("BAD %s: %.0f triangles turned over", what, folds));
    const test::LipState lips = test::lips(*subject.face, nodes);
    found.check(lips.crossed < kLipsCrossed,
                text("BAD %s: lips %.2f mm through each other", what, lips.crossed));
    if (name == "pucker") {
        std::printf("%s: lips %.2f mm apart\n", what.c_str(), lips.apart);
    }
}

void study(const Subject& subject, Findings& found) {
    Simulator simulator(subject.face);
    const std::size_t count = subject.face->muscles.size();
    check_smile(simulator, subject, found);
    check_lids(simulator, subject, found);
    for (const Expression& preset : expression_presets()) {
        const StepReport report = test::pose(simulator, rates_of(preset, count));
        found.check(report.converged && report.finite,
                    text("BAD %s: not at rest after %.0f steps", subject.name + " " + preset.name,
                         report.iterations));
        check_pose(simulator, subject, preset.name, found);
    }
    for (std::size_t m = 0; m < count; ++m) {
        std::vector<double> rates(count, 0.0);
        rates[m] = 1.0;
        test::pose(simulator, rates);
        const MuscleTraits& traits = subject.face->muscles[m].traits;
        check_pose(simulator, subject, traits.name, found);
        if (traits.side != Side::Middle) {
            const double other =
                test::share_on_other_side(*subject.face, simulator.state().positions, traits.side);
            found.check(other < kOtherSide, text("BAD %s: %.3f of it on the other side",
                                                 subject.name + " " + traits.name, other));
        }
    }
}

/// Every muscle at random. Now and then in another order, and back to rest.
void draw(Simulator& simulator, const Subject& subject, unsigned seed, Findings& found) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const std::size_t count = subject.face->muscles.size();
    std::vector<double> rates(count);
    for (double& rate : rates) {
        rate = kLeastContraction + (kMostContraction - kLeastContraction) * unit(random);
    }
    const std::string name = subject.name + " draw " + std::to_string(seed);
    const StepReport report = test::pose(simulator, rates);
    const Points& nodes = simulator.state().positions;
    found.check(report.finite && nodes.allFinite(), "BAD " + name + ": not finite");
    const JawPose jaw = jaw_pose(*subject.face, simulator.contractions());
    const double bone = test::deepest_in_bone(*subject.face, nodes, jaw);
    found.check(bone < kInBone, text("BAD %s: %.2f mm in the bone", name, bone));
    const double eye = test::deepest_in_eye(*subject.face, nodes);
    found.check(eye < kInBone, text("BAD %s: %.2f mm in an eye", name, eye));
    if (seed % 20 == 0) {
        const Points before = nodes;
        test::pose(simulator, std::vector<double>(count, 0.0));
        const double rest =
            (simulator.state().positions - simulator.system().model.rest).cwiseAbs().maxCoeff();
        found.check(rest < kRestAgain, text("BAD %s: %.6f mm from rest", name, rest));
        for (std::size_t m = count; m-- > 0;) {
            simulator.set_contraction(static_cast<int>(m), 0.5 * rates[m]);
        }
        test::pose(simulator, rates);
        const double off = (simulator.state().positions - before).cwiseAbs().maxCoeff();
        found.check(off < 1e-5, text("BAD %s: another order ends %.7f mm away", name, off));
    }
}

Subject person(int number, int vertices) {
    GenericFaceOptions options;
    options.vertices = vertices;
    options.seed = static_cast<unsigned>(number);
    options.sex = number % 2 == 0 ? Sex::Female : Sex::Male;
    options.age = 20.0 + 5.0 * (number % 11);
    const GenericFace head = make_generic_face(options);
    return {"person " + std::to_string(number),
            fit_face(std::make_shared<const Scan>(head.scan), head.landmarks)};
}

}  // namespace
}  // namespace myoface

int main(int argc, char** argv) {
    using namespace myoface;
    int people = 50;
    int draws = 10000;
    int first = 0;
    int vertices = 4500;  // of a generated head
    std::vector<std::string> scans;
    for (int a = 1; a < argc; ++a) {
        if (a + 1 < argc && std::strcmp(argv[a], "--people") == 0) {
            people = std::atoi(argv[++a]);
        } else if (a + 1 < argc && std::strcmp(argv[a], "--draws") == 0) {
            draws = std::atoi(argv[++a]);
        } else if (a + 1 < argc && std::strcmp(argv[a], "--first") == 0) {
            first = std::atoi(argv[++a]);
        } else if (a + 1 < argc && std::strcmp(argv[a], "--vertices") == 0) {
            vertices = std::atoi(argv[++a]);
        } else {
            scans.emplace_back(argv[a]);
        }
    }
    Findings found;
    std::vector<Subject> subjects;
    for (const std::string& scan : scans) {
        OpenedFace opened = open_face(scan);
        find_missing_landmarks(opened);
        subjects.push_back({opened.name, fit_face(opened.scan, *opened.landmarks)});
        study(subjects.back(), found);
    }
    for (int k = first; k < first + people; ++k) {
        const Subject subject = person(k, vertices);
        study(subject, found);
        if (subjects.size() < 3) {
            subjects.push_back(subject);
        }
    }
    while (subjects.size() < 3) {
        subjects.push_back(person(static_cast<int>(subjects.size()), vertices));
    }
    subjects.resize(3);
    std::vector<std::unique_ptr<Simulator>> simulators;
    for (const Subject& subject : subjects) {
        simulators.push_back(std::make_unique<Simulator>(subject.face));
    }
    for (int d = 0; d < draws; ++d) {
        const auto which = static_cast<std::size_t>(d) % subjects.size();
        draw(*simulators[which], subjects[which], static_cast<unsigned>(d), found);
    }
    std::printf("%d checks, %d out of bounds\n", found.checks, found.bad);
    return found.bad > 0 ? 1 : 0;
}
