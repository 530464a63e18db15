// SPDX-License-Identifier: Apache-2.0
#include "myoface/physics/build_mass_spring.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "myoface/base/parallel.h"

namespace myoface {
namespace {

constexpr double kLongestCotangent = 8.0;  // of a thin triangle
constexpr double kInsertionRadius = 9.0;   // of a linear muscle's end in the skin [mm]
constexpr double kRingRadius = 7.0;        // of a ring's hold on the skin [mm]
constexpr double kChainAnchor = 20.0;      // of a chain's inner nodes [mN/mm]
constexpr double kTensionSpan = 0.3;       // a chain's full tension is reached at this strain
constexpr double kHardLimit = 2.5;         // of the strain at which a stress finds its limit
constexpr double kNoStrainLimit = 1e6;
constexpr double kStop = 0.7;          // of the tissue's depth: there the bone begins to stop
constexpr double kMuscleArea = 12.0;   // cross-section [mm²]
constexpr double kMarginOfBone = 0.5;  // that skin keeps from bone, teeth and eyes [mm]
constexpr double kNear = 2.0;          // of an obstacle: looked at closely [mm]
constexpr int kSpringGrain = 256;

/// Collects a symmetric matrix entry by entry.
class MatrixBuilder {
public:
    explicit MatrixBuilder(int rows) : rows_(static_cast<std::size_t>(rows)) {}

    void add(int i, int j, double value) {
        rows_[static_cast<std::size_t>(i)].emplace_back(j, value);
    }
    /// ½ k |u_i − u_j|²
    void add_link(int i, int j, double k) {
        add(i, i, k);
        add(j, j, k);
        add(i, j, -k);
        add(j, i, -k);
    }

    LinearStiffness finish() {
        LinearStiffness matrix;
        for (auto& row : rows_) {
            std::stable_sort(row.begin(), row.end(),
                             [](const auto& p, const auto& q) { return p.first < q.first; });
            for (std::size_t k = 0; k < row.size();) {
                const int column = row[k].first;
                double sum = 0.0;
                for (; k < row.size() && row[k].first == column; ++k) {
                    sum += row[k].second;
                }
                matrix.column.push_back(column);
                matrix.value.push_back(sum);
            }
            matrix.start.push_back(static_cast<int>(matrix.column.size()));
        }
        return matrix;
    }

private:
    std::vector<std::vector<std::pair<int, double>>> rows_;
};

double cotangent(const Vec3& a, const Vec3& b) {
    const double sine = a.cross(b).norm();
    const double c = sine > 1e-12 ? a.dot(b) / sine : kLongestCotangent;
    return std::clamp(c, -kLongestCotangent, kLongestCotangent);
}

class Builder {
public:
    Builder(const FaceModel& face, const Points& skin_rest, const TissueConstants& constants)
        : face_(face), c_(constants), skin_(skin_rest), matrix_(count_nodes(face)) {}

    FaceMassSpring build() {
        MassSpringModel& model = out_.model;
        const int total = count_nodes(face_);
        model.skin_nodes = face_.node_count();
        model.rest.resize(3, total);
        model.rest.leftCols(model.skin_nodes) = skin_;
        model.mass = Eigen::VectorXd::Constant(total, 1e-7);
        model.fixed.assign(static_cast<std::size_t>(total), 0);
        model.ties.resize(static_cast<std::size_t>(total));
        model.stretch.resize(static_cast<std::size_t>(total));
        model.label.resize(static_cast<std::size_t>(total));
        add_skin_nodes();
        add_skin_springs();
        int next = model.skin_nodes;
        for (std::size_t m = 0; m < face_.muscles.size(); ++m) {
            add_muscle(static_cast<int>(m), next);
        }
        add_contacts();
        add_barriers();
        model.linear = matrix_.finish();
        index_rows(model);
        add_damping();
        return std::move(out_);
    }

private:
    static int count_nodes(const FaceModel& face) {
        int count = face.node_count();
        for (const Muscle& muscle : face.muscles) {
            count += static_cast<int>(muscle.path.cols());
        }
        return count;
    }

