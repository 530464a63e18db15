// SPDX-License-Identifier: Apache-2.0
// What the main window does to muscles and shape, as steps of undo, and what it says about them.
#include <algorithm>
#include <numeric>

#include <QStatusBar>
#include <QToolTip>

#include "myoface/base/error.h"
#include "myoface/muscle/user_expressions.h"
#include "myoface/muscle/weakening.h"
#include "myoface/scene/muscle_drawing.h"

#include "language.h"
#include "layer_panel.h"
#include "main_window.h"
#include "muscle_panel.h"

namespace myoface {
namespace {

constexpr double kGlideSeconds = 0.4;  // in which a chosen preset is reached

}  // namespace

/// The list of muscles with their settings, in the language of the interface.
void MainWindow::showMuscles() {
    const auto& model = m_document.model();
    if (!model) {
        return;
    }
    m_muscles->setMuscles(model->muscles);
    m_muscles->setSkinAge(m_document.skinAge());
    for (std::size_t m = 0; m < model->muscles.size(); ++m) {
        m_muscles->setRate(static_cast<int>(m), m_document.contractions().rate[m]);
        m_muscles->setStrength(static_cast<int>(m), m_document.contractions().strength[m]);
    }
}

void MainWindow::restMuscles() {
    std::vector<int> which;
    const std::vector<double>& rates = m_document.contractions().rate;
    for (std::size_t m = 0; m < rates.size(); ++m) {
        if (rates[m] != 0.0) {
            which.push_back(static_cast<int>(m));
        }
    }
    if (!which.empty()) {
        m_document.undoStack()->push(new SetMusclesCommand(m_document, MuscleSetting::Rate, which,
                                                           std::vector<double>(which.size(), 0.0),
                                                           -1, tr("muscles at rest")));
    }
}

void MainWindow::resetFace() {
    if (!m_document.model()) {
        return;
    }
    m_document.undoStack()->beginMacro(tr("reset"));
    restMuscles();
    const Points& scan = m_document.model()->skin.mesh.vertices;
    if (m_document.skinRest() != scan) {
        m_document.undoStack()->push(
            new ReshapeCommand(m_document, m_document.skinRest(), scan, tr("shape of the scan")));
    }
    m_document.undoStack()->endMacro();
}

void MainWindow::nameWhatIsThere(const ViewRay& ray, const std::optional<SurfacePoint>& where) {
    const auto& model = m_document.model();
    if (!model) {
        return;
    }
    const bool japanese = Language::instance().japanese();
    const LayerOpacity layers = m_layers->layers();
    const bool muscles = layers.muscles > 0.0F && (layers.skin < 0.9F || m_layers->cutAway() > 0.0);
    const std::optional<int> muscle = muscles ? muscle_on_ray(*model, ray) : std::nullopt;
    if (muscle) {
        const MuscleTraits& traits = model->muscles[static_cast<std::size_t>(*muscle)].traits;
        QToolTip::showText(QCursor::pos(),
                           QString::fromStdString(muscle_in_words(traits, japanese)), m_view);
        return;
    }
    QToolTip::hideText();
    if (where) {
        int corner = 0;
        where->weights.maxCoeff(&corner);
        statusBar()->showMessage(
            QString::fromStdString(tissue_in_words(
                *model, model->skin.mesh.triangles(corner, where->triangle), japanese)),
            2500);
    }
}

void MainWindow::setRates(const std::string& muscle, double rate) {
    setMuscles(MuscleSetting::Rate, muscle, rate);
}

void MainWindow::setStrengths(const std::string& muscle, double strength) {
    setMuscles(MuscleSetting::Strength, muscle, strength);
}

void MainWindow::setMuscles(MuscleSetting setting, const std::string& muscle, double value) {
    const std::vector<int> which = muscles_named(muscle);
    m_document.undoStack()->push(new SetMusclesCommand(
        m_document, setting, which, std::vector<double>(which.size(), value), -2,
        QString::fromStdString(
            m_document.model()->muscles[static_cast<std::size_t>(which[0])].traits.title)));
}

void MainWindow::pushExpression(std::vector<double> rates, const std::string& name, double left,
                                double right, int gesture) {
    const Expression expression = expression_named(name);
    Expression sided = expression;
    for (auto& [muscle, rate] : sided.rates) {
        const Side side = m_document.model()->muscles[static_cast<std::size_t>(muscle)].traits.side;
        rate *= side == Side::Left ? left : side == Side::Right ? right : 0.5 * (left + right);
    }
    add_expression(rates, sided, 1.0);
    std::vector<int> which(rates.size());
    std::iota(which.begin(), which.end(), 0);
    m_document.undoStack()->push(new SetMusclesCommand(m_document, MuscleSetting::Rate, which,
                                                       rates, gesture, inWords(expression.title)));
}

/// A preset from the list: alone, or on top of what the muscles did when it was chosen.
void MainWindow::chooseExpression(const std::string& name, double left, double right, int gesture,
                                  bool fresh) {
    const std::vector<double>& now = m_document.contractions().rate;
    if (fresh || m_expressionBase.size() != now.size()) {
        m_expressionBase = m_muscles->blends() ? now : std::vector<double>(now.size(), 0.0);
    }
    const double seconds = fresh && m_muscles->glides() ? kGlideSeconds : 0.0;
    inWorker([seconds](SimulationWorker& w) { w.beginGlide(seconds); });
    pushExpression(m_expressionBase, name, left, right, gesture);
    inWorker([](SimulationWorker& w) { w.endGlide(); });
}

/// Changes the user's own presets and lists them anew.
void MainWindow::changePresets(const QString& chosen, const std::function<void()>& change) {
    try {
        change();
        m_muscles->listExpressions(chosen);
    } catch (const Error& error) {
        complain(QString::fromUtf8(error.what()));
    }
}

void MainWindow::setSkinAge(double years) {
    m_document.undoStack()->push(new SetSkinAgeCommand(
        m_document, std::clamp(years, kYoungestSkin, kOldestSkin), -2, tr("age of the skin")));
}

void MainWindow::addExpression(const std::string& name, double intensity) {
    if (m_document.model()) {
        pushExpression(m_document.contractions().rate, name, intensity, intensity, -2);
    }
}

/// Sets a ready set of weak muscles, and all others back to full strength.
void MainWindow::weaken(const std::string& preset, bool left, bool right) {
    if (!m_document.model()) {
        return;
    }
    std::vector<double> strengths(m_document.model()->muscles.size(), 1.0);
    QString title = tr("full strength");
    if (!preset.empty()) {
        const Weakening set = weakening_named(preset + (left && right ? "" : left ? ".L" : ".R"));
        for (const auto& [muscle, strength] : set.strengths) {
            strengths[static_cast<std::size_t>(muscle)] = strength;
        }
        title = inWords(set.title);
    }
    std::vector<int> all(strengths.size());
    std::iota(all.begin(), all.end(), 0);
    m_document.undoStack()->push(
        new SetMusclesCommand(m_document, MuscleSetting::Strength, all, strengths, -1, title));
}

}  // namespace myoface
