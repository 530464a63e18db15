// SPDX-License-Identifier: Apache-2.0
#include "scan_frame_editor.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace myoface {

void ScanFrameEditor::setFace(std::shared_ptr<const OpenedFace> face) {
    m_face = std::move(face);
    m_calibrating = false;
}

void ScanFrameEditor::setUnit(double mmPerUnit) {
    reopen(mmPerUnit, std::nullopt);
}

void ScanFrameEditor::turnQuarter(int axis) {
    if (!m_face) {
        return;
    }
    const Mat3 turn =
        Eigen::AngleAxisd(std::numbers::pi / 2.0, Vec3::Unit(axis)).toRotationMatrix();
    reopen(std::nullopt, nearest_quarter_turn(turn * m_face->scan->frame.axes));
}

void ScanFrameEditor::beginCalibration() {
    if (!m_face) {
        return;
    }
    m_calibrating = true;
    m_points.clear();
    Q_EMIT asked(
        tr("Calibration: click the first of two points whose distance you know (Esc "
           "ends it)."));
}

void ScanFrameEditor::cancelCalibration() {
    m_calibrating = false;
}

void ScanFrameEditor::place(const Vec3& point) {
    m_points.push_back(point);
    if (m_points.size() < 2) {
        Q_EMIT asked(tr("Calibration: click the second point."));
        return;
    }
    m_calibrating = false;
    Q_EMIT distanceNeeded((m_points[0] - m_points[1]).norm());
}

void ScanFrameEditor::calibrate(double mm) {
    const double measured = m_points.size() == 2 ? (m_points[0] - m_points[1]).norm() : 0.0;
    if (m_face && measured > 0.0 && mm > 0.0) {
        reopen(m_face->scan->frame.mm_per_unit * mm / measured, std::nullopt);
    }
}

void ScanFrameEditor::reopen(std::optional<double> mmPerUnit, const std::optional<Mat3>& axes) {
    if (!m_face) {
        return;
    }
    const FileFrame& frame = m_face->scan->frame;
    OpenOptions options;
    options.mm_per_unit = mmPerUnit.value_or(frame.mm_per_unit);
    options.axes = axes.value_or(frame.axes);
    if (m_face->landmarks) {
        LandmarkFile file;
        for (const auto& [name, landmark] : *m_face->landmarks) {
            file.landmarks[name] = {frame.to_file(landmark.position), landmark.error_mm};
        }
        options.placed = std::move(file);
    }
    Q_EMIT reopenWanted(options);
}

}  // namespace myoface
