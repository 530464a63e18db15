// SPDX-License-Identifier: Apache-2.0
// The real window with real mouse events.
#include <algorithm>
#include <random>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QDropEvent>
#include <QInputDialog>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>
#include <QtTest>
#include <gtest/gtest.h>

#include "myoface/face/muscle_atlas.h"
#include "myoface/io/mesh_file.h"
#include "myoface/measure/landmarks_on_skin.h"
#include "myoface/measure/volume.h"

#include "action_search.h"
#include "callipers.h"
#include "compare_panel.h"
#include "comparison.h"
#include "face_files.h"
#include "journal_keeper.h"
#include "landmark_panel.h"
#include "main_window.h"
#include "measure_panel.h"
#include "muscle_panel.h"
#include "shape_panel.h"
#include "test_meshes.h"
#include "thorough.h"
#include "window_fixture.h"

namespace myoface {
namespace {

using test::kPatience;
using test::Window;

TEST_F(Window, OpensAFaceAndComesToRest) {
    open(path_);
    EXPECT_TRUE(window_.document().model());
    EXPECT_TRUE(settle());
    EXPECT_TRUE(window_.windowTitle().contains("face.ply"));
}

TEST_F(Window, MovesALandmarkFitsAnewAndUndoesIt) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.showLandmarks();
    ASSERT_TRUE(settle());
    const Landmarks before = window_.document().landmarks();
    const auto model = window_.document().model();
    const Vec3 midway = model->muscles[0].path.col(0);
    drag(pixel("ch_l"), {8, 5});
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window_.document().model() != model && window_.settled(); }, kPatience));
    const Landmark& moved = window_.document().landmarks().at("ch_l");
    EXPECT_GT((moved.position - before.at("ch_l").position).norm(), 1.0);
    EXPECT_LE(moved.error_mm, kCheckedError);
    EXPECT_EQ(window_.document().landmarks().at("ch_r").position, before.at("ch_r").position);
    EXPECT_LT((window_.document().model()->muscles[0].path.col(0) - midway).norm(), 5.0);
    const auto second = window_.document().model();
    window_.document().undoStack()->undo();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window_.document().model() != second && window_.settled(); }, kPatience));
    EXPECT_EQ(window_.document().landmarks().at("ch_l").position, before.at("ch_l").position);
}

TEST_F(Window, LooksForLandmarksBesideTheWindow) {
    open(path_);
    ASSERT_TRUE(settle());
    auto* panel = window_.findChild<LandmarkPanel*>();
    ASSERT_NE(panel, nullptr);
    const Landmarks before = window_.document().landmarks();
    Q_EMIT panel->detectionAsked();
    EXPECT_FALSE(window_.settled());  // the window goes on meanwhile
    ASSERT_TRUE(settle());
    const Landmarks found = window_.document().landmarks();
    EXPECT_NE(found.at("prn").position, before.at("prn").position);
    EXPECT_LT((found.at("prn").position - before.at("prn").position).norm(), 5.0);
}

TEST_F(Window, FitsAnewToAnotherTissueDepth) {
    open(path_);
    ASSERT_TRUE(settle());
    auto* panel = window_.findChild<LandmarkPanel*>();
    ASSERT_NE(panel, nullptr);
    const auto model = window_.document().model();
    Q_EMIT panel->tissueChosen(TissueThickness::Heavy);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window_.document().model() != model && window_.settled(); }, kPatience));
    double mean = 0.0;
    double heavy = 0.0;
    for (std::size_t v = 0; v < model->tissue.size(); ++v) {
        mean += model->tissue[v].depth;
        heavy += window_.document().model()->tissue[v].depth;
    }
    EXPECT_GT(heavy, 1.1 * mean);
}

TEST_F(Window, ComesToRestWithAnExpression) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.addExpression("joy", 0.8);
    EXPECT_FALSE(window_.settled());
    EXPECT_TRUE(settle());
    const auto& rates = window_.document().contractions().rate;
    EXPECT_GT(*std::max_element(rates.begin(), rates.end()), 0.5);
}

