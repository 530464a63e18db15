// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "myoface/measure/section.h"
#include "myoface/scene/scene.h"

namespace myoface {

/// A cut through the face before and now, drawn in millimetres.
class SectionPlot final : public QWidget {
    Q_OBJECT

public:
    explicit SectionPlot(QWidget* parent = nullptr);

    void setLines(std::vector<SectionLine> before, std::vector<SectionLine> now);
    const std::vector<SectionLine>& before() const { return m_before; }
    const std::vector<SectionLine>& now() const { return m_now; }

    QSize sizeHint() const override { return {230, 220}; }
    QSize minimumSizeHint() const override { return {150, 120}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<SectionLine> m_before, m_now;
};

/// The profile, or a level, upright or free cut through a place, with its drawing.
class SectionView final : public QWidget {
    Q_OBJECT

public:
    explicit SectionView(QWidget* parent = nullptr);

    enum Kind { Profile, Level, Beside, Free };

    void setFace(std::shared_ptr<const FaceModel> face);
    /// @param before, now 3×nodes [mm]
    void show(const Points& before, const Points& now);
    /// Through a place of the skin as it is shown; a profile becomes a level cut.
    void place(const Vec3& through);
    void placeFree(const Vec3& through, const Vec3& normal);
    Kind kind() const { return static_cast<Kind>(m_kind->currentIndex()); }
    void setKind(Kind kind) { m_kind->setCurrentIndex(kind); }
    const SectionPlot& plot() const { return *m_plot; }
    /// Draws the cut on the face.
    void draw(SceneData& scene) const;

Q_SIGNALS:
    void changed();  ///< another plane
    void problem(const QString& sentence);
    void message(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void choose();
    void sayGap();
    void exportFile();

    std::shared_ptr<const FaceModel> m_face;
    Triangles m_skin;
    SectionPlane m_plane;
    Vec3 m_through = Vec3::Zero();
    Vec3 m_freeNormal = Vec3::UnitX();
    QComboBox* m_kind = nullptr;
    SectionPlot* m_plot = nullptr;
    QLabel* m_gap = nullptr;
};

}  // namespace myoface
