// SPDX-License-Identifier: Apache-2.0
// Several views, sections, sides, volumes and files of the real window.
#include <QAction>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QStandardPaths>
#include <nlohmann/json.hpp>

#include "myoface/io/text_file.h"

#include "compare_panel.h"
#include "comparison.h"
#include "face_files.h"
#include "language.h"
#include "measure_panel.h"
#include "window_fixture.h"

namespace myoface {
namespace {

class Views : public test::Window {
protected:
    /// Where a landmark appears in a part of the view.
    QPoint pixel(const std::string& landmark, int part) {
        FaceView& view = window_.view();
        for (const ViewPane& pane : view.panes()) {
            if (pane.camera == part && !pane.before) {
                const PixelPoint p = project(
                    view.cameraOf(part), test::small_face().landmarks.at(landmark).position,
                    static_cast<int>(pane.area.width()), static_cast<int>(pane.area.height()));
                return {static_cast<int>(pane.area.x() + p.x),
                        static_cast<int>(pane.area.y() + p.y)};
            }
        }
        return {};
    }
    void drag(const QPoint& from, const QPoint& by, Qt::MouseButton button = Qt::LeftButton) {
        QWindow* native = window_.windowHandle();
        const QPoint origin = window_.view().mapTo(&window_, from);
        QTest::mousePress(native, button, {}, origin);
        for (int k = 1; k <= 6; ++k) {
            QTest::mouseMove(native, origin + by * k / 6);
            QTest::qWait(30);
        }
        QTest::mouseRelease(native, button, {}, origin + by);
    }
};

TEST(ViewPanes, ShareTheWidgetWithoutGaps) {
    for (const ViewLayout layout : {ViewLayout::One, ViewLayout::Two, ViewLayout::Four}) {
        for (const bool sideBySide : {false, true}) {
            const auto panes = viewPanes(layout, sideBySide, {801.0, 600.0});
            double area = 0.0;
            for (std::size_t i = 0; i < panes.size(); ++i) {
                area += panes[i].area.width() * panes[i].area.height();
                for (std::size_t j = 0; j < i; ++j) {
                    const QRectF both = panes[i].area.intersected(panes[j].area);
                    EXPECT_LT(both.width() * both.height(), 1e-6);
                }
            }
            EXPECT_NEAR(area, 801.0 * 600.0, 1e-6);
            EXPECT_EQ(panes.size(), viewsOf(layout).size() * (sideBySide ? 2 : 1));
        }
    }
}

TEST_F(Views, TheHandWorksInEachOfFour) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.setViews(ViewLayout::Four);
    EXPECT_EQ(window_.view().layout(), ViewLayout::Four);
    // A place that is seen from before, from the side, obliquely and from below.
    const char* const places[] = {"pg", "al_l", "al_l", "prn"};
    for (int part = 0; part < 4; ++part) {
        drag(pixel(places[part], part), {3, -6});
        ASSERT_TRUE(QTest::qWaitFor([&] { return window_.document().undoStack()->count() == 1; },
                                    test::kPatience))
            << part;
        ASSERT_TRUE(settle());
        EXPECT_GT((window_.document().skinRest() - window_.document().model()->skin.mesh.vertices)
                      .colwise()
                      .norm()
                      .maxCoeff(),
                  0.5)
            << part;
        window_.document().undoStack()->undo();
        ASSERT_TRUE(settle());
        window_.document().undoStack()->clear();
    }
}

TEST_F(Views, CamerasMoveTogetherOrAlone) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.setViews(ViewLayout::Four);
    const auto turned = [&](int part, const Eigen::Quaterniond& from) {
        return window_.view().cameraOf(part).orientation.angularDistance(from) > 0.01;
    };
    for (const bool linked : {true, false}) {
        window_.view().setLinked(linked);
        std::vector<Eigen::Quaterniond> before;
        for (int part = 0; part < 4; ++part) {
            before.push_back(window_.view().cameraOf(part).orientation);
        }
        drag({window_.view().width() - 40, window_.view().height() - 40}, {30, 0},
             Qt::MiddleButton);
        for (int part = 0; part < 4; ++part) {
            EXPECT_EQ(turned(part, before[static_cast<std::size_t>(part)]), linked || part == 3);
        }
    }
    window_.setViews(ViewLayout::One);
    EXPECT_EQ(window_.view().panes().size(), 1U);
}

