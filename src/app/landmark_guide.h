// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "myoface/face/landmarks.h"

namespace myoface {

/// Leads through the points that a scan without landmarks needs, one click each.
class LandmarkGuide final : public QWidget {
    Q_OBJECT

public:
    explicit LandmarkGuide(QWidget* parent = nullptr);

    void begin();
    bool active() const { return m_active; }
    /// The user clicked the scan here [mm, our frame].
    void place(const Vec3& point);
    const Landmarks& placed() const { return m_placed; }

Q_SIGNALS:
    void changed();
    void completed();

private:
    void ask();
    void stepBack();

    QLabel* m_question = nullptr;
    QPushButton* m_back = nullptr;
    std::vector<std::string> m_names;
    std::size_t m_next = 0;
    Landmarks m_placed;
    bool m_active = false;
};

}  // namespace myoface
