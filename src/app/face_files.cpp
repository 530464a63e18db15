// SPDX-License-Identifier: Apache-2.0
#include "face_files.h"

#include <QBuffer>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>

#include "myoface/base/error.h"

#include "face_view.h"

namespace myoface {
namespace {

constexpr int kRecentFiles = 8;
constexpr int kThumbnail = 256;  // [px]
const QString kRecentKey = QStringLiteral("recentFiles");

QString withSuffix(const QString& path, const QString& suffix) {
    return path.isEmpty() || !QFileInfo(path).suffix().isEmpty() ? path : path + suffix;
}

/// Tells whether a file is still the one that was read or written.
QString stampOf(const QString& path) {
    const QFileInfo info(path);
    return QStringLiteral("%1 %2").arg(info.size()).arg(info.lastModified().toMSecsSinceEpoch());
}

}  // namespace

FaceFiles::FaceFiles(FaceDocument& document, QWidget& window)
    : QObject(&window), m_document(document), m_window(window), m_report(this) {
    connect(&m_report, &ReportExport::written, this, [this](const QString& file) {
        Q_EMIT reportWriting(false);
        Q_EMIT message(tr("Written: %1").arg(file));
        Q_EMIT reportWritten(file);
    });
    connect(&m_report, &ReportExport::failed, this, [this](const QString& sentence) {
        Q_EMIT reportWriting(false);
        Q_EMIT problem(sentence);
    });
}

void FaceFiles::setOpened(const QString& path) {
    m_path = path;
    m_casePath = QFileInfo(path).suffix() == QLatin1String("myoface") ? path : QString();
    m_stamp = stampOf(m_casePath);
    remember(path);
}

QString FaceFiles::folder() const {
    return m_path.isEmpty() || m_path == QLatin1String("generic")
               ? QString()
               : QFileInfo(m_path).absolutePath();
}

void FaceFiles::remember(const QString& path) {
    if (path == QLatin1String("generic")) {
        return;
    }
    QSettings settings;
    QStringList files = settings.value(kRecentKey).toStringList();
    const QString full = QFileInfo(path).absoluteFilePath();
    files.removeAll(full);
    files.prepend(full);
    settings.setValue(kRecentKey, QStringList(files.mid(0, kRecentFiles)));
}

void FaceFiles::fillRecent(QMenu& menu) {
    menu.clear();
    const QStringList files = QSettings().value(kRecentKey).toStringList();
    for (const QString& path : files) {
        QAction* action = menu.addAction(QFileInfo(path).fileName());
        action->setToolTip(path);
        action->setEnabled(QFileInfo::exists(path));
        if (QFileInfo(path).suffix() == QLatin1String("myoface")) {
            const QByteArray png = QByteArray::fromStdString(case_thumbnail(path.toStdString()));
            QPixmap picture;
            if (picture.loadFromData(png, "PNG")) {
                action->setIcon(QIcon(picture));
            }
        }
        connect(action, &QAction::triggered, this, [this, path] { Q_EMIT openWanted(path); });
    }
    if (files.isEmpty()) {
        menu.addAction(tr("None yet"))->setEnabled(false);
    }
}

void FaceFiles::chooseFace() {
    const QString path = QFileDialog::getOpenFileName(
        &m_window, tr("Open a face"), folder(),
        tr("Faces (*.obj *.ply *.stl *.glb *.gltf *.myoface);;All files (*)"));
    if (!path.isEmpty()) {
        Q_EMIT openWanted(path);
    }
}

void FaceFiles::chooseLandmarks() {
    if (!m_document.opened()) {
        return;
    }
    const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open landmarks"), folder(),
                                                      tr("Landmarks (*.json);;All files (*)"));
    if (!path.isEmpty()) {
        Q_EMIT landmarksWanted(path);
    }
}

bool FaceFiles::saveCase() {
    if (m_casePath.isEmpty()) {
        return saveCaseAs();
    }
    if (stampOf(m_casePath) != m_stamp && QFileInfo::exists(m_casePath) &&
        !qEnvironmentVariableIsSet("MYOFACE_UNATTENDED")) {
        QMessageBox box(QMessageBox::Warning, tr("Myoface"),
                        tr("%1 was changed by another program or window since it was opened here.")
                            .arg(m_casePath),
                        QMessageBox::Cancel, &m_window);
        const QAbstractButton* over = box.addButton(tr("Overwrite"), QMessageBox::DestructiveRole);
        const QAbstractButton* beside = box.addButton(tr("Save as…"), QMessageBox::AcceptRole);
        box.exec();
        if (box.clickedButton() == beside) {
            return saveCaseAs();
        }
        if (box.clickedButton() != over) {
            return false;
        }
    }
    return saveCaseTo(m_casePath);
}

