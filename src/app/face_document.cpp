// SPDX-License-Identifier: Apache-2.0
#include "face_document.h"

namespace myoface {

CaseState stateOf(const FaceEdits& edits) {
    CaseState state;
    if (edits.model) {
        state = case_state(*edits.model, edits.contractions, edits.skinRest);
        state.protection = protection_of_scan(*edits.model, edits.protection);
    }
    state.variants = edits.variants;
    state.notes = edits.notes;
    return state;
}

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
    const CaseState state = m_opened ? m_opened->state : CaseState();
    m_protection = m_model ? protection_of_nodes(*m_model, state.protection) : Eigen::VectorXd();
    m_variants = state.variants;
    m_notes = QString::fromStdString(state.notes);
    Q_EMIT faceChanged();
}

void FaceDocument::setRate(int muscle, double rate) {
    m_contractions.rate[static_cast<std::size_t>(muscle)] = rate;
    Q_EMIT rateChanged(muscle, rate);
}

void FaceDocument::setStrength(int muscle, double strength) {
    m_contractions.strength[static_cast<std::size_t>(muscle)] = strength;
    Q_EMIT strengthChanged(muscle, strength);
}

void FaceDocument::setSkinRest(const Points& skinRest) {
    m_skinRest = skinRest;
    Q_EMIT skinRestChanged();
}

void FaceDocument::setProtection(const Eigen::VectorXd& share) {
    m_protection = share;
    Q_EMIT protectionChanged();
}

void FaceDocument::setLandmarks(const Landmarks& landmarks) {
    m_landmarks = landmarks;
    Q_EMIT landmarksChanged();
}

void FaceDocument::setTissue(TissueThickness tissue) {
    m_fit.tissue = tissue;
    Q_EMIT tissueChanged();
}

void FaceDocument::setVariants(const std::vector<Variant>& variants) {
    m_variants = variants;
    Q_EMIT variantsChanged();
}

void FaceDocument::setNotes(const QString& notes) {
    m_notes = notes;
    Q_EMIT notesChanged();
}

OpenedFace FaceDocument::asSaved() const {
    OpenedFace face = *m_opened;
    if (!m_landmarks.empty()) {
        face.landmarks = m_landmarks;
    }
    face.fit = m_fit;
    return face;
}

FaceEdits FaceDocument::edits() const {
    return {m_model,     m_contractions, m_skinRest, m_protection,
            m_landmarks, m_fit,          m_variants, m_notes.toStdString()};
}

void FaceDocument::setModel(std::shared_ptr<const FaceModel> model, const Points& skinRest) {
    // What is protected goes along by the scan's vertices.
    const Eigen::VectorXd onScan =
        m_model ? protection_of_scan(*m_model, m_protection) : Eigen::VectorXd();
    m_model = std::move(model);
    m_skinRest = skinRest;
    m_protection = protection_of_nodes(*m_model, onScan);
}

}  // namespace myoface
