// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include <QImage>
#include <QMenu>
#include <QObject>

#include "myoface/measure/measurement.h"
#include "myoface/sim/snapshot.h"

#include "cli_export.h"
#include "face_document.h"
#include "report_panel.h"

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
    /// Saves beside the window. @param then is done when it has been saved
    void saveCase(std::function<void()> then = {});
    void saveCaseAs(std::function<void()> then = {});
    void saveCaseTo(const QString& path, std::function<void()> then = {});
    void exportFace(const SimSnapshot& shown, bool anonymous = false);
    void exportFaceTo(const QString& path, const SimSnapshot& shown);
    void exportPicture(FaceView& view);
    /// Pictures or a film: around the head, or from rest to the face as it is.
    void chooseAnimation(const QString& motion, bool anonymous);
    void exportAnimation(const QString& motion, const QString& path, bool anonymous);
    void chooseReport(const ReportWords& words, const Population& population);
    /// Writes a report of the face as it stands, beside the window.
    void exportReport(const QString& path, const ReportWords& words, const Population& population);
    /// Something is being written.
    bool busy() const { return m_job != nullptr || m_cli.running(); }
    void cancel();

Q_SIGNALS:
    void openWanted(const QString& path);
    void landmarksWanted(const QString& path);
    void message(const QString& sentence);
    void problem(const QString& sentence);
    void reportWritten(const QString& file);
    void reportWriting(bool writing);
    /// Work begins, is so far (percent, below 0: nobody knows), and has ended.
    void working(const QString& what);
    void progressed(int percent);
    void rested();

private:
    QString folder() const;
    QImage picture() const;
    void remember(const QString& path);
    /// Does something with a file beside the window. @param then when it went well
    void begin(const QString& what, std::function<void(const Progress&)> work,
               std::function<void()> then);
    void beginCli(const QString& what, const QString& command, const QString& path,
                  const QStringList& options);

    FaceDocument& m_document;
    QWidget& m_window;
    CliExport m_cli;
    std::unique_ptr<FileJob> m_job;
    QString m_path, m_casePath;
    QString m_stamp;  ///< of the case as it was read or written last
};

}  // namespace myoface