    void add_skin_nodes() {
        MassSpringModel& model = out_.model;
        const double shear = c_.fat_modulus / 2.9;
        for (int i = 0; i < model.skin_nodes; ++i) {
            const TissueProperties& t = face_.tissue[i];
            const double area = std::max(face_.area[i], 1e-3);
            const double depth = std::max(t.depth, 1.0);
            Tie& tie = model.ties[i];
            tie.normal = face_.sliding[i].normal;
            const double tether = t.bone_tie * shear * area / depth;
            if (t.tissue == Tissue::Skin) {
                tie.curvature = face_.sliding[i].curvature;
                tie.thickness = c_.confined_modulus * area / depth;
                tie.stop = kStop * depth;
                tie.tether = tether;
            } else {
                tie.anchor =
                    tether * (t.tissue == Tissue::Mucosa ? c_.mucosa_share : c_.cartilage_share);
            }
            model.mass[i] = c_.density * area * depth * t.bone_tie;
            model.fixed[i] = t.fixed ? 1 : 0;
            model.label[i] = face_.label[i];
            model.stretch[i].stiffening = c_.stiffening;
            if (t.strain_limit < kNoStrainLimit) {
                model.stretch[i].limit = std::clamp(kHardLimit * t.strain_limit, 0.4, 0.8);
            }
            out_.strain_limit.push_back(t.strain_limit);
            out_.bone_tie.push_back(t.bone_tie);
        }
    }

    /// How firmly the muscle layer hangs together: least where as much of one muscle lies under
    /// the skin as of the next, in a seam of some millimetres whatever the triangles.
    void set_hold() {
        hold_.assign(static_cast<std::size_t>(face_.node_count()), 1.0);
        for (std::size_t i = 0; i < face_.muscles_under.size(); ++i) {
            const auto& under = face_.muscles_under[i];
            const double second = under.size() > 1 ? under[1].weight / under[0].weight : 0.0;
            hold_[i] = 1.0 - (1.0 - c_.other_label) * second * second;
        }
    }

    void add_skin_springs() {
        const TriangleMesh mesh{skin_, face_.skin.mesh.triangles};
        std::vector<double> area(static_cast<std::size_t>(mesh.triangle_count()));
        for (int t = 0; t < mesh.triangle_count(); ++t) {
            area[t] = 0.5 * double_area_vector(mesh, t).norm();
        }
        MatrixBuilder layer(face_.node_count());
        set_hold();
        const double layer_stiffness = 0.866 * c_.layer_modulus * c_.layer_thickness;
        for (const MeshEdge& edge : face_.adjacency->edges()) {
            const auto [a, b] = edge.vertices;
            double both = area[edge.triangles[0]];
            if (edge.triangles[1] >= 0) {
                both += area[edge.triangles[1]];
            }
            Spring spring;
            spring.a = a;
            spring.b = b;
            spring.length = (skin_.col(a) - skin_.col(b)).norm();
            const double share = 0.5 * (face_.tissue[a].skin_share + face_.tissue[b].skin_share);
            const double square = std::max(spring.length * spring.length, 1e-6);
            // A sliver's long edge carries no more than that of a square.
            spring.stiffness =
                c_.skin_modulus * c_.skin_thickness * share * std::min(both / square, 4.0);
            spring.label = face_.label[a] == face_.label[b] ? face_.label[a] : TissueLabel{};
            out_.model.springs.push_back(spring);
            layer.add_link(a, b, layer_stiffness * std::sqrt(hold_[a] * hold_[b]));
            if (edge.triangle_count == 2) {
                add_hinge(edge, both, share);
            }
        }
        out_.model.layer.links = layer.finish();
    }

    void add_hinge(const MeshEdge& edge, double both_areas, double share) {
        const std::array<int, 4> v{edge.vertices[0], edge.vertices[1], edge.opposite[0],
                                   edge.opposite[1]};
        if (v[2] == v[3] || both_areas < 1e-9) {
            return;
        }
        const Vec3 x0 = skin_.col(v[0]);
        const Vec3 x1 = skin_.col(v[1]);
        const Vec3 x2 = skin_.col(v[2]);
        const Vec3 x3 = skin_.col(v[3]);
        const double c01 = cotangent(x1 - x0, x2 - x0);
        const double c02 = cotangent(x1 - x0, x3 - x0);
        const double c03 = cotangent(x0 - x1, x2 - x1);
        const double c04 = cotangent(x0 - x1, x3 - x1);
        const std::array<double, 4> row{c03 + c04, c01 + c02, -c01 - c03, -c02 - c04};
        // The smallest area of a pair of slivers is bounded by the edge, as for the springs.
        const double least = 0.1 * (x1 - x0).squaredNorm();
        const double k = share * 3.0 * c_.bending / std::max(both_areas, least);
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) {
                matrix_.add(v[i], v[j], k * row[i] * row[j]);
            }
        }
    }

