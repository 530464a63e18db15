// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <QComboBox>
#include <QElapsedTimer>
#include <QSpinBox>
#include <QTabWidget>
#include <QTreeWidget>
#include <QWidget>

#include "myoface/measure/measurement.h"
#include "myoface/scene/scene.h"

#include "section_view.h"
#include "volume_plot.h"

namespace myoface {

/// All measures of the face before and now beside their norms, how far left and right differ,
/// sections, and what came to each region. Changes nothing.
class MeasurePanel final : public QWidget {
    Q_OBJECT

public:
    explicit MeasurePanel(QWidget* parent = nullptr);

    /// Another face; null: none.
    /// @param places of its landmarks
    void setFace(std::shared_ptr<const FaceModel> face,
                 std::shared_ptr<const LandmarksOnSkin> places);
    /// @param before, now 3×nodes [mm]. While `moving`, not every call is answered.
    void show(const Points& before, const Points& now, bool moving);
    /// Draws the chosen measure on the face.
    void draw(SceneData& scene, const Points& now) const;
    Population population() const;
    void setPopulation(const Population& population);
    const std::vector<Measurement>& rows() const { return m_rows; }
    SectionView& sections() { return *m_sections; }
    const VolumePlot& volumes() const { return *m_volumes; }
    /// Brings the section or the volumes to the front.
    void showSections() { m_plots->setCurrentIndex(0); }
    void showVolumes() { m_plots->setCurrentIndex(1); }

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
    void fillPlots();
    void copy() const;
    void exportFile();

    std::shared_ptr<const FaceModel> m_face;
    std::shared_ptr<const LandmarksOnSkin> m_places;
    Points m_before, m_now;
    std::vector<Measurement> m_rows;
    std::vector<std::pair<std::string, double>> m_asymmetryBefore, m_asymmetryNow;
    QComboBox* m_sex = nullptr;
    QSpinBox* m_age = nullptr;
    QTreeWidget* m_tree = nullptr;
    QTabWidget* m_plots = nullptr;
    SectionView* m_sections = nullptr;
    VolumePlot* m_volumes = nullptr;
    QElapsedTimer m_since;
};

}  // namespace myoface
