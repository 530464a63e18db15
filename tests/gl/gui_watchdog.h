// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QApplication>

namespace myoface::test {

/// An application that watches how long its thread is kept busy by one event, drawing left out.
class WatchedApplication final : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;

    /// Forgets what was seen so far.
    static void beginWatch();
    /// The longest time that one event has taken: of the processor, so that a busy machine does not
    /// count, and of the clock [ms].
    static double longestBusy();
    static double longestWall();
    /// What that event was.
    static QString culprit();
};

}  // namespace myoface::test
