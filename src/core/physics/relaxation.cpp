// SPDX-License-Identifier: Apache-2.0
#include "relaxation.h"

#include <algorithm>
#include <cmath>

#include "myoface/base/parallel.h"

#include "node_force.h"

namespace myoface {
namespace {

constexpr int kColdIterations = 20;
constexpr int kLookEvery = 5;         // iterations between looks at convergence
constexpr double kMassSafety = 1.15;  // over Gershgorin's bound for a unit step
constexpr double kRunaway = 200.0;    // no tissue moves that far [mm]
constexpr double kLongestStep = 5.0;  // [mm] springs far beyond their limit grow too stiff at once
constexpr double kSmoothingDamping = 1.0;  // critical for a tenth of the stiffest
constexpr double kEnergyRise = 1e-5;       // of the energy: rounding
constexpr int kLayerGrain = 384;

/// Velocity after one unit step under force f.
Vec3 stepped(const Vec3& v, const Vec3& f, double mass, double damping) {
    return ((2.0 - damping) * v + (2.0 / mass) * f) / (2.0 + damping);
}

Vec3 way_of(const LargeArray<NodeRecord>& records, int row) {
    const float* moved = records[static_cast<std::size_t>(row)].moved;
    return {moved[0], moved[1], moved[2]};
}

void add_way(LargeArray<NodeRecord>& records, int row, const Vec3& way) {
    for (int axis = 0; axis < 3; ++axis) {
        records[static_cast<std::size_t>(row)].moved[axis] += static_cast<float>(way[axis]);
    }
}

}  // namespace

Relaxation::Relaxation(const MassSpringModel& model)
    : packed_(model), records_(packed_.resting_records()), next_(packed_.resting_records()) {
    const auto slices = static_cast<std::size_t>(packed_.slices);
    for (auto* lanes : {&force_, &last_force_, &velocity_}) {
        lanes->reset(slices);
    }
    mass_.reset(slices);
    sums_.resize(slices / kSliceGrain + 1);
}

void Relaxation::set_drive(const Drive& drive) {
    packed_.set_drive(drive);
    renew_masses();
}

void Relaxation::cold_start(bool smoothing, bool layer) {
    for (auto* lanes : {&last_force_, &velocity_}) {
        std::fill(lanes->begin(), lanes->end(), VectorLanes{});
    }
    const int skin = layer ? packed_.model.skin_nodes : 0;
    layer_sums_ = {};
    layer_velocity_ = layer_force_ = layer_last_force_ = Points::Zero(3, skin);
    damping_ = smoothing ? kSmoothingDamping : 0.1;
    since_cold_ = smoothing ? kColdIterations : 0;
    warm_ = true;
}

void Relaxation::scale_masses(const Hands& hands, const Drive& drive, bool layer) {
    const MassSpringModel& model = packed_.model;
    // A unit step is stable while ω² = Σ|K|/M stays below 4.
    constexpr double kScale = kMassSafety / 4.0;
    packed_.row_sums(records_, mass_);
    for (const RowPull& pull : hands.pulls) {
        for (std::size_t k = 0; k < pull.rows.size(); ++k) {
            of_row(mass_, pull.rows[k]) +=
                static_cast<float>(pull.hand->stiffness * pull.hand->weights[k]);
        }
    }
    if (layer) {
        layer_mass_.resize(model.skin_nodes);
        const LinearStiffness& links = model.layer.links;
        for (int i = 0; i < model.skin_nodes; ++i) {
            const double boost = drive.tether_boost.size() > 0 ? drive.tether_boost[i] : 1.0;
            double sum = model.ties[i].tether * (1.0 + 2.0 * boost);
            for (int e = links.start[i]; e < links.start[i + 1]; ++e) {
                sum += std::abs(links.value[e]);
            }
            layer_mass_[i] = std::max(kScale * sum, 1e-9);
            of_row(mass_, packed_.row_of[i]) += static_cast<float>(model.ties[i].tether * boost);
        }
    }
    for (int r = 0; r < packed_.slices * kLanes; ++r) {
        const int node = packed_.node_of[r];
        float& mass = of_row(mass_, r);
        mass = node < 0 || model.fixed[node] != 0
                   ? 0.0F
                   : std::max(static_cast<float>(kScale) * mass, 1e-9F);
    }
}

Eigen::Vector2d Relaxation::pull_force(const LargeArray<NodeRecord>& records,
                                       const RowPull& pull) const {
    const HandPull& hand = *pull.hand;
    if (hand.force) {
        return *hand.force;
    }
    Vec3 grip = Vec3::Zero();
    for (std::size_t k = 0; k < pull.grip_rows.size(); ++k) {
        grip += hand.grip_weights[k] * way_of(records, pull.grip_rows[k]);
    }
    const Eigen::Vector2d gap = pull.target - hand.plane.transpose() * grip;
    const double distance = gap.norm();
    if (!(distance > 0.0)) {
        return Eigen::Vector2d::Zero();
    }
    const double size = hand.largest * std::tanh(hand.stiffness * distance / hand.largest);
    return size / distance * gap;
}

/// One step of all nodes into next_. @return energy before it
double Relaxation::advance(bool smoothing, bool with_energy) {
    StepTask work{};
    work.force = force_.data();
    work.last_force = last_force_.data();
    work.velocity = velocity_.data();
    work.mass = mass_.data();
    work.from = records_.data();
    work.to = next_.data();
    work.keep = static_cast<float>((2.0 - damping_) / (2.0 + damping_));
    work.push = static_cast<float>(2.0 / (2.0 + damping_));
    work.longest = static_cast<float>(kLongestStep);
    const double energy =
        packed_.forces_then(records_, force_, with_energy, [&](int begin, int end) {
            auto at = std::lower_bound(hand_rows_.begin(), hand_rows_.end(), begin * kLanes,
                                       [](const HandRow& h, int row) { return h.row < row; });
            for (; at != hand_rows_.end() && at->row < end * kLanes; ++at) {
                set_row(force_, at->row, of_row(force_, at->row) + at->force);
            }
            sums_[begin / kSliceGrain] = lane_kernels().step(work, begin, end);
        });
    StepSums total{};
    for (int chunk = 0; chunk * kSliceGrain < packed_.slices; ++chunk) {
        total.residual += sums_[chunk].residual;
        total.curvature += sums_[chunk].curvature;
        total.kinetic += sums_[chunk].kinetic;
        total.wanted = sums_[chunk].wanted <= total.wanted ? total.wanted : sums_[chunk].wanted;
    }
    wanted_step_ = std::sqrt(total.wanted);
    residual_ = total.residual;
    step_damping_ = damping_;
    total.curvature += layer_sums_.curvature;
    total.kinetic += layer_sums_.kinetic;
    // The damping that is critical for the slowest motion seen in the last step.
    if (smoothing) {
        damping_ = kSmoothingDamping;
    } else if (total.kinetic > 0.0) {
        const double slowest = std::clamp(total.curvature / total.kinetic, 0.0, 0.9);
        damping_ = std::clamp(2.0 * std::sqrt(slowest), 0.004, 1.9);
    }
    return energy;
}

void Relaxation::advance_layer(const Drive& drive, const Points& layer) {
    const MassSpringModel& model = packed_.model;
    layer_next_ = layer;
    parallel_for(model.skin_nodes, kLayerGrain, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            if (model.fixed[i] != 0) {
                continue;
            }
            const Vec3 f = layer_node_force(model, positions_, layer, drive, i);
            const Vec3 v = stepped(layer_velocity_.col(i), f, layer_mass_[i], step_damping_);
            layer_force_.col(i) = f;
            layer_velocity_.col(i) = v;
            layer_next_.col(i) += v;
        }
    });
    residual_ += layer_force_.squaredNorm();
    layer_sums_.curvature = layer_velocity_.cwiseProduct(layer_last_force_ - layer_force_).sum();
    layer_sums_.kinetic =
        (layer_velocity_.colwise().squaredNorm() * layer_mass_.head(model.skin_nodes)).value();
    layer_last_force_ = layer_force_;
}

