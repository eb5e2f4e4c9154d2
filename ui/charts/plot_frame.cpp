// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_frame.h"

#include "ui/charts/plot_series_painter.h"
#include "ui/theme/theme.h"
#include "ui/widgets/axis_ticks.h"

#include <QChart>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QValueAxis>
#include <QXYSeries>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
// Around the plot, logical pixels: room for the numbers of every plot of a page, so that all have the same
// edges.
constexpr int left = 66, right = 14, top = 26, bottomBare = 8, bottomTitled = 26;
} // namespace

PlotFrame::PlotFrame(QWidget* parent)
    : QChartView(parent), m_horizontal(new QValueAxis(this)), m_vertical(new QValueAxis(this))
{
    chart()->legend()->hide();
    chart()->setMargins({});
    chart()->layout()->setContentsMargins(0, 0, 0, 0);
    chart()->setBackgroundRoundness(0);
    chart()->setBackgroundVisible(false);
    chart()->setPlotAreaBackgroundVisible(false);
    chart()->setLocalizeNumbers(true);
    chart()->addAxis(m_horizontal, Qt::AlignBottom);
    chart()->addAxis(m_vertical, Qt::AlignLeft);
    for (QValueAxis* axis : {m_horizontal, m_vertical}) {
        axis->setTickType(QValueAxis::TicksDynamic);
        axis->setTickAnchor(0);
        axis->setMinorTickCount(0);
    }
    m_horizontal->setLabelsVisible(false);
    setRenderHint(QPainter::Antialiasing);
    setRubberBand(QChartView::RectangleRubberBand);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::StrongFocus);
    connect(&Theme::instance(), &Theme::changed, this, [this] { themeChanged(); });
    PlotFrame::themeChanged();
}

void PlotFrame::attach(QAbstractSeries* series)
{
    chart()->addSeries(series);
    series->attachAxis(m_horizontal);
    series->attachAxis(m_vertical);
}

void PlotFrame::setTitle(const QString& title, const QString& brief)
{
    m_title = title;
    m_briefTitle = brief.isEmpty() ? title : brief;
    describe();
}

void PlotFrame::setFinding(const QString& finding, bool doubtful)
{
    m_finding = finding;
    m_findingDoubtful = doubtful;
    describe();
}

void PlotFrame::describe()
{
    setAccessibleName(m_finding.isEmpty() ? m_title : u"%1: %2"_s.arg(m_title, m_finding));
    viewport()->update();
}

void PlotFrame::setExportNames(const QString& plot, const QString& file, const QString& axis)
{
    m_plotName = plot;
    m_fileName = file;
    m_pictureAxis = axis;
}

QSize PlotFrame::pictureSize() const
{
    return viewport()->size();
}

void PlotFrame::paintPicture(QPainter& painter)
{
    m_inPicture = true;
    const bool ownAxis = m_horizontalTitle.isEmpty() && !m_pictureAxis.isEmpty();
    if (ownAxis)
        setHorizontalTitle(m_pictureAxis);
    chart()->layout()->activate();
    const QList<QAbstractSeries*> series = chart()->series();
    for (QAbstractSeries* one : series)
        one->setVisible(false); // painted below, cut off without a clip
    const QRect all = viewport()->rect();
    render(&painter, all, all);
    for (QAbstractSeries* one : series)
        one->setVisible(true);
    paintSeries(painter, *chart());
    if (ownAxis)
        setHorizontalTitle({});
    chart()->layout()->activate(); // before the screen is painted again
    m_inPicture = false;
}

void PlotFrame::setHorizontalTitle(const QString& title)
{
    m_horizontalTitle = title;
    m_horizontal->setLabelsVisible(!title.isEmpty());
    layOut();
}

void PlotFrame::setBand(std::optional<PlotRange> band, const QString& name)
{
    m_band = band;
    m_bandName = name;
    viewport()->update();
}

void PlotFrame::setEmptyText(const QString& text)
{
    m_emptyText = text;
    viewport()->update();
}

void PlotFrame::setLegend(std::vector<LegendEntry> entries)
{
    m_legend = std::move(entries);
    viewport()->update();
}

PlotRange PlotFrame::horizontal() const
{
    return {m_horizontal->min(), m_horizontal->max()};
}
PlotRange PlotFrame::vertical() const
{
    return {m_vertical->min(), m_vertical->max()};
}

