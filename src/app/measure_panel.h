// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <QComboBox>
#include <QElapsedTimer>
#include <QSpinBox>
#include <QTreeWidget>
#include <QWidget>

#include "myoface/measure/measurement.h"
#include "myoface/scene/scene.h"

#include "profile_plot.h"

namespace myoface {

/// All measures of the face before and now beside their norms, how far left and right differ, and
/// the profile. Changes nothing.
class MeasurePanel final : public QWidget {
    Q_OBJECT

public:
    explicit MeasurePanel(QWidget* parent = nullptr);

    /// Another face; null: none.
    void setFace(std::shared_ptr<const FaceModel> face);
    /// @param before, now 3×nodes [mm]. While `moving`, not every call is answered.
    void show(const Points& before, const Points& now, bool moving);
    /// Draws the chosen measure on the face.
    void draw(SceneData& scene, const Points& now) const;
    Population population() const;
    void setPopulation(const Population& population);
    const std::vector<Measurement>& rows() const { return m_rows; }

Q_SIGNALS:
    void chosen();
    void populationChanged();
    void problem(const QString& sentence);
    void message(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void fill();
    void fillTree();
    void showProfile(const Points& before, const Points& now);
    void copy() const;
    void exportFile();

    std::shared_ptr<const FaceModel> m_face;
    std::unique_ptr<LandmarksOnSkin> m_places;
    Triangles m_outside;  ///< of the skin that is seen
    Points m_before, m_now;
    std::vector<Measurement> m_rows;
    std::vector<std::pair<std::string, double>> m_asymmetryBefore, m_asymmetryNow;
    QComboBox* m_sex = nullptr;
    QSpinBox* m_age = nullptr;
    QTreeWidget* m_tree = nullptr;
    ProfilePlot* m_profile = nullptr;
    QElapsedTimer m_since;
};

}  // namespace myoface
