// SPDX-License-Identifier: Apache-2.0
// The hands of a drag: what they hold, where they may go, and how what they do is spread.
#include <algorithm>
#include <cmath>

#include "myoface/drag/counter_bulge.h"
#include "myoface/drag/drag.h"

#include "in_plane.h"

namespace myoface {
namespace {

constexpr double kHandStiffness = 1000.0;  // [mN/mm]
constexpr double kLargestForce = 6000.0;   // [mN]
constexpr double kLayerOtherLabel = 3.0;
constexpr double kAlongFibres = 2.5;     // a stress goes so many times further than across
constexpr double kJudgingRadius = 12.0;  // [mm]

}  // namespace

SkinDrag::Hand SkinDrag::make_hand(const SurfacePoint& where, const ViewRay& ray) const {
    Hand hand;
    hand.grip = grip_at(face_, where);
    // Shaping grips as broadly as suits the region; judging compares regions, so its stress is
    // spread alike everywhere.
    const double usual =
        request_.mode == DragMode::MousePriority ? kernel_radius(face_, hand.grip) : kJudgingRadius;
    const double radius = request_.radius > 0.0 ? request_.radius : usual;
    const bool judging = request_.mode == DragMode::ConstraintPriority;
    const double elongation = judging ? kAlongFibres : 1.0;
    hand.kernel = stress_kernel(face_, start_, hand.grip, radius, 1.8, elongation);
    hand.layer_kernel =
        stress_kernel(face_, start_, hand.grip, 2.0 * radius, kLayerOtherLabel, elongation);
    for (StressKernel* kernel : {&hand.kernel, &hand.layer_kernel}) {
        if (yielding_.size() > 0) {
            spare(*kernel, yielding_);
        }
    }
    if (judging) {
        hand.bulge = counter_bulge(face_, system_.model, start_, hand.kernel);
    }
    hand.start = grip_position(hand.grip, start_);
    hand.normal.setZero();
    for (std::size_t k = 0; k < hand.grip.nodes.size(); ++k) {
        hand.normal += hand.grip.weights[k] *
                       face_.sliding[static_cast<std::size_t>(hand.grip.nodes[k])].normal;
    }
    hand.normal.normalize();
    hand.peak = 0.0;
    for (std::size_t k = 0; k < hand.kernel.nodes.size(); ++k) {
        for (std::size_t g = 0; g < hand.grip.nodes.size(); ++g) {
            if (hand.grip.nodes[g] == hand.kernel.nodes[k]) {
                hand.peak += hand.grip.weights[g] * hand.kernel.profile[k];
            }
        }
    }
    hand.peak = std::max(hand.peak, 0.2);
    hand.ray = guided(hand, ray);
    hand.target = in_plane(hand.ray, kernel_centre(hand));
    std::vector<char> near(static_cast<std::size_t>(face_.node_count()), 0);
    for (const int node : stress_kernel(face_, start_, hand.grip, 2.0 * radius, 1.0).nodes) {
        near[node] = 1;
    }
    const MassSpringModel& model = system_.model;
    for (std::size_t s = 0; s < model.springs.size(); ++s) {
        const Spring& spring = model.springs[s];
        if (spring.a < model.skin_nodes && spring.b < model.skin_nodes && near[spring.a] != 0 &&
            near[spring.b] != 0) {
            hand.near_springs.push_back(static_cast<int>(s));
        }
    }
    return hand;
}

void SkinDrag::add_mirrored_hand() {
    const TriangleMesh generic{face_.generic, face_.skin.mesh.triangles};
    if (std::abs(position(generic, request_.where).x()) < 1.0) {
        return;  // on the midline already
    }
    Hand hand = make_hand(mirrored_place(face_, request_.where), hands_.front().ray);
    hands_.push_back(hand);
    hands_[1].ray = mirrored(hands_.front().ray);
    // The plane of the mirrored view differs: set the target anew.
    hands_[1].target = in_plane(hands_[1].ray, kernel_centre(hand));
}

ViewRay SkinDrag::mirrored(const ViewRay& ray) const {
    const Vec3 normal = face_.axes.col(0);
    const Vec3 middle = 0.5 * (hands_[0].start + hands_[1].start);
    ViewRay other;
    other.origin = ray.origin - 2.0 * normal.dot(ray.origin - middle) * normal;
    other.direction = ray.direction - 2.0 * normal.dot(ray.direction) * normal;
    // The two grips are not exact mirror images: keep the offset of the second.
    const Vec3 image = hands_[0].start - 2.0 * normal.dot(hands_[0].start - middle) * normal;
    other.origin += hands_[1].start - image;
    return other;
}

/// The ray that leads where the gesture's path allows: what the path forbids it does not ask for.
ViewRay SkinDrag::guided(const Hand& hand, const ViewRay& ray) const {
    if (request_.path == DragPath::Free) {
        return ray;
    }
    const Vec3 off = ray.origin - hand.start;
    const Vec3 left = face_.axes.col(0);
    if (request_.path == DragPath::Midplane) {
        // Seen from the side the way lies in the plane; seen from the front it goes up and down.
        ViewRay result = ray;
        const Vec3 across = left - left.dot(ray.direction) * ray.direction;
        if (across.norm() > 0.2) {
            result.origin -= off.dot(across) / across.squaredNorm() * across;
        }
        return result;
    }
    // The point of the normal's line that is nearest to the ray, held from beside the line.
    const Vec3 beside = ray.direction - ray.direction.dot(hand.normal) * hand.normal;
    if (beside.norm() < 0.05) {
        return ray;  // looked at along the normal: no way along it is seen
    }
    const double slope = ray.direction.dot(hand.normal);
    const double along =
        (hand.normal.dot(off) - slope * ray.direction.dot(off)) / (1.0 - slope * slope);
    ViewRay result;
    result.direction = beside.normalized();
    result.origin = hand.start + along * hand.normal - 300.0 * result.direction;
    return result;
}

Vec3 SkinDrag::kernel_centre(const Hand& hand) const {
    Vec3 centre = Vec3::Zero();
    for (std::size_t k = 0; k < hand.kernel.nodes.size(); ++k) {
        centre += hand.kernel.weights[k] * start_.col(hand.kernel.nodes[k]);
    }
    return centre;
}

std::vector<Handle> SkinDrag::handles() const {
    std::vector<Handle> result;
    for (const Hand& hand : hands_) {
        result.push_back(
            {hand.kernel.nodes, hand.kernel.weights, view_plane(hand.ray.direction), hand.target});
    }
    return result;
}

/// The force of a kernel node per force of the hand: its share, and the push that keeps volume.
Mat3 SkinDrag::spread(const Hand& hand, std::size_t k) const {
    const auto node = static_cast<std::size_t>(hand.kernel.nodes[k]);
    return hand.kernel.weights[k] * Mat3::Identity() +
           face_.sliding[node].normal * hand.bulge.col(static_cast<Eigen::Index>(k)).transpose();
}

std::vector<HandPull> SkinDrag::pulls() const {
    std::vector<HandPull> result;
    for (const Hand& hand : hands_) {
        HandPull pull;
        pull.grip_nodes = hand.grip.nodes;
        pull.grip_weights = hand.grip.weights;
        pull.nodes = hand.kernel.nodes;
        pull.weights = hand.kernel.weights;
        for (std::size_t k = 0; k < pull.nodes.size(); ++k) {
            pull.spread.push_back(spread(hand, k));
        }
        pull.layer_nodes = hand.layer_kernel.nodes;
        pull.layer_weights = hand.layer_kernel.weights;
        pull.plane = view_plane(hand.ray.direction);
        pull.target = in_plane(hand.ray, hand.ray.origin);
        pull.stiffness = kHandStiffness;
        pull.largest = kLargestForce;
        if (request_.force_mN > 0.0) {
            const Eigen::Vector2d way = pull.target - in_plane(hand.ray, hand.start);
            pull.force =
                std::min(request_.force_mN, kLargestForce) / std::max(way.norm(), 1e-9) * way;
        }
        pull.skin_share = second_stage_ ? 0.0 : skin_share_;
        pull.layer_share = second_stage_ ? layer_share_ : 0.0;
        result.push_back(std::move(pull));
    }
    return result;
}

}  // namespace myoface
