// SPDX-License-Identifier: Apache-2.0
#include <QCheckBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QtTest>
#include <gtest/gtest.h>

#include "myoface/muscle/user_expressions.h"

#include "landmark_guide.h"
#include "layer_panel.h"
#include "muscle_panel.h"
#include "scan_frame_editor.h"
#include "scan_panel.h"
#include "test_meshes.h"

namespace myoface {
namespace {

/// The panel with all muscles, and what it said.
struct Panel {
    MusclePanel panel;
    std::vector<std::vector<int>> which;
    std::vector<double> rates;
    std::vector<int> gestures;

    Panel() {
        panel.setMuscles(test::small_model()->muscles);
        QObject::connect(&panel, &MusclePanel::ratesEdited,
                         [this](const std::vector<int>& w, double r, int g, const QString&) {
                             which.push_back(w);
                             rates.push_back(r);
                             gestures.push_back(g);
                         });
    }
    int muscle(const char* name) const { return test::muscle(*test::small_model(), name); }
};

TEST(MusclePanel, MovesBothSidesTogether) {
    Panel p;
    p.panel.slider(p.muscle("risorius.L"))->setValue(60);
    ASSERT_EQ(p.which.size(), 1U);
    EXPECT_EQ(p.which[0].size(), 2U);
    EXPECT_DOUBLE_EQ(p.rates[0], 0.6);
}

TEST(MusclePanel, HasASliderForEveryMuscle) {
    Panel p;
    for (std::size_t m = 0; m < muscle_atlas().size(); ++m) {
        ASSERT_NE(p.panel.slider(static_cast<int>(m)), nullptr) << muscle_atlas()[m].traits.name;
        p.panel.setRate(static_cast<int>(m), 0.3);
        EXPECT_EQ(p.panel.slider(static_cast<int>(m))->value(), 30);
    }
}

TEST(MusclePanel, OffersExpressions) {
    Panel p;
    std::vector<std::pair<std::string, double>> chosen;
    QObject::connect(&p.panel, &MusclePanel::expressionChosen,
                     [&](const std::string& name, double left, double right, int, bool fresh) {
                         EXPECT_EQ(left, right);
                         EXPECT_EQ(fresh, chosen.empty());
                         chosen.emplace_back(name, left);
                     });
    auto* list = p.panel.findChild<QComboBox*>();
    ASSERT_NE(list, nullptr);
    EXPECT_GE(list->count(), static_cast<int>(expression_presets().size()) + 1);
    list->setCurrentIndex(1);
    Q_EMIT list->activated(1);
    ASSERT_EQ(chosen.size(), 1U);
    EXPECT_EQ(chosen[0].first, expression_presets()[0].name);
    EXPECT_DOUBLE_EQ(chosen[0].second, 0.8);
    for (QSlider* slider : p.panel.findChildren<QSlider*>()) {
        if (slider->accessibleName() == QStringLiteral("Intensity of the expression")) {
            slider->setValue(30);
        }
    }
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_DOUBLE_EQ(chosen[1].second, 0.3);
    auto* letter = p.panel.findChild<QToolButton*>(QStringLiteral("intensityE"));
    ASSERT_NE(letter, nullptr);
    letter->click();
    ASSERT_EQ(chosen.size(), 3U);
    EXPECT_DOUBLE_EQ(chosen[2].second, 1.0);
    EXPECT_TRUE(letter->isChecked());
}

TEST(MusclePanel, ListsPresetsOfTheUsersOwn) {
    const test::TemporaryFolder folder;
    qputenv("MYOFACE_EXPRESSIONS", QByteArray::fromStdString((folder / "own").string()));
    std::vector<double> rates(muscle_atlas().size(), 0.0);
    rates[3] = 0.7;
    save_user_expression("Frau K. / Tag 3", rates);
    MusclePanel panel;
    auto* list = panel.findChild<QComboBox*>(QStringLiteral("expression"));
    auto* remove = panel.findChild<QToolButton*>(QStringLiteral("removePreset"));
    ASSERT_TRUE(list != nullptr && remove != nullptr);
    const int at = list->findData(QStringLiteral("Frau K. / Tag 3"));
    ASSERT_GT(at, 0);
    EXPECT_FALSE(remove->isEnabled());
    list->setCurrentIndex(at);
    Q_EMIT list->activated(at);
    EXPECT_TRUE(remove->isEnabled());
    QString gone;
    QObject::connect(&panel, &MusclePanel::expressionRemoveAsked,
                     [&](const QString& name) { gone = name; });
    remove->click();
    EXPECT_EQ(gone, QStringLiteral("Frau K. / Tag 3"));
    remove_user_expression(gone.toStdString());
    panel.listExpressions();
    EXPECT_LT(list->findData(gone), 0);
    qunsetenv("MYOFACE_EXPRESSIONS");
}

TEST(MusclePanel, SaysTheAgeOfTheSkin) {
    MusclePanel panel;
    std::vector<double> years;
    QObject::connect(&panel, &MusclePanel::skinAgeEdited,
                     [&](double age, int) { years.push_back(age); });
    panel.setSkinAge(62.0);
    EXPECT_TRUE(years.empty());
    auto* slider = panel.findChild<QSlider*>(QStringLiteral("skinAge"));
    ASSERT_NE(slider, nullptr);
    EXPECT_EQ(slider->value(), 62);
    slider->setValue(70);
    EXPECT_EQ(years, std::vector<double>{70.0});
}

TEST(LayerPanel, CutsTheSkinAway) {
    LayerPanel panel;
    int edits = 0;
    QObject::connect(&panel, &LayerPanel::layersEdited, [&] { ++edits; });
    EXPECT_EQ(panel.cutAway(), 0.0);
    for (QSlider* slider : panel.findChildren<QSlider*>()) {
        if (slider->accessibleName() == QStringLiteral("Cut-away")) {
            slider->setValue(40);
        }
    }
    EXPECT_DOUBLE_EQ(panel.cutAway(), 0.4);
    EXPECT_EQ(edits, 1);
}

TEST(MusclePanel, MovesOneSideWhenApart) {
    Panel p;
    p.panel.findChild<QCheckBox*>()->setChecked(false);
    p.panel.slider(p.muscle("risorius.R"))->setValue(-20);
    ASSERT_EQ(p.which.size(), 1U);
    EXPECT_EQ(p.which[0], std::vector<int>{p.muscle("risorius.R")});
}

TEST(MusclePanel, IsSilentWhenTheDocumentSetsIt) {
    Panel p;
    p.panel.setRate(p.muscle("risorius.L"), 0.4);
    EXPECT_TRUE(p.which.empty());
    EXPECT_EQ(p.panel.slider(p.muscle("risorius.L"))->value(), 40);
}

TEST(MusclePanel, RestsAMuscleOnDoubleClick) {
    Panel p;
    QSlider* slider = p.panel.slider(p.muscle("procerus"));
    slider->setValue(50);
    QTest::mouseDClick(slider, Qt::LeftButton);
    EXPECT_EQ(slider->value(), 0);
}

TEST(MusclePanel, AnswersTheKeyboardInStepsOfTheirOwn) {
    Panel p;
    QSlider* slider = p.panel.slider(p.muscle("mentalis.L"));
    QTest::keyClick(slider, Qt::Key_Right);
    QTest::keyClick(slider, Qt::Key_Right);
    ASSERT_EQ(p.gestures.size(), 2U);
    EXPECT_NE(p.gestures[0], p.gestures[1]);
    EXPECT_NEAR(p.rates[1], 0.02, 1e-12);
}

TEST(MusclePanel, FindsMusclesByNameAndActionUnit) {
    Panel p;
    p.panel.show();
    p.panel.findChild<QLineEdit*>()->setText(QStringLiteral("AU12"));
    EXPECT_TRUE(p.panel.slider(p.muscle("zygomaticus_major.L"))->isVisible());
    EXPECT_FALSE(p.panel.slider(p.muscle("procerus"))->isVisible());
}

TEST(LayerPanel, SaysOpacityOfWhatIsShown) {
    LayerPanel panel;
    QSignalSpy spy(&panel, &LayerPanel::layersEdited);
    EXPECT_FLOAT_EQ(panel.layers().skin, 1.0F);
    EXPECT_FLOAT_EQ(panel.layers().bone, 0.0F);
    panel.setLayers({0.4F, 1.0F, 0.0F, 0.0F});
    EXPECT_EQ(spy.count(), 0);
    EXPECT_NEAR(panel.layers().skin, 0.4F, 0.011F);
    panel.findChildren<QCheckBox*>().at(2)->click();
    EXPECT_EQ(spy.count(), 1);
    EXPECT_FLOAT_EQ(panel.layers().bone, 1.0F);
}

TEST(LandmarkGuide, AsksForOnePointAfterTheOther) {
    LandmarkGuide guide;
    QSignalSpy done(&guide, &LandmarkGuide::completed);
    guide.begin();
    for (int k = 0; guide.active() && k < 50; ++k) {
        guide.place(Vec3(k, 0.0, 0.0));
    }
    EXPECT_EQ(done.count(), 1);
    EXPECT_EQ(guide.placed().size(), 14U);
    EXPECT_EQ(guide.placed().at("prn").position.x(), 0.0);
}

/// An opened ball, as if from a file in centimetres that lies on its back.
std::shared_ptr<OpenedFace> openedBall() {
    auto face = std::make_shared<OpenedFace>();
    Scan scan = test::scan_of(test::together(test::sphere(10.0), test::grid(3, 1.0)));
    set_frame(scan, {10.0, axes_from_text("+x-z+y")});
    face->report = describe(scan);
    face->scan = std::make_shared<const Scan>(std::move(scan));
    face->scan_bytes = "x";
    face->landmarks = Landmarks{{"prn", {Vec3(0, 0, 100), 2.0}}};
    return face;
}

TEST(ScanPanel, ShowsUnitAndOffersOthers) {
    ScanPanel panel;
    panel.setFace(*openedBall(), nullptr, 0);
    auto* unit = panel.findChild<QComboBox*>();
    ASSERT_NE(unit, nullptr);
    EXPECT_DOUBLE_EQ(unit->currentData().toDouble(), 10.0);
    QSignalSpy spy(&panel, &ScanPanel::unitEdited);
    unit->setFocus();
    QTest::keyClick(unit, Qt::Key_Down);  // the next larger one
    ASSERT_EQ(spy.count(), 1);
    EXPECT_DOUBLE_EQ(spy[0][0].toDouble(), 100.0);
}

TEST(ScanPanel, HidesLooseParts) {
    ScanPanel panel;
    panel.setFace(*openedBall(), nullptr, 0);
    auto* loose = panel.findChild<QCheckBox*>();
    ASSERT_NE(loose, nullptr);
    EXPECT_FALSE(loose->isHidden());
    QSignalSpy spy(&panel, &ScanPanel::loosePartsEdited);
    loose->click();
    ASSERT_EQ(spy.count(), 1);
    EXPECT_FALSE(spy[0][0].toBool());
}

TEST(ScanFrameEditor, ReopensWithLandmarksInTheFilesOwnNumbers) {
    ScanFrameEditor editor;
    OpenOptions wanted;
    int count = 0;
    QObject::connect(&editor, &ScanFrameEditor::reopenWanted, [&](const OpenOptions& options) {
        wanted = options;
        ++count;
    });
    const auto face = openedBall();
    editor.setFace(face);
    editor.setUnit(1.0);
    ASSERT_EQ(count, 1);
    EXPECT_DOUBLE_EQ(*wanted.mm_per_unit, 1.0);
    EXPECT_EQ(axes_to_text(*wanted.axes), "+x-z+y");
    EXPECT_TRUE(wanted.placed->landmarks.at("prn").position.isApprox(
        face->scan->frame.to_file({0, 0, 100})));
    editor.turnQuarter(0);
    EXPECT_EQ(axes_to_text(*wanted.axes), "+x+y+z");  // what was up is in front
    for (int k = 0; k < 3; ++k) {
        editor.beginCalibration();
        EXPECT_TRUE(editor.calibrating());
        editor.place({0, 0, 0});
        editor.place({0, 50, 0});
        EXPECT_FALSE(editor.calibrating());
    }
    editor.calibrate(25.0);
    EXPECT_DOUBLE_EQ(*wanted.mm_per_unit, 5.0);
}

}  // namespace
}  // namespace myoface