TEST_F(Window, ShapesTheSkinUnderTheMouseAndUndoesIt) {
    open(path_);
    ASSERT_TRUE(settle());
    const Points before = window_.document().skinRest();
    drag(pixel("pg"), {0, 25});
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return window_.document().undoStack()->count() == 1; }, kPatience));
    ASSERT_TRUE(settle());
    const double moved = (window_.document().skinRest() - before).colwise().norm().maxCoeff();
    EXPECT_GT(moved, 2.0);
    EXPECT_LT(moved, 40.0);
    window_.document().undoStack()->undo();
    EXPECT_EQ(window_.document().skinRest(), before);
    window_.document().undoStack()->redo();
    EXPECT_NE(window_.document().skinRest(), before);
    EXPECT_TRUE(settle());
}

TEST_F(Window, FeelsWithoutKeeping) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.view().setTool(Tool::Feel);
    const Points before = window_.document().skinRest();
    drag(pixel("pg"), {20, 0});
    ASSERT_TRUE(settle());
    EXPECT_EQ(window_.document().undoStack()->count(), 0);
    EXPECT_EQ(window_.document().skinRest(), before);
}

TEST_F(Window, ShapesInBothProjections) {
    open(path_);
    ASSERT_TRUE(settle());
    for (const bool orthographic : {false, true}) {
        window_.view().setOrthographic(orthographic);
        drag(pixel("ch_l"), {12, -9});
        ASSERT_TRUE(settle());
        EXPECT_EQ(window_.document().undoStack()->index(), 1);
        window_.document().undoStack()->undo();
        ASSERT_TRUE(settle());
    }
}

TEST_F(Window, ShapesOnBothSidesWhenToldSo) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.view().setFocus();
    QTest::keyClick(&window_.view(), Qt::Key_X);
    EXPECT_TRUE(window_.shape().mirrored());
    drag(pixel("ch_l"), {14, 0});
    ASSERT_TRUE(settle());
    const FaceModel& face = *window_.document().model();
    const Points moved = window_.document().skinRest() - face.skin.mesh.vertices;
    double left = 0.0;
    double right = 0.0;
    for (int i = 0; i < face.node_count(); ++i) {
        double& side = face.generic(0, i) > 0.0 ? left : right;
        side = std::max(side, moved.col(i).norm());
    }
    EXPECT_GT(left, 1.0);
    EXPECT_NEAR(right, left, 0.25 * left);
}

TEST_F(Window, AddsAVolumeByAClickAndTakesItBack) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.view().setTool(Tool::Volume);
    QSignalSpy changed(&window_.document(), &FaceDocument::skinRestChanged);
    QWindow* native = window_.windowHandle();
    QTest::mouseClick(native, Qt::LeftButton, {}, window_.view().mapTo(&window_, pixel("pg")));
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return window_.document().undoStack()->count() == 1; }, kPatience));
    const FaceModel& face = *window_.document().model();
    EXPECT_NEAR(swept_volume(face.skin.mesh.triangles, face.skin.mesh.vertices,
                             window_.document().skinRest()),
                500.0, 15.0);  // half a millilitre
    EXPECT_TRUE(window_.document().undoStack()->undoText().contains("mL"));
    window_.document().undoStack()->undo();
    EXPECT_EQ(window_.document().skinRest(), face.skin.mesh.vertices);
}

TEST_F(Window, NudgesTheLastGripByTheArrowKeys) {
    open(path_);
    ASSERT_TRUE(settle());
    drag(pixel("prn"), {0, -4});
    ASSERT_TRUE(settle());
    const int before = window_.document().undoStack()->count();
    ASSERT_EQ(before, 1);
    const Points shaped = window_.document().skinRest();
    QTest::keyClick(&window_.view(), Qt::Key_Up, Qt::ShiftModifier);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] { return window_.document().undoStack()->count() == before + 1; }, kPatience));
    const Points moved = window_.document().skinRest() - shaped;
    EXPECT_NEAR(moved.row(1).maxCoeff(), 1.0, 0.15);  // ten steps of 0.1 mm, upwards
}

