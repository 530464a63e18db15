// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/packed_model.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "myoface/base/parallel.h"

#include "packed_data.h"

namespace myoface {
namespace {

constexpr int kWindow = 256;           // rows sorted by their number of neighbours
constexpr int kPaddingColumns = 40;    // that prefetching may look at
constexpr int kBeyondCache = 150'000;  // nodes
constexpr double kNoLength = 1e-6;     // [mm]
constexpr double kNothing = 1e-9;      // of a row's stiffness: rounding
constexpr float kNoBarrier = 1e30F;
constexpr double kNearBarrier = 0.5;  // [mm] it may be met in the next step

std::atomic<const LaneKernels*> chosen_kernels{nullptr};

/// Bits of three coordinates, interleaved. @cite morton_1966
std::uint64_t morton_code(const Eigen::Matrix<std::uint32_t, 3, 1>& cell) {
    std::uint64_t code = 0;
    for (int bit = 0; bit < 20; ++bit) {
        for (int axis = 0; axis < 3; ++axis) {
            code |= static_cast<std::uint64_t>(cell[axis] >> bit & 1U) << (3 * bit + axis);
        }
    }
    return code;
}

std::vector<std::uint64_t> morton_codes(const Points& points) {
    const Vec3 low = points.rowwise().minCoeff();
    const double span = std::max((points.rowwise().maxCoeff() - low).maxCoeff(), 1e-9);
    std::vector<std::uint64_t> codes(static_cast<std::size_t>(points.cols()));
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
        const Vec3 cell = (points.col(i) - low) * (1048575.0 / span);
        codes[i] = morton_code(cell.cast<std::uint32_t>());
    }
    return codes;
}

/// Distance at rest as the kernels see it.
float packed_distance(const MassSpringModel& model, const Spring& spring) {
    float r[3];
    for (int axis = 0; axis < 3; ++axis) {
        r[axis] = static_cast<float>(model.rest(axis, spring.a)) -
                  static_cast<float>(model.rest(axis, spring.b));
    }
    return std::sqrt(std::max(r[0] * r[0] + r[1] * r[1] + r[2] * r[2], 1e-30F));
}

/// A natural length by as much off the rounded distance at rest as it is off the true one: no
/// spring pulls at rest because of rounding.
float packed_length(const MassSpringModel& model, const Spring& spring, double natural) {
    const double distance = (model.rest.col(spring.a) - model.rest.col(spring.b)).norm();
    return packed_distance(model, spring) + static_cast<float>(natural - distance);
}

}  // namespace

const LaneKernels& lane_kernels() {
    if (const LaneKernels* chosen = chosen_kernels.load(std::memory_order_relaxed)) {
        return *chosen;
    }
#ifdef MYOFACE_AVX2_KERNELS
    static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    if (has_avx2) {
        return avx2_kernels();
    }
#endif
    return portable_kernels();
}

void use_kernels(const LaneKernels* kernels) {
    chosen_kernels.store(kernels);
}

const char* kernel_name() {
    return lane_kernels().name;
}

PackedModel::Data::Data(const MassSpringModel& of) : model(of), nodes(of.node_count()) {
    tissue = std::any_of(model.stretch.begin(), model.stretch.end(), [](const Stretch& s) {
        return s.stiffening > 0.0 || s.limit < Stretch{}.limit;
    });
    order_rows();
    fill_columns();
    fill_ties();
    targets.reset(static_cast<std::size_t>(slices));
    loads.reset(static_cast<std::size_t>(slices));
    set_drive({});
}

/// Skin along a Morton curve, then the muscles' chains; within windows the busiest first, so that
/// rows of one slice have about as many neighbours.
void PackedModel::Data::order_rows() {
    const std::vector<std::uint64_t> codes = morton_codes(model.rest);
    const int skin = model.skin_nodes > 0 ? model.skin_nodes : nodes;
    std::vector<int> degree(static_cast<std::size_t>(nodes));
    for (int i = 0; i < nodes; ++i) {
        degree[i] = model.spring_start[i + 1] - model.spring_start[i] + model.linear.start[i + 1] -
                    model.linear.start[i];
    }
    std::vector<int> order(static_cast<std::size_t>(nodes));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.begin() + skin,
                     [&](int a, int b) { return codes[a] < codes[b]; });
    const auto busier = [&](int a, int b) { return degree[a] > degree[b]; };
    for (int begin = 0; begin < skin; begin += kWindow) {
        std::stable_sort(order.begin() + begin, order.begin() + std::min(begin + kWindow, skin),
                         busier);
    }
    std::stable_sort(order.begin() + skin, order.end(), busier);
    slices = (nodes + kLanes - 1) / kLanes;
    node_of = std::move(order);
    node_of.resize(static_cast<std::size_t>(slices) * kLanes, -1);
    row_of.assign(static_cast<std::size_t>(nodes), 0);
    for (int r = 0; r < nodes; ++r) {
        row_of[node_of[r]] = r;
    }
}

