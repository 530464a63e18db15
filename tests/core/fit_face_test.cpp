// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/face/face_model.h"
#include "myoface/face/generic_face.h"
#include "myoface/face/landmark_detection.h"
#include "myoface/io/mesh_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/mesh/normals.h"
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
    std::set<std::string> names;
    for (const AtlasMuscle& muscle : muscle_atlas()) {
        EXPECT_TRUE(names.insert(muscle.traits.name).second) << muscle.traits.name;
        EXPECT_FALSE(muscle.traits.title.empty());
        EXPECT_FALSE(muscle.traits.title_ja.empty());
        EXPECT_FALSE(muscle.traits.action_unit.empty());
        const MuscleTraits& t = muscle.traits;
        for (const std::string* text : {&t.latin, &t.nerve, &t.origin, &t.insertion, &t.does,
                                        &t.does_ja, &t.note, &t.note_ja}) {
            EXPECT_FALSE(text->empty()) << t.name;
        }
        // Japanese is written in its own script, Latin and English are not.
        for (const std::string* text : {&t.title_ja, &t.does_ja, &t.note_ja}) {
            EXPECT_TRUE(std::any_of(text->begin(), text->end(), [](char c) {
                return static_cast<unsigned char>(c) >= 0xE3;
            })) << t.name;
        }
        for (const std::string* text : {&t.title, &t.latin, &t.does}) {
            EXPECT_TRUE(std::all_of(text->begin(), text->end(), [](char c) {
                return static_cast<unsigned char>(c) < 0x80;
            })) << t.name;
        }
        const bool fan = t.kind == MuscleKind::Sheet ||
                         (t.kind == MuscleKind::Volume && t.action != MuscleAction::ShiftJaw);
        EXPECT_EQ(muscle.edges.size(), fan ? 2U : 0U) << t.name;
    }
    for (const char* name : {"procerus", "depressor_septi_nasi", "orbicularis_oris_upper",
                             "orbicularis_oris_lower", "jaw_opening"}) {
        EXPECT_EQ(names.count(name), 1U) << name;
    }
    for (const char* name : {"frontalis_medial",
                             "frontalis_lateral",
                             "corrugator_supercilii",
                             "depressor_supercilii",
                             "orbicularis_oculi_orbital",
                             "orbicularis_oculi_palpebral",
                             "levator_palpebrae_superioris",
                             "levator_labii_superioris_alaeque_nasi",
                             "levator_labii_superioris",
                             "zygomaticus_minor",
                             "zygomaticus_major",
                             "levator_anguli_oris",
                             "buccinator",
                             "risorius",
                             "depressor_anguli_oris",
                             "depressor_labii_inferioris",
                             "mentalis",
                             "incisivii_labii",
                             "nasalis_transverse",
                             "nasalis_alar",
                             "platysma",
                             "masseter",
                             "temporalis",
                             "lateral_pterygoid"}) {
        EXPECT_EQ(names.count(std::string(name) + ".L"), 1U) << name;
        EXPECT_EQ(names.count(std::string(name) + ".R"), 1U) << name;
    }
    EXPECT_EQ(names.size(), 5U + 2U * 24U);
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
    // The mesh cuts corners of the surface, and is sampled.
    const Eigen::VectorXd off =
        (face->generic - face->skin.mesh.vertices).colwise().norm().transpose();
    EXPECT_LT(off.maxCoeff(), 1.2);
    EXPECT_LT(off.mean(), 0.3);
}

/// The front of the average head, eyes and nostrils left out.
std::vector<Vec3> front_of(const TriangleMesh& average, double spacing) {
    const Bvh bvh(average);
    std::vector<Vec3> points;
    for (double y = -75.0; y <= 55.0; y += spacing) {
        for (double x = -54.0; x <= 54.0; x += spacing) {
            const auto hit = bvh.first_hit(average, {Vec3(x, y, 250.0), -Vec3::UnitZ()});
            const bool eye = std::hypot(std::abs(x) - 30.0, y - 17.0) < 18.0;
            const bool nostril = std::abs(x) < 14.0 && y > -36.0 && y < -20.0;
            if (hit && 250.0 - hit->distance > 45.0 && !eye && !nostril) {
                points.emplace_back(x, y, 250.0 - hit->distance);
            }
        }
    }
    return points;
}

