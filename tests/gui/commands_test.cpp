// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include <cmath>

#include <gtest/gtest.h>

#include "test_meshes.h"

namespace myoface {
namespace {

struct Document {
    FaceDocument document;

    Document() {
        const auto model = test::small_model();
        document.setFace(std::make_shared<OpenedFace>(), model, resting(*model),
                         model->skin.mesh.vertices);
    }
    double rate(int muscle) const {
        return document.contractions().rate[static_cast<std::size_t>(muscle)];
    }
    void set(double rate, int gesture) {
        document.undoStack()->push(new SetMusclesCommand(
            document, MuscleSetting::Rate, {2, 3}, {rate, rate}, gesture, QStringLiteral("x")));
    }
};

TEST(SetMusclesCommand, UndoesAndRedoes) {
    Document d;
    d.set(0.5, 1);
    EXPECT_DOUBLE_EQ(d.rate(3), 0.5);
    d.document.undoStack()->undo();
    EXPECT_DOUBLE_EQ(d.rate(2), 0.0);
    d.document.undoStack()->redo();
    EXPECT_DOUBLE_EQ(d.rate(2), 0.5);
}

TEST(SetMusclesCommand, MakesOneStepOfOneGesture) {
    Document d;
    d.set(0.2, 1);
    d.set(0.4, 1);
    d.set(0.6, 1);
    d.set(0.9, 2);
    EXPECT_EQ(d.document.undoStack()->count(), 2);
    d.document.undoStack()->undo();
    EXPECT_DOUBLE_EQ(d.rate(2), 0.6);
    d.document.undoStack()->undo();
    EXPECT_DOUBLE_EQ(d.rate(2), 0.0);
}

TEST(SetMusclesCommand, LeavesNoStepWhenTheSliderComesBack) {
    Document d;
    d.set(0.2, 1);
    d.set(0.0, 1);
    EXPECT_EQ(d.document.undoStack()->count(), 0);
}

TEST(SetSkinAgeCommand, IsOneStepOfOneGestureAndIsKept) {
    Document d;
    const auto set = [&](double years, int gesture) {
        d.document.undoStack()->push(
            new SetSkinAgeCommand(d.document, years, gesture, QStringLiteral("x")));
    };
    EXPECT_EQ(d.document.skinAge(), kUsualSkin);
    set(50, 1);
    set(60, 1);
    set(70, 2);
    EXPECT_EQ(d.document.undoStack()->count(), 2);
    EXPECT_EQ(d.document.state().skin_age, 70.0);
    d.document.undoStack()->undo();
    EXPECT_EQ(d.document.skinAge(), 60.0);
    d.document.undoStack()->undo();
    EXPECT_EQ(d.document.skinAge(), kUsualSkin);
    set(50, 3);
    set(kUsualSkin, 3);
    EXPECT_EQ(d.document.undoStack()->index(), 0);
}

TEST(ReshapeCommand, SwapsTheMovedNodesOnly) {
    Document d;
    const Points before = d.document.skinRest();
    Points after = before;
    after.col(5) += Vec3(1, 2, 3);
    d.document.undoStack()->push(
        new ReshapeCommand(d.document, before, after, QStringLiteral("shape")));
    EXPECT_EQ(d.document.skinRest(), after);
    d.document.undoStack()->undo();
    EXPECT_EQ(d.document.skinRest(), before);
}

TEST(ReshapeCommand, IsUndoneOnAFaceThatWasFittedWithOtherNodes) {
    Document d;
    const auto whole = test::small_model();
    const auto coarser =
        fit_face(std::make_shared<const Scan>(test::small_face().scan),
                 test::small_face().landmarks, nullptr, FitOptions{.finest = 1000});
    const Points before = d.document.skinRest();
    Points after = before;
    for (Eigen::Index i = 0; i < after.cols(); ++i) {
        after(2, i) += 3.0 * std::exp(-(after.col(i) - Vec3(0, -20, 110)).squaredNorm() / 300.0);
    }
    d.document.undoStack()->push(
        new ReshapeCommand(d.document, before, after, QStringLiteral("shape")));
    const Points shape = shape_of_scan(*whole, d.document.skinRest());
    d.document.setModel(coarser, shaped_skin(*coarser, shape));
    EXPECT_GT((d.document.skinRest() - coarser->skin.mesh.vertices).norm(), 1.0);
    d.document.undoStack()->undo();
    EXPECT_LT((d.document.skinRest() - coarser->skin.mesh.vertices).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SetTissueCommand, IsKeptInWhatIsSavedAndUndone) {
    Document d;
    d.document.undoStack()->push(
        new SetTissueCommand(d.document, TissueThickness::Heavy, QStringLiteral("tissue")));
    EXPECT_EQ(d.document.asSaved().fit.tissue, TissueThickness::Heavy);
    d.document.undoStack()->undo();
    EXPECT_EQ(d.document.asSaved().fit.tissue, TissueThickness::Mean);
}

}  // namespace
}  // namespace myoface