void PackedModel::Data::fill_columns() {
    struct Neighbour {
        int row = 0, spring = -1;
        double linear = 0.0;
    };
    spring_start.assign(1, 0);
    link_start.assign(1, 0);
    std::vector<std::array<Neighbour, kLanes>> with_spring, linked;
    std::array<std::vector<Neighbour>, kLanes> near, far;
    linear_ground_.reset(static_cast<std::size_t>(slices));
    for (int s = 0; s < slices; ++s) {
        std::size_t most_near = 0;
        std::size_t most_far = 0;
        for (int lane = 0; lane < kLanes; ++lane) {
            near[lane].clear();
            far[lane].clear();
            const int i = node_of[s * kLanes + lane];
            if (i < 0) {
                continue;
            }
            for (int e = model.spring_start[i]; e < model.spring_start[i + 1]; ++e) {
                const SpringEnd& end = model.spring_ends[e];
                if (model.springs[end.spring].length > kNoLength) {
                    near[lane].push_back({row_of[end.other], end.spring, 0.0});
                } else {  // without a length of its own it is linear
                    far[lane].push_back({row_of[end.other], -1, -end.stiffness});
                }
            }
            double row_sum = 0.0;
            double row_size = 0.0;
            for (int e = model.linear.start[i]; e < model.linear.start[i + 1]; ++e) {
                const int j = model.linear.column[e];
                row_sum += model.linear.value[e];
                row_size += std::abs(model.linear.value[e]);
                if (j == i) {
                    continue;
                }
                const int row = row_of[j];
                const auto spring = std::find_if(near[lane].begin(), near[lane].end(),
                                                 [&](const auto& n) { return n.row == row; });
                if (spring != near[lane].end()) {
                    spring->linear += model.linear.value[e];
                } else {
                    far[lane].push_back({row, -1, model.linear.value[e]});
                }
            }
            if (std::abs(row_sum) > kNothing * row_size) {
                linear_ground_[s].s[lane] = static_cast<float>(row_sum);
            }
            const auto by_row = [](const auto& a, const auto& b) { return a.row < b.row; };
            std::stable_sort(near[lane].begin(), near[lane].end(), by_row);
            std::stable_sort(far[lane].begin(), far[lane].end(), by_row);
            most_near = std::max(most_near, near[lane].size());
            most_far = std::max(most_far, far[lane].size());
        }
        const auto columns = [&](const auto& rows, std::size_t count, auto& out) {
            for (std::size_t c = 0; c < count; ++c) {
                auto& column = out.emplace_back();
                for (int lane = 0; lane < kLanes; ++lane) {
                    column[lane] = c < rows[lane].size() ? rows[lane][c]
                                                         : Neighbour{s * kLanes + lane, -1, 0.0};
                }
            }
        };
        columns(near, most_near, with_spring);
        columns(far, most_far, linked);
        spring_start.push_back(static_cast<int>(with_spring.size()));
        link_start.push_back(static_cast<int>(linked.size()));
    }
    springs.reset(with_spring.size() + kPaddingColumns);
    linear.reset(springs.size());
    links.reset(linked.size());
    spring_places_.assign(model.springs.size(), {-1, -1});
    for (std::size_t c = 0; c < with_spring.size(); ++c) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const Neighbour& n = with_spring[c][lane];
            springs[c].other[lane] = n.row;
            linear[c].s[lane] = static_cast<float>(n.linear);
            tissue = tissue || n.linear != 0.0;
            springs[c].length[lane] = 1.0F;
            if (n.spring >= 0) {
                const Spring& spring = model.springs[n.spring];
                springs[c].stiffness[lane] = static_cast<float>(spring.stiffness);
                springs[c].length[lane] = packed_length(model, spring, spring.length);
                auto& [first, second] = spring_places_[n.spring];
                (first < 0 ? first : second) = static_cast<int>(c) * kLanes + lane;
            }
        }
    }
    for (std::size_t c = 0; c < linked.size(); ++c) {
        for (int lane = 0; lane < kLanes; ++lane) {
            links[c].other[lane] = linked[c][lane].row;
            links[c].value[lane] = static_cast<float>(linked[c][lane].linear);
        }
    }
}

