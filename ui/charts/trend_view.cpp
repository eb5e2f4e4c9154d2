// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_figure.h"
#include "ui/charts/trend_plot.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr int plots = 3;
constexpr int leastDrag = 6;     ///< pixels; less is a click
constexpr double closest = 1e-5; ///< of the whole: no closer
} // namespace

TrendView::TrendView(QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Mass, damping and stiffness of the squeezes"));
    connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void TrendView::setContent(TrendContent content)
{
    m_content = std::move(content);
    update();
}

void TrendView::setSelected(std::optional<std::size_t> place)
{
    m_content.selected = place;
    update();
}

bool TrendView::empty() const
{
    return !m_content.points || m_content.points->points.empty();
}

QRectF TrendView::box(int parameter) const
{
    return trendBoxes(QRectF(rect()))[std::size_t(parameter)];
}

TrendPlot TrendView::plot(int parameter) const
{
    return {m_content, parameter, box(parameter), parameter == plots - 1};
}

QString TrendView::plotName() const
{
    return tr("Mass, damping and stiffness");
}

QString TrendView::fileName() const
{
    return u"trend"_s;
}

QSize TrendView::pictureSize() const
{
    QSize plain = size();
    if (m_pictureSize.isValid()) // higher than a single plot
        plain = {m_pictureSize.width(), m_pictureSize.height() * (2 + plots) / 3};
    return plain + QSize(0, typeLegendHeight(m_content, plain.width()));
}

void TrendView::paintPicture(QPainter& painter)
{
    TrendContent content = m_content;
    content.selected.reset();
    paintTrendFigure(painter, content, pictureSize(), Theme::instance().tokens());
}

PlotTable TrendView::numbers() const
{
    return trendNumbers(m_content);
}

void TrendView::paintEvent(QPaintEvent*)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    QPainter painter(this);
    painter.fillRect(rect(), tokens.surface);
    for (int parameter = 0; parameter < plots && !empty(); ++parameter)
        plot(parameter).paint(painter, tokens);
    if (m_pressed && m_dragged) {
        const int from = std::min(m_pressed->x(), m_dragged->x()),
                  to = std::max(m_pressed->x(), m_dragged->x());
        QColor tint = tokens.accent;
        tint.setAlpha(50);
        painter.fillRect(QRect(from, 0, to - from, height()), tint);
    }
    if (hasFocus()) {
        painter.setPen(QPen(tokens.accent, 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

void TrendView::show(double low, double high)
{
    const AxisRange whole = m_content.whole();
    const double least = whole.span() * closest;
    m_content.low = std::clamp(low, whole.low, whole.high - least);
    m_content.high = std::clamp(high, m_content.low + least, whole.high);
    update();
}

void TrendView::zoom(double around, double factor)
{
    show(around - (around - m_content.low) * factor, around + (m_content.high - around) * factor);
}

void TrendView::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && !empty())
        m_pressed = event->position().toPoint();
}

void TrendView::mouseMoveEvent(QMouseEvent* event)
{
    if (!m_pressed)
        return;
    m_dragged = event->position().toPoint();
    update();
}

void TrendView::mouseReleaseEvent(QMouseEvent* event)
{
    if (!m_pressed || event->button() != Qt::LeftButton)
        return;
    const QPoint from = *m_pressed, to = event->position().toPoint();
    m_pressed.reset();
    m_dragged.reset();
    update();
    if (std::abs(to.x() - from.x()) >= leastDrag) {
        const TrendPlot first = plot(0);
        show(first.valueAt(std::min(from.x(), to.x())), first.valueAt(std::max(from.x(), to.x())));
        return;
    }
    for (int parameter = 0; parameter < plots; ++parameter) {
        if (!box(parameter).contains(to))
            continue;
        if (const auto place = plot(parameter).pointAt(to)) {
            setSelected(place);
            emit pointChosen(qsizetype(*place));
        }
    }
}

void TrendView::mouseDoubleClickEvent(QMouseEvent*)
{
    const AxisRange whole = m_content.whole();
    show(whole.low, whole.high);
}

void TrendView::wheelEvent(QWheelEvent* event)
{
    if (!empty())
        zoom(plot(0).valueAt(event->position().x()), std::pow(0.8, event->angleDelta().y() / 120.0));
    event->accept();
}

void TrendView::keyPressEvent(QKeyEvent* event)
{
    const double span = m_content.high - m_content.low, middle = (m_content.high + m_content.low) / 2;
    const AxisRange whole = m_content.whole();
    const auto move = [&](double share) {
        const double by = std::clamp(span * share, whole.low - m_content.low, whole.high - m_content.high);
        show(m_content.low + by, m_content.high + by);
    };
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(middle, 0.5);
    case Qt::Key_Minus:
        return zoom(middle, 2);
    case Qt::Key_Left:
        return move(-0.2);
    case Qt::Key_Right:
        return move(0.2);
    case Qt::Key_Home:
        return show(whole.low, whole.high);
    default:
        QWidget::keyPressEvent(event);
    }
}

} // namespace gripscope
