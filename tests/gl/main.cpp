// SPDX-License-Identifier: Apache-2.0
#include <clocale>

#include <QApplication>
#include <QSurfaceFormat>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "gui_watchdog.h"

int main(int argc, char** argv) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    qputenv("MYOFACE_UNATTENDED", "1");
    const QTemporaryDir home;  // nobody's settings and journals
    qputenv("XDG_CONFIG_HOME", home.filePath("config").toUtf8());
    qputenv("XDG_DATA_HOME", home.filePath("data").toUtf8());
    myoface::test::WatchedApplication application(argc, argv);
    QApplication::setApplicationName("Myoface");
    QApplication::setOrganizationName("Myoface");
    std::setlocale(LC_NUMERIC, "C");
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
