// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QMenu>
#include <QObject>

#include "myoface/sim/snapshot.h"

#include "face_document.h"
#include "report_export.h"

namespace myoface {

class FaceView;

/// Files of the window: which one is open, where it was saved, what is written from it. Asks with
/// the system's dialogs.
class FaceFiles final : public QObject {
    Q_OBJECT

public:
    FaceFiles(FaceDocument& document, QWidget& window);

    /// A face has been opened from here.
    void setOpened(const QString& path);
    const QString& path() const { return m_path; }
    /// The case that Save writes to; empty: it asks.
    const QString& casePath() const { return m_casePath; }
    void fillRecent(QMenu& menu);

    void chooseFace();
    void chooseLandmarks();
    /// @return whether it was saved
    bool saveCase();
    bool saveCaseAs();
    bool saveCaseTo(const QString& path);
    void exportFace(const SimSnapshot& shown);
    void exportPicture(FaceView& view);
    void exportTurntable(FaceView& view);
    void chooseReport(const ReportWords& words, const Population& population);
    /// Writes a report of the face as it stands, beside the window.
    void exportReport(const QString& path, const ReportWords& words, const Population& population);

Q_SIGNALS:
    void openWanted(const QString& path);
    void landmarksWanted(const QString& path);
    void message(const QString& sentence);
    void problem(const QString& sentence);
    void reportWritten(const QString& file);
    void reportWriting(bool writing);

private:
    QString folder() const;
    std::string thumbnail() const;
    void remember(const QString& path);

    FaceDocument& m_document;
    QWidget& m_window;
    ReportExport m_report;
    QString m_path, m_casePath;
    QString m_stamp;  ///< of the case as it was read or written last
};

}  // namespace myoface
