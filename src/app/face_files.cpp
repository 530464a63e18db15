// SPDX-License-Identifier: Apache-2.0
#include "face_files.h"

#include <QBuffer>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include "myoface/base/error.h"

#include "face_view.h"
#include "language.h"

namespace myoface {
namespace {

constexpr int kRecentFiles = 8;
constexpr int kThumbnail = 256;  // [px]
const QString kRecentKey = QStringLiteral("recentFiles");

QString withSuffix(const QString& path, const QString& suffix) {
    return path.isEmpty() || !QFileInfo(path).suffix().isEmpty() ? path : path + suffix;
}

/// A picture, small, as PNG.
std::string thumbnail(const QImage& whole) {
    QImage picture = whole.scaled(kThumbnail, kThumbnail, Qt::KeepAspectRatioByExpanding,
                                  Qt::SmoothTransformation);
    picture = picture.copy((picture.width() - kThumbnail) / 2, (picture.height() - kThumbnail) / 2,
                           kThumbnail, kThumbnail);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return bytes.toStdString();
}

/// Tells whether a file is still the one that was read or written.
QString stampOf(const QString& path) {
    const QFileInfo info(path);
    return QStringLiteral("%1 %2").arg(info.size()).arg(info.lastModified().toMSecsSinceEpoch());
}

}  // namespace

FaceFiles::FaceFiles(FaceDocument& document, QWidget& window)
    : QObject(&window), m_document(document), m_window(window), m_cli(this) {
    connect(&m_cli, &CliExport::progressed, this, &FaceFiles::progressed);
    const auto end = [this] {
        Q_EMIT reportWriting(false);
        Q_EMIT rested();
    };
    connect(&m_cli, &CliExport::written, this, [this, end](const QString& file) {
        end();
        Q_EMIT message(tr("Written: %1").arg(file));
        Q_EMIT reportWritten(file);
    });
    connect(&m_cli, &CliExport::failed, this, [this, end](const QString& sentence) {
        end();
        Q_EMIT problem(sentence);
    });
    connect(&m_cli, &CliExport::cancelled, this, [this, end] {
        end();
        Q_EMIT message(tr("Cancelled; nothing was written."));
    });
}

void FaceFiles::begin(const QString& what, std::function<void(const Progress&)> work,
                      std::function<void()> then) {
    if (busy()) {
        Q_EMIT problem(tr("Something is being written already; wait for it or cancel it."));
        return;
    }
    m_job = std::make_unique<FileJob>(std::move(work));
    connect(m_job.get(), &FileJob::finished, this, [this, then = std::move(then)] {
        const std::unique_ptr<FileJob> job = std::move(m_job);
        Q_EMIT rested();
        if (job->cancelled()) {
            Q_EMIT message(tr("Cancelled; nothing was written."));
        } else if (!job->problem().isEmpty()) {
            Q_EMIT problem(inWords(job->problem().toStdString()));
        } else {
            then();
        }
    });
    Q_EMIT working(what);
    m_job->start();
}

void FaceFiles::beginCli(const QString& what, const QString& command, const QString& path,
                         const QStringList& options) {
    if (busy()) {
        Q_EMIT problem(tr("Something is being written already; wait for it or cancel it."));
        return;
    }
    Q_EMIT working(what);
    m_cli.start(m_document, command, path, options);
}

void FaceFiles::cancel() {
    if (m_job) {
        m_job->cancel();
    } else if (m_cli.running()) {
        m_cli.cancel();
    }
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

void FaceFiles::saveCase(std::function<void()> then) {
    if (m_casePath.isEmpty()) {
        saveCaseAs(std::move(then));
        return;
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
            saveCaseAs(std::move(then));
            return;
        }
        if (box.clickedButton() != over) {
            return;
        }
    }
    saveCaseTo(m_casePath, std::move(then));
}

void FaceFiles::saveCaseAs(std::function<void()> then) {
    if (!m_document.opened()) {
        return;
    }
    const QString path =
        withSuffix(QFileDialog::getSaveFileName(&m_window, tr("Save the case"),
                                                m_casePath.isEmpty() ? folder() : m_casePath,
                                                tr("Myoface case (*.myoface)")),
                   QStringLiteral(".myoface"));
    if (!path.isEmpty()) {
        saveCaseTo(path, std::move(then));
    }
}

/// The face as it is shown; null where nothing is.
QImage FaceFiles::picture() const {
    auto* view = m_window.findChild<FaceView*>();
    return view != nullptr && view->isVisible() ? view->grabFramebuffer() : QImage();
}

void FaceFiles::saveCaseTo(const QString& path, std::function<void()> then) {
    const int step = m_document.undoStack()->index();
    begin(
        tr("Saving"),
        [path, opened = m_document.opened(), edits = m_document.edits(),
         passphrase = m_document.passphrase(), picture = picture()](const Progress& progress) {
            OpenedFace face = asSaved(*opened, edits);
            face.passphrase = passphrase;
            if (!picture.isNull()) {
                face.thumbnail = thumbnail(picture);
            }
            write_case(path.toStdString(), face, stateOf(edits), &progress);
        },
        [this, path, step, opened = m_document.opened(), then = std::move(then)] {
            if (opened == m_document.opened()) {  // still the face that was saved
                m_casePath = path;
                m_stamp = stampOf(path);
                if (step == m_document.undoStack()->index()) {
                    m_document.undoStack()->setClean();
                }
            }
            remember(path);
            Q_EMIT message(tr("Saved: %1").arg(path));
            if (then) {
                then();
            }
        });
}

void FaceFiles::exportFace(const SimSnapshot& shown, bool anonymous) {
    // What is anonymous has no colours: it is for printing.
    const QString path = QFileDialog::getSaveFileName(
        &m_window, tr("Export the face as it is shown"), folder(),
        anonymous ? tr("STL (*.stl)") : tr("OBJ (*.obj);;PLY (*.ply);;GLB (*.glb);;STL (*.stl)"));
    if (!path.isEmpty()) {
        exportFaceTo(anonymous ? withSuffix(path, QStringLiteral(".stl")) : path, shown);
    }
}

void FaceFiles::exportFaceTo(const QString& path, const SimSnapshot& shown) {
    begin(
        tr("Writing the face"),
        [path, opened = m_document.opened(), model = m_document.model(), nodes = shown.positions,
         jaw = shown.jaw, wrinkles = shown.wrinkles](const Progress& progress) {
            progress.report("writing", 0.1);
            write_face(path.toStdString(), *opened->scan, *model, nodes, jaw, wrinkles);
        },
        [this, path] { Q_EMIT message(tr("Written: %1").arg(path)); });
}

void FaceFiles::exportPicture(FaceView& view) {
    const QString path = withSuffix(QFileDialog::getSaveFileName(&m_window, tr("Export a picture"),
                                                                 folder(), tr("PNG (*.png)")),
                                    QStringLiteral(".png"));
    if (path.isEmpty()) {
        return;
    }
    begin(
        tr("Writing the picture"),
        [path, picture = view.grabFramebuffer()](const Progress&) {
            if (!picture.save(path)) {
                throw IoError(path.toStdString() + ": cannot be written.");
            }
        },
        [this, path] { Q_EMIT message(tr("Written: %1").arg(path)); });
}

void FaceFiles::chooseAnimation(const QString& motion, bool anonymous) {
    if (!m_document.model()) {
        return;
    }
    QString chosen;
    QString path = QFileDialog::getSaveFileName(
        &m_window,
        motion == QLatin1String("turn") ? tr("A film or pictures all around the head")
                                        : tr("A film or pictures from rest to the face as it is"),
        folder(), tr("GIF (*.gif);;Film (*.mp4);;Folder of PNG pictures (*)"), &chosen);
    if (path.isEmpty()) {
        return;
    }
    if (QFileInfo(path).suffix().isEmpty() && chosen.contains(QLatin1String("*.gif"))) {
        path += QStringLiteral(".gif");
    } else if (QFileInfo(path).suffix().isEmpty() && chosen.contains(QLatin1String("*.mp4"))) {
        path += QStringLiteral(".mp4");
    }
    exportAnimation(motion, path, anonymous);
}

void FaceFiles::exportAnimation(const QString& motion, const QString& path, bool anonymous) {
    QStringList options{QStringLiteral("--motion"), motion};
    if (anonymous) {
        options << QStringLiteral("--anonymous");
    }
    beginCli(tr("Drawing the film"), QStringLiteral("animate"), path, options);
}

void FaceFiles::chooseReport(const ReportWords& words, const Population& population) {
    if (!m_document.model() || busy()) {
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
    QStringList options{QStringLiteral("--age"), QString::number(population.age),
                        QStringLiteral("--language"), Language::instance().code()};
    for (const auto& [option, value] :
         {std::pair("--title", words.title), std::pair("--patient", words.patient),
          std::pair("--notes", words.notes), std::pair("--logo", words.logo)}) {
        if (!value.trimmed().isEmpty()) {
            options << QString::fromLatin1(option) + QLatin1Char('=') + value;
        }
    }
    if (population.sex) {
        options << QStringLiteral("--sex")
                << (*population.sex == Sex::Female ? QStringLiteral("f") : QStringLiteral("m"));
    }
    if (words.anonymous) {
        options << QStringLiteral("--anonymous");
    }
    Q_EMIT reportWriting(true);
    beginCli(tr("Writing the report"), QStringLiteral("report"), path, options);
}

}  // namespace myoface