void PackedModel::Data::fill_ties() {
    ties.reset(static_cast<std::size_t>(slices));
    for (int r = 0; r < slices * kLanes; ++r) {
        const int i = node_of[r];
        TieLanes& lanes = ties[r / kLanes];
        const int k = r % kLanes;
        lanes.stop[k] = 1e3F;
        if (i < 0) {
            continue;
        }
        const Tie& tie = model.ties[i];
        for (int axis = 0; axis < 3; ++axis) {
            lanes.normal[axis][k] = static_cast<float>(tie.normal[axis]);
        }
        const Mat3& q = tie.curvature;
        const std::array<double, 6> parts{q(0, 0), q(1, 1), q(2, 2), q(0, 1), q(0, 2), q(1, 2)};
        for (int p = 0; p < 6; ++p) {
            lanes.curvature[p][k] = static_cast<float>(parts[p]);
        }
        lanes.thickness[k] = static_cast<float>(tie.thickness);
        lanes.anchor[k] = static_cast<float>(tie.anchor);
        lanes.stop[k] = static_cast<float>(tie.stop);
        sliding = sliding || tie.thickness > 0.0 || tie.tether > 0.0;
    }
    for (const Contact& contact : model.contacts) {
        for (const bool first : {true, false}) {
            ContactEnd end;
            end.row = row_of[first ? contact.a : contact.b];
            end.other = row_of[first ? contact.b : contact.a];
            end.sign = first ? 1.0F : -1.0F;
            end.stiffness = static_cast<float>(contact.stiffness);
            end.apart = static_cast<float>(
                contact.normal.dot(model.rest.col(contact.a) - model.rest.col(contact.b)) -
                contact.gap);
            end.gap = static_cast<float>(contact.gap);
            for (int axis = 0; axis < 3; ++axis) {
                end.normal[axis] = static_cast<float>(contact.normal[axis]);
            }
            contacts_.push_back(end);
        }
    }
    std::stable_sort(contacts_.begin(), contacts_.end(),
                     [](const ContactEnd& a, const ContactEnd& b) { return a.row < b.row; });
    if (!model.barriers.stiffness.empty()) {
        clear_.assign(static_cast<std::size_t>(slices) * kLanes, kNoBarrier);
        for (int r = 0; r < nodes; ++r) {
            const int i = node_of[r];
            if (model.barriers.stiffness[i] > 0.0 && model.fixed[i] == 0) {
                const double clear = model.barriers.clear[i];
                clear_[r] = static_cast<float>(clear * clear);
            }
        }
    }
}

void PackedModel::Data::set_drive(const Drive& drive) {
    const bool factored = !drive.length_factor.empty() || !drive.stiffness_factor.empty();
    if (factored || factored_) {
        for (std::size_t s = 0; s < model.springs.size(); ++s) {
            const Spring& spring = model.springs[s];
            const float length =
                packed_length(model, spring,
                              drive.length_factor.empty() ? spring.length
                                                          : spring.length * drive.length_factor[s]);
            const auto stiffness = static_cast<float>(
                drive.stiffness_factor.empty() ? spring.stiffness
                                               : spring.stiffness * drive.stiffness_factor[s]);
            if (spring_places_[s].first < 0) {
                continue;
            }
            for (const int place : {spring_places_[s].first, spring_places_[s].second}) {
                springs[place / kLanes].length[place % kLanes] = length;
                springs[place / kLanes].stiffness[place % kLanes] = stiffness;
            }
        }
    }
    factored_ = factored;
    pose_ = drive.obstacle_pose;
    unposed_.clear();
    for (const Eigen::Isometry3d& pose : pose_) {
        unposed_.push_back(pose.inverse());
    }
    targeted = drive.carry.cols() > 0 || drive.shift.cols() > 0 || drive.height.size() > 0;
    for (int r = 0; r < nodes; ++r) {
        const int i = node_of[r];
        const int k = r % kLanes;
        const auto s = static_cast<std::size_t>(r / kLanes);
        const double boost = drive.tether_boost.size() > 0 ? drive.tether_boost[i] : 1.0;
        ties[s].tether[k] = static_cast<float>(model.ties[i].tether * boost);
        for (int axis = 0; axis < 3; ++axis) {
            targets[s].carry[axis][k] =
                drive.carry.cols() > 0 ? static_cast<float>(drive.carry(axis, i)) : 0.0F;
            targets[s].shift[axis][k] =
                drive.shift.cols() > 0 ? static_cast<float>(drive.shift(axis, i)) : 0.0F;
        }
        targets[s].height[k] = drive.height.size() > 0 ? static_cast<float>(drive.height[i]) : 0.0F;
    }
    set_loads(drive);
}

