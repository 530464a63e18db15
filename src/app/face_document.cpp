// SPDX-License-Identifier: Apache-2.0
#include "face_document.h"

#include "commands.h"

namespace myoface {

CaseState stateOf(const FaceEdits& edits) {
    CaseState state;
    if (edits.model) {
        state = case_state(*edits.model, edits.contractions, edits.skinRest);
        state.protection = protection_of_scan(*edits.model, edits.protection);
    }
    state.variants = edits.variants;
    state.skin_age = edits.skinAge;
    state.notes = edits.notes;
    if (edits.model && !edits.plan.empty()) {
        state.plan = {plan_origin(*edits.model), edits.plan};
    }
    return state;
}

namespace {

/// The same edits with their places on another fit of the scan; what is lost there is left out.
Plan placedOn(const FaceModel& model, const FaceModel& before, const Plan& edits) {
    return edits.empty() ? Plan() : carried({plan_origin(before), edits}, model).edits;
}

void appendEdits(Plan& plan, const QUndoCommand& step,
                 const std::shared_ptr<const FaceModel>& model) {
    const auto* planned = dynamic_cast<const PlannedStep*>(&step);
    if (planned == nullptr) {
        for (int k = 0; k < step.childCount(); ++k) {
            appendEdits(plan, *step.child(k), model);
        }
        return;
    }
    const auto on = planned->placedOn();
    const Plan edits =
        on && on != model ? placedOn(*model, *on, planned->edits()) : planned->edits();
    plan.insert(plan.end(), edits.begin(), edits.end());
}

}  // namespace

OpenedFace asSaved(const OpenedFace& opened, const FaceEdits& edits) {
    OpenedFace face = opened;
    if (!edits.landmarks.empty()) {
        face.landmarks = edits.landmarks;
    }
    face.fit = edits.fit;
    return face;
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
    m_skinAge = state.skin_age;
    m_notes = QString::fromStdString(state.notes);
    m_passphrase = m_opened ? m_opened->passphrase : std::string();
    m_before = m_model ? carried(state.plan, *m_model).edits : Plan();
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

void FaceDocument::setSkinAge(double years) {
    m_skinAge = years;
    Q_EMIT skinAgeChanged(years);
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
    face.passphrase = m_passphrase;
    return face;
}

void FaceDocument::setPassphrase(const std::string& passphrase) {
    if (passphrase != m_passphrase) {
        m_passphrase = passphrase;
        m_undoStack.resetClean();  // the file is not yet as it is wanted
        Q_EMIT passphraseChanged();
    }
}

Plan FaceDocument::plan() const {
    Plan plan = m_before;
    for (int i = 0; m_model && i < m_undoStack.index(); ++i) {
        appendEdits(plan, *m_undoStack.command(i), m_model);
    }
    return plan;
}

FaceEdits FaceDocument::edits() const {
    return {m_model, m_contractions, m_skinRest, m_protection,          m_landmarks,
            m_fit,   m_variants,     m_skinAge,  m_notes.toStdString(), plan()};
}

void FaceDocument::setModel(std::shared_ptr<const FaceModel> model, const Points& skinRest) {
    // What is protected goes along by the scan's vertices.
    const Eigen::VectorXd onScan =
        m_model ? protection_of_scan(*m_model, m_protection) : Eigen::VectorXd();
    m_before = m_model ? placedOn(*model, *m_model, m_before) : Plan();
    m_model = std::move(model);
    m_skinRest = skinRest;
    m_protection = protection_of_nodes(*m_model, onScan);
}

}  // namespace myoface
