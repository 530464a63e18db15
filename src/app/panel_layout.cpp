// SPDX-License-Identifier: Apache-2.0
#include "panel_layout.h"

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

namespace myoface {

namespace {

/// As wide as what is inside needs, so that nothing is cut off.
class ScrollColumn final : public QScrollArea {
public:
    QSize minimumSizeHint() const override {
        const int bar = verticalScrollBar()->sizeHint().width();
        const int inside = widget() != nullptr ? widget()->minimumSizeHint().width() : 0;
        return {inside + bar, QScrollArea::minimumSizeHint().height()};
    }
    QSize sizeHint() const override {
        return {minimumSizeHint().width(), QScrollArea::sizeHint().height()};
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) {
            updateGeometry();
        }
        return QScrollArea::eventFilter(watched, event);
    }
};

}  // namespace

QVBoxLayout* scrollingColumn(QWidget& panel) {
    auto* outer = new QVBoxLayout(&panel);
    outer->setContentsMargins(0, 0, 0, 0);
    auto* scroll = new ScrollColumn;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(12, 8, 12, 8);
    column->setSpacing(8);
    scroll->setWidget(inside);
    outer->addWidget(scroll);
    return column;
}

}  // namespace myoface