TEST_F(Window, ShapesUntilAMeasureIsMetOrSaysWhyNot) {
    open(path_);
    ASSERT_TRUE(settle());
    auto* target = window_.shape().findChild<QDoubleSpinBox*>("target");
    auto* meet = window_.shape().findChild<QPushButton*>("meet");
    ASSERT_TRUE(target && meet);
    const double before = target->value();
    target->setValue(before - 2.0);  // tip projection
    meet->click();
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return window_.document().undoStack()->count() == 1; }, kPatience));
    const LandmarksOnSkin places(window_.document().model());
    const Points& rest = window_.document().skinRest();
    EXPECT_NEAR(*places.measure(target_measure("tip projection"), rest), before - 2.0, 0.1);
    target->setValue(before + 45.0);
    meet->click();
    auto* words = window_.shape().findChild<QLabel*>("words");
    ASSERT_TRUE(
        QTest::qWaitFor([&] { return words->text().contains("tip projection stays"); }, kPatience));
    EXPECT_EQ(window_.document().undoStack()->count(), 1);
}

TEST_F(Window, ProtectedSkinIsNotGripped) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.view().setTool(Tool::Protect);
    drag(pixel("prn"), {6, 0});
    EXPECT_EQ(window_.document().undoStack()->count(), 1);  // the stroke is one step
    EXPECT_GT(window_.document().protection().maxCoeff(), 0.9);
    window_.view().setTool(Tool::Shape);
    drag(pixel("prn"), {0, -20});
    ASSERT_TRUE(settle());
    EXPECT_EQ(window_.document().undoStack()->count(), 1);
    auto* words = window_.shape().findChild<QLabel*>("words");
    EXPECT_TRUE(words->text().contains("protected"));
    window_.document().undoStack()->undo();
    drag(pixel("prn"), {0, -20});
    ASSERT_TRUE(settle());
    EXPECT_EQ(window_.document().undoStack()->count(), 1);  // shaped in place of the stroke
    EXPECT_NE(window_.document().skinRest(), window_.document().model()->skin.mesh.vertices);
}

TEST_F(Window, EveryStepShowsItsPanels) {
    open(path_);
    ASSERT_TRUE(settle());
    const std::map<QString, QString> panel{{"scan", "scan"},       {"fit", "landmarks"},
                                           {"shape", "shape"},     {"expression", "muscles"},
                                           {"compare", "compare"}, {"report", "report"}};
    for (const auto& [step, name] : panel) {
        auto* action = window_.findChild<QAction*>("step-" + step);
        ASSERT_NE(action, nullptr);
        action->trigger();
        EXPECT_EQ(window_.step(), step);
        for (const auto& [other, hidden] : panel) {
            EXPECT_EQ(window_.findChild<QDockWidget*>(hidden)->isVisible(), hidden == name)
                << step.toStdString() << ' ' << hidden.toStdString();
        }
    }
    // What was moved by hand comes back with its step.
    window_.showStep("shape");
    window_.findChild<QDockWidget*>("history")->hide();
    window_.showStep("scan");
    window_.showStep("shape");
    EXPECT_FALSE(window_.findChild<QDockWidget*>("history")->isVisible());
}

TEST_F(Window, ComparesBeforeAndAfter) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.showStep("compare");
    window_.addExpression("joy", 1.0);
    ASSERT_TRUE(settle());
    ComparePanel& panel = window_.comparePanel();
    std::vector<QImage> pictures{window_.view().grabFramebuffer()};
    for (const CompareMode mode :
         {CompareMode::SideBySide, CompareMode::Wipe, CompareMode::Ghost}) {
        panel.setMode(mode);
        ASSERT_TRUE(settle());
        EXPECT_EQ(window_.view().compareMode(), mode);
        pictures.push_back(window_.view().grabFramebuffer());
    }
    panel.setMap(true);
    pictures.push_back(window_.view().grabFramebuffer());
    panel.setMode(CompareMode::Off);
    for (std::size_t a = 0; a < pictures.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            EXPECT_NE(pictures[a], pictures[b]) << a << ' ' << b;
        }
    }
    EXPECT_EQ(window_.view().grabFramebuffer(), pictures[0]);  // nothing is left behind
    // A share of the change is between before and now.
    const auto width = [&] {
        for (const Measurement& row : window_.measures().rows()) {
            if (row.measure.id == "ch-ch") {
                return *row.other;
            }
        }
        return 0.0;
    };
    QTest::qWait(150);
    panel.setShare(0.0);
    QTest::qWait(20);
    const double before = width();
    QTest::qWait(150);
    panel.setShare(0.5);
    const double half = width();
    QTest::qWait(150);
    panel.setShare(1.0);
    const double now = width();
    EXPECT_GT(now, before + 4.0);
    EXPECT_NEAR(half, 0.5 * (before + now), 0.3);
}

