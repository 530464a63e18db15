// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include <QObject>
#include <QUndoStack>

#include "myoface/cases/case_file.h"

namespace myoface {

/// What the user made of a face at a moment, to be written down beside the window.
struct FaceEdits {
    std::shared_ptr<const FaceModel> model;  ///< null for a scan that has not been fitted
    Contractions contractions;
    Points skinRest;
    Eigen::VectorXd protection;
    Landmarks landmarks;
    FitOptions fit;
    std::vector<Variant> variants;
    double skinAge = kUsualSkin;
    std::string notes;
    Plan plan;  ///< the edits that led here, with places on `model`
};
/// In terms of the scan. Costs a moment on fine scans.
CaseState stateOf(const FaceEdits& edits);
/// A face as it is to be saved: as opened, with what was placed and chosen since.
OpenedFace asSaved(const OpenedFace& opened, const FaceEdits& edits);

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
    /// What gestures leave alone, 0 … 1 per skin node; empty: nothing.
    const Eigen::VectorXd& protection() const { return m_protection; }
    /// As they were found, opened, or placed since.
    const Landmarks& landmarks() const { return m_landmarks; }
    const FitOptions& fit() const { return m_fit; }
    const std::vector<Variant>& variants() const { return m_variants; }
    double skinAge() const { return m_skinAge; }
    const QString& notes() const { return m_notes; }
    QUndoStack* undoStack() { return &m_undoStack; }

    // For commands.
    void setRate(int muscle, double rate);
    void setStrength(int muscle, double strength);
    void setSkinRest(const Points& skinRest);
    void setProtection(const Eigen::VectorXd& share);
    void setLandmarks(const Landmarks& landmarks);
    void setTissue(TissueThickness tissue);
    void setVariants(const std::vector<Variant>& variants);
    void setSkinAge(double years);
    void setNotes(const QString& notes);
    /// Of saved cases and the journal; empty: they are not protected.
    void setPassphrase(const std::string& passphrase);
    const std::string& passphrase() const { return m_passphrase; }
    /// The edits that led to the face as it is, what a case brought first, with places on model().
    Plan plan() const;
    /// The face as it is to be saved: as opened, with what was placed and chosen since.
    OpenedFace asSaved() const;
    FaceEdits edits() const;
    CaseState state() const { return stateOf(edits()); }

    /// The same scan fitted anew; the history goes on.
    void setModel(std::shared_ptr<const FaceModel> model, const Points& skinRest);

Q_SIGNALS:
    void faceChanged();
    void rateChanged(int muscle, double rate);
    void strengthChanged(int muscle, double strength);
    void skinRestChanged();
    void protectionChanged();
    void landmarksChanged();
    void tissueChanged();
    void variantsChanged();
    void skinAgeChanged(double years);
    void notesChanged();
    void passphraseChanged();

private:
    std::shared_ptr<const OpenedFace> m_opened;
    std::shared_ptr<const FaceModel> m_model;
    Contractions m_contractions;
    Points m_skinRest;
    Eigen::VectorXd m_protection;
    Landmarks m_landmarks;
    FitOptions m_fit;
    std::vector<Variant> m_variants;
    double m_skinAge = kUsualSkin;
    QString m_notes;
    std::string m_passphrase;
    Plan m_before;  ///< edits from before the history begins, with places on m_model
    QUndoStack m_undoStack;
};

}  // namespace myoface
