// SPDX-License-Identifier: Apache-2.0
#include "comparison.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>

#include "myoface/scene/colour_map.h"

#include "commands.h"
#include "comparison_jobs.h"
#include "language.h"

namespace myoface {
namespace {

constexpr int kLegendSteps = 60;
const Eigen::Vector3f kGhost(0.45F, 0.72F, 0.95F);

/// Wrinkles on the way from one moment to another; both maps are of the same face.
Wrinkles between(const Wrinkles& from, const Wrinkles& to, double share) {
    Wrinkles result = to.map ? to : from;
    const Eigen::Index n =
        result.map ? static_cast<Eigen::Index>(result.map->gauges.size()) : Eigen::Index(0);
    result.depth = Eigen::VectorXd::Zero(n);
    if (from.depth.size() == n) {
        result.depth += (1.0 - share) * from.depth;
    }
    if (to.depth.size() == n) {
        result.depth += share * to.depth;
    }
    return result;
}

}  // namespace

Comparison::Comparison(FaceDocument& document, FaceView& view, ComparePanel& panel, QObject* parent)
    : QObject(parent), m_document(document), m_view(view), m_panel(panel) {
    connect(&panel, &ComparePanel::edited, this, [this] {
        if (m_panel.map() || m_panel.sides()) {
            m_actual.reset();
        }
        if (!m_panel.sides()) {
            m_panel.setSidesWords({});
            m_sidesOf.resize(3, 0);
        }
        updateView();
        Q_EMIT changed();
    });
    connect(&panel, &ComparePanel::referenceChosen, this, &Comparison::choose);
    connect(&panel, &ComparePanel::storeAsked, this, &Comparison::storeVariant);
    connect(&panel, &ComparePanel::showAsked, this, [this](int row) {
        const auto& variants = m_document.variants();
        if (m_document.model() && row >= 0 && row < static_cast<int>(variants.size())) {
            const Variant variant = variants[static_cast<std::size_t>(row)];
            pushVariant(m_document, variant,
                        tr("variant %1").arg(QString::fromStdString(variant.name)));
        }
    });
    connect(&panel, &ComparePanel::renameAsked, this, [this](int row, const QString& name) {
        std::vector<Variant> variants = m_document.variants();
        if (row >= 0 && row < static_cast<int>(variants.size()) && !name.trimmed().isEmpty()) {
            variants[static_cast<std::size_t>(row)].name = name.trimmed().toStdString();
            m_document.undoStack()->push(
                new SetVariantsCommand(m_document, variants, tr("rename variant")));
        } else {
            m_panel.setVariants(m_document.variants());
        }
    });
    connect(&panel, &ComparePanel::removeAsked, this, [this](int row) {
        std::vector<Variant> variants = m_document.variants();
        if (row >= 0 && row < static_cast<int>(variants.size())) {
            variants.erase(variants.begin() + row);
            m_document.undoStack()->push(
                new SetVariantsCommand(m_document, variants, tr("remove variant")));
        }
    });
    connect(&panel, &ComparePanel::actualAsked, this, &Comparison::chooseActual);
    connect(&document, &FaceDocument::variantsChanged, this,
            [this] { m_panel.setVariants(m_document.variants()); });
    connect(&view, &FaceView::wipeMoved, this, [this] { Q_EMIT changed(); });
    m_followsSliders.setSingleShot(true);
    m_followsSliders.setInterval(150);
    connect(&m_followsSliders, &QTimer::timeout, this, &Comparison::settleUntreated);
    for (const auto edited : {&FaceDocument::rateChanged, &FaceDocument::strengthChanged}) {
        connect(&document, edited, this, [this] {
            if (m_untreated) {
                m_followsSliders.start();
            }
        });
    }
}

Comparison::~Comparison() = default;

void Comparison::setScene(FaceScene* scene) {
    m_scene = scene;
    m_now.reset();
    m_before.reset();
    m_beforeJaw = {};
    m_beforeWrinkles = {};
    retire(m_settling);
    retire(m_comparing);
    retire(m_comparingSides);
    retire(m_drawing);
    m_actual.reset();
    m_sides.resize(0);
    m_sidesOf.resize(3, 0);
    m_stale = true;
    if (std::exchange(m_untreated, false)) {
        Q_EMIT untreatedChanged(false);
    }
    m_panel.setActualWords({});
    m_panel.setSidesWords({});
    m_panel.setEnabled(scene != nullptr && m_document.model() != nullptr);
    m_panel.setVariants(m_document.variants());
    if (scene == nullptr) {
        m_view.setCompare(CompareMode::Off, nullptr);
        return;
    }
    if (m_panel.reference() >= 0) {
        choose(m_panel.reference());
    }
    updateView();
}

const Points& Comparison::before() const {
    return m_before ? *m_before : m_document.model()->skin.mesh.vertices;
}

SimSnapshot Comparison::shown(const SimSnapshot& now) const {
    SimSnapshot result = now;
    const double share = m_held ? 0.0 : m_panel.share();
    if (share < 1.0) {
        const Points& from = before();
        const Eigen::Index n = m_document.model()->node_count();
        result.positions.leftCols(n) =
            from.leftCols(n) + share * (now.positions.leftCols(n) - from.leftCols(n));
        result.jaw = between(m_beforeJaw, now.jaw, share);
        result.wrinkles = between(m_beforeWrinkles, now.wrinkles, share);
    }
    return result;
}

void Comparison::holdBefore(bool held) {
    m_held = held;
    Q_EMIT changed();
}

bool Comparison::paint(const SimSnapshot& shown) {
    m_now = std::make_shared<SimSnapshot>(shown);
    if (m_scene == nullptr || !m_document.model()) {
        return false;
    }
    if (m_actual) {
        Eigen::Matrix4Xf tint = Eigen::Matrix4Xf::Zero(4, m_actual->distance.size());
        for (Eigen::Index i = 0; i < m_actual->distance.size(); ++i) {
            const double d = m_actual->distance[i];
            if (std::isfinite(d)) {
                tint.col(i) = signed_tint(d / m_panel.mapMillimetres());
            }
        }
        m_scene->tint_nodes(tint);
        return true;
    }
    if (m_panel.sides()) {
        const Points nodes = shown.positions.leftCols(m_document.model()->node_count());
        if (nodes.cols() != m_sidesOf.cols() || nodes != m_sidesOf) {
            compareSides(nodes);
        }
        Eigen::Matrix4Xf tint = Eigen::Matrix4Xf::Zero(4, m_sides.size());
        for (Eigen::Index i = 0; i < m_sides.size(); ++i) {
            if (std::isfinite(m_sides[i])) {
                tint.col(i) = signed_tint(m_sides[i] / m_panel.mapMillimetres());
            }
        }
        m_scene->tint_nodes(tint);
        return true;
    }
    if (m_panel.map()) {
        m_scene->tint_change(before(), shown.positions, m_panel.mapMillimetres());
        return true;
    }
    return false;
}

void Comparison::compareUntreated(bool beside) {
    if (beside && m_document.model()) {
        m_panel.setReference(-1);
        m_untreated = true;
        m_panel.setMode(CompareMode::SideBySide);
        settleUntreated();
    } else {
        m_panel.setMode(CompareMode::Off);
        choose(m_panel.reference());
    }
    Q_EMIT untreatedChanged(m_untreated);
}

void Comparison::settleUntreated() {
    if (!m_untreated || !m_document.model()) {
        return;
    }
    if (m_settling) {
        m_followsSliders.start();  // one after the other
        return;
    }
    const CaseState state = m_document.state();
    m_settling = std::make_unique<SettleJob>(m_document.model(),
                                             Variant{"untreated", state.rates, {}, state.shape},
                                             m_document.skinAge());
    connect(m_settling.get(), &SettleJob::finished, this, &Comparison::settled);
    m_settling->start();
}

QString Comparison::beforeTitle() const {
    if (m_untreated) {
        return tr("untreated");
    }
    if (m_panel.reference() < 0) {
        return tr("before");
    }
    const auto& variants = m_document.variants();
    return tr("variant %1")
        .arg(QString::fromStdString(variants[static_cast<std::size_t>(m_panel.reference())].name));
}

void Comparison::compareSides(const Points& nodes) {
    if (m_comparingSides) {
        return;  // looks again when it is done
    }
    m_comparingSides = std::make_unique<SidesJob>(m_document.model(), nodes);
    connect(m_comparingSides.get(), &SidesJob::finished, this, &Comparison::sidesCompared);
    m_comparingSides->start();
}

void Comparison::sidesCompared() {
    const std::unique_ptr<SidesJob> job = std::move(m_comparingSides);
    if (!job->problem().isEmpty() || !m_panel.sides()) {
        return;
    }
    m_sidesOf = job->nodes();
    m_sides = job->result();
    m_panel.setSidesWords(regionTable(job->regions()));
    Q_EMIT changed();
}

void Comparison::choose(int variant) {
    if (std::exchange(m_untreated, false)) {
        Q_EMIT untreatedChanged(false);
    }
    const auto& variants = m_document.variants();
    if (variant < 0 || variant >= static_cast<int>(variants.size()) || !m_document.model()) {
        retire(m_settling);
        m_before.reset();
        m_beforeJaw = {};
        m_beforeWrinkles = {};
        m_stale = true;
        updateView();
        Q_EMIT changed();
        return;
    }
    retire(m_settling);
    m_settling = std::make_unique<SettleJob>(
        m_document.model(), variants[static_cast<std::size_t>(variant)], m_document.skinAge());
    connect(m_settling.get(), &SettleJob::finished, this, &Comparison::settled);
    m_settling->start();
}

void Comparison::settled() {
    const std::unique_ptr<SettleJob> job = std::move(m_settling);
    if (!job->problem().isEmpty()) {
        Q_EMIT problem(inWords(job->problem().toStdString()));
        return;
    }
    m_before = job->result().positions;
    m_beforeJaw = job->result().jaw;
    m_beforeWrinkles = job->result().wrinkles;
    m_stale = true;
    updateView();
    Q_EMIT changed();
}

void Comparison::storeVariant() {
    if (!m_document.model()) {
        return;
    }
    std::vector<Variant> variants = m_document.variants();
    const auto taken = [&](const std::string& name) {
        return std::any_of(variants.begin(), variants.end(),
                           [&](const Variant& v) { return v.name == name; });
    };
    std::string name = "A";
    for (int k = 1; taken(name); ++k) {
        name = k < 26 ? std::string(1, static_cast<char>('A' + k)) : std::to_string(k);
    }
    const CaseState state = m_document.state();
    variants.push_back({name, state.rates, state.strengths, state.shape});
    m_document.undoStack()->push(new SetVariantsCommand(
        m_document, variants, tr("keep variant %1").arg(QString::fromStdString(name))));
    Q_EMIT message(tr("Kept as variant %1.").arg(QString::fromStdString(name)));
}

void Comparison::chooseActual() {
    const QString path = QFileDialog::getOpenFileName(
        &m_panel, tr("Open a scan of afterwards"), {},
        tr("Faces (*.obj *.ply *.stl *.glb *.gltf *.myoface);;All files (*)"));
    if (!path.isEmpty()) {
        openActual(path);
    }
}

void Comparison::openActual(const QString& path) {
    if (!m_document.model() || !m_now) {
        return;
    }
    m_panel.setActualWords(tr("Laying %1 on the face…").arg(QFileInfo(path).fileName()));
    retire(m_comparing);
    m_comparing = std::make_unique<ActualJob>(m_document.model(), m_now->positions, path);
    connect(m_comparing.get(), &ActualJob::finished, this, &Comparison::compared);
    m_comparing->start();
}

void Comparison::compared() {
    const std::unique_ptr<ActualJob> job = std::move(m_comparing);
    if (!job->problem().isEmpty()) {
        m_panel.setActualWords(inWords(job->problem().toStdString()).toHtmlEscaped());
        return;
    }
    m_panel.setMode(CompareMode::Off);
    m_actual = std::move(job->result());
    const QLocale locale;
    QString words = tr("<p>%1, laid on forehead and nasal root (%2 mm left)</p>")
                        .arg(QFileInfo(job->path()).fileName().toHtmlEscaped(),
                             locale.toString(m_actual->registration_mm, 'f', 2));
    m_panel.setActualWords(words + regionTable(m_actual->regions));
    updateView();
    Q_EMIT changed();
}

QString Comparison::regionTable(const std::vector<RegionDistance>& regions) const {
    const QLocale locale;
    QString words = QStringLiteral(
                        "<table cellspacing=4><tr><td></td><td>%1</td><td>%2</td><td>%3</td>"
                        "</tr>")
                        .arg(tr("mean"), tr("90 %"), tr("&lt; 2 mm"));
    for (const RegionDistance& row : regions) {
        words += QStringLiteral(
                     "<tr><td>%1</td><td align=right>%2</td><td align=right>%3</td>"
                     "<td align=right>%4 %</td></tr>")
                     .arg(inWords(row.region), locale.toString(row.mean_mm, 'f', 1),
                          locale.toString(row.p90_mm, 'f', 1),
                          locale.toString(100.0 * row.share_below_2mm, 'f', 0));
    }
    return words + QStringLiteral("</table>");
}

void Comparison::updateView() {
    if (m_scene == nullptr || !m_document.model()) {
        return;
    }
    const bool same = m_mode == m_panel.mode() && !m_stale;
    m_mode = m_panel.mode();
    m_stale = false;
    if (same) {
        // the picture of the state before still holds
    } else if (m_mode == CompareMode::Off) {
        retire(m_drawing);
        m_view.setCompare(CompareMode::Off, nullptr);
    } else {
        drawBefore();
    }
    if (!paints()) {
        m_scene->tint_nodes({});
    }
    showLegend();
}

/// Draws the state before beside the window; until it is there, the face is shown alone.
void Comparison::drawBefore() {
    retire(m_drawing);
    m_drawing = std::make_unique<StillJob>(m_scene->still(before(), m_beforeJaw, m_beforeWrinkles));
    connect(m_drawing.get(), &StillJob::finished, this, &Comparison::beforeDrawn);
    m_drawing->start();
}

void Comparison::beforeDrawn() {
    const std::unique_ptr<StillJob> job = std::move(m_drawing);
    if (!job->problem().isEmpty()) {
        Q_EMIT problem(job->problem());
        return;
    }
    if (m_scene == nullptr || m_mode == CompareMode::Off) {
        return;
    }
    std::shared_ptr<SceneData> still = std::move(job->result());
    still->background_top = m_scene->scene().background_top;
    still->background_bottom = m_scene->scene().background_bottom;
    if (m_mode == CompareMode::Ghost) {
        still->skin.opacity = 0.34F;
        still->skin.texture = nullptr;
        still->skin.colours.resize(3, 0);
        still->skin.rest.resize(3, 0);
        still->skin.plain_colour = kGhost;
        still->mouth.opacity = 0.0F;
        still->eyes.opacity = 0.0F;
        ++still->topology;
    }
    m_view.setCompare(m_mode, std::move(still), beforeTitle());
    Q_EMIT changed();
}

void Comparison::showLegend() {
    QVector<QColor> colours;
    if (paints()) {
        for (int k = 0; k < kLegendSteps; ++k) {
            const Eigen::Vector4f c = signed_tint(2.0 * (k + 0.5) / kLegendSteps - 1.0);
            const Eigen::Vector3f skin(0.80F, 0.62F, 0.53F);
            const Eigen::Vector3f shown = c[3] * c.head<3>() + (1.0F - c[3]) * skin;
            colours.append(QColor::fromRgbF(shown.x(), shown.y(), shown.z()));
        }
    }
    const QString most = QLocale().toString(m_panel.mapMillimetres(), 'f', 1);
    if (m_panel.sides()) {
        m_view.setLegend(colours, tr("−%1 mm behind").arg(most), tr("stands out +%1 mm").arg(most));
    } else {
        m_view.setLegend(colours, tr("−%1 mm in").arg(most), tr("out +%1 mm").arg(most));
    }
}

}  // namespace myoface
