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
    void setSkinAge(double years);
    /// Presets of the program and of the user's own, anew. @param chosen name of the current one
    void listExpressions(const QString& chosen = {});
    /// Whether a preset adds to what the muscles do, and whether it is reached by and by.
    bool blends() const { return m_blend->isChecked(); }
    bool glides() const { return m_glide->isChecked(); }
    void setUntreated(bool beside);
    QSlider* slider(int muscle) const;  ///< for tests and shortcuts

Q_SIGNALS:
    void ratesEdited(const std::vector<int>& muscles, double rate, int gesture,
                     const QString& title);
    void strengthsEdited(const std::vector<int>& muscles, double strength, int gesture,
                         const QString& title);
    /// A ready set of weak muscles is wanted; an empty name: all at full strength.
    void weakeningChosen(const std::string& name, bool left, bool right);
    void resetRequested();
    void skinAgeEdited(double years, int gesture);
    /// A preset is to be shown, with an intensity of 0 … 1 for each side: alone, or on top of what
    /// the muscles did when it was chosen. @param fresh it has just been chosen
    void expressionChosen(const std::string& name, double left, double right, int gesture,
                          bool fresh);
    /// What the sliders show is to be kept as a preset of the user's own.
    void expressionSaveAsked(const QString& name);
    void expressionRemoveAsked(const QString& name);
    /// The expression with all muscles at full strength is wanted beside the weakened one.
    void untreatedAsked(bool beside);

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
    QLayout* intensityRow();
    QLayout* presetRow();
    void savePreset();
    void showIntensity();
    QLayout* weakeningRow();
    QLayout* skinAgeRow();
    void applyLink();
    void applyFilter(const QString& text);

    void chooseExpression(bool fresh);
    void chooseWeakening();

    QCheckBox* m_linked = nullptr;
    QComboBox* m_expression = nullptr;
    QSlider* m_intensity = nullptr;
    QSlider* m_balance = nullptr;
    std::vector<QToolButton*> m_letters;  ///< A … E
    QCheckBox *m_blend = nullptr, *m_glide = nullptr;
    QToolButton *m_save = nullptr, *m_remove = nullptr, *m_untreated = nullptr;
    QComboBox *m_weakening = nullptr, *m_weakSide = nullptr;
    QSlider* m_skinAge = nullptr;
    QLabel* m_skinAgeWords = nullptr;
    QLineEdit* m_filter = nullptr;
    QWidget* m_list = nullptr;
    QVBoxLayout* m_listLayout = nullptr;
    std::vector<Row> m_rows;  ///< one per muscle, in the atlas' order
    int m_gesture = 0;
};

}  // namespace myoface
