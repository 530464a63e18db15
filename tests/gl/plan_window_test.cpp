// SPDX-License-Identifier: Apache-2.0
// Plans and protected cases in the real window.
#include <QUndoStack>

#include "myoface/io/text_file.h"
#include "myoface/sim/plan_file.h"

#include "face_files.h"
#include "plan_files.h"
#include "shape_panel.h"
#include "window_fixture.h"

namespace myoface {
namespace {

using test::kPatience;

class PlanWindow : public test::Window {
protected:
    bool done(int steps) {
        return QTest::qWaitFor([&] { return window_.document().undoStack()->index() == steps; },
                               kPatience) &&
               settle();
    }
    QString file(const char* name) { return QString::fromStdString((folder_ / name).string()); }
};

TEST_F(PlanWindow, WritesItsHistoryAndRepeatsItOnAnotherFace) {
    open(path_);
    ASSERT_TRUE(settle());
    drag(pixel("pg"), {4, 18});
    ASSERT_TRUE(done(1));
    window_.setRates("zygomaticus_major.L", 0.5);
    ASSERT_TRUE(settle());
    QTest::keyClick(&window_.view(), Qt::Key_Up, Qt::ShiftModifier);  // the last grip, by 1 mm
    ASSERT_TRUE(done(3));
    const Points shaped = window_.document().skinRest();
    const QString plan = file("plan.json");
    ASSERT_TRUE(window_.plans().exportTo(plan));
    const RecordedPlan written = recorded_plan_from_json(read_file(plan.toStdString()), "plan");
    ASSERT_EQ(written.edits.size(), 3U);
    EXPECT_EQ(std::get<DragEdit>(written.edits[0]).place->near, "pg");
    EXPECT_DOUBLE_EQ(std::get<ContractionEdit>(written.edits[1]).rate, 0.5);

    while (window_.document().undoStack()->canUndo()) {
        window_.document().undoStack()->undo();
    }
    ASSERT_TRUE(settle());
    EXPECT_TRUE(window_.document().plan().empty());
    window_.plans().apply(plan);
    ASSERT_TRUE(done(1));
    const double largest =
        (shaped - window_.document().model()->skin.mesh.vertices).colwise().norm().maxCoeff();
    const double off = (window_.document().skinRest() - shaped).colwise().norm().maxCoeff();
    EXPECT_GT(largest, 2.0);
    EXPECT_LT(off, 0.05 * largest);  // frames of a live hand against one pull to rest
    EXPECT_TRUE(window_.document().undoStack()->undoText().contains("plan"));
    EXPECT_EQ(window_.document().plan().size(), 3U);
    window_.document().undoStack()->undo();
    EXPECT_EQ(window_.document().skinRest(), window_.document().model()->skin.mesh.vertices);
    EXPECT_EQ(window_.document().contractions().rate,
              std::vector<double>(window_.document().contractions().rate.size(), 0.0));
}

TEST_F(PlanWindow, KeepsItsPlanInTheCase) {
    open(path_);
    ASSERT_TRUE(settle());
    drag(pixel("prn"), {0, -10});
    ASSERT_TRUE(done(1));
    ASSERT_TRUE(saved(file("c.myoface")));
    EXPECT_FALSE(case_thumbnail(file("c.myoface").toStdString()).empty());
    open(file("c.myoface"));
    ASSERT_TRUE(settle());
    ASSERT_EQ(window_.document().plan().size(), 1U);
    window_.setRates("mentalis", 0.4);
    EXPECT_EQ(window_.document().plan().size(), 3U);  // both sides
}

TEST_F(PlanWindow, SaysWhatIsWrongWithAPlan) {
    open(path_);
    ASSERT_TRUE(settle());
    write_file(folder_ / "bad.json", "{\"plan\": [{\"drag\": \"mov=1\"}]}");
    window_.plans().apply(file("bad.json"));
    EXPECT_TRUE(window_.lastProblem().contains("edit 1"));
    write_file(folder_ / "half.json",
               "{\"plan\": [{\"muscle\": \"mentalis\", \"rate\": 0.3}, {\"drag\": \"at=tail\"}]}");
    window_.plans().apply(file("half.json"));
    ASSERT_TRUE(done(1));
    EXPECT_TRUE(window_.lastProblem().contains("1 of 2"));
    EXPECT_TRUE(window_.lastProblem().contains("tail"));
}

TEST_F(PlanWindow, ProtectsACase) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.document().setPassphrase("seven quiet herons");
    EXPECT_TRUE(window_.isWindowModified());
    ASSERT_TRUE(saved(file("c.myoface")));
    EXPECT_THROW(open_face((folder_ / "c.myoface").string()), PassphraseNeeded);
    OpenOptions options;
    options.passphrase = "seven quiet herons";
    EXPECT_NO_THROW(open_face((folder_ / "c.myoface").string(), options));
    open(path_);  // another face is not protected
    EXPECT_TRUE(window_.document().passphrase().empty());
    open(file("c.myoface"));  // nobody is there to be asked
    EXPECT_TRUE(window_.lastProblem().contains("passphrase"));
}

}  // namespace
}  // namespace myoface
