// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/face/face_model.h"
#include "myoface/io/mesh_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/physics/build_mass_spring.h"

#include "test_meshes.h"

namespace myoface {
namespace {

using test::small_face;
using test::small_model;

std::shared_ptr<const Scan> scan() {
    return small_model()->scan;
}

TEST(MuscleAtlas, HoldsTheMusclesThatWerePromised) {
    int paired_linear = 0;
    std::set<std::string> names;
    for (const AtlasMuscle& muscle : muscle_atlas()) {
        EXPECT_TRUE(names.insert(muscle.traits.name).second) << muscle.traits.name;
        EXPECT_FALSE(muscle.traits.title.empty());
        EXPECT_FALSE(muscle.traits.title_ja.empty());
        EXPECT_FALSE(muscle.traits.action_unit.empty());
        paired_linear +=
            muscle.traits.kind == MuscleKind::Linear && muscle.traits.side == Side::Left;
    }
    EXPECT_GE(paired_linear, 14);
    for (const char* name :
         {"orbicularis_oris_upper", "orbicularis_oris_lower", "orbicularis_oculi_orbital.L",
          "orbicularis_oculi_palpebral.R", "zygomaticus_major.L"}) {
        EXPECT_EQ(names.count(name), 1U) << name;
    }
}

TEST(MuscleNames, MeanBothSidesWithoutASide) {
    EXPECT_EQ(muscles_named("risorius").size(), 2U);
    EXPECT_EQ(muscles_named("risorius.R").size(), 1U);
    EXPECT_EQ(muscles_named("procerus").size(), 1U);
    try {
        muscles_named("risorus");
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("'risorius'"), std::string::npos);
    }
}

TEST(FitFace, RecoversTheGenericHeadItself) {
    const auto face = small_model();
    EXPECT_NEAR(face->to_generic.scale, 1.0, 1e-6);
    EXPECT_LT((face->generic - face->skin.mesh.vertices).cwiseAbs().maxCoeff(), 0.05);
}

TEST(FitFace, DoesNotDependOnPoseAndUnit) {
    // The same head turned by quarters, in centimetres, far from the origin.
    Scan turned = small_face().scan;
    const Mat3 turn = axes_from_text("+x-z+y");
    LandmarkFile file;
    turned.file_vertices = (0.1 * turn * turned.mesh.vertices).colwise() + Vec3(3, 40, -7);
    for (const auto& [name, landmark] : small_face().landmarks) {
        file.landmarks[name] = {0.1 * turn * landmark.position + Vec3(3, 40, -7), 0.1};
    }
    const FileFrame frame = frame_from_landmarks(file, {}, {});
    EXPECT_DOUBLE_EQ(frame.mm_per_unit, 10.0);
    EXPECT_TRUE(frame.axes.isApprox(turn.transpose()));
    turned.mesh.vertices = 10.0 * frame.axes * turned.file_vertices;
    turned.frame = frame;
    const auto face = fit_face(std::make_shared<const Scan>(turned), in_model_frame(file, frame));
    EXPECT_LT((face->generic - small_model()->generic).cwiseAbs().maxCoeff(), 0.01);
}

TEST(FitFace, PutsMuscleEndsOnBoneAndSkin) {
    const auto face = small_model();
    const Bvh skin(face->skin.mesh);
    for (const Muscle& muscle : face->muscles) {
        for (Eigen::Index k = 0; k < muscle.path.cols(); ++k) {
            const Vec3 p = muscle.path.col(k);
            const ClosestPoint on_skin = skin.closest_point(face->skin.mesh, p);
            EXPECT_LT(on_skin.distance, 24.0) << muscle.traits.name;
            EXPECT_GT(on_skin.distance, 0.2) << muscle.traits.name;
        }
        if (muscle.traits.kind == MuscleKind::Linear) {
            const Vec3 end = muscle.path.col(muscle.path.cols() - 1);
            EXPECT_LT(skin.closest_point(face->skin.mesh, end).distance, 7.0) << muscle.traits.name;
            EXPECT_GT(muscle.length, 10.0) << muscle.traits.name;
        }
    }
}

TEST(FitFace, MirrorsLeftAndRight) {
    const auto face = small_model();
    for (std::size_t m = 0; m + 1 < face->muscles.size(); ++m) {
        const Muscle& left = face->muscles[m];
        if (left.traits.side != Side::Left || left.traits.kind != MuscleKind::Linear) {
            continue;
        }
        Points mirrored = face->muscles[m + 1].path;
        mirrored.row(0) *= -1.0;
        EXPECT_LT((left.path - mirrored).cwiseAbs().maxCoeff(), 0.2) << left.traits.name;
    }
}

TEST(FitFace, LabelsEveryNodeAndLink) {
    const auto face = small_model();
    const FaceMassSpring system = build_mass_spring(*face, face->skin.mesh.vertices);
    ASSERT_EQ(static_cast<int>(face->label.size()), face->node_count());
    ASSERT_EQ(static_cast<int>(system.model.label.size()), system.model.node_count());
    std::set<int> used;
    for (const TissueLabel& label : system.model.label) {
        used.insert(label.muscle);
    }
    EXPECT_EQ(used.size(), face->muscles.size() + 1);  // every muscle, and none
    for (std::size_t m = 0; m < face->muscles.size(); ++m) {
        const MuscleChain& chain = system.chains[m];
        for (int s = chain.first_spring; s < chain.first_spring + chain.spring_count; ++s) {
            EXPECT_EQ(system.model.springs[static_cast<std::size_t>(s)].label.muscle,
                      static_cast<int>(m));
        }
    }
}

TEST(FitFace, KeepsBoneUnderTheSkin) {
    const auto face = small_model();
    const Bvh skin(face->skin.mesh);
    ASSERT_GT(face->bone.triangle_count(), 500);
    int shallow = 0;
    for (int t = 0; t < face->bone.triangle_count(); ++t) {
        const Vec3 centre =
            (face->bone.corner(t, 0) + face->bone.corner(t, 1) + face->bone.corner(t, 2)) / 3.0;
        shallow += skin.closest_point(face->skin.mesh, centre).distance < 1.5;
    }
    EXPECT_LT(shallow, face->bone.triangle_count() / 100);
}

TEST(FitFace, TellsThePartsOfTheFaceApart) {
    const auto face = small_model();
    const auto region = [&](const Vec3& at) {
        Eigen::Index nearest = 0;
        (face->skin.mesh.vertices.colwise() - at).colwise().squaredNorm().minCoeff(&nearest);
        return face->tissue[static_cast<std::size_t>(nearest)].region;
    };
    const auto at = [&](const char* name) { return face->landmarks.at(name).position; };
    EXPECT_EQ(region(at("prn")), Region::Nose);
    EXPECT_EQ(region(at("pg")), Region::Chin);
    EXPECT_EQ(region(at("li")), Region::LowerLip);
    EXPECT_EQ(region({0, 62, 100}), Region::Forehead);
    EXPECT_EQ(region({45, -20, 75}), Region::Cheek);
    EXPECT_EQ(region({0, -130, 45}), Region::Neck);
    EXPECT_EQ(region({82, 5, -20}), Region::Ear);
}

TEST(FitFace, RefusesTooFewLandmarks) {
    Landmarks few;
    few["prn"] = small_face().landmarks.at("prn");
    few["en_l"] = small_face().landmarks.at("en_l");
    EXPECT_THROW(fit_face(scan(), few), InvalidInput);
}

TEST(FitFace, RefusesLandmarksThatLieElsewhere) {
    Landmarks away = small_face().landmarks;
    for (auto& [name, landmark] : away) {
        landmark.position += Vec3(0, 0, 400);
    }
    try {
        fit_face(scan(), away);
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("mm away from the scan"), std::string::npos);
    }
}