    /// Skin nodes near a point, with weights (1 − d²/R²)² × area that sum to 1; the zone of the
    /// muscle keeps upper and lower lip apart.
    std::vector<std::pair<int, double>> skin_near(const Vec3& at, double radius,
                                                  MuscleZone zone) const {
        std::vector<std::pair<int, double>> found;
        int nearest = -1;
        double least = 1e30;
        double sum = 0.0;
        for (int i = 0; i < face_.node_count(); ++i) {
            const double square = (face_.skin.mesh.vertices.col(i) - at).squaredNorm();
            if (square < least) {
                least = square;
                nearest = i;
            }
            if (square >= radius * radius) {
                continue;
            }
            double weight = 1.0 - square / (radius * radius);
            weight *= weight * face_.area[i];
            const double upper = upper_lip_share(face_.generic.col(i), 1.5, face_.lip_side[i]);
            if (zone == MuscleZone::UpperLip) {
                weight *= upper;
            } else if (zone == MuscleZone::LowerLip) {
                weight *= 1.0 - upper;
            }
            if (weight > 0.0) {
                found.emplace_back(i, weight);
                sum += weight;
            }
        }
        if (!(sum > 0.0)) {
            return {{nearest, 1.0}};
        }
        for (auto& [node, weight] : found) {
            weight /= sum;
        }
        return found;
    }

    int nearest_skin(const Vec3& at) const {
        Eigen::Index nearest = 0;
        (face_.skin.mesh.vertices.colwise() - at).colwise().squaredNorm().minCoeff(&nearest);
        return static_cast<int>(nearest);
    }

    void attach(int node, const Vec3& at, double radius, MuscleZone zone, double stiffness) {
        Vec3 moved = Vec3::Zero();
        for (const auto& [skin_node, weight] : skin_near(at, radius, zone)) {
            matrix_.add_link(node, skin_node, weight * stiffness);
            moved += weight * (skin_.col(skin_node) - face_.skin.mesh.vertices.col(skin_node));
        }
        out_.model.rest.col(node) += moved;  // the muscle's end follows a reshaped skin
    }

    void add_muscle(int index, int& next) {
        const Muscle& muscle = face_.muscles[static_cast<std::size_t>(index)];
        MassSpringModel& model = out_.model;
        const bool ring = muscle.traits.kind == MuscleKind::Sphincter;
        // These act on the skin by what they do to lids and bone, not through their insertion.
        const bool passive = muscle.traits.action == MuscleAction::Bulge ||
                             muscle.traits.action == MuscleAction::OpenJaw ||
                             muscle.traits.action == MuscleAction::ShiftJaw ||
                             muscle.traits.action == MuscleAction::RaiseLid;
        MuscleChain chain;
        chain.first_node = next;
        chain.node_count = static_cast<int>(muscle.path.cols());
        chain.first_spring = static_cast<int>(model.springs.size());
        const int parts = ring ? chain.node_count : chain.node_count - 1;
        // Full tension at a strain of kTensionSpan, held while the skin end goes its way.
        const double total =
            muscle.traits.strength * 1000.0 / (kTensionSpan * std::max(muscle.length, 5.0));
        chain.shortening =
            ring ? kTensionSpan
                 : std::min(0.6, kTensionSpan + muscle.traits.pull / std::max(muscle.length, 5.0));
        for (int k = 0; k < chain.node_count; ++k) {
            const int node = next + k;
            model.rest.col(node) = muscle.path.col(k);
            model.label[node] = {Tissue::Muscle, index};
            out_.skin_over.push_back(nearest_skin(muscle.path.col(k)));
            model.mass[node] = c_.density * kMuscleArea * muscle.length / parts;
            Tie& tie = model.ties[node];
            if (passive || (!ring && k == 0)) {
                model.fixed[node] = 1;
                model.label[node].tissue = Tissue::Bone;
                continue;
            }
            tie.anchor = kChainAnchor;
            if (ring) {
                attach(node, muscle.path.col(k), kRingRadius, muscle.traits.zone, 4.0 * total);
            } else if (k + 1 == chain.node_count) {
                tie.anchor = 0.0;
                attach(node, muscle.path.col(k), kInsertionRadius, muscle.traits.zone,
                       10.0 * total);
            }
        }
        for (int k = 0; k < parts; ++k) {
            Spring spring;
            spring.a = next + k;
            spring.b = next + (k + 1) % chain.node_count;
            spring.length = (model.rest.col(spring.a) - model.rest.col(spring.b)).norm();
            spring.stiffness = c_.passive_muscle * total * parts;
            spring.label = {Tissue::Muscle, index};
            model.springs.push_back(spring);
        }
        chain.spring_count = parts;
        chain.activation = 1.0 / c_.passive_muscle;
        next += chain.node_count;
        out_.chains.push_back(chain);
    }

