// SPDX-License-Identifier: Apache-2.0
#include "individual.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace myoface {
namespace {

/// Standard normal draws that are the same with every library: the sum of twelve uniforms, held
/// within 2.4.
class Draws {
public:
    explicit Draws(std::uint32_t seed) : random_(seed) { random_.discard(16); }
    double operator()() {
        double sum = -6.0;
        for (int i = 0; i < 12; ++i) {
            sum += static_cast<double>(random_()) / 4294967296.0;
        }
        return std::clamp(sum, -2.4, 2.4);
    }

private:
    std::mt19937 random_;
};

/// What is left for the last part so that the sum of independent parts and it has the spread
/// `whole`.
double remaining_sd(double whole, std::initializer_list<double> parts) {
    double square = whole * whole;
    for (const double part : parts) {
        square -= part * part;
    }
    return std::sqrt(std::max(square, 0.25));
}

/// A pair of draws with correlation rho.
std::pair<double, double> correlated(Draws& draw, double rho) {
    const double a = draw();
    return {a, rho * a + std::sqrt(1.0 - rho * rho) * draw()};
}

}  // namespace

WantedMeasures wanted_measures(std::optional<Sex> sex, double age, double old,
                               std::optional<std::uint32_t> seed) {
    WantedMeasures wanted;
    std::map<std::string, double> sd;
    for (const Norm& norm : norms(sex, age)) {
        wanted[norm.measure.id] = norm.mean;
        sd[norm.measure.id] = norm.sd;
    }
    if (seed) {
        Draws draw(*seed);
        std::map<std::string, double> off;
        // Big faces are big in most things: widths and heights share a part of their draw.
        constexpr double kShared = 0.45;
        const double size = draw();
        const auto sized = [&] {
            return kShared * size + std::sqrt(1.0 - kShared * kShared) * draw();
        };
        for (const char* id : {"zy-zy", "go-go", "ft-ft", "n-sn", "al-al", "ch-ch"}) {
            off[id] = sd[id] * sized();
        }
        // ex-ex is en-en and twice en-ex, nearly on one line.
        const double fissures = 1.93 * sd["en-ex"];
        const double rho_eyes =
            (sd["ex-ex"] * sd["ex-ex"] - sd["en-en"] * sd["en-en"] - fissures * fissures) /
            (2.0 * sd["en-en"] * fissures);
        const auto [inner, fissure] = correlated(draw, std::clamp(rho_eyes, -0.9, 0.9));
        off["en-en"] = sd["en-en"] * inner;
        off["en-ex"] = sd["en-ex"] * fissure;
        off["ex-ex"] = off["en-en"] + 1.93 * off["en-ex"];
        // sn-sto is sn-ls and ls-sto, nearly on one line.
        const double rho_lip = (sd["sn-sto"] * sd["sn-sto"] - sd["sn-ls"] * sd["sn-ls"] -
                                sd["ls-sto"] * sd["ls-sto"]) /
                               (2.0 * sd["sn-ls"] * sd["ls-sto"]);
        const auto [white, red] = correlated(draw, std::clamp(rho_lip, -0.9, 0.9));
        off["sn-ls"] = sd["sn-ls"] * white;
        off["ls-sto"] = sd["ls-sto"] * red;
        off["sn-sto"] = off["sn-ls"] + off["ls-sto"];
        off["sto-li"] = sd["sto-li"] * draw();
        off["li-sl"] = sd["li-sl"] * draw();
        // n-gn is the sum of its stretches and the chin.
        const double chin =
            remaining_sd(sd["n-gn"], {sd["n-sn"], sd["sn-sto"], sd["sto-li"], sd["li-sl"]});
        off["n-gn"] = off["n-sn"] + off["sn-sto"] + off["sto-li"] + off["li-sl"] + chin * draw();
        // The bridge follows the nose's height, the wing its protrusion.
        constexpr double kBridge = 0.8;
        off["n-prn"] = sd["n-prn"] * (kBridge * off["n-sn"] / sd["n-sn"] +
                                      std::sqrt(1.0 - kBridge * kBridge) * draw());
        off["sn-prn"] = sd["sn-prn"] * draw();
        constexpr double kWing = 0.6;
        off["ac-prn"] = sd["ac-prn"] * (kWing * off["sn-prn"] / sd["sn-prn"] +
                                        std::sqrt(1.0 - kWing * kWing) * draw());
        constexpr double kSill = 0.5;
        off["sbal-sbal"] = sd["sbal-sbal"] * (kSill * off["al-al"] / sd["al-al"] +
                                              std::sqrt(1.0 - kSill * kSill) * draw());
        for (const char* id : {"cph-cph", "sn-c", "se-en", "ex-en-en", "g-sn-pg", "c-sn-ls"}) {
            off[id] = sd[id] * draw();
        }
        for (const auto& [id, value] : off) {
            wanted[id] += value;
        }
    }
    if (old > 0.0) {
        wanted["ls-sto"] *= 1.0 - 0.30 * old;
        wanted["sto-li"] *= 1.0 - 0.25 * old;
        wanted["sn-ls"] += 2.4 * old;
        wanted["sn-sto"] = wanted["sn-ls"] + wanted["ls-sto"] - 1.0;
        wanted["sn-c"] *= 1.0 - 0.06 * old;
    }
    return wanted;
}