TEST_F(Window, DragsTheWipeWithTheMouse) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.comparePanel().setMode(CompareMode::Wipe);
    ASSERT_TRUE(settle());
    const int width = window_.view().width();
    drag({width / 2, 40}, {width / 4, 0});
    EXPECT_NEAR(window_.view().wipe(), 0.75, 0.02);
    EXPECT_EQ(window_.document().undoStack()->count(), 0);
}

TEST_F(Window, KeepsVariantsAndComparesWithThem) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.setRates("zygomaticus_major", 1.0);
    ASSERT_TRUE(settle());
    window_.comparison().storeVariant();
    ASSERT_EQ(window_.document().variants().size(), 1U);
    EXPECT_EQ(window_.document().variants()[0].name, "A");
    window_.document().undoStack()->undo();
    window_.document().undoStack()->undo();
    ASSERT_TRUE(settle());
    EXPECT_TRUE(window_.document().variants().empty());
    window_.document().undoStack()->redo();
    window_.document().undoStack()->redo();
    window_.setRates("zygomaticus_major", 0.0);
    ASSERT_TRUE(settle());
    window_.comparePanel().setReference(0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_.settled(); }, kPatience));
    const Points& smile = window_.comparison().before();
    EXPECT_GT((smile.leftCols(window_.document().skinRest().cols()) -
               window_.document().model()->skin.mesh.vertices)
                  .colwise()
                  .norm()
                  .maxCoeff(),
              5.0);
    Q_EMIT window_.comparePanel().showAsked(0);
    const auto& rates = window_.document().contractions().rate;
    EXPECT_EQ(*std::max_element(rates.begin(), rates.end()), 1.0);
    // They come back with the case.
    const QString file = QString::fromStdString((folder_ / "v.myoface").string());
    bool saved = false;
    window_.files().saveCaseTo(file, [&] { saved = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, kPatience));
    open(file);
    ASSERT_EQ(window_.document().variants().size(), 1U);
    EXPECT_EQ(window_.document().variants()[0].rates.at("zygomaticus_major.L"), 1.0);
}

TEST_F(Window, MeasuresWithTheCallipers) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.view().setTool(Tool::Measure);
    QWindow* native = window_.windowHandle();
    const auto click = [&](const std::string& landmark) {
        QTest::mouseClick(native, Qt::LeftButton, {},
                          window_.view().mapTo(&window_, pixel(landmark)));
    };
    QSignalSpy hints(&window_.view(), &FaceView::measured);
    click("en_l");
    click("en_r");
    EXPECT_EQ(hints.count(), 2);
    EXPECT_EQ(window_.document().undoStack()->count(), 0);
    const Landmarks& marks = test::small_face().landmarks;
    const double apart = (marks.at("en_l").position - marks.at("en_r").position).norm();
    const QString words = window_.findChild<Callipers*>()->words();
    const double shown = words.section(' ', 0, 0).toDouble();
    EXPECT_NEAR(shown, apart, 1.5) << words.toStdString();
    const double along = words.section(' ', -2, -2).toDouble();
    EXPECT_GT(along, shown);
    QTest::keyClick(&window_.view(), Qt::Key_Escape);
    EXPECT_TRUE(window_.findChild<Callipers*>()->words().isEmpty());
}

