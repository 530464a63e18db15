// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/physics/mass_spring_model.h"

namespace myoface {

/// Net force on every mass point of a mass-spring-damper network, eq. (1) to the letter:
///   F_i = m_i g − Σ_j { k_ij (1 − L_ij/|r_ij|) r_ij + D_ij v_ij },   r_ij = x_i − x_j
/// @return 3×N [mN]. Springs are summed in index order. A spring with coincident ends has no
///         direction: only its damping counts.
/// @cite matsuda_muscle_spring, Eq. (1)
Points spring_forces(const MassSpringModel& model, const MassSpringState& state,
                     const Vec3& gravity);

/// Forces of the whole model: springs with stiffening, ties, bending and attachments, contacts,
/// gravity beyond that of rest, outer loads; with `damped` also the dampers. Zero at rest.
/// @return 3×N [mN]; the same bits for any number of threads
Points total_forces(const MassSpringModel& model, const MassSpringState& state, const Drive& drive,
                    bool damped);

/// Forces on the muscle layer, 3×skin nodes [mN]. @pre state.layer is not empty
Points layer_forces(const MassSpringModel& model, const MassSpringState& state, const Drive& drive);

/// Energy of which total_forces() without dampers and layer_forces() are the negative gradient
/// [µJ].
double potential_energy(const MassSpringModel& model, const MassSpringState& state,
                        const Drive& drive);

/// Largest stretch |r|/L − 1 of the skin's springs around a set of nodes, with each spring's share
/// of its limit. @param limit per skin node @param least_limit no link counts with less
struct StrainReport {
    double largest = 0.0;         ///< |ε|
    double share_of_limit = 0.0;  ///< largest |ε| / limit
};
StrainReport skin_strain(const MassSpringModel& model, const Points& positions,
                         const std::vector<int>& springs, const std::vector<double>& limit,
                         double least_limit);

}  // namespace myoface
