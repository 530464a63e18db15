// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include "myoface/face/face_model.h"

namespace myoface {

/// Sliders of all muscles by region, both sides linked or apart. Setters are silent; only the
/// user's own edits are signalled.
class MusclePanel final : public QWidget {
    Q_OBJECT

public:
    explicit MusclePanel(QWidget* parent = nullptr);

    void setMuscles(const std::vector<Muscle>& muscles);
    void setRate(int muscle, double rate);
    void setStrength(int muscle, double strength);
    QSlider* slider(int muscle) const;  ///< for tests and shortcuts

Q_SIGNALS:
    void ratesEdited(const std::vector<int>& muscles, double rate, int gesture,
                     const QString& title);
    void strengthsEdited(const std::vector<int>& muscles, double strength, int gesture,
                         const QString& title);
    /// A ready set of weak muscles is wanted; an empty name: all at full strength.
    void weakeningChosen(const std::string& name, bool left, bool right);
    void resetRequested();
    /// A preset is to be shown alone, with an intensity of 0 … 1 for each side.
    void expressionChosen(const std::string& name, double left, double right, int gesture);

private:
    struct Row {
        QWidget* widget = nullptr;
        QLabel* label = nullptr;
        QSlider* slider = nullptr;
        QLabel* value = nullptr;
        QToolButton* strength = nullptr;
        QString title;
        int muscle = -1;
        int other = -1;  ///< muscle of the other side, -1 for midline muscles
        bool right = false;
        double share = 1.0;  ///< strength
    };
    void addRow(QVBoxLayout* into, const std::vector<Muscle>& muscles, int muscle);
    void showValue(Row& row);
    void editStrength(int muscle);
    QLayout* expressionRow();
    QLayout* weakeningRow();
    void applyLink();
    void applyFilter(const QString& text);

    void chooseExpression();
    void chooseWeakening();

    QCheckBox* m_linked = nullptr;
    QComboBox* m_expression = nullptr;
    QSlider* m_intensity = nullptr;
    QSlider* m_balance = nullptr;
    QComboBox *m_weakening = nullptr, *m_weakSide = nullptr;
    QLineEdit* m_filter = nullptr;
    QWidget* m_list = nullptr;
    QVBoxLayout* m_listLayout = nullptr;
    std::vector<Row> m_rows;  ///< one per muscle, in the atlas' order
    int m_gesture = 0;
};

}  // namespace myoface