void PackedModel::Data::set_loads(const Drive& drive) {
    const Vec3 gravity = drive.gravity - model.rest_gravity;
    loaded = drive.load.cols() > 0 || drive.inertia.size() > 0 || gravity != Vec3::Zero() ||
             std::any_of(linear_ground_.data(), linear_ground_.data() + linear_ground_.size(),
                         [](const ScalarLanes& lanes) {
                             return std::any_of(lanes.s, lanes.s + kLanes,
                                                [](float g) { return g != 0.0F; });
                         });
    for (int r = 0; r < nodes; ++r) {
        const int i = node_of[r];
        const int k = r % kLanes;
        const auto s = static_cast<std::size_t>(r / kLanes);
        Vec3 force = model.mass[i] * gravity;
        if (drive.load.cols() > 0) {
            force += drive.load.col(i);
        }
        loads[s].ground[k] = linear_ground_[s].s[k];
        if (drive.inertia.size() > 0) {
            force += drive.inertia[i] * drive.ahead.col(i);
            loads[s].ground[k] += static_cast<float>(drive.inertia[i]);
        }
        for (int axis = 0; axis < 3; ++axis) {
            loads[s].force[axis][k] = static_cast<float>(force[axis]);
        }
    }
}

void PackedModel::Data::set_shift(const Drive& drive, const Points& layer) {
    targeted = true;
    for (int i = 0; i < model.skin_nodes; ++i) {
        const int r = row_of[i];
        for (int axis = 0; axis < 3; ++axis) {
            const double shift = drive.shift.cols() > 0 ? drive.shift(axis, i) : 0.0;
            targets[r / kLanes].shift[axis][r % kLanes] =
                static_cast<float>(shift + layer(axis, i));
        }
    }
}

LargeArray<NodeRecord> PackedModel::Data::resting_records() const {
    LargeArray<NodeRecord> records(static_cast<std::size_t>(slices) * kLanes);
    for (int r = 0; r < nodes; ++r) {
        const int i = node_of[r];
        for (int axis = 0; axis < 3; ++axis) {
            records[r].place[axis] = static_cast<float>(model.rest(axis, i));
        }
        records[r].limit = static_cast<float>(model.stretch[i].limit);
        records[r].stiffening = static_cast<float>(model.stretch[i].stiffening);
    }
    return records;
}

void PackedModel::Data::put(const Points& positions, LargeArray<NodeRecord>& records) const {
    for (int r = 0; r < nodes; ++r) {
        const int i = node_of[r];
        for (int axis = 0; axis < 3; ++axis) {
            records[r].moved[axis] = static_cast<float>(positions(axis, i) - model.rest(axis, i));
        }
    }
}

void PackedModel::Data::put_motion(const MassSpringState& state,
                                   LargeArray<NodeRecord>& records) const {
    for (int r = 0; r < nodes; ++r) {
        const int i = node_of[r];
        for (int axis = 0; axis < 3; ++axis) {
            records[r].place[axis] = static_cast<float>(state.positions(axis, i));
            records[r].moved[axis] = static_cast<float>(state.velocities(axis, i));
        }
    }
}

void PackedModel::Data::take(const LargeArray<NodeRecord>& records, Points& positions) const {
    for (int r = 0; r < nodes; ++r) {
        const int i = node_of[r];
        if (model.fixed[i] == 0) {
            for (int axis = 0; axis < 3; ++axis) {
                positions(axis, i) =
                    model.rest(axis, i) + static_cast<double>(records[r].moved[axis]);
            }
        }
    }
}

ForceTask PackedModel::Data::task(const LargeArray<NodeRecord>& records) const {
    ForceTask task{};
    task.records = records.data();
    task.spring_start = spring_start.data();
    task.link_start = link_start.data();
    task.springs = springs.data();
    task.links = links.data();
    task.linear = linear.data();
    task.ties = ties.data();
    task.targets = targeted ? targets.data() : nullptr;
    task.loads = loaded ? loads.data() : nullptr;
    task.damping = damping.data();
    task.tie_damping = tie_damping.data();
    task.linear_rest = linear_rest.empty() ? nullptr : linear_rest.data();
    task.rest = rest.data();
    task.tissue = tissue;
    task.sliding = sliding;
    task.prefetch = nodes > kBeyondCache;
    return task;
}