void Relaxation::list_hand_rows(const Hands& hands) {
    std::vector<HandRow> listed;
    const auto add = [&](const std::vector<int>& rows, int hand) {
        for (std::size_t k = 0; k < rows.size(); ++k) {
            listed.push_back({rows[k], hand, k, Vec3::Zero()});
        }
    };
    int hand = 0;
    for (const RowPull& pull : hands.pulls) {
        add(pull.rows, hand++);
    }
    for (const RowHandle& handle : hands.handles) {
        add(handle.rows, hand++);
    }
    std::stable_sort(listed.begin(), listed.end(),
                     [](const HandRow& a, const HandRow& b) { return a.row < b.row; });
    const bool same = std::equal(
        listed.begin(), listed.end(), hand_rows_.begin(), hand_rows_.end(),
        [](const HandRow& a, const HandRow& b) { return a.row == b.row && a.hand == b.hand; });
    hand_rows_.swap(listed);
    if (!same || hand_rows_.empty() || reactions_.size() != hands.handles.size()) {
        // Other hands: what they would hold here.
        reactions_.clear();
        free_forces(records_, hands, force_, &reactions_);
    }
    reactions_.resize(hands.handles.size(), Vec3::Zero());
    for (std::size_t h = 0; h < reactions_.size(); ++h) {  // the view may have turned
        const auto& plane = hands.handles[h].plane;
        reactions_[h] = plane * (plane.transpose() * reactions_[h]);
    }
}

