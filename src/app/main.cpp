// SPDX-License-Identifier: Apache-2.0
#include <clocale>
#include <cstdio>

#include <QApplication>
#include <QCommandLineParser>
#include <QMessageBox>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>
#include <QTimer>

#include "myoface/base/error.h"
#include "myoface/muscle/expression.h"
#include "myoface/sim/plan.h"

#include "compare_panel.h"
#include "journal_keeper.h"
#include "language.h"
#include "main_window.h"
#include "measure_panel.h"
#include "theme.h"

namespace {

constexpr int kScreenshotLimit = 600000;  // [ms], for slow machines without a graphics card

/// Whether this computer draws OpenGL 3.3 at all; a window without it would abort.
bool hasOpenGl() {
    QOpenGLContext context;
    if (!context.create()) {
        return false;
    }
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    const bool current = context.makeCurrent(&surface);
    context.doneCurrent();
    return current && context.format().version() >= qMakePair(3, 3);
}

/// Saves the whole window once it has come to rest, then ends.
void saveAndQuit(myoface::MainWindow& window, const QString& file) {
    QTimer::singleShot(400, &window, [&window, file] {  // a last frame with everything in place
        if (!window.settled()) {                        // soft shadows are still on their way
            saveAndQuit(window, file);
            return;
        }
        QApplication::sendPostedEvents();  // layouts that a busy machine has not come to yet
        QApplication::processEvents();
        const bool saved = window.grab().save(file);
        if (!saved) {
            std::fprintf(stderr, "myoface: %s: cannot be written.\n", qPrintable(file));
        }
        window.journal().finish();  // nobody is there to want it back
        window.journal().flush();
        QApplication::exit(saved ? 0 : 1);
    });
}

void showComparison(myoface::MainWindow& window, const QString& mode) {
    myoface::ComparePanel& panel = window.comparePanel();
    if (mode == QLatin1String("map")) {
        panel.setMap(true);
    } else if (mode == QLatin1String("sides")) {
        panel.setSides(true);
    } else {
        panel.setMode(mode == QLatin1String("side")    ? myoface::CompareMode::SideBySide
                      : mode == QLatin1String("wipe")  ? myoface::CompareMode::Wipe
                      : mode == QLatin1String("ghost") ? myoface::CompareMode::Ghost
                                                       : myoface::CompareMode::Off);
    }
}

}  // namespace

