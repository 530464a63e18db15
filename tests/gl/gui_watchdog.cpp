// SPDX-License-Identifier: Apache-2.0
#include "gui_watchdog.h"

#include <ctime>

#include <QElapsedTimer>
#include <QEvent>

#include "face_view.h"

namespace myoface::test {
namespace {

int depth = 0;
double longest_busy = 0.0;
double longest_wall = 0.0;
QString longest_name;

double processor_time() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Drawing is what a graphics card does; here the processor stands in for it.
bool draws(QEvent::Type type) {
    return type == QEvent::Paint || type == QEvent::UpdateRequest || type == QEvent::UpdateLater ||
           type == QEvent::Expose || type == QEvent::Resize || type == QEvent::Show;
}

}  // namespace

bool WatchedApplication::notify(QObject* receiver, QEvent* event) {
    if (depth > 0 || draws(event->type())) {
        return QApplication::notify(receiver, event);
    }
    ++depth;
    const QString name = QStringLiteral("%1, event %2")
                             .arg(QString::fromLatin1(receiver->metaObject()->className()))
                             .arg(event->type());
    QElapsedTimer clock;
    clock.start();
    const double start = processor_time();
    const double drawn = FaceView::drawingTime();
    const bool result = QApplication::notify(receiver, event);
    const double drawing = FaceView::drawingTime() - drawn;
    const double busy = processor_time() - start - drawing;
    longest_wall = std::max(longest_wall, static_cast<double>(clock.elapsed()) - drawing);
    if (busy > longest_busy) {
        longest_busy = busy;
        longest_name = name;
    }
    --depth;
    return result;
}

void WatchedApplication::beginWatch() {
    longest_busy = longest_wall = 0.0;
    longest_name.clear();
}

double WatchedApplication::longestBusy() {
    return longest_busy;
}

double WatchedApplication::longestWall() {
    return longest_wall;
}

QString WatchedApplication::culprit() {
    return longest_name;
}

}  // namespace myoface::test
