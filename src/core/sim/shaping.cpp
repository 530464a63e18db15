// SPDX-License-Identifier: Apache-2.0
#include "myoface/sim/shaping.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "myoface/base/error.h"
#include "myoface/measure/volume.h"
#include "myoface/mesh/bvh.h"

#include "undo_shaping.h"

namespace myoface {
namespace {

constexpr double kCubicMillimetres = 1000.0;  // in a millilitre
constexpr double kMostVolume = 20.0;          // [mL]
constexpr double kVolumeOff = 0.005;          // share of the volume
constexpr double kFirstPressure = 2.0;        // [kPa]
constexpr double kMostPressure = 400.0;       // [kPa] no tissue bears more
constexpr int kMostSettles = 12;

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

}  // namespace

VolumeReport add_volume(Simulator& simulator, const VolumeRequest& request) {
    if (!std::isfinite(request.ml) || std::abs(request.ml) > kMostVolume || request.ml == 0.0) {
        throw InvalidInput("A volume lies between -20 and 20 mL and is not 0.");
    }
    const FaceModel& face = simulator.face();
    UndoShaping undo(simulator);
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

}  // namespace myoface