int main(int argc, char** argv) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    // Multisampling is slow without a graphics card; software drawing says so in its name.
    format.setSamples(qEnvironmentVariableIsSet("MYOFACE_NO_MULTISAMPLING") ? 0 : 4);
    QSurfaceFormat::setDefaultFormat(format);
    QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // numbers in files have points, whatever the user's language
    QApplication::setApplicationName(QStringLiteral("Myoface"));
    QApplication::setOrganizationName(QStringLiteral("Myoface"));
    QApplication::setApplicationVersion(QStringLiteral(MYOFACE_VERSION));
    QCommandLineParser parser;
    parser.setApplicationDescription(
        QObject::tr("Facial surgery consultation simulator. A planning and communication aid, not "
                    "a medical device."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("FACE"),
                                 QObject::tr("OBJ, PLY or .myoface file, or the word generic"));
    const QCommandLineOption screenshot(QStringLiteral("screenshot"),
                                        QObject::tr("save the window as PNG and end"),
                                        QStringLiteral("file"));
    const QCommandLineOption muscle(QStringLiteral("muscle"),
                                    QObject::tr("NAME=c, contraction; repeatable"),
                                    QStringLiteral("setting"));
    const QCommandLineOption expression(QStringLiteral("expression"),
                                        QObject::tr("NAME=w, intensity; repeatable"),
                                        QStringLiteral("setting"));
    const QCommandLineOption layers(QStringLiteral("layers"),
                                    QObject::tr("of skin,muscle,bone,springs"),
                                    QStringLiteral("list"));
    const QCommandLineOption view(QStringLiteral("view"), QObject::tr("standard view"),
                                  QStringLiteral("name"));
    const QCommandLineOption landmarks(QStringLiteral("landmarks-panel"),
                                       QObject::tr("show landmarks and fitted head"));
    const QCommandLineOption panel(
        QStringLiteral("panel"), QObject::tr("layers, scan, landmarks, shape or muscles in front"),
        QStringLiteral("name"));
    const QCommandLineOption strength(QStringLiteral("strength"),
                                      QObject::tr("NAME=s, of a muscle; repeatable"),
                                      QStringLiteral("setting"));
    const QCommandLineOption skinAge(QStringLiteral("skin-age"),
                                     QObject::tr("years of the skin that wrinkles, 18 to 80"),
                                     QStringLiteral("years"));
    const QCommandLineOption step(QStringLiteral("step"),
                                  QObject::tr("scan, fit, shape, expression, compare or report"),
                                  QStringLiteral("name"));
    const QCommandLineOption compare(QStringLiteral("compare"),
                                     QObject::tr("off, side, wipe, ghost, map or sides"),
                                     QStringLiteral("mode"));
    const QCommandLineOption language(QStringLiteral("language"), QObject::tr("en or ja"),
                                      QStringLiteral("code"));
    const QCommandLineOption theme(QStringLiteral("theme"), QObject::tr("dark or light"),
                                   QStringLiteral("name"));
    const QCommandLineOption size(QStringLiteral("size"), QObject::tr("of the window [px]"),
                                  QStringLiteral("WxH"));
    const QCommandLineOption views(QStringLiteral("views"),
                                   QObject::tr("1, 2 or 4 sides of the face at once"),
                                   QStringLiteral("number"));
    const QCommandLineOption section(QStringLiteral("section"),
                                     QObject::tr("a level cut through this landmark"),
                                     QStringLiteral("landmark"));
    parser.addOptions({views, section, screenshot, muscle, strength, expression, skinAge, layers,
                       view, landmarks, panel, step, compare, language, theme, size});
    parser.process(application);

    myoface::Settings settings = myoface::Settings::read();
    if (parser.isSet(language)) {
        settings.language = parser.value(language);
    }
    if (parser.isSet(theme)) {
        settings.theme = parser.value(theme) == QLatin1String("light") ? myoface::Theme::Light
                                                                       : myoface::Theme::Dark;
    }
    myoface::applyTheme(application, settings.theme);
    myoface::Language::instance().choose(settings.language);

    if (!hasOpenGl()) {
        const QString sentence = QObject::tr(
            "This computer offers no OpenGL 3.3, which the 3D view needs. Install or "
            "update its graphics driver; myoface-cli works without.");
        std::fprintf(stderr, "myoface: %s\n", qPrintable(sentence));
        if (!parser.isSet(screenshot) && QApplication::platformName() != "offscreen") {
            QMessageBox::critical(nullptr, QStringLiteral("Myoface"), sentence);
        }
        return 1;
    }

    std::vector<std::pair<std::string, double>> rates;
    std::vector<std::pair<std::string, double>> strengths;
    std::vector<std::pair<std::string, double>> expressions;
    try {
        for (const QString& text : parser.values(expression)) {
            expressions.push_back(myoface::parse_setting(text.toStdString()));
            myoface::expression_named(expressions.back().first);
        }
        for (const QString& text : parser.values(muscle)) {
            rates.push_back(myoface::parse_setting(text.toStdString()));
            myoface::muscles_named(rates.back().first);
        }
        for (const QString& text : parser.values(strength)) {
            strengths.push_back(myoface::parse_setting(text.toStdString()));
            myoface::muscles_named(strengths.back().first);
        }
        if (parser.isSet(view)) {
            myoface::standard_view(parser.value(view).toStdString());
        }
    } catch (const myoface::Error& error) {
        std::fprintf(stderr, "myoface: %s\n", error.what());
        return 1;
    }

    if (parser.isSet(screenshot)) {
        qputenv("MYOFACE_UNATTENDED", "1");
    }
    myoface::MainWindow window;
    const QStringList extent = parser.value(size).split(QLatin1Char('x'));
    if (extent.size() == 2) {
        window.resize(extent[0].toInt(), extent[1].toInt());
    }
    window.show();
    QObject::connect(&window, &myoface::MainWindow::opened, &window, [&] {
        try {
            for (const auto& [name, intensity] : expressions) {
                window.addExpression(name, intensity);
            }
            for (const auto& [name, rate] : rates) {
                window.setRates(name, rate);
            }
            for (const auto& [name, share] : strengths) {
                window.setStrengths(name, share);
            }
            if (parser.isSet(skinAge)) {
                window.setSkinAge(parser.value(skinAge).toDouble());
            }
            if (parser.isSet(step)) {
                window.showStep(parser.value(step));
            }
            if (parser.isSet(compare)) {
                showComparison(window, parser.value(compare));
            }
            if (parser.isSet(layers)) {
                const QStringList names = parser.value(layers).split(QLatin1Char(','));
                const bool inner = names.contains(QStringLiteral("muscle")) ||
                                   names.contains(QStringLiteral("bone"));
                window.setLayers(
                    {names.contains(QStringLiteral("skin")) ? (inner ? 0.4F : 1.0F) : 0.0F,
                     names.contains(QStringLiteral("muscle")) ? 1.0F : 0.0F,
                     names.contains(QStringLiteral("bone")) ? 1.0F : 0.0F,
                     names.contains(QStringLiteral("springs")) ? 0.8F : 0.0F});
            }
            if (parser.isSet(landmarks)) {
                window.showLandmarks();
            }
            if (parser.isSet(panel)) {
                window.showPanel(parser.value(panel));
            }
            if (parser.isSet(section)) {
                const auto& places = window.document().landmarks();
                const auto found = places.find(parser.value(section).toStdString());
                if (found != places.end()) {
                    window.measures().sections().place(found->second.position);
                }
            }
            if (parser.isSet(views)) {
                const int number = parser.value(views).toInt();
                window.setViews(number == 4   ? myoface::ViewLayout::Four
                                : number == 2 ? myoface::ViewLayout::Two
                                              : myoface::ViewLayout::One);
            }
            if (parser.isSet(view)) {
                window.view().showStandardView(parser.value(view));
            }
        } catch (const myoface::Error& error) {
            std::fprintf(stderr, "myoface: %s\n", error.what());
        }
        if (parser.isSet(screenshot) && window.settled()) {
            saveAndQuit(window, parser.value(screenshot));
        }
    });
    if (parser.isSet(screenshot)) {
        QObject::connect(&window, &myoface::MainWindow::cameToRest, &window, [&] {
            static bool saving = false;
            if (!saving) {
                saving = true;
                saveAndQuit(window, parser.value(screenshot));
            }
        });
        QObject::connect(&window, &myoface::MainWindow::openFailed, &window,
                         [](const QString& sentence) {
                             std::fprintf(stderr, "myoface: %s\n", qPrintable(sentence));
                             QApplication::exit(1);
                         });
        QTimer::singleShot(kScreenshotLimit, &window, [] {
            std::fputs("myoface: the face did not come to rest in ten minutes.\n", stderr);
            QApplication::exit(1);
        });
    }
    if (!parser.isSet(screenshot)) {
        window.offerRecovery();
        if (!window.settled()) {  // one comes back
            return QApplication::exec();
        }
    }
    const QStringList faces = parser.positionalArguments();
    window.openPath(faces.isEmpty() ? QStringLiteral("generic") : faces.first());
    return QApplication::exec();
}