TEST_F(Window, WeakMusclesSmileLess) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.showStep("expression");
    auto* list = window_.muscles().findChild<QComboBox*>("weakening");
    ASSERT_NE(list, nullptr);
    list->setCurrentIndex(list->findData("palsy_6"));
    Q_EMIT list->activated(list->currentIndex());
    const auto& strength = window_.document().contractions().strength;
    EXPECT_EQ(*std::min_element(strength.begin(), strength.end()), 0.0);
    window_.addExpression("full_smile", 1.0);
    ASSERT_TRUE(settle());
    window_.document().undoStack()->undo();
    window_.document().undoStack()->undo();
    EXPECT_EQ(*std::min_element(strength.begin(), strength.end()), 1.0);
}

TEST_F(Window, IsSpokenInJapaneseAndBack) {
    open(path_);
    ASSERT_TRUE(settle());
    Settings settings;
    auto* step = window_.findChild<QAction*>("step-shape");
    const QString english = step->text();
    settings.language = "ja";
    window_.applySettings(settings);
    EXPECT_NE(step->text(), english);
    EXPECT_FALSE(window_.muscles().slider(0)->accessibleName().isEmpty());
    settings.language = "en";
    settings.theme = Theme::Light;
    window_.applySettings(settings);
    EXPECT_EQ(step->text(), english);
    settings.theme = Theme::Dark;
    window_.applySettings(settings);
    EXPECT_TRUE(settle());
}

TEST_F(Window, FindsActionsByTheirName) {
    ActionSearch* search = new ActionSearch(actionsOf(window_), &window_);
    search->show();
    auto* text = search->findChild<QLineEdit*>();
    auto* found = search->findChild<QListWidget*>();
    const int all = found->count();
    EXPECT_GT(all, 25);
    QTest::keyClicks(text, "side by");
    EXPECT_EQ(found->count(), 1);
    QTest::keyClick(text, Qt::Key_Return);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return window_.comparePanel().mode() == CompareMode::SideBySide; }));
}

TEST_F(Window, BringsBackWhatWasNotSaved) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.setRates("risorius", 0.7);
    window_.document().setNotes("half a gesture");
    drag(pixel("prn"), {0, -14});
    ASSERT_TRUE(settle());
    const Points shape = window_.document().skinRest();
    window_.journal().flush();
    // The journal as a crash would leave it: copied while the window lives.
    const std::filesystem::path crashed = folder_ / "crashed";
    std::filesystem::copy(window_.journal().folder(), crashed,
                          std::filesystem::copy_options::recursive);
    const std::vector<Recovery> found = recoverable(crashed);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].name, "face.ply");
    QSignalSpy opened(&window_, &MainWindow::opened);
    window_.recover(found[0]);
    ASSERT_TRUE(QTest::qWaitFor([&] { return opened.count() == 1; }, kPatience));
    ASSERT_TRUE(settle());
    EXPECT_LT((window_.document().skinRest() - shape).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_EQ(window_.document().notes(), "half a gesture");
    EXPECT_TRUE(window_.isWindowModified());
    EXPECT_TRUE(recoverable(crashed).empty());  // it lives in the window's own journal now
}

TEST_F(Window, WritesAReportBesideTheWindow) {
    open(path_);
    ASSERT_TRUE(settle());
    const QString file = QString::fromStdString((folder_ / "report.pdf").string());
    QSignalSpy written(&window_, &MainWindow::reportWritten);
    window_.document().setNotes("tip and chin");
    window_.exportReport(file);
    ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 1; }, kPatience))
        << window_.lastProblem().toStdString();
    QFile pdf(file);
    ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
    EXPECT_EQ(pdf.read(5), QByteArray("%PDF-"));
}

TEST_F(Window, TurnsTheHeadBesideTheFaceAndWithTheMiddleButton) {
    open(path_);
    const auto start = window_.view().camera().orientation;
    drag({20, 20}, {60, 10});
    const auto turned = window_.view().camera().orientation;
    EXPECT_GT(start.angularDistance(turned), 0.1);
    drag(pixel("prn"), {60, 0}, Qt::MiddleButton);
    EXPECT_GT(turned.angularDistance(window_.view().camera().orientation), 0.1);
    EXPECT_EQ(window_.document().undoStack()->count(), 0);
}

