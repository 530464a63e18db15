// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "myoface/base/error.h"
#include "myoface/face/face_model.h"
#include "myoface/io/mesh_file.h"
#include "myoface/mesh/bvh.h"
#include "myoface/muscle/expression.h"
#include "myoface/sim/simulator.h"
#include "myoface/sim/snapshot.h"

#include "test_meshes.h"

namespace myoface {
namespace {

/// The face as a scanner sees it: one sheet, with the lips grown together.
Scan closed_scan() {
    const TriangleMesh& head = test::small_face().scan.mesh;
    const Bvh bvh(head);
    constexpr double kStep = 1.7;
    constexpr int kColumns = 75;
    constexpr int kRows = 95;
    TriangleMesh sheet;
    sheet.vertices.resize(3, kColumns * kRows);
    for (int r = 0; r < kRows; ++r) {
        for (int c = 0; c < kColumns; ++c) {
            const double x = kStep * (c - kColumns / 2) + 0.3;
            const double y = 62.0 - kStep * r;
            double z = 20.0;
            for (const double beside : {-0.7, 0.0, 0.7}) {  // not through the slit
                const auto hit = bvh.first_hit(head, {Vec3(x, y + beside, 250.0), -Vec3::UnitZ()});
                z = hit ? std::max(z, 250.0 - hit->distance) : z;
            }
            sheet.vertices.col(r * kColumns + c) = Vec3(x, y, z);
        }
    }
    sheet.triangles.resize(3, 2 * (kColumns - 1) * (kRows - 1));
    Eigen::Index t = 0;
    for (int r = 0; r + 1 < kRows; ++r) {
        for (int c = 0; c + 1 < kColumns; ++c) {
            const int i = r * kColumns + c;
            sheet.triangles.col(t++) << i, i + kColumns, i + 1;
            sheet.triangles.col(t++) << i + 1, i + kColumns, i + kColumns + 1;
        }
    }
    return test::scan_of(sheet);
}

class ClosedLips : public ::testing::Test {
protected:
    ClosedLips()
        : scan_(std::make_shared<const Scan>(closed_scan())), face_(fit_face(scan_, landmarks())) {}

public:
    static Landmarks landmarks() {
        Landmarks front = test::small_face().landmarks;
        std::erase_if(front, [](const auto& entry) {
            return std::abs(entry.second.position.x()) > 50.0 || entry.first == "tr";
        });
        return front;
    }

protected:
    Points posed(const char* expression, double intensity) const {
        Simulator simulator(face_);
        std::vector<double> rates(face_->muscles.size(), 0.0);
        add_expression(rates, expression_named(expression), intensity);
        for (std::size_t m = 0; m < rates.size(); ++m) {
            if (rates[m] != 0.0) {
                simulator.set_contraction(static_cast<int>(m), rates[m]);
            }
        }
        const StepReport report = simulator.settle();
        EXPECT_TRUE(report.finite) << expression;
        return simulator.state().positions;
    }