TEST_F(Views, CutsWhereTheMouseSays) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.showStep("shape");
    window_.view().setTool(Tool::Section);
    MeasurePanel& measures = window_.measures();
    EXPECT_EQ(measures.sections().kind(), SectionView::Profile);
    QWindow* native = window_.windowHandle();
    QTest::mouseClick(native, Qt::LeftButton, {}, window_.view().mapTo(&window_, pixel("sn", 0)));
    EXPECT_EQ(measures.sections().kind(), SectionView::Level);
    EXPECT_FALSE(measures.sections().plot().now().empty());
    EXPECT_FALSE(measures.grab().isNull());
    const QPoint start = pixel("ch_r", 0);
    drag(start, pixel("ex_l", 0) - start);
    EXPECT_EQ(measures.sections().kind(), SectionView::Free);
    EXPECT_FALSE(measures.sections().plot().now().empty());
    EXPECT_EQ(window_.document().undoStack()->count(), 0);  // looking changes nothing
}

TEST_F(Views, ShowsVolumesByRegion) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.showStep("shape");
    window_.measures().showVolumes();
    drag(pixel("pg", 0), {0, 20});
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_.document().undoStack()->count() == 1; },
                                test::kPatience));
    ASSERT_TRUE(settle());
    EXPECT_TRUE(QTest::qWaitFor([&] { return !window_.measures().volumes().volumes().empty(); },
                                test::kPatience));
    EXPECT_FALSE(window_.measures().grab().isNull());
}

TEST_F(Views, PaintsHowTheSidesDiffer) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.showStep("compare");
    const QImage plain = window_.view().grabFramebuffer();
    window_.setRates("zygomaticus_major.L", 1.0);
    ASSERT_TRUE(settle());
    window_.comparePanel().setSides(true);
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
            auto* words = window_.comparePanel().findChild<QLabel*>("sides");
            return window_.settled() && words != nullptr && words->isVisible();
        },
        test::kPatience));
    EXPECT_NE(window_.view().grabFramebuffer(), plain);
    window_.comparePanel().setMode(CompareMode::Off);
    ASSERT_TRUE(settle());
}

TEST_F(Views, SavesBesideTheWindowAndCanBeCancelled) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.addExpression("joy", 0.5);
    ASSERT_TRUE(settle());
    EXPECT_FALSE(window_.document().undoStack()->isClean());
    const QString file = QString::fromStdString((folder_ / "case.myoface").string());
    bool saved = false;
    window_.files().saveCaseTo(file, [&] { saved = true; });
    EXPECT_TRUE(window_.files().busy());
    EXPECT_FALSE(saved);  // not in this thread
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, test::kPatience));
    EXPECT_TRUE(QFile::exists(file));
    EXPECT_TRUE(window_.document().undoStack()->isClean());
    const QString other = QString::fromStdString((folder_ / "other.myoface").string());
    saved = false;
    window_.files().saveCaseTo(other, [&] { saved = true; });
    window_.files().cancel();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !window_.files().busy(); }, test::kPatience));
    EXPECT_EQ(saved, QFile::exists(other));  // whole or not at all
}

TEST_F(Views, WritesPicturesOfTheHeadTurning) {
    open(path_);
    ASSERT_TRUE(settle());
    const QString folder = QString::fromStdString((folder_ / "turning").string());
    QSignalSpy written(&window_.files(), &FaceFiles::reportWritten);
    window_.files().exportAnimation("turn", folder, true);
    ASSERT_TRUE(QTest::qWaitFor([&] { return written.count() == 1; }, 4 * test::kPatience))
        << window_.lastProblem().toStdString();
    const QStringList pictures = QDir(folder).entryList({"frame-*.png"});
    EXPECT_EQ(pictures.size(), 48);
    EXPECT_NE(QImage(QDir(folder).filePath(pictures[0])),
              QImage(QDir(folder).filePath(pictures[9])));
}