TEST_F(Window, ComesNearerByTwoFingersOnATouchPad) {
    FaceView& view = window_.view();
    const double before = view.camera().distance;
    const QPointF middle = view.rect().center();
    QNativeGestureEvent pinch(Qt::ZoomNativeGesture, nullptr, middle, middle, middle, 0.25, 0, 0);
    QApplication::sendEvent(&view, &pinch);
    EXPECT_NEAR(view.camera().distance, before / 1.25, 1e-6);
}

TEST_F(Window, SmilesWithTheSliderAndResets) {
    open(path_);
    ASSERT_TRUE(settle());
    const int m = test::muscle(*window_.document().model(), "zygomaticus_major.L");
    window_.muscles().slider(m)->setValue(80);
    EXPECT_DOUBLE_EQ(window_.document().contractions().rate[static_cast<std::size_t>(m)], 0.8);
    EXPECT_DOUBLE_EQ(window_.document().contractions().rate[static_cast<std::size_t>(m) + 1], 0.8);
    ASSERT_TRUE(settle());
    window_.document().undoStack()->undo();
    EXPECT_EQ(window_.muscles().slider(m)->value(), 0);
    EXPECT_TRUE(settle());
}

TEST_F(Window, StaysAsItWasWhenAFileIsBad) {
    open(path_);
    ASSERT_TRUE(settle());
    const auto model = window_.document().model();
    open(QStringLiteral("no/such/file.obj"));
    EXPECT_TRUE(window_.lastProblem().contains("no such file"));
    EXPECT_EQ(window_.document().model(), model);
}

TEST_F(Window, TakesAFileThatIsDroppedOnIt) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path_)});
    QSignalSpy opened(&window_, &MainWindow::opened);
    QDropEvent event(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    static_cast<QObject&>(window_).event(&event);
    EXPECT_TRUE(QTest::qWaitFor([&] { return opened.count() == 1; }, kPatience));
}

TEST_F(Window, TurnsAScanByAQuarterAndKeepsItsLandmarks) {
    open(path_);
    QSignalSpy opened(&window_, &MainWindow::opened);
    for (QPushButton* button : window_.findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("Nod")) {
            button->click();
        }
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return opened.count() == 1; }, kPatience))
        << window_.lastProblem().toStdString();
    const OpenedFace& face = *window_.document().opened();
    EXPECT_EQ(face.report.axes, "+x+z-y");
    EXPECT_EQ(face.landmarks->size(), test::small_face().landmarks.size());
    EXPECT_TRUE(window_.document().model());
}

TEST_F(Window, CalibratesByTwoClicksAndADistance) {
    open(path_);
    QSignalSpy opened(&window_, &MainWindow::opened);
    for (QPushButton* button : window_.findChildren<QPushButton*>()) {
        if (button->text().startsWith(QStringLiteral("Calibrate"))) {
            button->click();
        }
    }
    QTimer answer;
    QObject::connect(&answer, &QTimer::timeout, [&] {
        if (auto* dialog = qobject_cast<QInputDialog*>(QApplication::activeModalWidget())) {
            answer.stop();
            dialog->setDoubleValue(40.0);
            dialog->accept();
        }
    });
    answer.start(50);
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, pixel("en_l"));
    QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, pixel("en_r"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return opened.count() == 1; }, kPatience))
        << window_.lastProblem().toStdString();
    const Landmarks& l = *window_.document().opened()->landmarks;
    EXPECT_NEAR((l.at("en_l").position - l.at("en_r").position).norm(), 40.0, 1.5);
}

