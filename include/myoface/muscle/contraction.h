// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/face/face_model.h"
#include "myoface/muscle/response.h"
#include "myoface/physics/build_mass_spring.h"

namespace myoface {

/// Contraction per muscle, −0.5 relaxed … 0 rest … 1 full, and strength 0 … 1 (toxin, palsy).
struct Contractions {
    std::vector<double> rate;
    std::vector<double> strength;
};
Contractions resting(const FaceModel& face);

/// Where muscles have the jaw: opened, thrust forward by both lateral pterygoids, sideways by one.
JawPose jaw_pose(const FaceModel& face, const Contractions& contractions);
/// How far the jaw is open, as a share of its full opening.
double jaw_opening(const FaceModel& face, const Contractions& contractions);

constexpr double kLeastContraction = -0.5;
constexpr double kMostContraction = 1.0;

/// What one muscle at full contraction asks of the skin: only nodes it reaches.
struct MuscleResponse {
    std::vector<int> nodes;
    Points shift;            ///< tether target [mm]
    Eigen::VectorXd height;  ///< thickness target [mm]
    Eigen::VectorXd hold;    ///< 0 … 1: how firmly the target is held
    double firmness = 0.0;   ///< hold at 1, in tethers of a unit tie
    bool whole = false;      ///< carries skin and bone surface together: lids, jaw
    bool jaw = false;        ///< moves the mandible
};

/// Responses of all muscles on the resting face. Always from rest: sums do not depend on the order
/// of muscles, and releasing returns exactly.
std::vector<MuscleResponse> muscle_responses(const FaceModel& face, const MassSpringModel& model,
                                             ResponseForm form);

/// Sums contractions into a drive: tether and thickness targets, and shortened chains.
Drive contraction_drive(const FaceMassSpring& system, const std::vector<MuscleResponse>& responses,
                        const Contractions& contractions);

}  // namespace myoface