    std::shared_ptr<const Scan> scan_;
    std::shared_ptr<const FaceModel> face_;
};

TEST_F(ClosedLips, ArePartedFromCornerToCorner) {
    EXPECT_GT(face_->node_count(), face_->own_nodes + 30);
    EXPECT_EQ(face_->own_nodes, scan_->mesh.vertex_count());
    double left = 0.0;
    double right = 0.0;
    for (int v = face_->own_nodes; v < face_->node_count(); ++v) {
        left = std::max(left, face_->generic(0, v));
        right = std::min(right, face_->generic(0, v));
        EXPECT_NEAR(face_->generic(1, v), -52.0, 2.0);
    }
    EXPECT_GT(left, 19.0);
    EXPECT_LT(right, -19.0);
    // Margins hang together with their own lip only.
    for (const MeshEdge& edge : face_->adjacency->edges()) {
        const auto [a, b] = edge.vertices;
        if (std::abs(face_->generic(0, a)) < 18.0 && std::abs(face_->generic(0, b)) < 18.0) {
            EXPECT_GE(face_->lip_side[static_cast<std::size_t>(a)] *
                          face_->lip_side[static_cast<std::size_t>(b)],
                      0);
        }
    }
}

TEST_F(ClosedLips, KeepTheFilesVerticesFirstAndInOrder) {
    const Eigen::Index own = scan_->mesh.vertices.cols();
    EXPECT_EQ(face_->scan->mesh.vertices.leftCols(own), scan_->mesh.vertices);
    EXPECT_EQ(face_->scan->file_vertices.leftCols(own), scan_->file_vertices);
    EXPECT_TRUE(face_->scan->mesh.vertices.allFinite());
    double area = 0.0;
    double before = 0.0;
    for (int t = 0; t < face_->scan->mesh.triangle_count(); ++t) {
        area += double_area_vector(face_->scan->mesh, t).norm();
    }
    for (int t = 0; t < scan_->mesh.triangle_count(); ++t) {
        before += double_area_vector(scan_->mesh, t).norm();
    }
    EXPECT_NEAR(area / before, 1.0, 1e-4);
}

TEST_F(ClosedLips, GetALiningBehindThem) {
    const MouthLining& mouth = face_->mouth;
    ASSERT_GT(mouth.mesh.triangle_count(), 100);
    EXPECT_EQ(mouth.with_jaw.size(), mouth.mesh.vertex_count());
    const Bvh skin(face_->skin.mesh);
    for (int v = 0; v < mouth.mesh.vertex_count(); ++v) {  // none of it comes out of the face
        const Vec3 p = mouth.mesh.vertices.col(v);
        const ViewRay ahead{p, face_->axes.col(2)};
        EXPECT_TRUE(skin.first_hit(face_->skin.mesh, ahead)) << v;
    }
    EXPECT_EQ(test::small_model()->mouth.mesh.triangle_count(), 0);
}

TEST_F(ClosedLips, OpenWithTheJaw) {
    const Points open = posed("jaw_open", 0.6);
    double gap = 0.0;
    for (const auto& [upper, lower] : face_->lip_contacts) {
        gap = std::max(gap, (open.col(upper) - open.col(lower)).norm());
    }
    EXPECT_GT(face_->lip_contacts.size(), 10U);
    EXPECT_GT(gap, 8.0);
}

TEST_F(ClosedLips, AreWrittenAsTheyCameWhileTheyTouch) {
    const test::TemporaryFolder folder;
    write_face(folder / "closed.ply", *scan_, *face_, face_->skin.mesh.vertices, 0.0);
    EXPECT_EQ(read_mesh(folder / "closed.ply").mesh.vertex_count(), scan_->mesh.vertex_count());
    write_face(folder / "open.ply", *scan_, *face_, posed("jaw_open", 0.6), 0.6);
    EXPECT_EQ(read_mesh(folder / "open.ply").mesh.vertex_count(), face_->scan->mesh.vertex_count());
}

TEST_F(ClosedLips, CarryAShapeOfTheScansOwnNodes) {
    Points shape = Points::Zero(3, scan_->mesh.vertex_count());
    shape.row(2).setConstant(1.5);
    const Points skin = shaped_skin(*face_, shape);
    ASSERT_EQ(skin.cols(), face_->node_count());
    EXPECT_NEAR((skin - face_->skin.mesh.vertices).row(2).minCoeff(), 1.5, 1e-12);
    EXPECT_TRUE(shape_of_scan(*face_, skin).isApprox(shape, 1e-12));
    EXPECT_EQ(shape_of_scan(*face_, face_->skin.mesh.vertices).cols(), 0);
    EXPECT_THROW(shaped_skin(*face_, Points::Zero(3, 5)), InvalidInput);
}

TEST(ClosedLipsOfAnInwardScan, KeepTheFilesWinding) {
    TriangleMesh sheet = closed_scan().mesh;
    sheet.triangles.row(0).swap(sheet.triangles.row(1));
    Scan scan = test::scan_of(sheet);
    examine(scan);
    const auto face = fit_face(std::make_shared<const Scan>(scan), ClosedLips::landmarks());
    ASSERT_GT(face->scan->faces.count(), scan.faces.count());
    const Polygons& faces = face->scan->faces;
    const Points& v = face->scan->mesh.vertices;
    for (int f = 0; f < faces.count(); ++f) {
        const auto k = static_cast<std::size_t>(faces.start[static_cast<std::size_t>(f)]);
        const Vec3 a = v.col(faces.vertex[k]);
        const Vec3 b = v.col(faces.vertex[k + 1]);
        const Vec3 c = v.col(faces.vertex[k + 2]);
        EXPECT_LE((b - a).cross(c - a).z(), 0.0) << f;
    }
}

TEST(OpenLips, AreLeftAlone) {
    const auto face = test::small_model();
    EXPECT_EQ(face->own_nodes, face->node_count());
    EXPECT_EQ(face->scan->mesh.vertex_count(), test::small_face().scan.mesh.vertex_count());
}

}  // namespace
}  // namespace myoface