TEST_F(Views, MeasuresAgreeInWindowCommandLineAndPaper) {
    open(path_);
    ASSERT_TRUE(settle());
    window_.showStep("shape");
    drag(pixel("pg", 0), {0, 18});
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_.document().undoStack()->count() == 1; },
                                test::kPatience));
    ASSERT_TRUE(settle());
    ASSERT_TRUE(QTest::qWaitFor([&] { return window_.measures().rows().size() > 20; }, 5000));
    const QString file = QString::fromStdString((folder_ / "case.myoface").string());
    bool saved = false;
    window_.files().saveCaseTo(file, [&] { saved = true; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return saved; }, test::kPatience));
    QProcess cli;
    const QString program = QDir(QApplication::applicationDirPath()).filePath("myoface-cli");
    cli.start(program, {"measure", file, "--age", "25"});
    ASSERT_TRUE(cli.waitForFinished(test::kPatience));
    const auto json = nlohmann::json::parse(cli.readAllStandardOutput().toStdString());
    const QString paper = QString::fromStdString((folder_ / "r.pdf").string());
    cli.start(program, {"report", file, "--age", "25", "-o", paper});
    ASSERT_TRUE(cli.waitForFinished(4 * test::kPatience));
    QString printed;
    if (!QStandardPaths::findExecutable("pdftotext").isEmpty()) {
        QProcess reader;
        reader.start("pdftotext", {"-layout", paper, "-"});
        ASSERT_TRUE(reader.waitForFinished(test::kPatience));
        // Ligatures are letters again.
        printed = QString::fromUtf8(reader.readAllStandardOutput())
                      .normalized(QString::NormalizationForm_KC);
    }
    const auto digits = [](double value) { return QString::number(value, 'f', 1); };
    const std::vector<Measurement>& rows = window_.measures().rows();
    ASSERT_EQ(json["measures"].size(), rows.size());
    int changed = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto& row = json["measures"][i];
        EXPECT_EQ(row["id"], rows[i].measure.id);
        EXPECT_EQ(digits(row["value"]), digits(rows[i].value)) << rows[i].measure.title;
        EXPECT_EQ(digits(row["other"]), digits(*rows[i].other)) << rows[i].measure.title;
        changed += digits(rows[i].value) != digits(*rows[i].other);
        if (!printed.isEmpty()) {
            const QString unit = rows[i].measure.in_degrees() ? "°" : " mm";
            const QRegularExpression line(
                QRegularExpression::escape(QString::fromStdString(rows[i].measure.title)) + "\\s+" +
                QRegularExpression::escape(digits(rows[i].value) + unit) + "\\s+" +
                QRegularExpression::escape(digits(*rows[i].other) + unit));
            EXPECT_TRUE(printed.contains(line)) << rows[i].measure.title;
        }
    }
    EXPECT_GT(changed, 0);
}

TEST(Sentences, OfTheCoreAreSpokenInJapanese) {
    EXPECT_EQ(inWords("x.obj: there is no such file."), "x.obj: there is no such file.");
    Language::instance().choose("ja");
    EXPECT_EQ(inWords("/a b/x.obj: there is no such file."),
              QStringLiteral("/a b/x.obj：そのファイルはありません。"));
    EXPECT_EQ(inWords("x.obj line 7: a vertex needs three coordinates."),
              QStringLiteral("x.obj line 7：頂点には 3 つの座標が必要です。"));
    EXPECT_EQ(inWords("Triangles without area: 12. Left out of computing, kept in the file."),
              QStringLiteral("面積のない三角形：12。計算では除き、ファイルには残します。"));
    const QString limit =
        inWords("Target: tip projection stays at 12.0 mm of 19.0 mm: the bone holds back.");
    EXPECT_TRUE(limit.startsWith(QStringLiteral("目標：")));
    EXPECT_TRUE(limit.endsWith(QStringLiteral("骨に当たっています。")));
    EXPECT_EQ(inWords("Something that nobody translated."), "Something that nobody translated.");
    Language::instance().choose("en");
}

}  // namespace
}  // namespace myoface