void PlotFrame::setTicks(QValueAxis* axis, int most)
{
    AxisTicks ticks = roundTicks(axis->min(), axis->max(), most);
    if (most < 4 && axis->min() == -axis->max())
        ticks.step = symmetricStep(axis->max()); // zero and both ends, or they would stand too close
    else
        for (int more = most + 1; ticks.values.size() < 2 && more < most + 8; ++more)
            ticks = roundTicks(axis->min(), axis->max(), more); // one number says nothing about the scale
    if (!(ticks.step > 0))
        return;
    axis->setTickInterval(ticks.step);
    axis->setLabelFormat(u"%.%1f"_s.arg(decimalsOf(ticks.step)));
}

void PlotFrame::setHorizontal(PlotRange range)
{
    if (!(range.span() > 0) || range == horizontal())
        return;
    m_horizontal->setRange(range.low, range.high);
    setTicks(m_horizontal, columns() / 70);
    refresh();
}

void PlotFrame::setVertical(PlotRange range)
{
    if (!(range.span() > 0))
        return;
    m_vertical->setRange(range.low, range.high);
    setTicks(m_vertical, verticalSteps());
}

void PlotFrame::setWhole(PlotRange range)
{
    m_whole = range;
    setHorizontal(range);
}

void PlotFrame::showWhole()
{
    setHorizontal(m_whole);
}

int PlotFrame::columns() const
{
    return std::max(16, int(chart()->plotArea().width()));
}

int PlotFrame::verticalSteps() const
{
    return std::max(2, int(chart()->plotArea().height() / 26));
}

void PlotFrame::layOut()
{
    const bool titled = !m_horizontalTitle.isEmpty();
    const QSize all = viewport()->size();
    const QRectF area(left, top, std::max(10, all.width() - left - right),
                      std::max(10, all.height() - top - (titled ? bottomTitled : bottomBare)));
    chart()->resize(all);
    chart()->setPlotArea(area);
    setTicks(m_horizontal, columns() / 70);
    setTicks(m_vertical, verticalSteps());
}

void PlotFrame::resizeEvent(QResizeEvent* event)
{
    QChartView::resizeEvent(event);
    layOut();
    refresh();
}

void PlotFrame::themeChanged()
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    setBackgroundBrush(tokens.surface);
    for (QValueAxis* axis : {m_horizontal, m_vertical}) {
        axis->setLabelsColor(tokens.secondText);
        axis->setLabelsFont(Theme::font(metrics::fontSmall));
        axis->setLinePen(QPen(tokens.line, tokens.lineWidth));
        axis->setGridLinePen(QPen(Theme::mix(tokens.surface, tokens.line, 0.7), 1));
    }
    viewport()->update();
}

void PlotFrame::drawBackground(QPainter* painter, const QRectF& rect)
{
    QChartView::drawBackground(painter, rect);
    if (!m_band || empty())
        return;
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QRectF area = chart()->plotArea();
    const double y0 = chart()->mapToPosition({m_horizontal->min(), m_band->high}).y();
    const double y1 = chart()->mapToPosition({m_horizontal->min(), m_band->low}).y();
    const QRectF stripe = QRectF(QPointF(area.left(), y0), QPointF(area.right(), y1)).intersected(area);
    painter->save();
    painter->fillRect(stripe, Theme::mix(tokens.surface, tokens.accent, 0.12));
    painter->setPen(QPen(tokens.accent, tokens.lineWidth, Qt::DashLine));
    for (const double y : {y0, y1})
        if (y >= area.top() && y <= area.bottom())
            painter->drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter->restore();
}

double PlotFrame::paintTitle(QPainter* painter, const QRectF& line) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QFont strong = Theme::font(metrics::fontSmall, true), plain = Theme::font(metrics::fontSmall);
    const QFont& found = m_findingDoubtful ? strong : plain;
    const double findingWidth =
        m_finding.isEmpty() ? 0 : QFontMetricsF(found).horizontalAdvance(m_finding) + 7;
    const auto width = [&](const QString& title) { return QFontMetricsF(strong).horizontalAdvance(title); };
    QString title = m_finding.isEmpty() ? m_title : m_title + u':';
    // Where it is tight the short title; where that is too long, from the edge of the plot's own margin.
    QRectF room = line;
    if (width(title) + findingWidth > room.width())
        title = m_finding.isEmpty() ? m_briefTitle : m_briefTitle + u':';
    if (width(title) + findingWidth > room.width())
        room.setLeft(std::max(8.0, room.right() - width(title) - findingWidth));
    title =
        QFontMetricsF(strong).elidedText(title, Qt::ElideRight, std::max(0.0, room.width() - findingWidth));
    painter->setFont(strong);
    painter->setPen(tokens.text);
    painter->drawText(room, Qt::AlignLeft | Qt::AlignVCenter, title);
    const double end = room.left() + width(title);
    if (m_finding.isEmpty())
        return end;
    painter->setFont(found);
    painter->setPen(m_findingDoubtful ? tokens.notValid : tokens.secondText);
    painter->drawText(room.adjusted(width(title) + 6, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, m_finding);
    return end + findingWidth;
}