/// What the hands do in the step to come: a pull by where its grip is, a handle what it held last.
void Relaxation::hands_act(const Hands& hands) {
    hand_forces_.clear();
    for (const RowPull& pull : hands.pulls) {
        hand_forces_.push_back(pull.hand->plane * pull_force(records_, pull));
    }
    const auto pulls = static_cast<int>(hands.pulls.size());
    for (HandRow& at : hand_rows_) {
        if (!is_free(at.row)) {
            at.force.setZero();
        } else if (at.hand < pulls) {
            const auto h = static_cast<std::size_t>(at.hand);
            const HandPull& hand = *hands.pulls[h].hand;
            at.force = hand.skin_share * part_of(hand, at.part, hand_forces_[h]);
        } else {
            const auto h = static_cast<std::size_t>(at.hand - pulls);
            at.force = hands.handles[h].weights[at.part] * reactions_[h];
        }
    }
}

void Relaxation::pull_layer(const HandPull& hand, const Vec3& force) {
    for (std::size_t k = 0; k < hand.layer_nodes.size(); ++k) {
        const int i = hand.layer_nodes[k];
        if (packed_.model.fixed[i] == 0) {
            const Vec3 part = hand.layer_share * hand.layer_weights[k] * force;
            residual_ +=
                (layer_force_.col(i) + part).squaredNorm() - layer_force_.col(i).squaredNorm();
            const Vec3 kick = 2.0 / (layer_mass_[i] * (2.0 + step_damping_)) * part;
            layer_velocity_.col(i) += kick;
            layer_next_.col(i) += kick;
        }
    }
}

/// Puts what a handle holds where it is wanted. @param reaction what that takes, of all steps
void Relaxation::hold(const RowHandle& handle, Vec3& reaction) {
    double compliance = 0.0;  // Σ w²/M
    Vec3 centre = Vec3::Zero();
    for (std::size_t k = 0; k < handle.rows.size(); ++k) {
        const int row = handle.rows[k];
        centre += handle.weights[k] * way_of(next_, row);
        if (is_free(row)) {
            compliance += handle.weights[k] * handle.weights[k] / of_row(mass_, row);
        }
    }
    if (!(compliance > 0.0)) {
        hand_forces_.emplace_back(Vec3::Zero());
        return;
    }
    const Vec3 error = handle.plane * (handle.target - handle.plane.transpose() * centre);
    const Vec3 more = 0.5 * (2.0 + step_damping_) / compliance * error;
    reaction += more;
    hand_forces_.push_back(reaction);
    for (std::size_t k = 0; k < handle.rows.size(); ++k) {
        const int row = handle.rows[k];
        if (is_free(row)) {
            const Vec3 move = handle.weights[k] / (of_row(mass_, row) * compliance) * error;
            add_way(next_, row, move);
            set_row(velocity_, row, of_row(velocity_, row) + move);
            // The held nodes are not out of balance by what the hand holds.
            const Vec3 f = of_row(last_force_, row);
            residual_ += (f + handle.weights[k] * more).squaredNorm() - f.squaredNorm();
        }
    }
}

void Relaxation::free_forces(const LargeArray<NodeRecord>& records, const Hands& hands,
                             LargeArray<VectorLanes>& out, std::vector<Vec3>* held) const {
    packed_.forces(records, out, false);
    for (const RowPull& pull : hands.pulls) {
        const Vec3 f = pull.hand->plane * pull_force(records, pull);
        for (std::size_t k = 0; k < pull.rows.size(); ++k) {
            const Vec3 part = pull.hand->skin_share * part_of(*pull.hand, k, f);
            set_row(out, pull.rows[k], of_row(out, pull.rows[k]) + part);
        }
    }
    const auto is_fixed = [&](int row) {
        const int node = packed_.node_of[row];
        return node < 0 || packed_.model.fixed[node] != 0;
    };
    for (const RowHandle& handle : hands.handles) {
        Vec3 sum = Vec3::Zero();
        double square = 0.0;
        for (std::size_t k = 0; k < handle.rows.size(); ++k) {
            if (!is_fixed(handle.rows[k])) {
                sum += handle.weights[k] * of_row(out, handle.rows[k]);
                square += handle.weights[k] * handle.weights[k];
            }
        }
        if (!(square > 0.0)) {
            if (held != nullptr) {
                held->emplace_back(Vec3::Zero());
            }
            continue;
        }
        const Vec3 taken = handle.plane * (handle.plane.transpose() * sum) / square;
        for (std::size_t k = 0; k < handle.rows.size(); ++k) {
            const int row = handle.rows[k];
            set_row(out, row, of_row(out, row) - handle.weights[k] * taken);
        }
        if (held != nullptr) {
            held->push_back(-taken);
        }
    }
    for (int r = 0; r < packed_.slices * kLanes; ++r) {
        if (is_fixed(r)) {
            set_row(out, r, Vec3::Zero());
        }
    }
}