TEST(FitFace, LaysTheHeadOntoThePersonAndCarriesMusclesWhereTheyBelong) {
    GenericFaceOptions options;
    options.vertices = 8000;
    const GenericFace average = make_generic_face(options);
    const auto average_fit = fit_face(std::make_shared<Scan>(average.scan), average.landmarks);
    std::vector<double> ends;
    for (const std::uint32_t seed : {811U, 812U, 813U}) {
        options.seed = seed;
        options.sex = seed % 2 == 0 ? Sex::Female : Sex::Male;
        options.age = 20.0 + 12.0 * (seed - 811.0);
        options.asymmetry = 1.0;
        const GenericFace person = make_generic_face(options);
        const auto scan = std::make_shared<Scan>(person.scan);
        const auto face = fit_face(scan, detect_landmarks(scan->mesh).landmarks);
        EXPECT_EQ(face->scan->mesh.vertices, person.scan.mesh.vertices);  // never altered
        const Bvh bvh(face->skin.mesh);
        std::vector<double> off;
        for (const Vec3& p : front_of(average.scan.mesh, 4.0)) {
            off.push_back(bvh.closest_point(face->skin.mesh, from_generic(*face, p)).distance);
            // No place is turned inside out.
            Mat3 jacobian;
            for (int axis = 0; axis < 3; ++axis) {
                jacobian.col(axis) =
                    from_generic(*face, p + Vec3::Unit(axis)) - from_generic(*face, p);
            }
            EXPECT_GT(jacobian.determinant(), 0.1) << p.transpose();
        }
        std::sort(off.begin(), off.end());
        EXPECT_LT(off[off.size() * 95 / 100], 0.8) << seed;
        // Heads of the same count of vertices share them: the truth is known.
        for (std::size_t m = 0; m < face->muscles.size(); ++m) {
            if (face->muscles[m].traits.kind == MuscleKind::Sphincter) {
                continue;
            }
            for (const Eigen::Index k :
                 {Eigen::Index(0), average_fit->muscles[m].path.cols() - 1}) {
                const Vec3 at = average_fit->muscles[m].path.col(k);
                Eigen::Index v = 0;
                (average.scan.mesh.vertices.colwise() - at).colwise().squaredNorm().minCoeff(&v);
                const Vec3 truth =
                    person.scan.mesh.vertices.col(v) + at - Vec3(average.scan.mesh.vertices.col(v));
                ends.push_back((face->muscles[m].path.col(k) - truth).norm());
            }
        }
    }
    std::sort(ends.begin(), ends.end());
    EXPECT_LT(ends[ends.size() / 2], 2.0);
    EXPECT_LT(ends.back(), 12.0);
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
        if (muscle.traits.action == MuscleAction::RaiseLid ||
            muscle.traits.action == MuscleAction::ShiftJaw) {
            continue;  // starts at the bottom of the orbit, runs behind the jaw
        }
        for (Eigen::Index k = 0; k < muscle.path.cols(); ++k) {
            const Vec3 p = muscle.path.col(k);
            const ClosestPoint on_skin = skin.closest_point(face->skin.mesh, p);
            EXPECT_LT(on_skin.distance, 24.0) << muscle.traits.name;
            EXPECT_GT(on_skin.distance, 0.01) << muscle.traits.name;
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
    std::vector<double> apart;
    for (std::size_t m = 0; m + 1 < face->muscles.size(); ++m) {
        const Muscle& left = face->muscles[m];
        if (left.traits.side != Side::Left || left.traits.kind == MuscleKind::Sphincter) {
            continue;
        }
        Points mirrored = face->muscles[m + 1].path;
        mirrored.row(0) *= -1.0;
        // The surface is sampled, so not to the last bit; an end may choose another side of a fold.
        const double off = (left.path - mirrored).cwiseAbs().maxCoeff();
        EXPECT_LT(off, 3.5) << left.traits.name;
        apart.push_back(off);
    }
    std::sort(apart.begin(), apart.end());
    EXPECT_LT(apart[apart.size() / 2], 0.5);
    EXPECT_LT(apart[apart.size() * 3 / 4], 1.0);
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
    ASSERT_EQ(static_cast<int>(face->bone_part.size()), face->bone.vertex_count());
    for (const BonePart part :
         {BonePart::Cranium, BonePart::Mandible, BonePart::UpperTeeth, BonePart::LowerTeeth}) {
        EXPECT_GT(std::count(face->bone_part.begin(), face->bone_part.end(), part), 300);
    }
    // Winding number by solid angles would be exact; the normal at the nearest place tells enough.
    const Points normals = vertex_normals(face->skin.mesh, *face->adjacency);
    int outside = 0;
    for (int v = 0; v < face->bone.vertex_count(); ++v) {
        const Vec3 p = face->bone.vertices.col(v);
        const ClosestPoint hit = skin.closest_point(face->skin.mesh, p);
        const int corner = face->skin.mesh.triangles(0, hit.where.triangle);
        // Jaws and teeth stand in the mouth's own hollow.
        const bool mouth =
            face->tissue[static_cast<std::size_t>(corner)].tissue != Tissue::Skin ||
            (std::abs(p.x()) < 38.0 && std::abs(p.y() + 50.0) < 27.0 && p.z() > 35.0);
        if (!mouth && face->bone_part[static_cast<std::size_t>(v)] < BonePart::UpperTeeth) {
            const bool out = (p - hit.point).dot(normals.col(corner)) > 0.5;
            outside += out;
            if (out && outside < 5) {
                ADD_FAILURE() << "bone outside at " << p.transpose();
            }
        }
    }
    EXPECT_EQ(outside, 0);
}

TEST(FitFace, KeepsTheTissuesDepthAtTheTablesSites) {
    const auto face = small_model();
    std::ifstream table(std::string(MYOFACE_SOURCE_DIR) + "/assets/tissue_depth.csv");
    ASSERT_TRUE(table);
    const Bvh bone(face->bone);
    const Bvh skin(face->skin.mesh);
    const std::set<std::string> on_bone{
        "supraglabella",    "glabella",       "nasion",       "mid-philtrum",
        "chin-lip fold",    "pogonion",       "menton",       "frontal eminence",
        "mid-supraorbital", "inferior malar", "supraglenoid", "zygion",
        "temporal fossa",   "vertex"};
    std::string line;
    std::getline(table, line);
    int sites = 0;
    while (std::getline(table, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) {
            cells.push_back(cell);
        }
        const Vec3 near(std::stod(cells[2]), std::stod(cells[3]), std::stod(cells[4]));
        const double depth = std::stod(cells[5]);
        const ClosestPoint hit = skin.closest_point(face->skin.mesh, near);
        EXPECT_NEAR(tissue_depths(near)[0], depth, 0.5) << cells[0];
        // What the model computes with, between the nodes around the site.
        double modelled = 0.0;
        bool lid_or_lip = false;
        Vec3 normal = Vec3::Zero();
        for (int c = 0; c < 3; ++c) {
            const int v = face->skin.mesh.triangles(c, hit.where.triangle);
            modelled += hit.where.weights[c] * face->tissue[static_cast<std::size_t>(v)].depth;
            lid_or_lip |= is_lid(face->tissue[static_cast<std::size_t>(v)].region);
            normal += face->sliding[static_cast<std::size_t>(v)].normal;
        }
        if (!lid_or_lip && face->tissue[0].depth > 0.0) {
            EXPECT_NEAR(modelled, depth, 2.0) << cells[0];
        }
        if (on_bone.count(cells[0]) != 0) {
            // The skull's surface itself, straight in or at its nearest.
            const auto ray = bone.first_hit(face->bone, {hit.point, -normal.normalized()});
            const double nearest = bone.closest_point(face->bone, hit.point).distance;
            const double straight = ray ? ray->distance : 1e9;
            EXPECT_LT(std::min(std::abs(straight - depth), std::abs(nearest - depth)), 1.2)
                << cells[0] << ": " << straight << " straight, " << nearest << " nearest, wanted "
                << depth;
            ++sites;
        }
    }
    EXPECT_EQ(sites, static_cast<int>(on_bone.size()));
}

TEST(FitFace, KeepsMusclesBetweenSkinAndBone) {
    const auto face = small_model();
    const Bvh skin(face->skin.mesh);
    const Points normals = vertex_normals(face->skin.mesh, *face->adjacency);
    for (const Muscle& muscle : face->muscles) {
        if (muscle.traits.action == MuscleAction::RaiseLid ||
            muscle.traits.action == MuscleAction::ShiftJaw) {
            continue;  // runs inside the orbit or behind the jaw
        }
        std::vector<Points> paths = muscle.fibres;
        paths.push_back(muscle.path);
        for (const Points& path : paths) {
            for (Eigen::Index k = 0; k < path.cols(); ++k) {
                const Vec3 p = path.col(k);
                const ClosestPoint hit = skin.closest_point(face->skin.mesh, p);
                const int v = face->skin.mesh.triangles(0, hit.where.triangle);
                const auto& tissue = face->tissue[static_cast<std::size_t>(v)];
                if (tissue.tissue != Tissue::Skin) {
                    continue;  // behind lips and wings of the nose both sides are near
                }
                EXPECT_LT((p - hit.point).dot(normals.col(v)), 0.6) << muscle.traits.name;
                EXPECT_LT(hit.distance, tissue.depth + 1.5 + 0.15 * tissue.depth)
                    << muscle.traits.name;
            }
        }
    }
}

TEST(FitFace, TellsWhichMusclesLieUnderANode) {
    const auto face = small_model();
    std::set<int> seen;
    for (int v = 0; v < face->node_count(); ++v) {
        double sum = 0.0;
        for (const MuscleWeight& entry : face->muscles_under[static_cast<std::size_t>(v)]) {
            seen.insert(entry.muscle);
            sum += entry.weight;
        }
        EXPECT_TRUE(face->muscles_under[static_cast<std::size_t>(v)].empty() ||
                    std::abs(sum - 1.0) < 1e-12);
        EXPECT_EQ(face->muscles_under[static_cast<std::size_t>(v)].empty(),
                  face->label[static_cast<std::size_t>(v)].muscle < 0);
    }
    for (std::size_t m = 0; m < face->muscles.size(); ++m) {
        EXPECT_EQ(seen.count(static_cast<int>(m)), 1U) << face->muscles[m].traits.name;
    }
}

TEST(JawHinge, OpensDownAndForwardAboutTheCondyles) {
    const auto face = small_model();
    const Vec3 chin = face->landmarks.at("gn").position;
    const Vec3 moved = opened(face->jaw, 1.0, chin);
    EXPECT_LT(moved.y(), chin.y() - 25.0);  // well below
    EXPECT_LT(moved.z(), chin.z() + 1.0);   // and back: it turns
    EXPECT_NEAR(moved.x(), chin.x(), 0.3);
    EXPECT_NEAR((opened(face->jaw, 1.0, face->jaw.centre) - face->jaw.centre).norm(),
                face->jaw.slide.norm(), 1e-12);
    EXPECT_LT((opened(face->jaw, 0.0, chin) - chin).norm(), 1e-9);
    EXPECT_GT(face->jaw_vertices.size(), 50U);  // the lower teeth
}

TEST(FitFace, TellsThePartsOfTheFaceApart) {
    const auto face = small_model();
    const auto region = [&](const Vec3& at) {
        Eigen::Index nearest = 0;
        (face->skin.mesh.vertices.colwise() - at).colwise().squaredNorm().minCoeff(&nearest);
        return face->tissue[static_cast<std::size_t>(nearest)].region;
    };
    const auto at = [&](const char* name) { return face->landmarks.at(name).position; };
    EXPECT_EQ(region(at("prn")), Region::NoseTip);
    EXPECT_EQ(region({0, 5, 106}), Region::NoseDorsum);
    EXPECT_EQ(region({30, 25, 84}), Region::UpperLid);
    EXPECT_EQ(region({30, 9, 84}), Region::LowerLid);
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
    sites.col(0) << 0, 37.8, 101.2;
    sites.col(1) << 0, -80.7, 99.2;
    sites.col(2) << 0, 24.4, 98.3;
    const Eigen::VectorXd depths = tissue_depths(sites);
    EXPECT_NEAR(depths[0], 5.5, 0.05);
    EXPECT_NEAR(depths[1], 11.0, 0.05);
    EXPECT_NEAR(depths[2], 6.5, 0.05);
}

}  // namespace
}  // namespace myoface