bool FaceFiles::saveCaseAs() {
    if (!m_document.opened()) {
        return false;
    }
    const QString path =
        withSuffix(QFileDialog::getSaveFileName(&m_window, tr("Save the case"),
                                                m_casePath.isEmpty() ? folder() : m_casePath,
                                                tr("Myoface case (*.myoface)")),
                   QStringLiteral(".myoface"));
    return !path.isEmpty() && saveCaseTo(path);
}

bool FaceFiles::saveCaseTo(const QString& path) {
    try {
        OpenedFace face = m_document.asSaved();
        face.thumbnail = thumbnail();
        write_case(path.toStdString(), face, m_document.state());
    } catch (const Error& error) {
        Q_EMIT problem(QString::fromUtf8(error.what()));
        return false;
    }
    m_casePath = path;
    m_stamp = stampOf(path);
    m_document.undoStack()->setClean();
    remember(path);
    Q_EMIT message(tr("Saved: %1").arg(path));
    return true;
}

/// The face as it is shown, small, as PNG.
std::string FaceFiles::thumbnail() const {
    auto* view = m_window.findChild<FaceView*>();
    if (view == nullptr || !view->isVisible()) {
        return m_document.opened()->thumbnail;
    }
    QImage picture = view->grabFramebuffer().scaled(
        kThumbnail, kThumbnail, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
    picture = picture.copy((picture.width() - kThumbnail) / 2, (picture.height() - kThumbnail) / 2,
                           kThumbnail, kThumbnail);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return bytes.toStdString();
}

void FaceFiles::exportFace(const SimSnapshot& shown) {
    const QString path =
        QFileDialog::getSaveFileName(&m_window, tr("Export the face as it is shown"), folder(),
                                     tr("OBJ (*.obj);;PLY (*.ply);;GLB (*.glb);;STL (*.stl)"));
    if (path.isEmpty()) {
        return;
    }
    try {
        write_face(path.toStdString(), *m_document.opened()->scan, *m_document.model(),
                   shown.positions, shown.jaw, shown.wrinkles);
        Q_EMIT message(tr("Written: %1").arg(path));
    } catch (const Error& error) {
        Q_EMIT problem(QString::fromUtf8(error.what()));
    }
}

void FaceFiles::exportPicture(FaceView& view) {
    const QString path = withSuffix(QFileDialog::getSaveFileName(&m_window, tr("Export a picture"),
                                                                 folder(), tr("PNG (*.png)")),
                                    QStringLiteral(".png"));
    if (path.isEmpty()) {
        return;
    }
    if (view.grabFramebuffer().save(path)) {
        Q_EMIT message(tr("Written: %1").arg(path));
    } else {
        Q_EMIT problem(tr("%1: cannot be written.").arg(path));
    }
}

void FaceFiles::exportTurntable(FaceView& view) {
    const QString folder = QFileDialog::getExistingDirectory(
        &m_window, tr("A folder for pictures all around the head"), this->folder());
    if (folder.isEmpty()) {
        return;
    }
    constexpr int kPictures = 36;
    const Camera home = view.camera();
    QProgressDialog progress(tr("Turning the head…"), tr("Cancel"), 0, kPictures, &m_window);
    progress.setWindowModality(Qt::WindowModal);
    bool good = true;
    for (int k = 0; k < kPictures && good && !progress.wasCanceled(); ++k) {
        progress.setValue(k);
        Camera camera = home;
        orbit(camera, 2.0 * 3.14159265358979 * k / kPictures, 0.0);
        view.setCamera(camera);
        good = view.grabFramebuffer().save(
            QDir(folder).filePath(QStringLiteral("turn-%1.png").arg(k, 2, 10, QLatin1Char('0'))));
    }
    progress.setValue(kPictures);
    view.setCamera(home);
    if (good) {
        Q_EMIT message(tr("Written: %1").arg(folder));
    } else {
        Q_EMIT problem(tr("%1: cannot be written.").arg(folder));
    }
}

void FaceFiles::chooseReport(const ReportWords& words, const Population& population) {
    if (!m_document.model() || m_report.running()) {
        return;
    }
    const QString path = withSuffix(
        QFileDialog::getSaveFileName(&m_window, tr("Export a report"), folder(), tr("PDF (*.pdf)")),
        QStringLiteral(".pdf"));
    if (!path.isEmpty()) {
        exportReport(path, words, population);
    }
}

void FaceFiles::exportReport(const QString& path, const ReportWords& words,
                             const Population& population) {
    try {
        m_report.start(m_document, path, words, population);
        Q_EMIT reportWriting(true);
        Q_EMIT message(tr("Writing the report…"));
    } catch (const Error& error) {
        Q_EMIT problem(QString::fromUtf8(error.what()));
    }
}

}  // namespace myoface
