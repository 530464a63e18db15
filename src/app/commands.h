// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <QUndoCommand>

#include "myoface/sim/plan.h"

#include "face_document.h"

namespace myoface {

/// Which setting of a muscle.
enum class MuscleSetting { Rate, Strength };

/// A step of the history that a plan can repeat.
class PlannedStep {
public:
    virtual ~PlannedStep() = default;
    /// What it did, once it is done.
    virtual Plan edits() const = 0;
    /// Whose places the edits name; null: none.
    virtual std::shared_ptr<const FaceModel> placedOn() const { return nullptr; }
};

/// Contractions or strengths of some muscles. One gesture of a slider is one step: commands of the
/// same gesture merge.
class SetMusclesCommand final : public QUndoCommand, public PlannedStep {
public:
    SetMusclesCommand(FaceDocument& document, MuscleSetting setting, std::vector<int> muscles,
                      std::vector<double> values, int gesture, const QString& text);

    void undo() override { swap(); }
    void redo() override { swap(); }
    int id() const override { return m_setting == MuscleSetting::Rate ? 1 : 2; }
    bool mergeWith(const QUndoCommand* other) override;
    Plan edits() const override;

private:
    void swap();
    double shown(int muscle) const;

    FaceDocument& m_document;
    MuscleSetting m_setting;
    std::vector<int> m_muscles;
    std::vector<double> m_other;  ///< what undo or redo will set
    std::vector<double> m_after;  ///< what it set
    int m_gesture;
};

/// A new resting shape of the skin: holds only the nodes that moved, before and after. On a face
/// that was fitted anew meanwhile, with other nodes, the difference is carried over by the scan.
class ReshapeCommand final : public QUndoCommand, public PlannedStep {
public:
    /// @param edits that made the shape; nothing: it has no gestures
    ReshapeCommand(FaceDocument& document, const Points& before, const Points& after,
                   const QString& text, Plan edits = {});

    void undo() override { apply(m_after, m_before); }
    void redo() override { apply(m_before, m_after); }
    Plan edits() const override { return m_edits; }
    std::shared_ptr<const FaceModel> placedOn() const override { return m_model; }

private:
    void apply(const Points& from, const Points& to);

    FaceDocument& m_document;
    std::shared_ptr<const FaceModel> m_model;  ///< whose nodes they are
    std::vector<int> m_nodes;
    Points m_before, m_after;
    Plan m_edits;
};

/// Other protected skin. One stroke of the brush is one step.
class SetProtectionCommand final : public QUndoCommand, public PlannedStep {
public:
    SetProtectionCommand(FaceDocument& document, Eigen::VectorXd share, const QString& text,
                         Plan edits = {})
        : QUndoCommand(text),
          m_document(document),
          m_model(document.model()),
          m_before(document.protection()),
          m_after(std::move(share)),
          m_edits(std::move(edits)) {}

    void undo() override { apply(m_before); }
    void redo() override { apply(m_after); }
    Plan edits() const override { return m_edits; }
    std::shared_ptr<const FaceModel> placedOn() const override { return m_model; }

private:
    void apply(const Eigen::VectorXd& share);

    FaceDocument& m_document;
    std::shared_ptr<const FaceModel> m_model;  ///< whose nodes they are
    Eigen::VectorXd m_before, m_after;
    Plan m_edits;
};

/// A plan that was applied: several commands as one step, told by the plan's own edits.
class PlanCommand final : public QUndoCommand, public PlannedStep {
public:
    PlanCommand(const QString& text, Plan edits, std::shared_ptr<const FaceModel> model,
                std::vector<std::unique_ptr<QUndoCommand>> parts)
        : QUndoCommand(text),
          m_edits(std::move(edits)),
          m_model(std::move(model)),
          m_parts(std::move(parts)) {}

    void undo() override;
    void redo() override;
    Plan edits() const override { return m_edits; }
    std::shared_ptr<const FaceModel> placedOn() const override { return m_model; }

private:
    Plan m_edits;
    std::shared_ptr<const FaceModel> m_model;
    std::vector<std::unique_ptr<QUndoCommand>> m_parts;
};

/// Another age of the skin that wrinkles. One gesture of the slider is one step.
class SetSkinAgeCommand final : public QUndoCommand {
public:
    SetSkinAgeCommand(FaceDocument& document, double years, int gesture, const QString& text)
        : QUndoCommand(text),
          m_document(document),
          m_before(document.skinAge()),
          m_after(years),
          m_gesture(gesture) {}

    void undo() override { m_document.setSkinAge(m_before); }
    void redo() override { m_document.setSkinAge(m_after); }
    int id() const override { return 3; }
    bool mergeWith(const QUndoCommand* other) override;

private:
    FaceDocument& m_document;
    double m_before, m_after;
    int m_gesture;
};

/// Another list of variants.
class SetVariantsCommand final : public QUndoCommand {
public:
    SetVariantsCommand(FaceDocument& document, std::vector<Variant> variants, const QString& text)
        : QUndoCommand(text),
          m_document(document),
          m_before(document.variants()),
          m_after(std::move(variants)) {}

    void undo() override { m_document.setVariants(m_before); }
    void redo() override { m_document.setVariants(m_after); }

private:
    FaceDocument& m_document;
    std::vector<Variant> m_before, m_after;
};

/// Makes the face what a variant says, as one step of the history.
void pushVariant(FaceDocument& document, const Variant& variant, const QString& text);

/// Other landmarks; the face is fitted anew.
class SetLandmarksCommand final : public QUndoCommand {
public:
    SetLandmarksCommand(FaceDocument& document, Landmarks landmarks, const QString& text);

    void undo() override { m_document.setLandmarks(m_before); }
    void redo() override { m_document.setLandmarks(m_after); }

private:
    FaceDocument& m_document;
    Landmarks m_before, m_after;
};

/// Another depth of the soft tissue over the bone; the face is fitted anew.
class SetTissueCommand final : public QUndoCommand {
public:
    SetTissueCommand(FaceDocument& document, TissueThickness tissue, const QString& text)
        : QUndoCommand(text),
          m_document(document),
          m_before(document.fit().tissue),
          m_after(tissue) {}

    void undo() override { m_document.setTissue(m_before); }
    void redo() override { m_document.setTissue(m_after); }

private:
    FaceDocument& m_document;
    TissueThickness m_before, m_after;
};

}  // namespace myoface