void PlotFrame::paintHeader(QPainter* painter) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QRectF area = chart()->plotArea();
    const QRectF line(area.left(), 2, area.width(), top - 6);
    const double titleEnd = paintTitle(painter, line) + 16;
    painter->setFont(Theme::font(metrics::fontSmall));
    const QFontMetricsF small(painter->font());
    double end = line.right();
    const auto entry = [&](const QString& name, const auto& paintSign) {
        const double width = small.horizontalAdvance(name);
        if (name.isEmpty() || end - width - 24 < titleEnd)
            return;
        painter->setPen(tokens.secondText);
        painter->drawText(QRectF(end - width, line.top(), width + 1, line.height()),
                          Qt::AlignLeft | Qt::AlignVCenter, name);
        paintSign(QPointF(end - width - 24, line.center().y()));
        end -= width + 40;
    };
    if (!m_horizontalTitle.isEmpty()) {
        painter->setPen(tokens.secondText);
        painter->drawText(QRectF(0, area.bottom() + 4, area.left() - 14, 18),
                          Qt::AlignRight | Qt::AlignVCenter, m_horizontalTitle);
    }
    if (m_band)
        entry(m_bandName, [&](QPointF at) {
            painter->fillRect(QRectF(at.x(), at.y() - 4, 18, 8),
                              Theme::mix(tokens.surface, tokens.accent, 0.25));
        });
    for (auto i = m_legend.rbegin(); i != m_legend.rend(); ++i)
        entry(i->name, [&](QPointF at) {
            painter->setPen(QPen(i->color, i->width, Qt::SolidLine, Qt::FlatCap));
            painter->drawLine(at, at + QPointF(18, 0));
        });
}

void PlotFrame::drawForeground(QPainter* painter, const QRectF&)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter->save();
    paintHeader(painter);
    if (empty()) {
        painter->setPen(tokens.secondText);
        painter->setFont(Theme::font(metrics::fontSmall));
        painter->drawText(chart()->plotArea(), Qt::AlignCenter | Qt::TextWordWrap, m_emptyText);
    }
    if (hasFocus() && !m_inPicture) {
        painter->setPen(QPen(tokens.accent, 2));
        painter->setBrush(Qt::NoBrush);
        painter->drawRect(viewport()->rect().adjusted(1, 1, -1, -1));
    }
    painter->restore();
}

void PlotFrame::ask(PlotRange range)
{
    // Never beyond what there is, never so close that a pixel is less than a sample's rounding.
    const double least = m_whole.span() * 1e-4;
    range.low = std::clamp(range.low, m_whole.low, m_whole.high - least);
    range.high = std::clamp(range.high, range.low + least, m_whole.high);
    setHorizontal(range);
    emit horizontalChanged(horizontal());
}

void PlotFrame::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::RightButton) // QChartView would zoom out by an amount of its own
        return;
    const PlotRange before = horizontal();
    QChartView::mouseReleaseEvent(event);
    const PlotRange after = horizontal();
    if (after == before)
        return;
    setVertical(vertical());
    m_horizontal->setRange(before.low, before.high);
    ask(after);
}

void PlotFrame::mouseDoubleClickEvent(QMouseEvent*)
{
    showWhole();
    emit horizontalChanged(horizontal());
    emit wholeAsked();
}

void PlotFrame::keyPressEvent(QKeyEvent* event)
{
    const PlotRange now = horizontal();
    const double middle = (now.low + now.high) / 2;
    const auto zoomed = [&](double factor) {
        return PlotRange{middle - now.span() / 2 * factor, middle + now.span() / 2 * factor};
    };
    const auto moved = [&](double share) {
        const double step = std::clamp(now.span() * share, m_whole.low - now.low, m_whole.high - now.high);
        return PlotRange{now.low + step, now.high + step};
    };
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        ask(zoomed(0.5));
        return;
    case Qt::Key_Minus:
        ask(zoomed(2));
        return;
    case Qt::Key_Left:
        ask(moved(-0.2));
        return;
    case Qt::Key_Right:
        ask(moved(0.2));
        return;
    case Qt::Key_Home:
        showWhole();
        emit horizontalChanged(horizontal());
        emit wholeAsked();
        return;
    default:
        QChartView::keyPressEvent(event);
    }
}

} // namespace gripscope