namespace {

/// Free coordinates: y and z of midline landmarks, x, y and z of the left ones of pairs.
struct Layout {
    std::vector<std::string> middle, paired;

    explicit Layout(const Landmarks& landmarks) {
        for (const auto& [name, landmark] : landmarks) {
            if (name.ends_with("_l")) {
                paired.push_back(name.substr(0, name.size() - 2));
            } else if (!name.ends_with("_r")) {
                middle.push_back(name);
            }
        }
    }
    Eigen::Index size() const {
        return static_cast<Eigen::Index>(2 * middle.size() + 3 * paired.size());
    }
    Eigen::VectorXd pack(const Landmarks& landmarks) const {
        Eigen::VectorXd x(size());
        Eigen::Index i = 0;
        for (const std::string& name : middle) {
            x.segment<2>(i) = landmarks.at(name).position.tail<2>();
            i += 2;
        }
        for (const std::string& name : paired) {
            x.segment<3>(i) = landmarks.at(name + "_l").position;
            i += 3;
        }
        return x;
    }
    void unpack(const Eigen::VectorXd& x, Landmarks& landmarks) const {
        Eigen::Index i = 0;
        for (const std::string& name : middle) {
            landmarks[name].position.tail<2>() = x.segment<2>(i);
            i += 2;
        }
        for (const std::string& name : paired) {
            const Vec3 p = x.segment<3>(i);
            landmarks[name + "_l"].position = p;
            landmarks[name + "_r"].position = {-p.x(), p.y(), p.z()};
            i += 3;
        }
    }
};

/// Landmarks that lie close together move alike.
constexpr std::array<std::pair<const char*, const char*>, 29> kNeighbours{{
    {"g", "n"},         {"n", "se"},      {"se", "prn"},    {"prn", "c"},        {"c", "sn"},
    {"sn", "ls"},       {"ls", "sto"},    {"sto", "li"},    {"li", "sl"},        {"sl", "pg"},
    {"pg", "gn"},       {"en_l", "ex_l"}, {"se", "en_l"},   {"al_l", "ac_l"},    {"al_l", "prn"},
    {"ac_l", "sn"},     {"sbal_l", "sn"}, {"ch_l", "sto"},  {"cph_l", "ls"},     {"zy_l", "t_l"},
    {"go_l", "gn"},     {"go_l", "t_l"},  {"tr", "g"},      {"ft_l", "g"},       {"zy_l", "ex_l"},
    {"sbal_l", "ac_l"}, {"ch_l", "li"},   {"ft_l", "ex_l"}, {"cph_l", "sbal_l"},
}};

}  // namespace

Landmarks with_measures(const Landmarks& from, const WantedMeasures& wanted) {
    const Layout layout(from);
    const Eigen::VectorXd start = layout.pack(from);
    std::vector<std::pair<Measure, double>> goals;
    for (const Norm& norm : norms(std::nullopt, 20.0)) {
        const auto found = wanted.find(norm.measure.id);
        if (found != wanted.end()) {
            goals.emplace_back(norm.measure, found->second);
        }
    }
    constexpr double kGoal = 0.05;       // [mm], [deg]: met this well
    constexpr double kWay = 9.0;         // [mm]: a landmark may go
    constexpr double kDifference = 3.0;  // [mm]: between neighbours
    Landmarks moved = from;
    const auto residuals = [&](const Eigen::VectorXd& x) {
        layout.unpack(x, moved);
        std::vector<double> r;
        for (const auto& [measure, value] : goals) {
            r.push_back((measured(measure, moved).value_or(value) - value) / kGoal);
        }
        for (const auto& [a, b] : kNeighbours) {
            const Vec3 d = (moved.at(a).position - from.at(a).position) -
                           (moved.at(b).position - from.at(b).position);
            for (const double v : {d.x(), d.y(), d.z()}) {
                r.push_back(v / kDifference);
            }
        }
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            r.push_back((x[i] - start[i]) / kWay);
        }
        return Eigen::Map<const Eigen::VectorXd>(r.data(), static_cast<Eigen::Index>(r.size()))
            .eval();
    };
    // Gauss-Newton; the regularising terms keep it well-posed.
    Eigen::VectorXd x = start;
    for (int round = 0; round < 12; ++round) {
        const Eigen::VectorXd r = residuals(x);
        Eigen::MatrixXd jacobian(r.size(), x.size());
        constexpr double kStep = 1e-5;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            Eigen::VectorXd ahead = x;
            ahead[i] += kStep;
            jacobian.col(i) = (residuals(ahead) - r) / kStep;
        }
        const Eigen::VectorXd step =
            (jacobian.transpose() * jacobian).ldlt().solve(jacobian.transpose() * r);
        x -= step;
        if (step.norm() < 1e-6) {
            break;
        }
    }
    layout.unpack(x, moved);
    return moved;
}

}  // namespace myoface
