// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QSignalSpy>
#include <QtTest>
#include <gtest/gtest.h>

#include "myoface/io/mesh_file.h"

#include "face_files.h"
#include "main_window.h"
#include "test_meshes.h"

namespace myoface::test {

inline constexpr int kPatience = 60000;  // [ms]

/// A window with the small face opened from disk.
class Window : public ::testing::Test {
protected:
    void SetUp() override {
        path_ = QString::fromStdString((folder_ / "face.ply").string());
        write_mesh(path_.toStdString(), small_face().scan, small_face().scan.mesh.vertices);
        write_landmarks(folder_ / "face.landmarks.json", small_face().landmarks, {});
        window_.resize(1200, 800);
        window_.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
    }
    void TearDown() override { window_.close(); }
    void open(const QString& path, int patience = kPatience) {
        QSignalSpy opened(&window_, &MainWindow::opened);
        QSignalSpy failed(&window_, &MainWindow::openFailed);
        window_.openPath(path);
        ASSERT_TRUE(QTest::qWaitFor([&] { return opened.count() + failed.count() > 0; }, patience));
    }
    bool settle(int patience = kPatience) {
        return QTest::qWaitFor([&] { return window_.settled(); }, patience);
    }
    /// Saves the case and waits for it.
    bool saved(const QString& path) {
        bool done = false;
        window_.files().saveCaseTo(path, [&] { done = true; });
        return QTest::qWaitFor([&] { return done; }, kPatience);
    }
    QPoint pixel(const std::string& landmark) {
        FaceView& view = window_.view();
        const PixelPoint p = project(view.camera(), small_face().landmarks.at(landmark).position,
                                     view.width(), view.height());
        return {static_cast<int>(p.x), static_cast<int>(p.y)};
    }
    /// Press, move in steps, release: on the native window, so that drags are delivered.
    void drag(const QPoint& from, const QPoint& by, Qt::MouseButton button = Qt::LeftButton) {
        QWindow* native = window_.windowHandle();
        const QPoint origin = window_.view().mapTo(&window_, from);
        QTest::mousePress(native, button, {}, origin);
        for (int k = 1; k <= 6; ++k) {
            QTest::mouseMove(native, origin + by * k / 6);
            QTest::qWait(40);
        }
        QTest::mouseRelease(native, button, {}, origin + by);
    }

    TemporaryFolder folder_;
    QString path_;
    MainWindow window_;
};

}  // namespace myoface::test