double PackedModel::Data::contact_forces(const LargeArray<NodeRecord>& records, bool in_motion,
                                         int begin_row, int end_row,
                                         LargeArray<VectorLanes>& out) const {
    double energy = 0.0;
    auto end = std::lower_bound(contacts_.begin(), contacts_.end(), begin_row,
                                [](const ContactEnd& c, int row) { return c.row < row; });
    for (; end != contacts_.end() && end->row < end_row; ++end) {
        const NodeRecord& here = records[end->row];
        const NodeRecord& there = records[end->other];
        float gap = in_motion ? -end->gap : end->apart;
        for (int axis = 0; axis < 3; ++axis) {
            const float way = in_motion ? here.place[axis] - there.place[axis]
                                        : here.moved[axis] - there.moved[axis];
            gap += end->sign * end->normal[axis] * way;
        }
        if (gap < 0.0F) {
            for (int axis = 0; axis < 3; ++axis) {
                of_row(out, end->row, axis) -= end->sign * end->stiffness * gap * end->normal[axis];
            }
            energy += 0.25 * static_cast<double>(end->stiffness * gap * gap);
        }
    }
    return energy;
}

template <typename Met>
void PackedModel::Data::each_barrier(const LargeArray<NodeRecord>& records, bool in_motion,
                                     int begin_row, int end_row, const Met& met) const {
    for (int r = begin_row; r < end_row && !clear_.empty(); ++r) {
        if (!(clear_[r] < kNoBarrier)) {
            continue;
        }
        const NodeRecord& record = records[r];
        const Vec3 moved = Eigen::Map<const Eigen::Vector3f>(record.moved).cast<double>();
        if (pose_.empty() && !in_motion && !(moved.squaredNorm() > clear_[r])) {
            continue;
        }
        const int i = node_of[r];
        const Vec3 place = Eigen::Map<const Eigen::Vector3f>(record.place).cast<double>();
        const Vec3 at = in_motion ? place : Vec3(model.rest.col(i) + moved);
        for (std::size_t o = 0; o < model.obstacles.size(); ++o) {
            const bool posed = !pose_.empty() && model.obstacles[o].with_jaw;
            const Vec3 p = posed ? Vec3(unposed_[o] * at) : at;
            // On a way as short as that from its rest it meets nothing.
            if (!((p - model.rest.col(i)).squaredNorm() > clear_[r])) {
                continue;
            }
            DistanceField::Sample sample = distance_to(model.obstacles[o], p);
            sample.distance -= model.barriers.margin(static_cast<Eigen::Index>(o), i);
            if (posed) {
                sample.slope = pose_[o].linear() * sample.slope;
            }
            met(r, model.barriers.stiffness[i], sample);
        }
    }
}

double PackedModel::Data::barrier_forces(const LargeArray<NodeRecord>& records, bool in_motion,
                                         int begin_row, int end_row,
                                         LargeArray<VectorLanes>& out) const {
    double energy = 0.0;
    each_barrier(records, in_motion, begin_row, end_row,
                 [&](int row, double stiffness, const DistanceField::Sample& sample) {
                     if (sample.distance < 0.0) {
                         const Vec3 push = -stiffness * sample.distance * sample.slope;
                         set_row(out, row, of_row(out, row) + push);
                         energy += 0.5 * stiffness * sample.distance * sample.distance;
                     }
                 });
    return energy;
}

void PackedModel::Data::row_sums(const LargeArray<NodeRecord>& records,
                                 LargeArray<ScalarLanes>& out) const {
    const ForceTask work = task(records);
    const LaneKernels& kernels = lane_kernels();
    parallel_for(slices, kSliceGrain,
                 [&](int begin, int end) { kernels.row_sums(work, begin, end, out.data()); });
    for (const ContactEnd& contact : contacts_) {
        of_row(out, contact.row) += 2.0F * contact.stiffness;
    }
    each_barrier(records, false, 0, slices * kLanes,
                 [&](int row, double stiffness, const DistanceField::Sample& sample) {
                     if (sample.distance < kNearBarrier) {
                         of_row(out, row) +=
                             static_cast<float>(stiffness * sample.slope.squaredNorm());
                     }
                 });
}

