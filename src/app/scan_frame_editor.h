// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <QObject>

#include "myoface/cases/case_file.h"

namespace myoface {

/// Changes how a scan's unit and axes are understood. The face is opened anew with them, its
/// landmarks kept.
class ScanFrameEditor final : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    void setFace(std::shared_ptr<const OpenedFace> face);
    void setUnit(double mmPerUnit);
    /// Turns the scan by a quarter about one of our axes (0 x, 1 y, 2 z).
    void turnQuarter(int axis);

    /// Two points on the skin are asked for, then their distance.
    void beginCalibration();
    void cancelCalibration();
    bool calibrating() const { return m_calibrating; }
    /// The user clicked the skin here [mm, our frame].
    void place(const Vec3& point);
    /// The scale that makes the two points `mm` apart.
    void calibrate(double mm);

Q_SIGNALS:
    void asked(const QString& instruction);  ///< what to click next
    void distanceNeeded(double measured);    ///< both points are placed [mm as understood so far]
    void reopenWanted(const myoface::OpenOptions& options);

private:
    void reopen(std::optional<double> mmPerUnit, const std::optional<Mat3>& axes);

    std::shared_ptr<const OpenedFace> m_face;
    bool m_calibrating = false;
    std::vector<Vec3> m_points;
};

}  // namespace myoface
