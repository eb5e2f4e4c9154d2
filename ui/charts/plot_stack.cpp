// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/plot_stack.h"

#include "ui/charts/plot_frame.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>
#include <iterator>

namespace gripscope {

namespace {

constexpr int legendLine = 20, legendEdge = 8; // pixels: height of a line, air at both sides
constexpr int signWidth = 26, signGap = 6, nameGap = 18;
constexpr QSize notShownYet{640, 480};

} // namespace

PlotStack::PlotStack(QWidget* parent) : QWidget(parent)
{
    connect(&Theme::instance(), &Theme::changed, this, [this] { update(); });
}

void PlotStack::add(PlotFrame* plot, int stretch)
{
    plot->setParent(this);
    m_parts.push_back({plot, stretch});
}

std::vector<PlotFrame*> PlotStack::plots() const
{
    std::vector<PlotFrame*> plots;
    for (const Part& part : m_parts)
        plots.push_back(part.plot);
    return plots;
}

void PlotStack::setExportNames(const QString& plot, const QString& file)
{
    m_plotName = plot;
    m_fileName = file;
    setAccessibleName(plot);
}

void PlotStack::setLegend(std::vector<FigureSign> signs)
{
    m_legend = std::move(signs);
    layOut();
    update();
}

QSize PlotStack::minimumSizeHint() const
{
    int height = m_legend.empty() ? 0 : 2 * legendLine;
    for (const Part& part : m_parts)
        height += part.plot->minimumSizeHint().height();
    return {240, height};
}

PlotStack::Arrangement PlotStack::arrange(QSize size) const
{
    Arrangement result;
    const int legend = paintLegend(nullptr, QRect(QPoint(), size));
    int stretches = 0;
    for (const Part& part : m_parts)
        stretches += part.stretch;
    const int room = size.height() - legend;
    int passed = 0, top = 0;
    for (const Part& part : m_parts) {
        passed += part.stretch;
        const int bottom = room * passed / std::max(1, stretches);
        result.plots.emplace_back(0, top, size.width(), bottom - top);
        top = bottom;
    }
    result.legend = QRect(0, top, size.width(), size.height() - top);
    return result;
}

void PlotStack::layOut()
{
    const Arrangement all = arrange(size());
    for (std::size_t i = 0; i < m_parts.size(); ++i)
        m_parts[i].plot->setGeometry(all.plots[i]);
}

void PlotStack::resizeEvent(QResizeEvent*)
{
    layOut();
}

void PlotStack::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRect room = arrange(size()).legend;
    painter.fillRect(room, Theme::instance().tokens().surface);
    paintLegend(&painter, room);
}

int PlotStack::paintLegend(QPainter* painter, QRect room) const
{
    if (m_legend.empty())
        return 0;
    const ThemeTokens& tokens = Theme::instance().tokens();
    const QFont font = Theme::font(metrics::fontSmall);
    const QFontMetricsF letters(font);
    const double most = room.width() - 2 * legendEdge - signWidth - signGap; // for a name
    double x = room.left() + legendEdge, y = room.top();
    for (const FigureSign& sign : m_legend) {
        const QString name = elided(letters, sign.name, std::max(0.0, most));
        const double width = signWidth + signGap + letters.horizontalAdvance(name) + 1;
        if (x > room.left() + legendEdge && x + width > room.right() - legendEdge) {
            x = room.left() + legendEdge;
            y += legendLine;
        }
        if (painter) {
            const double middle = y + legendLine / 2.0;
            if (sign.point) {
                painter->setPen(QPen(Theme::mix(tokens.surface, sign.pen.color(), sign.fade), 1));
                painter->setBrush(sign.fade < 1 ? tokens.surface : sign.pen.color());
                painter->drawEllipse(QPointF(x + signWidth / 2.0, middle), 2.5, 2.5);
            } else {
                painter->setPen(sign.pen);
                painter->drawLine(QPointF(x, middle), QPointF(x + signWidth, middle));
            }
            painter->setFont(font);
            painter->setPen(tokens.secondText);
            painter->drawText(QRectF(x + signWidth + signGap, y, width, legendLine),
                              Qt::AlignLeft | Qt::AlignVCenter, name);
        }
        x += width + nameGap;
    }
    return int(y) + legendLine + metrics::insideControl - room.top();
}

QSize PlotStack::pictureSize() const
{
    if (!m_pictureSize.isValid())
        return isVisible() ? size() : size().expandedTo(notShownYet);
    const int legend = paintLegend(nullptr, QRect(QPoint(), m_pictureSize));
    const int plots = m_pictureSize.height() * (2 + int(m_parts.size())) / 3;
    return {m_pictureSize.width(), plots + legend};
}

void PlotStack::paintPicture(QPainter& painter)
{
    const QSize all = pictureSize();
    const Arrangement places = arrange(all);
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
        PlotFrame* plot = m_parts[i].plot;
        plot->setPictureSize(places.plots[i].size());
        painter.save();
        painter.translate(places.plots[i].topLeft());
        plot->paintPicture(painter);
        painter.restore();
        plot->setPictureSize({});
    }
    painter.save();
    painter.fillRect(places.legend, Theme::instance().tokens().surface);
    paintLegend(&painter, places.legend);
    painter.restore();
}

PlotTable PlotStack::numbers() const
{
    PlotTable table;
    for (const Part& part : m_parts) {
        PlotTable columns = part.plot->numbers();
        std::move(columns.begin(), columns.end(), std::back_inserter(table));
    }
    return table;
}

} // namespace gripscope
