// SPDX-License-Identifier: Apache-2.0
#include "myoface/muscle/response.h"

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace myoface {
namespace {

constexpr double kStart = 7.0;
constexpr double kEnd = 14.0;
constexpr double kHalfAngle = 35.0 * std::numbers::pi / 180.0;
constexpr std::array<ResponseForm, 6> kForms{ResponseForm::Smooth,         ResponseForm::AsPrinted,
                                             ResponseForm::QuarterTurn,    ResponseForm::Waters1987,
                                             ResponseForm::ZoneNormalised, ResponseForm::LaterCode};

double radial(double distance, ResponseForm form) {
    return radial_response(distance, kStart, kEnd, form);
}

TEST(RadialResponse, AsPrintedHasThePrintedValues) {
    const auto form = ResponseForm::AsPrinted;
    EXPECT_NEAR(radial(0.0, form), std::cos(1.0), 1e-15);
    EXPECT_NEAR(radial(kStart, form), 1.0, 1e-15);
    EXPECT_NEAR(radial(kEnd, form), std::cos(1.0), 1e-15);
    EXPECT_NEAR(radial(3.5, form), std::cos(0.5), 1e-15);
    EXPECT_NEAR(radial(10.5, form), std::cos(0.5), 1e-15);
    EXPECT_EQ(radial(kEnd + 1e-9, form), 0.0);
}

TEST(RadialResponse, ScaledFormsAreZeroAtBothEndsAndOneBetween) {
    for (const ResponseForm form : kForms) {
        if (form == ResponseForm::AsPrinted) {
            continue;
        }
        EXPECT_NEAR(radial(0.0, form), 0.0, 1e-15) << response_name(form);
        EXPECT_NEAR(radial(kStart, form), 1.0, 1e-15) << response_name(form);
        EXPECT_NEAR(radial(kEnd, form), 0.0, 1e-15) << response_name(form);
    }
}

TEST(RadialResponse, IsContinuousWhereTheFormsMeet) {
    for (const ResponseForm form : kForms) {
        EXPECT_NEAR(radial(kStart - 1e-9, form), radial(kStart + 1e-9, form), 1e-8);
    }
}

TEST(RadialResponse, SmoothHasNoKink) {
    const auto slope = [](double d) {
        return (radial(d + 1e-6, ResponseForm::Smooth) - radial(d - 1e-6, ResponseForm::Smooth)) /
               2e-6;
    };
    EXPECT_NEAR(slope(kStart), 0.0, 1e-5);
    EXPECT_NEAR(slope(kEnd - 2e-6), 0.0, 1e-5);
    EXPECT_NEAR(slope(2e-6), 0.0, 1e-5);
}

TEST(AngularResponse, JumpsAtTheSectorsEdgeAsTheTableSays) {
    EXPECT_NEAR(angular_response(kHalfAngle, kHalfAngle, ResponseForm::AsPrinted), 0.819, 5e-4);
    EXPECT_NEAR(angular_response(kHalfAngle, kHalfAngle, ResponseForm::Waters1987), 0.954, 5e-4);
    for (const ResponseForm form :
         {ResponseForm::ZoneNormalised, ResponseForm::LaterCode, ResponseForm::Smooth}) {
        EXPECT_NEAR(angular_response(kHalfAngle, kHalfAngle, form), 0.0, 1e-12);
        EXPECT_NEAR(angular_response(0.0, kHalfAngle, form), 1.0, 1e-12);
    }
}

TEST(LinearResponse, PullsTowardsTheBoneEndAndNowhereElse) {
    const ResponseZone zone{Vec3(1, 2, 3), Vec3(1, 2, 13), kHalfAngle, 9.0, 14.0};
    for (const ResponseForm form : kForms) {
        const Vec3 p(2.0, 3.0, 10.0);
        const Vec3 d = linear_response(zone, p, form);
        EXPECT_GT(d.norm(), 0.1);
        EXPECT_NEAR(d.normalized().dot((zone.bone_end - p).normalized()), 1.0, 1e-12);
        EXPECT_EQ(linear_response(zone, {1, 2, -5}, form), Vec3(Vec3::Zero()));    // behind
        EXPECT_EQ(linear_response(zone, {1, 2, 17.1}, form), Vec3(Vec3::Zero()));  // beyond
        EXPECT_EQ(linear_response(zone, {9, 2, 8}, form), Vec3(Vec3::Zero()));     // beside
        EXPECT_TRUE(linear_response(zone, zone.bone_end, form).allFinite());
    }
}

TEST(LinearResponse, MatchesAHandValue) {
    // D = 10 along the axis, R_s 9, R_f 14: smooth cos²(π/2 · 1/5), printed cos(1/5).
    const ResponseZone zone{Vec3::Zero(), Vec3(0, 0, 10), kHalfAngle, 9.0, 14.0};
    const Vec3 p(0, 0, 10);
    EXPECT_NEAR(linear_response(zone, p, ResponseForm::Smooth).z(),
                -std::pow(std::cos(std::numbers::pi / 10.0), 2.0), 1e-12);
    EXPECT_NEAR(linear_response(zone, p, ResponseForm::AsPrinted).z(), -std::cos(0.2), 1e-12);
}

TEST(LinearResponse, DoesNotFoldBelowItsGainLimit) {
    // Along the axis the map p + k r u must stay monotonic for k < 0.637 R_s.
    const ResponseZone zone{Vec3::Zero(), Vec3(0, 0, 10), kHalfAngle, 9.0, 14.0};
    const double gain = 0.63 * 9.0;
    for (const ResponseForm form : {ResponseForm::Smooth, ResponseForm::QuarterTurn}) {
        double last = -1.0;
        for (double z = 0.01; z < 16.0; z += 0.01) {
            const double image = z + gain * linear_response(zone, {0, 0, z}, form).z();
            EXPECT_GT(image, last) << response_name(form) << " at " << z;
            last = image;
        }
    }
}

TEST(SphincterResponse, IsZeroAtCentreAndRimAndPeaksAtOne) {
    SphincterZone zone;
    zone.half_width = 30.0;
    zone.half_height = 15.0;
    EXPECT_EQ(sphincter_response(zone, Vec3::Zero()).norm(), 0.0);
    EXPECT_NEAR(sphincter_response(zone, {30.0, 0.0, 0.0}).norm(), 0.0, 1e-12);
    double largest = 0.0;
    for (double x = 0.0; x < 30.0; x += 0.05) {
        const Vec3 d = sphincter_response(zone, {x, 0.0, 0.0});
        EXPECT_LE(d.x(), 0.0);
        largest = std::max(largest, d.norm());
    }
    EXPECT_NEAR(largest, 1.0, 1e-4);
}

TEST(SphincterResponse, IsContinuousAcrossItsDepthWindow) {
    SphincterZone zone;
    zone.half_width = zone.half_height = 20.0;
    zone.depth = 25.0;
    const Vec3 last_inside = sphincter_response(zone, {8.0, 0.0, 24.99});
    EXPECT_LT(last_inside.norm(), 1e-4);
    EXPECT_EQ(sphincter_response(zone, {8.0, 0.0, 25.0}).norm(), 0.0);
}

}  // namespace
}  // namespace myoface