    void add_contacts() {
        std::vector<char> taken(static_cast<std::size_t>(face_.node_count()), 0);
        for (const auto& [upper, lower] : face_.lip_contacts) {
            if (taken[upper] == 0 && taken[lower] == 0) {
                taken[upper] = taken[lower] = 1;
                const Vec3 up = face_.axes.col(1);
                const double gap = up.dot(skin_.col(upper) - skin_.col(lower));
                out_.model.contacts.push_back(
                    {upper, lower, up, c_.lip_contact, std::min(gap, 0.0)});
            }
        }
    }

    /// Bone, teeth and eyeballs. What rests in them or touches them may stay as it is.
    void add_barriers() {
        MassSpringModel& model = out_.model;
        if (face_.obstacles.empty()) {
            return;
        }
        const int n = model.skin_nodes;
        const auto count = static_cast<Eigen::Index>(face_.obstacles.size());
        model.obstacles = face_.obstacles;
        Barriers& barriers = model.barriers;
        barriers.stiffness.assign(static_cast<std::size_t>(model.node_count()), 0.0);
        barriers.clear.assign(static_cast<std::size_t>(model.node_count()), kMarginOfBone);
        barriers.margin = Eigen::MatrixXd::Constant(count, model.node_count(), kMarginOfBone);
        parallel_for(n, kSpringGrain, [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                // Linings of mouth and nose are thin folds, guessed where a scan has none: what
                // lies on the wrong side of a bone there would stay caught.
                if (face_.tissue[i].fixed || face_.tissue[i].tissue != Tissue::Skin) {
                    continue;
                }
                barriers.stiffness[i] = c_.contact * std::max(face_.area[i], 1e-3);
                double nearest = face_.obstacle_distance[i] -
                                 (skin_.col(i) - face_.skin.mesh.vertices.col(i)).norm();
                if (nearest < kNear) {
                    nearest = kNear;
                    for (Eigen::Index o = 0; o < count; ++o) {
                        const double distance =
                            distance_to(face_.obstacles[o], skin_.col(i)).distance;
                        barriers.margin(o, i) = std::min(kMarginOfBone, distance);
                        nearest = std::min(nearest, distance);
                    }
                }
                barriers.clear[i] = std::max(0.0, nearest - kMarginOfBone);
            }
        });
    }

    void add_damping() {
        MassSpringModel& model = out_.model;
        for (Spring& s : model.springs) {
            const double mass = std::min(model.mass[s.a], model.mass[s.b]);
            s.damping = 2.0 * c_.spring_damping * std::sqrt(s.stiffness * mass);
        }
        for (int i = 0; i < model.node_count(); ++i) {
            Tie& tie = model.ties[i];
            const double k = std::max({tie.tether, tie.anchor, 1e-3});
            tie.damping = 2.0 * c_.tie_damping * std::sqrt(k * model.mass[i]);
        }
    }

    const FaceModel& face_;
    const TissueConstants& c_;
    const Points& skin_;
    MatrixBuilder matrix_;
    std::vector<double> hold_;  ///< of the muscle layer, per skin node
    FaceMassSpring out_;
};

}  // namespace

FaceMassSpring build_mass_spring(const FaceModel& face, const Points& skin_rest,
                                 const TissueConstants& constants) {
    return Builder(face, skin_rest, constants).build();
}

}  // namespace myoface
