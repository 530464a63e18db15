// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

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
        document.undoStack()->push(
            new SetRatesCommand(document, {2, 3}, {rate, rate}, gesture, QStringLiteral("x")));
    }
};

TEST(SetRatesCommand, UndoesAndRedoes) {
    Document d;
    d.set(0.5, 1);
    EXPECT_DOUBLE_EQ(d.rate(3), 0.5);
    d.document.undoStack()->undo();
    EXPECT_DOUBLE_EQ(d.rate(2), 0.0);
    d.document.undoStack()->redo();
    EXPECT_DOUBLE_EQ(d.rate(2), 0.5);
}

TEST(SetRatesCommand, MakesOneStepOfOneGesture) {
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

TEST(SetRatesCommand, LeavesNoStepWhenTheSliderComesBack) {
    Document d;
    d.set(0.2, 1);
    d.set(0.0, 1);
    EXPECT_EQ(d.document.undoStack()->count(), 0);
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

}  // namespace
}  // namespace myoface
