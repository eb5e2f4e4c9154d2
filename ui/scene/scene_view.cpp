// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene/scene_view.h"

#include "ui/scene/offscreen_gl.h"
#include "ui/theme/theme.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPixmap>
#include <QToolTip>

#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
/// How far from the middle of a point a click still means it, logical pixels.
constexpr double pickReach = 9;
} // namespace

SceneView::SceneView(QWidget* parent) : QWidget(parent), m_content(std::make_shared<SceneContent>())
{
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("Types in the space of mass, damping and stiffness"));
    connect(&Theme::instance(), &Theme::changed, this, [this] { themeChanged(); });
}

SceneView::~SceneView() = default;

void SceneView::setContent(SceneContent content)
{
    m_content = std::make_shared<const SceneContent>(std::move(content));
    setAccessibleDescription(tr("%n point(s)", nullptr, int(m_content->points.size())));
    contentChanged();
    update();
}

void SceneView::setEmptyText(const QString& text)
{
    m_emptyText = text;
    update();
}

bool SceneView::empty() const
{
    return m_content->points.empty() && !m_content->highlight;
}

QImage SceneView::picture()
{
    return grab().toImage();
}

QString SceneView::plotName() const
{
    return tr("Space of m, b and k");
}

QString SceneView::fileName() const
{
    return u"space"_s;
}

QSize SceneView::pictureSize() const
{
    if (!m_pictureSize.isValid())
        return size();
    return {m_pictureSize.width(), m_pictureSize.width() * 3 / 4};
}

PlotTable SceneView::numbers() const
{
    PlotTable table;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        auto values = std::make_shared<std::vector<double>>();
        for (const ScenePoint& point : content().points)
            values->push_back(point.at[Eigen::Index(axis)] * content().axes[axis].factor);
        table.push_back({content().axes[axis].title(), std::move(values)});
    }
    return table;
}

void SceneView::pick(const QString& id, const std::optional<Ellipsoid>& error)
{
    m_pickedId = id;
    m_pickedError = error;
    update();
}

std::optional<QPointF> SceneView::placeOf(const QString& id) const
{
    for (const Spot& spot : spots())
        if (spot.point->id == id)
            return spot.at;
    return std::nullopt;
}

const ScenePoint* SceneView::pointNear(QPointF position) const
{
    const ScenePoint* best = nullptr;
    double bestScore = HUGE_VAL;
    for (const Spot& spot : spots()) {
        const double distance = std::hypot(spot.at.x() - position.x(), spot.at.y() - position.y());
        if (distance > pickReach)
            continue;
        // A unit of depth is the whole cube: of two points under the pointer the nearer to the eye wins.
        const double score = distance + 4 * pickReach * spot.depth;
        if (score < bestScore) {
            bestScore = score;
            best = spot.point;
        }
    }
    return best;
}

void SceneView::pickAt(QPointF position)
{
    const ScenePoint* point = pointNear(position);
    pick(point ? point->id : QString());
    emit picked(m_pickedId);
}

void SceneView::pickNext(int step)
{
    const std::vector<ScenePoint>& points = m_content->points;
    if (points.empty())
        return;
    int index = -1;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].id == m_pickedId)
            index = int(i);
    const int count = int(points.size());
    index = index < 0 ? (step > 0 ? 0 : count - 1) : (index + step + count) % count;
    pick(points[std::size_t(index)].id);
    emit picked(m_pickedId);
}

bool SceneView::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const ScenePoint* point = m_tips ? pointNear(help->pos()) : nullptr;
        if (point)
            QToolTip::showText(help->globalPos(), m_tips(point->id), this);
        else
            QToolTip::hideText();
        return true;
    }
    return QWidget::event(event);
}

void SceneView::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_N:
        pickNext(event->modifiers() & Qt::ShiftModifier ? -1 : 1);
        return;
    case Qt::Key_M:
        lookAlong(SceneDirection::AlongMass);
        return;
    case Qt::Key_B:
        lookAlong(SceneDirection::AlongDamping);
        return;
    case Qt::Key_K:
        lookAlong(SceneDirection::AlongStiffness);
        return;
    case Qt::Key_I:
    case Qt::Key_Home:
        lookAlong(SceneDirection::Isometric);
        return;
    case Qt::Key_O:
        setOrthographic(!orthographic());
        return;
    default:
        QWidget::keyPressEvent(event);
    }
}

SceneView* makeSceneView(QWidget* parent, SceneKind kind)
{
    if (kind == SceneKind::Best && sceneAvailable())
        return new SceneWidget(parent);
    return new PairPlots(parent);
}

} // namespace gripscope
