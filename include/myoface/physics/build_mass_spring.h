// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "myoface/face/face_model.h"
#include "myoface/physics/mass_spring_model.h"

namespace myoface {

/// Constants of the tissue. Values as tried on a face of real size; kPa = mN/mm².
struct TissueConstants {
    double skin_modulus = 100.0;      ///< E of the skin, small strain [kPa]
    double skin_thickness = 1.5;      ///< h [mm]
    double bending = 1000.0;          ///< D of the skin-SMAS-fat layer [mN mm]
    double confined_modulus = 120.0;  ///< M_d through the depth: fat cannot escape [kPa]
    double fat_modulus = 10.0;        ///< E_d; G = E_d / 2.9 sideways [kPa]
    double stiffening = 10.0;         ///< J
    double mucosa_share = 0.2;        ///< anchor of inner lips, of k_t
    double cartilage_share = 2.0;     ///< anchor of ears and nostrils, of k_t
    double layer_modulus = 30.0;      ///< muscle layer [kPa] …
    double layer_thickness = 3.0;     ///< … and its thickness [mm]
    double other_label = 0.15;        ///< of the muscle layer between one muscle and the next
    double density = 1.05e-6;         ///< [kg/mm³]
    double spring_damping = 0.2;      ///< share of critical
    double tie_damping = 1.0;         ///< share of critical
    double passive_muscle = 0.12;     ///< stiffness of a muscle at rest, of that in action
    double lip_contact = 1000.0;      ///< [mN/mm]
    double contact = 1000.0;          ///< of bone, teeth and eyeballs [kPa/mm]
};

/// Where one muscle's parts stand in the model.
struct MuscleChain {
    int first_node = 0, node_count = 0;
    int first_spring = 0, spring_count = 0;
    double shortening = 0.3;  ///< share of the length given up at full contraction
    double activation = 1.0;  ///< stiffness at full contraction, of that at rest
};

/// A model and what belongs to the face in it. Skin node i is model node i.
struct FaceMassSpring {
    MassSpringModel model;
    std::vector<MuscleChain> chains;   ///< per muscle
    std::vector<double> strain_limit;  ///< per skin node
    std::vector<double> bone_tie;      ///< per skin node, 1 usual
    std::vector<int> skin_over;        ///< per node of a muscle chain: the skin node next to it
};

/// Builds springs, hinges, ties and muscle chains.
/// @param skin_rest 3×skin nodes: the scan, or the scan as it was reshaped. Natural lengths and all
///        targets come from it; tissue and sliding surfaces stay those of the scan.
/// @cite van_gelder_1998 (edge stiffness), bergou_2006 (hinges)
FaceMassSpring build_mass_spring(const FaceModel& face, const Points& skin_rest,
                                 const TissueConstants& constants = {});

}  // namespace myoface