TEST_F(Window, FindsLandmarksOfAScanThatHasNoneAndTakesThemByHand) {
    std::filesystem::remove(folder_ / "face.landmarks.json");
    open(path_);
    ASSERT_TRUE(window_.document().model());
    EXPECT_TRUE(window_.document().opened()->landmarks_detected);
    const auto actions = window_.findChildren<QAction*>();
    const auto byHand = std::find_if(actions.begin(), actions.end(), [](const QAction* action) {
        return action->text().contains(QStringLiteral("by hand"));
    });
    ASSERT_NE(byHand, actions.end());
    (*byHand)->trigger();
    QSignalSpy opened(&window_, &MainWindow::opened);
    const std::vector<std::string> names{"prn",  "sn",   "ls",   "sto",  "li",   "pg",
                                         "en_l", "en_r", "ex_l", "ex_r", "ch_l", "ch_r"};
    for (const std::string& name : names) {
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, pixel(name));
    }
    // The tragi are seen from the sides.
    for (const auto& [view, name] : {std::pair("left", "t_l"), std::pair("right", "t_r")}) {
        window_.view().showStandardView(QString::fromLatin1(view));
        QTest::mouseClick(&window_.view(), Qt::LeftButton, {}, pixel(name));
    }
    ASSERT_TRUE(QTest::qWaitFor([&] { return opened.count() == 1; }, kPatience))
        << window_.lastProblem().toStdString();
    EXPECT_TRUE(window_.document().model());
    EXPECT_FALSE(window_.document().opened()->landmarks_detected);
    EXPECT_TRUE(settle());
}

TEST_F(Window, SurvivesRandomActions) {
    open(path_);
    ASSERT_TRUE(settle());
    std::mt19937 random(2026);
    const auto any = [&](int count) {
        return std::uniform_int_distribution<int>(0, count - 1)(random);
    };
    std::vector<QAction*> actions;
    for (QAction* action : actionsOf(window_)) {
        // Whatever asks for a file or leaves is no random matter.
        const QString text = plainText(*action);
        const bool asks = action->text().contains(QStringLiteral("…")) || text.contains(".") ||
                          text.contains("case", Qt::CaseInsensitive) || text == "Quit" ||
                          text.contains("built-in") || text.contains("About") ||
                          text.contains("Manual") || text.contains("screen") ||
                          text.contains("landmarks") || text.contains("Patient view") ||
                          text == "Keys and mouse";
        if (!asks) {
            actions.push_back(action);
        }
    }
    ASSERT_GT(actions.size(), 20U);
    const int keys[] = {Qt::Key_X,    Qt::Key_F,    Qt::Key_Escape, Qt::Key_Up,
                        Qt::Key_Left, Qt::Key_Home, Qt::Key_Space,  Qt::Key_Return};
    const QByteArray asked = qgetenv("MYOFACE_RANDOM_ACTIONS");
    const int actionCount = asked.isEmpty() ? (test::thorough() ? 1000 : 120) : asked.toInt();
    for (int k = 0; k < actionCount; ++k) {
        switch (any(6)) {
            case 0:
                actions[static_cast<std::size_t>(any(static_cast<int>(actions.size())))]->trigger();
                break;
            case 1:
                QTest::keyClick(&window_.view(), static_cast<Qt::Key>(keys[any(8)]));
                break;
            case 2:
                window_.view().setTool(static_cast<Tool>(any(6)));
                break;
            case 3: {
                const int muscle = any(static_cast<int>(muscle_atlas().size()));
                window_.muscles().slider(muscle)->setValue(any(150) - 50);
                break;
            }
            default: {
                const QPoint from(any(window_.view().width()), any(window_.view().height()));
                QWindow* native = window_.windowHandle();
                const QPoint origin = window_.view().mapTo(&window_, from);
                const Qt::MouseButton button = any(4) == 0 ? Qt::RightButton : Qt::LeftButton;
                QTest::mousePress(native, button, {}, origin);
                QTest::mouseMove(native, origin + QPoint(any(80) - 40, any(80) - 40));
                QTest::qWait(any(3) == 0 ? 30 : 0);
                QTest::mouseRelease(native, button, {}, origin);
            }
        }
        QApplication::processEvents();
    }
    QTest::keyClick(&window_.view(), Qt::Key_Escape);
    ASSERT_TRUE(settle());
    EXPECT_TRUE(window_.document().skinRest().allFinite());
    EXPECT_TRUE(window_.lastProblem().isEmpty()) << window_.lastProblem().toStdString();
    while (window_.document().undoStack()->canUndo()) {
        window_.document().undoStack()->undo();
    }
    ASSERT_TRUE(settle());
    EXPECT_LT((window_.document().skinRest() - window_.document().model()->skin.mesh.vertices)
                  .cwiseAbs()
                  .maxCoeff(),
              1e-9);
}

}  // namespace
}  // namespace myoface