TEST(FitFace, RefusesSwappedSides) {
    Landmarks swapped;
    for (const auto& [name, landmark] : small_face().landmarks) {
        swapped[mirrored_name(name)] = landmark;
    }
    try {
        fit_face(scan(), swapped);
        FAIL();
    } catch (const InvalidInput& error) {
        EXPECT_NE(std::string(error.what()).find("swapped"), std::string::npos);
    }
}

TEST(FitFace, RefusesPointsThatAreNoFace) {
    Landmarks chaos = small_face().landmarks;
    std::srand(6);
    for (auto& [name, landmark] : chaos) {
        landmark.position = 80.0 * Vec3::Random();
    }
    EXPECT_THROW(fit_face(scan(), chaos), InvalidInput);
}

TEST(FitFace, RefusesAWrongUnit) {
    Scan tiny = small_face().scan;
    set_frame(tiny, {0.1, Mat3::Identity()});
    Landmarks landmarks = small_face().landmarks;
    for (auto& [name, landmark] : landmarks) {
        landmark.position *= 0.1;
    }
    EXPECT_THROW(fit_face(std::make_shared<const Scan>(tiny), landmarks), InvalidInput);
}

TEST(TissueDepths, MeetTheTableAtItsSites) {
    Points sites(3, 3);
    sites.col(0) << 0, 38, 99;
    sites.col(1) << 0, -81, 98;
    sites.col(2) << -67, -4, 22;
    const Eigen::VectorXd depths = tissue_depths(sites);
    EXPECT_NEAR(depths[0], 5.5, 1e-6);
    EXPECT_NEAR(depths[1], 11.0, 1e-6);
    EXPECT_NEAR(depths[2], 7.0, 1e-6);
}

}  // namespace
}  // namespace myoface
