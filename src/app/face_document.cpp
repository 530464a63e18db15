// SPDX-License-Identifier: Apache-2.0
#include "face_document.h"

namespace myoface {

FaceDocument::FaceDocument(QObject* parent) : QObject(parent) {}

void FaceDocument::setFace(std::shared_ptr<const OpenedFace> opened,
                           std::shared_ptr<const FaceModel> model, const Contractions& contractions,
                           const Points& skinRest) {
    m_undoStack.clear();
    m_opened = std::move(opened);
    m_model = std::move(model);
    m_contractions = contractions;
    m_skinRest = skinRest;
    m_landmarks = m_opened && m_opened->landmarks ? *m_opened->landmarks : Landmarks();
    m_fit = m_opened ? m_opened->fit : FitOptions();
    Q_EMIT faceChanged();
}

void FaceDocument::setRate(int muscle, double rate) {
    m_contractions.rate[static_cast<std::size_t>(muscle)] = rate;
    Q_EMIT rateChanged(muscle, rate);
}

void FaceDocument::setSkinRest(const Points& skinRest) {
    m_skinRest = skinRest;
    Q_EMIT skinRestChanged();
}

void FaceDocument::setLandmarks(const Landmarks& landmarks) {
    m_landmarks = landmarks;
    Q_EMIT landmarksChanged();
}

void FaceDocument::setTissue(TissueThickness tissue) {
    m_fit.tissue = tissue;
    Q_EMIT tissueChanged();
}

OpenedFace FaceDocument::asSaved() const {
    OpenedFace face = *m_opened;
    if (!m_landmarks.empty()) {
        face.landmarks = m_landmarks;
    }
    face.fit = m_fit;
    return face;
}

void FaceDocument::setModel(std::shared_ptr<const FaceModel> model, const Points& skinRest) {
    m_model = std::move(model);
    m_skinRest = skinRest;
}

}  // namespace myoface
