// SPDX-License-Identifier: Apache-2.0
#include "commands.h"

#include <numeric>
#include <utility>

namespace myoface {

SetMusclesCommand::SetMusclesCommand(FaceDocument& document, MuscleSetting setting,
                                     std::vector<int> muscles, std::vector<double> values,
                                     int gesture, const QString& text)
    : QUndoCommand(text),
      m_document(document),
      m_setting(setting),
      m_muscles(std::move(muscles)),
      m_other(values),
      m_after(std::move(values)),
      m_gesture(gesture) {}

double SetMusclesCommand::shown(int muscle) const {
    const Contractions& now = m_document.contractions();
    return (m_setting == MuscleSetting::Rate ? now.rate
                                             : now.strength)[static_cast<std::size_t>(muscle)];
}

void SetMusclesCommand::swap() {
    for (std::size_t i = 0; i < m_muscles.size(); ++i) {
        const double value = std::exchange(m_other[i], shown(m_muscles[i]));
        if (m_setting == MuscleSetting::Rate) {
            m_document.setRate(m_muscles[i], value);
        } else {
            m_document.setStrength(m_muscles[i], value);
        }
    }
}

bool SetMusclesCommand::mergeWith(const QUndoCommand* other) {
    const auto* next = static_cast<const SetMusclesCommand*>(other);  // same id()
    if (next->m_gesture != m_gesture || next->m_muscles != m_muscles) {
        return false;
    }
    m_after = next->m_after;
    bool back = true;
    for (std::size_t i = 0; i < m_muscles.size(); ++i) {
        back = back && shown(m_muscles[i]) == m_other[i];
    }
    setObsolete(back);  // the slider returned to where it began
    return true;
}

Plan SetMusclesCommand::edits() const {
    Plan plan;
    for (std::size_t i = 0; i < m_muscles.size(); ++i) {
        const std::string& name =
            muscle_atlas()[static_cast<std::size_t>(m_muscles[i])].traits.name;
        if (m_after[i] == m_other[i]) {
            continue;
        }
        if (m_setting == MuscleSetting::Rate) {
            plan.emplace_back(ContractionEdit{name, m_after[i]});
        } else {
            plan.emplace_back(StrengthEdit{name, m_after[i]});
        }
    }
    return plan;
}

ReshapeCommand::ReshapeCommand(FaceDocument& document, const Points& before, const Points& after,
                               const QString& text, Plan edits)
    : QUndoCommand(text),
      m_document(document),
      m_model(document.model()),
      m_edits(std::move(edits)) {
    if (m_edits.empty() && m_model) {
        m_edits.emplace_back(shape_edit(shape_of_scan(*m_model, after)));
    }
    for (Eigen::Index i = 0; i < before.cols(); ++i) {
        if (before.col(i) != after.col(i)) {
            m_nodes.push_back(static_cast<int>(i));
        }
    }
    m_before.resize(3, static_cast<Eigen::Index>(m_nodes.size()));
    m_after.resize(3, m_before.cols());
    for (std::size_t k = 0; k < m_nodes.size(); ++k) {
        m_before.col(static_cast<Eigen::Index>(k)) = before.col(m_nodes[k]);
        m_after.col(static_cast<Eigen::Index>(k)) = after.col(m_nodes[k]);
    }
}

void ReshapeCommand::apply(const Points& from, const Points& to) {
    Points rest = m_document.skinRest();
    const auto& now = m_document.model();
    if (!m_model || !now || m_model->skin.vertex == now->skin.vertex) {
        rest(Eigen::all, m_nodes) = to;
    } else if (m_model->own_vertices == now->own_vertices) {
        Points moved = m_model->skin.mesh.vertices;
        moved(Eigen::all, m_nodes) += to - from;
        rest += shaped_skin(*now, shape_of_scan(*m_model, moved)) - now->skin.mesh.vertices;
    }
    m_document.setSkinRest(rest);
}

void SetProtectionCommand::apply(const Eigen::VectorXd& share) {
    const auto& now = m_document.model();
    m_document.setProtection(m_model == now || !m_model || !now
                                 ? share
                                 : protection_of_nodes(*now, protection_of_scan(*m_model, share)));
}

void PlanCommand::undo() {
    for (auto part = m_parts.rbegin(); part != m_parts.rend(); ++part) {
        (*part)->undo();
    }
}

void PlanCommand::redo() {
    for (const auto& part : m_parts) {
        part->redo();
    }
}

bool SetSkinAgeCommand::mergeWith(const QUndoCommand* other) {
    const auto* next = static_cast<const SetSkinAgeCommand*>(other);  // same id()
    if (next->m_gesture != m_gesture) {
        return false;
    }
    m_after = next->m_after;
    setObsolete(m_after == m_before);
    return true;
}

void pushVariant(FaceDocument& document, const Variant& variant, const QString& text) {
    const FaceModel& face = *document.model();
    const Contractions wanted = contractions_of(face, variant.rates, variant.strengths);
    std::vector<int> all(face.muscles.size());
    std::iota(all.begin(), all.end(), 0);
    QUndoStack& history = *document.undoStack();
    history.beginMacro(text);
    history.push(new SetMusclesCommand(document, MuscleSetting::Rate, all, wanted.rate, -1, text));
    history.push(
        new SetMusclesCommand(document, MuscleSetting::Strength, all, wanted.strength, -1, text));
    history.push(
        new ReshapeCommand(document, document.skinRest(), shaped_skin(face, variant.shape), text));
    history.endMacro();
}

SetLandmarksCommand::SetLandmarksCommand(FaceDocument& document, Landmarks landmarks,
                                         const QString& text)
    : QUndoCommand(text),
      m_document(document),
      m_before(document.landmarks()),
      m_after(std::move(landmarks)) {}

}  // namespace myoface
