// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QUndoStack>

#include "myoface/cases/case_file.h"

namespace myoface {

/// The face that is open and what the user made of it. Views listen to it; only commands change it.
class FaceDocument final : public QObject {
    Q_OBJECT

public:
    explicit FaceDocument(QObject* parent = nullptr);

    /// A new face; `model` is null for a scan that has not been fitted. Clears the history.
    void setFace(std::shared_ptr<const OpenedFace> opened, std::shared_ptr<const FaceModel> model,
                 const Contractions& contractions, const Points& skinRest);

    const std::shared_ptr<const OpenedFace>& opened() const { return m_opened; }
    const std::shared_ptr<const FaceModel>& model() const { return m_model; }
    const Contractions& contractions() const { return m_contractions; }
    const Points& skinRest() const { return m_skinRest; }
    /// As they were found, opened, or placed since.
    const Landmarks& landmarks() const { return m_landmarks; }
    const FitOptions& fit() const { return m_fit; }
    QUndoStack* undoStack() { return &m_undoStack; }

    // For commands.
    void setRate(int muscle, double rate);
    void setSkinRest(const Points& skinRest);
    void setLandmarks(const Landmarks& landmarks);
    void setTissue(TissueThickness tissue);
    /// The face as it is to be saved: as opened, with what was placed and chosen since.
    OpenedFace asSaved() const;

    /// The same scan fitted anew; the history goes on.
    void setModel(std::shared_ptr<const FaceModel> model, const Points& skinRest);

Q_SIGNALS:
    void faceChanged();
    void rateChanged(int muscle, double rate);
    void skinRestChanged();
    void landmarksChanged();
    void tissueChanged();

private:
    std::shared_ptr<const OpenedFace> m_opened;
    std::shared_ptr<const FaceModel> m_model;
    Contractions m_contractions;
    Points m_skinRest;
    Landmarks m_landmarks;
    FitOptions m_fit;
    QUndoStack m_undoStack;
};

}  // namespace myoface
