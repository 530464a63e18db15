// SPDX-License-Identifier: Apache-2.0
#include "myoface/sim/shaping.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "myoface/base/error.h"
#include "myoface/measure/volume.h"
#include "myoface/mesh/bvh.h"

namespace myoface {
namespace {

constexpr double kCubicMillimetres = 1000.0;  // in a millilitre
constexpr double kMostVolume = 20.0;          // [mL]
constexpr double kVolumeOff = 0.005;          // share of the volume
constexpr double kFirstPressure = 2.0;        // [kPa]
constexpr double kMostPressure = 400.0;       // [kPa] no tissue bears more
constexpr int kMostSettles = 12;

constexpr double kOffMillimetres = 0.02;
constexpr double kOffDegrees = 0.1;
constexpr double kFarthest = 25.0;    // way of a landmark [mm]
constexpr double kMostStretch = 2.5;  // of the strain at which a region's capacity is used up

std::string with_unit(double value, bool degrees) {
    char text[40];
    std::snprintf(text, sizeof text, degrees ? "%.1f°" : "%.2f mm", value);
    return text;
}

/// Pressure of 1 kPa under the skin, spread by the kernel of a place [mN].
void add_pressure(const Simulator& simulator, const SurfacePoint& where, double radius,
                  Points& load) {
    const FaceModel& face = simulator.face();
    const Grip grip = grip_at(face, where);
    // A volume lies under all of the skin above it, whatever muscle it belongs to.
    const StressKernel kernel = stress_kernel(
        face, simulator.skin_rest(), grip, radius > 0.0 ? radius : kernel_radius(face, grip), 1.0);
    for (std::size_t k = 0; k < kernel.nodes.size(); ++k) {
        const int i = kernel.nodes[k];
        const double yields =
            simulator.protection().size() > 0 ? 1.0 - simulator.protection()[i] : 1.0;
        load.col(i) += yields * kernel.profile[k] * face.area[i] *
                       face.sliding[static_cast<std::size_t>(i)].normal;
    }
}

/// Puts the face back on the way out, unless it was released.
class Undo {
public:
    explicit Undo(Simulator& simulator)
        : simulator_(simulator), skin_rest_(simulator.skin_rest()) {}
    ~Undo() {
        if (armed_) {
            simulator_.set_load({});
            if (simulator_.dragging()) {
                simulator_.end_drag(false);
            }
            simulator_.set_skin_rest(skin_rest_);
            simulator_.settle();
        }
    }
    Undo(const Undo&) = delete;
    Undo& operator=(const Undo&) = delete;
    void release() { armed_ = false; }

private:
    Simulator& simulator_;
    Points skin_rest_;
    bool armed_ = true;
};

/// What of a measure's landmarks a surgeon would move, first those that move most easily.
std::string movable(const Measure& measure) {
    for (const char* name :
         {"prn", "c",   "al", "ac", "sbal", "pg", "gn", "ls", "cph", "ch", "li",
          "sl",  "sto", "sn", "se", "go",   "zy", "g",  "ft", "ex",  "en", "n"}) {
        if (std::find(measure.points.begin(), measure.points.end(), name) != measure.points.end()) {
            return name;
        }
    }
    throw InvalidInput("Target: nothing of " + measure.title + " can be moved.");
}

/// How a measure changes with its movable landmark; both sides move alike, mirrored.
Vec3 slope(const Landmarks& here, const Mat3& axes, const Measure& measure,
           const std::string& landmark, bool paired) {
    constexpr double kStep = 0.05;  // [mm]
    Vec3 result = Vec3::Zero();
    for (int axis = 0; axis < 3; ++axis) {
        if (!paired && axis == 0) {
            continue;  // a landmark of the midline stays there
        }
        double value[2];
        for (const int side : {0, 1}) {
            Landmarks moved = here;
            const double way = side == 0 ? -kStep : kStep;
            moved.at(landmark + (paired ? "_l" : "")).position += way * axes.col(axis);
            if (paired) {
                moved.at(landmark + "_r").position += (axis == 0 ? -way : way) * axes.col(axis);
            }
            value[side] = measured(measure, moved).value_or(0.0);
        }
        result += (value[1] - value[0]) / (2.0 * kStep) * axes.col(axis);
    }
    return result;
}

}  // namespace

VolumeReport add_volume(Simulator& simulator, const VolumeRequest& request) {
    if (!std::isfinite(request.ml) || std::abs(request.ml) > kMostVolume || request.ml == 0.0) {
        throw InvalidInput("A volume lies between -20 and 20 mL and is not 0.");
    }
    const FaceModel& face = simulator.face();
    Undo undo(simulator);
    simulator.settle();
    const Points before = simulator.state().positions;
    Points unit = Points::Zero(3, face.node_count());
    add_pressure(simulator, request.where, request.radius, unit);
    double wanted = request.ml * kCubicMillimetres;
    const SurfacePoint other = mirrored_place(face, request.where);
    const bool apart =
        (position(face.skin.mesh, other) - position(face.skin.mesh, request.where)).norm() > 4.0;
    if (request.mirrored && apart) {
        add_pressure(simulator, other, request.radius, unit);
        wanted *= 2.0;
    }
    if (!(unit.norm() > 0.0)) {
        throw InvalidInput("This part of the face does not move: choose another place.");
    }
    const auto volume_at = [&](double pressure) {
        simulator.set_load(pressure * unit);
        simulator.settle();
        return swept_volume(face.skin.mesh.triangles, before.leftCols(face.node_count()),
                            simulator.state().positions.leftCols(face.node_count()));
    };
    // Tissue stiffens: between two pressures the volume follows nearly a line.
    VolumeReport report;
    double last = 0.0;
    double last_volume = 0.0;
    double pressure = std::copysign(kFirstPressure, request.ml);
    double volume = volume_at(pressure);
    for (int k = 0; k < kMostSettles && std::abs(volume - wanted) > kVolumeOff * std::abs(wanted);
         ++k) {
        const double rise = (volume - last_volume) / (pressure - last);
        if (!(rise > 0.0)) {
            break;
        }
        last = pressure;
        last_volume = volume;
        // Not further than three times as far in one go.
        pressure = std::clamp((wanted - volume) / rise + pressure, -3.0 * std::abs(pressure),
                              3.0 * std::abs(pressure));
        if (std::abs(pressure) > kMostPressure) {
            break;
        }
        volume = volume_at(pressure);
    }
    if (!(std::abs(volume - wanted) <= 2.0 * kVolumeOff * std::abs(wanted))) {
        char text[160];
        std::snprintf(text, sizeof text,
                      "The tissue here does not take %.2f mL: at %.0f kPa it has taken %.2f mL. "
                      "Give a wider radius or less volume.",
                      wanted / kCubicMillimetres, std::abs(pressure), volume / kCubicMillimetres);
        throw InvalidInput(text);
    }
    undo.release();
    const Points start = simulator.skin_rest();
    report.pressure_kPa = pressure;
    report.kept_share = simulator.keep_shape(before);
    simulator.set_load({});
    report.by_region = volume_by_region(face, start, simulator.skin_rest());
    report.ml =
        swept_volume(face.skin.mesh.triangles, start, simulator.skin_rest()) / kCubicMillimetres;
    return report;
}

Measure target_measure(const std::string& name) {
    const auto plain = [](std::string text) {
        std::transform(text.begin(), text.end(), text.begin(),
                       [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        return text;
    };
    std::string known;
    for (const Measure& measure : all_measures()) {
        if (plain(measure.id) == plain(name) || plain(measure.title) == plain(name)) {
            return measure;
        }
        known += (known.empty() ? "" : ", ") + plain(measure.title);
    }
    throw InvalidInput("'" + name + "' is not a measure; known are " + known + ".");
}

TargetReport meet_target(Simulator& simulator, const TargetRequest& request) {
    const Measure& measure = request.measure;
    const bool degrees = measure.in_degrees();
    const FaceModel& face = simulator.face();
    Undo undo(simulator);
    simulator.settle();
    const LandmarksOnSkin places(simulator.shared_face());
    const std::optional<double> before = places.measure(measure, simulator.state().positions);
    if (!before) {
        throw InvalidInput("Target: landmarks of " + measure.title + " are missing on this face.");
    }
    TargetReport report;
    report.before = report.reached = *before;
    report.wanted = request.relative ? *before + request.value : request.value;
    report.landmark = movable(measure);
    const double tolerance = degrees ? kOffDegrees : kOffMillimetres;
    const Landmarks here = places.at(simulator.state().positions);
    const bool paired = here.count(report.landmark) == 0;
    const std::string own = report.landmark + (paired ? "_l" : "");
    const Vec3 steep = measure.kind == MeasureKind::Projection
                           ? Vec3(face.axes.col(2))
                           : slope(here, face.axes, measure, report.landmark, paired);
    if (!(steep.norm() > 1e-3)) {
        throw InvalidInput("Target: " + measure.title + " does not change when " + report.landmark +
                           " moves.");
    }
    const Vec3 way = steep.normalized();
    // Seen from where the whole way lies in the picture.
    const Vec3 beside = paired ? Vec3(-face.axes.col(2)) : Vec3(-face.axes.col(0));
    Vec3 view = beside - beside.dot(way) * way;
    view = view.norm() > 0.1 ? view.normalized() : Vec3(-face.axes.col(0));
    DragRequest drag;
    const TriangleMesh now{simulator.state().positions.leftCols(face.node_count()),
                           face.skin.mesh.triangles};
    drag.where = Bvh(now).closest_point(now, here.at(own).position).where;
    drag.radius = request.radius;
    drag.mirrored = paired;
    const Vec3 start = position(now, drag.where);
    const auto ray_at = [&](double distance) {
        return ViewRay{start + distance * way - 300.0 * view, view};
    };
    simulator.begin_drag(drag, ray_at(0.0));
    StepReport step;
    const auto value_at = [&](double distance) {
        simulator.move_drag(ray_at(distance));
        step = simulator.settle();
        ++report.settles;
        report.force_mN = step.drag->force_mN;
        return places.measure(measure, simulator.state().positions).value_or(*before);
    };
    const auto refuse = [&](const std::string& why) {
        throw InvalidInput("Target: " + measure.title + " stays at " +
                           with_unit(report.reached, degrees) + " of " +
                           with_unit(report.wanted, degrees) + ": " + why);
    };
    double at = 0.0;
    double last = 0.0;
    double last_value = *before;
    double rise = steep.norm();
    while (std::abs(report.reached - report.wanted) > tolerance && report.settles < kMostSettles) {
        at += (report.wanted - report.reached) / rise;
        if (!(std::abs(at) < kFarthest)) {
            refuse(report.landmark + " would have to go more than 25 mm.");
        }
        last_value = report.reached;
        report.reached = value_at(at);
        if (step.drag->off_ray_mm > 0.2) {
            refuse("the bone holds back.");
        }
        if (step.drag->strain_share > kMostStretch) {
            refuse("the skin there is stretched to its limit.");
        }
        if (report.reached != last_value && at != last) {
            rise = (report.reached - last_value) / (at - last);
        }
        last = at;
        if (!(std::abs(rise) > 0.02 * steep.norm())) {
            refuse("moving " + report.landmark + " further changes nothing.");
        }
    }
    if (std::abs(report.reached - report.wanted) > tolerance) {
        refuse("it is not met after 12 tries.");
    }
    report.moved_mm = std::abs(at);
    const DragReport done = simulator.end_drag(true);
    if (done.kept_share < 1.0) {
        refuse("the skin would fold over itself.");
    }
    undo.release();
    report.reached = places.measure(measure, simulator.state().positions).value_or(report.reached);
    return report;
}

}  // namespace myoface
