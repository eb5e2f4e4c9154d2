// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_frame.h"

#include "ui/charts/axis_ticks.h"
#include "ui/theme/theme.h"

#include <QChart>
#include <QGraphicsLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QValueAxis>
#include <QXYSeries>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
// Around the plot, logical pixels: room for the numbers of every plot of a page, so that all have the same
// edges.
constexpr int frameLeft = 66, frameRight = 14, frameBottomBare = 8, bottomTitled = 26;
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
    return m_pictureSize.isValid() ? m_pictureSize : viewport()->size();
}

void PlotFrame::setPictureSize(QSize size)
{
    m_pictureSize = size;
    layOut();
    refresh();
    chart()->layout()->activate(); // before the screen is painted again
}

void PlotFrame::setHorizontalTitle(const QString& title)
{
    m_horizontalTitle = title;
    m_horizontal->setLabelsVisible(!title.isEmpty() && !m_logarithmicHorizontal);
    layOut();
}

void PlotFrame::renameHorizontal(const QString& title)
{
    if (!m_pictureAxis.isEmpty())
        m_pictureAxis = title;
    if (!m_horizontalTitle.isEmpty())
        setHorizontalTitle(title);
    viewport()->update();
}

void PlotFrame::setBand(std::optional<PlotRange> band, const QString& name)
{
    m_band = band;
    m_bandName = name;
    viewport()->update();
}

void PlotFrame::setLogarithmic(Qt::Orientation axis)
{
    QValueAxis* changed = axis == Qt::Horizontal ? m_horizontal : m_vertical;
    (axis == Qt::Horizontal ? m_logarithmicHorizontal : m_logarithmicVertical) = true;
    changed->setLabelsVisible(false); // painted with the grid, in plot_frame_painting.cpp
    changed->setGridLineVisible(false);
    viewport()->update();
}

namespace {

/// A label is made for each tick as soon as the range is set: at the interval of before, a range that is a
/// thousand times as wide (milliseconds for seconds) would have thousands of them.
void makeRoomForTicks(QValueAxis& axis, PlotRange range)
{
    if (range.span() > axis.max() - axis.min())
        axis.setTickInterval(range.span());
}

} // namespace

void PlotFrame::setVerticalStep(double step)
{
    m_verticalStep = step;
    setTicks(m_vertical, verticalSteps());
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
    if (logarithmic(axis))
        return;
    if (axis == m_vertical && m_verticalStep > 0) {
        const double few = std::ceil((axis->max() - axis->min()) / m_verticalStep / most);
        axis->setTickInterval(m_verticalStep * std::max(1.0, few));
        axis->setLabelFormat(u"%.%1f"_s.arg(decimalsOf(m_verticalStep)));
        return;
    }
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
    if (!m_logarithmicHorizontal)
        makeRoomForTicks(*m_horizontal, range);
    m_horizontal->setRange(range.low, range.high);
    setTicks(m_horizontal, horizontalSteps());
    refresh();
}

void PlotFrame::setVertical(PlotRange range)
{
    if (!(range.span() > 0))
        return;
    if (!m_logarithmicVertical)
        makeRoomForTicks(*m_vertical, range);
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

int PlotFrame::horizontalSteps() const
{
    return columns() / 70;
}

bool PlotFrame::logarithmic(const QValueAxis* axis) const
{
    return axis == m_horizontal ? m_logarithmicHorizontal : m_logarithmicVertical;
}

int PlotFrame::verticalSteps() const
{
    return std::max(2, int(chart()->plotArea().height() / 26));
}

void PlotFrame::layOut()
{
    const bool titled = !m_horizontalTitle.isEmpty();
    const QSize all = pictureSize();
    const QRectF area(frameLeft, headerHeight, std::max(10, all.width() - frameLeft - frameRight),
                      std::max(10, all.height() - headerHeight - (titled ? bottomTitled : frameBottomBare)));
    chart()->resize(all);
    chart()->setPlotArea(area);
    setTicks(m_horizontal, horizontalSteps());
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