double Relaxation::largest_step() const {
    float largest = 0.0F;
    bool finite = true;
    for (int s = 0; s < packed_.slices; ++s) {
        const VectorLanes& v = velocity_[static_cast<std::size_t>(s)];
        for (int k = 0; k < kLanes; ++k) {
            const float square =
                v.v[0][k] * v.v[0][k] + v.v[1][k] * v.v[1][k] + v.v[2][k] * v.v[2][k];
            finite = finite && square < 1e30F;  // false for what is no number
            largest = square > largest ? square : largest;
        }
    }
    return finite ? std::sqrt(static_cast<double>(largest)) : 2.0 * kRunaway;
}

RelaxReport Relaxation::run(const RelaxOptions& options, const Hands& hands, bool smoothing,
                            const Drive& drive, Points* layer) {
    if (!warm_ || (layer != nullptr && layer_velocity_.cols() == 0)) {
        cold_start(smoothing, layer != nullptr);
        since_masses_ = kMassesEvery;
    }
    list_hand_rows(hands);
    RelaxReport report;
    int still = 0;
    double energy = 0.0;
    for (int k = 0; k < options.iterations; ++k) {
        // A cold start may be far from rest: stretched springs are stiff and change quickly.
        if (since_cold_ < kColdIterations || since_masses_ >= kMassesEvery ||
            (k == 0 && (!hands.pulls.empty() || layer != nullptr))) {
            scale_masses(hands, drive, layer != nullptr);
            since_masses_ = 0;
        }
        ++since_cold_;
        ++since_masses_;
        hands_act(hands);
        if (layer != nullptr) {
            positions_ = packed_.model.rest;
            packed_.take(records_, positions_);
            packed_.set_shift(drive, *layer);
        }
        const double before = energy;
        const bool weighed = k == 0 || (!smoothing && k % kLookEvery == 0);
        const double now = advance(smoothing, weighed);
        energy = weighed ? now : energy;
        if (k == 0) {
            first_energy_ = energy;
        } else if (weighed && !smoothing && hands.pulls.empty() && layer == nullptr &&
                   energy > before + kEnergyRise * std::abs(before)) {
            // Uphill: momentum has carried it past the valley. On from here without.
            std::fill(velocity_.begin(), velocity_.end(), VectorLanes{});
            still = -1;
        }
        if (layer != nullptr) {
            advance_layer(drive, *layer);
        }
        for (std::size_t h = 0; h < hands.pulls.size() && layer != nullptr; ++h) {
            pull_layer(*hands.pulls[h].hand, hand_forces_[h]);
        }
        for (std::size_t h = 0; h < hands.handles.size(); ++h) {
            hold(hands.handles[h], reactions_[h]);
        }
        const bool look = k % kLookEvery == kLookEvery - 1 || k + 1 == options.iterations;
        if (look) {
            report.last_step = largest_step();
            if (layer != nullptr) {
                report.last_step =
                    std::max(report.last_step,
                             std::sqrt((layer_next_ - *layer).colwise().squaredNorm().maxCoeff()));
            }
        }
        records_.swap(next_);
        if (layer != nullptr) {
            layer->swap(layer_next_);
        }
        ++report.iterations;
        if (!look) {
            continue;
        }
        if (!(report.last_step < kRunaway) || !(wanted_step_ < kRunaway)) {
            report.finite = false;
            restart();
            break;
        }
        still = report.last_step < options.still_mm ? still + 1 : 0;
        if (still >= 2) {
            report.converged = true;
            break;
        }
    }
    report.residual = std::sqrt(std::max(residual_, 0.0) / std::max(packed_.nodes, 1));
    return report;
}

}  // namespace myoface
