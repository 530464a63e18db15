// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <QObject>
#include <QTimer>

#include "myoface/measure/result_comparison.h"
#include "myoface/scene/face_scene.h"

#include "compare_panel.h"
#include "face_document.h"
#include "face_view.h"

namespace myoface {

class ActualJob;
class SettleJob;
class SidesJob;
class StillJob;

/// Before and after: which earlier state the face is compared with, how both are shown, and the
/// variants of the plan.
class Comparison final : public QObject {
    Q_OBJECT

public:
    Comparison(FaceDocument& document, FaceView& view, ComparePanel& panel,
               QObject* parent = nullptr);
    ~Comparison() override;
    Comparison(const Comparison&) = delete;
    Comparison& operator=(const Comparison&) = delete;

    /// Another face, or the same one fitted anew; null: none.
    void setScene(FaceScene* scene);
    /// The moment that is to be drawn: all of the change, or a share of it.
    SimSnapshot shown(const SimSnapshot& now) const;
    /// Shows the state before while it is held.
    void holdBefore(bool held);
    /// Paints the map where one is wanted. @return whether the skin's colours are taken
    bool paint(const SimSnapshot& shown);
    bool paints() const { return m_panel.map() || m_panel.sides() || m_actual; }
    /// What is compared with, 3×skin nodes [mm].
    const Points& before() const;
    bool busy() const { return m_settling || m_comparing || m_comparingSides || m_drawing; }
    /// Compares with a scan of afterwards.
    void openActual(const QString& path);
    /// Shows the same contractions with all muscles at full strength beside the face, and goes
    /// along with its sliders.
    void compareUntreated(bool beside);
    /// Keeps the face as it is as a variant with the next free letter.
    void storeVariant();

Q_SIGNALS:
    void changed();  ///< draw again
    void untreatedChanged(bool beside);
    void message(const QString& sentence);
    void problem(const QString& sentence);

private:
    void choose(int variant);
    void settleUntreated();
    QString beforeTitle() const;
    void settled();
    void compared();
    void updateView();
    void drawBefore();
    void beforeDrawn();
    void compareSides(const Points& nodes);
    void sidesCompared();
    QString regionTable(const std::vector<RegionDistance>& regions) const;
    void showLegend();
    void chooseActual();

    FaceDocument& m_document;
    FaceView& m_view;
    ComparePanel& m_panel;
    FaceScene* m_scene = nullptr;
    std::optional<Points> m_before;  ///< of a variant; else the scan
    JawPose m_beforeJaw;
    Wrinkles m_beforeWrinkles;
    std::unique_ptr<SettleJob> m_settling;
    std::unique_ptr<ActualJob> m_comparing;
    std::unique_ptr<SidesJob> m_comparingSides;
    std::unique_ptr<StillJob> m_drawing;
    Points m_sidesOf;  ///< what m_sides was made of
    Eigen::VectorXd m_sides;
    std::optional<ResultComparison> m_actual;
    std::shared_ptr<const SimSnapshot> m_now;
    QTimer m_followsSliders;
    bool m_untreated = false;  ///< compared with itself at full strength
    bool m_held = false;
    bool m_stale = true;  ///< the picture of the state before is of another one
    CompareMode m_mode = CompareMode::Off;
};

}  // namespace myoface
