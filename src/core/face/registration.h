// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "myoface/base/progress.h"
#include "myoface/face/smooth_warp.h"
#include "myoface/mesh/triangle_mesh.h"

#include "surface_samples.h"

namespace myoface {

/// The part of a mesh around its face, in size and pose of the average head; all vertices are kept.
TriangleMesh around_face(const TriangleMesh& mesh, const Similarity& to_generic);

/// The most likely person of people() on samples of a face, and where.
struct LikelyPerson {
    Similarity place;        ///< average head -> samples
    Eigen::VectorXd modes;   ///< deviations from the mean person [SD]
    double agreement = 0.0;  ///< how well the person lies on the samples, 0 … 1
};

/// @pre samples in size and pose of the average head, to about 15 %, 15° and 15 mm
/// @cite blanz_1999
LikelyPerson likely_person(const SurfaceSamples& samples);

/// The face template brought onto a scan. Frame and unit: those of the samples, about the average
/// head's.
struct Registration {
    Eigen::VectorXd distance;  ///< N: how far the surface is from each, large where there is none
    SmoothWarp warp;           ///< average head -> scan, through the points
};

/// Brings the template onto samples of a face: first the most likely person, from several
/// beginnings, then a free bend, coarse to fine. Points pair by place, direction and relief.
/// @pre as likely_person()
/// @cite amberg_2007
Registration register_face(const SurfaceSamples& samples, const Progress* progress = nullptr);

/// Points that a bend keeps in place.
struct Pins {
    Points from = Points(3, 0);                     ///< where the start has them
    Points to = Points(3, 0);                       ///< where they belong
    Eigen::VectorXd softness = Eigen::VectorXd(0);  ///< how much each may be missed [mm]
};

/// The template's points on a scan.
struct DenseFit {
    Points points;             ///< 3×N
    Eigen::VectorXd distance;  ///< N: how far the surface is from each, large where there is none
};

/// Bends the template from where `start` puts it onto samples that lie in the average head's pose,
/// coarse to fine. @cite amberg_2007
DenseFit bend_onto(const SurfaceSamples& samples, const SmoothWarp& start, const Pins& pins);

}  // namespace myoface