void PackedModel::Data::prepare_damping() {
    if (!damping.empty()) {
        return;
    }
    damping.reset(springs.size());
    for (std::size_t s = 0; s < model.springs.size(); ++s) {
        if (spring_places_[s].first < 0) {
            continue;
        }
        for (const int place : {spring_places_[s].first, spring_places_[s].second}) {
            damping[place / kLanes].s[place % kLanes] =
                static_cast<float>(model.springs[s].damping);
        }
    }
    tie_damping.reset(static_cast<std::size_t>(slices));
    rest.reset(static_cast<std::size_t>(slices));
    if (!model.linear.value.empty()) {
        linear_rest.reset(static_cast<std::size_t>(slices));
    }
    for (int r = 0; r < nodes; ++r) {
        const int i = node_of[r];
        of_row(tie_damping, r) = static_cast<float>(model.ties[i].damping);
        set_row(rest, r, model.rest.col(i));
        if (!linear_rest.empty()) {
            Vec3 sum = Vec3::Zero();
            for (int e = model.linear.start[i]; e < model.linear.start[i + 1]; ++e) {
                const int j = model.linear.column[e];
                sum -= model.linear.value[e] * (model.rest.col(i) - model.rest.col(j));
            }
            set_row(linear_rest, r, sum);
        }
    }
}

void PackedModel::Data::damped_forces(const LargeArray<NodeRecord>& records,
                                      LargeArray<VectorLanes>& out) const {
    const ForceTask work = task(records);
    const LaneKernels& kernels = lane_kernels();
    parallel_for(slices, kSliceGrain, [&](int begin, int end) {
        const FlushTiny flush;
        kernels.damped_forces(work, begin, end, out.data());
        contact_forces(records, true, begin * kLanes, end * kLanes, out);
        barrier_forces(records, true, begin * kLanes, end * kLanes, out);
    });
}

PackedModel::PackedModel(const MassSpringModel& model) : data_(std::make_unique<Data>(model)) {}

PackedModel::~PackedModel() = default;

void PackedModel::set_drive(const Drive& drive) {
    data_->set_drive(drive);
}

Points PackedModel::forces(const Points& positions) {
    energy(positions);
    Points result(3, data_->nodes);
    for (int i = 0; i < data_->nodes; ++i) {
        result.col(i) = of_row(data_->last_forces, data_->row_of[i]);
    }
    return result;
}

double PackedModel::energy(const Points& positions) {
    if (data_->last_forces.empty()) {
        data_->last_forces.reset(static_cast<std::size_t>(data_->slices));
    }
    data_->last_records = data_->resting_records();
    data_->put(positions, data_->last_records);
    return data_->forces(data_->last_records, data_->last_forces);
}

Points PackedModel::damped_forces(const MassSpringState& state) {
    data_->prepare_damping();
    data_->last_records = data_->resting_records();
    data_->last_forces.reset(static_cast<std::size_t>(data_->slices));
    data_->put_motion(state, data_->last_records);
    data_->damped_forces(data_->last_records, data_->last_forces);
    Points result(3, data_->nodes);
    for (int i = 0; i < data_->nodes; ++i) {
        result.col(i) = of_row(data_->last_forces, data_->row_of[i]);
    }
    return result;
}

void PackedModel::repeat_pass(bool damped) {
    if (damped) {
        data_->damped_forces(data_->last_records, data_->last_forces);
    } else {
        data_->forces_then(data_->last_records, data_->last_forces, false, [](int, int) {});
    }
}

double PackedModel::bytes_of_pass(bool damped) const {
    const Data& d = *data_;
    const double ends = static_cast<double>(d.spring_start.back());
    const double per_slice =
        kLanes * sizeof(NodeRecord) + sizeof(VectorLanes) + sizeof(TieLanes::anchor) +
        (d.sliding ? sizeof(TieLanes) - sizeof(TieLanes::anchor) : 0) + 2 * sizeof(int) +
        (d.loaded ? sizeof(LoadLanes) : 0) + (d.targeted ? sizeof(TargetLanes) : 0) +
        (damped ? sizeof(VectorLanes) + sizeof(ScalarLanes) : 0) +
        (damped && !d.linear_rest.empty() ? sizeof(VectorLanes) : 0);
    return ends * (sizeof(SpringColumn) + (damped ? sizeof(ScalarLanes) : 0) +
                   (d.tissue ? sizeof(ScalarLanes) : 0)) +
           static_cast<double>(d.links.size()) * sizeof(LinkColumn) +
           static_cast<double>(d.slices) * static_cast<double>(per_slice);
}

}  // namespace myoface
