// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/trend_figure.h"

#include "ui/theme/elided_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

constexpr double nameLine = 20;                 ///< height of a line of names, logical pixels
constexpr double nameSign = 16, nameApart = 16; // beside a name, between two of them
constexpr double nameEdge = 8;                  ///< left and right of them in a figure
constexpr double lowestAxis = 18;               ///< that the lowest plot needs for its numbers

struct TrendFigureWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::TrendPlot)
};

QPainterPath signPath(int sign, QPointF at, double size)
{
    QPainterPath path;
    const double r = size / 2;
    switch (Theme::typeShape(sign)) {
    case 0:
        path.addEllipse(at, r, r);
        break;
    case 1:
        path.addRect(QRectF(at.x() - r * 0.9, at.y() - r * 0.9, 1.8 * r, 1.8 * r));
        break;
    case 2:
        path.addPolygon(QPolygonF{
            {at + QPointF(0, -r * 1.1), at + QPointF(r * 1.1, r * 0.9), at + QPointF(-r * 1.1, r * 0.9)}});
        break;
    default:
        path.addPolygon(QPolygonF{{at + QPointF(0, -r * 1.2), at + QPointF(r * 1.2, 0),
                                   at + QPointF(0, r * 1.2), at + QPointF(-r * 1.2, 0)}});
    }
    path.closeSubpath();
    return path;
}

/// A name of the legend with its sign.
struct NamedSign {
    QString name;
    int sign = -1;
    std::optional<ValidityVerdict> validity = {}; ///< in place of a type's
    int line = 0;
    double left = 0;
};

std::vector<NamedSign> namedSigns(const TrendContent& content)
{
    std::vector<NamedSign> all;
    for (qsizetype i = 0; i < content.points->types.size(); ++i)
        all.push_back({content.points->types[i], content.sign(int(i))});
    all.push_back({TrendFigureWords::tr("of no type")});
    if (content.suspects)
        all.push_back({TrendFigureWords::tr("suspect"), -1, ValidityVerdict::Suspect});
    if (content.invalid)
        all.push_back({TrendFigureWords::tr("not valid"), -1, ValidityVerdict::Invalid});
    return all;
}

/// In lines of this width, the names cut to it.
std::vector<NamedSign> inLines(std::vector<NamedSign> signs, double width)
{
    const QFontMetricsF letters(Theme::font(metrics::fontSmall));
    int line = 0;
    double left = 0;
    for (NamedSign& one : signs) {
        one.name = elided(letters, one.name, std::max(0.0, width - nameSign - 2));
        const double wide = nameSign + letters.horizontalAdvance(one.name) + 2;
        if (left > 0 && left + wide > width) {
            ++line;
            left = 0;
        }
        one.line = line;
        one.left = left;
        left += wide + nameApart;
    }
    return signs;
}

} // namespace

QColor typeSignColor(int sign, const ThemeTokens& tokens)
{
    return sign < 0 ? tokens.secondText : Theme::typeColor(sign);
}

void paintDoubt(QPainter& painter, const std::optional<ValidityVerdict>& validity, QPointF at, double size,
                const ThemeTokens& tokens)
{
    if (validity == ValidityVerdict::Suspect) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(tokens.suspect);
        painter.drawPolygon(QPolygonF{
            {at + QPointF(0, -size), at + QPointF(size, 0), at + QPointF(0, size), at + QPointF(-size, 0)}});
    } else if (validity == ValidityVerdict::Invalid) {
        const double reach = 0.75 * size;
        painter.setPen(QPen(tokens.secondText, 1.6));
        painter.drawLine(at + QPointF(-reach, -reach), at + QPointF(reach, reach));
        painter.drawLine(at + QPointF(-reach, reach), at + QPointF(reach, -reach));
    }
}

void paintTypeSign(QPainter& painter, int sign, QPointF at, double size, const ThemeTokens& tokens)
{
    const QColor color = typeSignColor(sign, tokens);
    const bool light = tokens.kind == ThemeKind::Light;
    if (sign < 0) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(color, 1.6));
        painter.drawEllipse(at, size / 2, size / 2);
        return;
    }
    painter.setBrush(color);
    painter.setPen(QPen(light ? tokens.surface : tokens.text, 1));
    painter.drawPath(signPath(sign, at, size));
}

void paintTypeLegend(QPainter& painter, const TrendContent& content, const QRectF& box,
                     const ThemeTokens& tokens)
{
    const std::vector<NamedSign> signs = inLines(namedSigns(content), box.width());
    const int lines = std::min(signs.back().line + 1, std::max(1, int(box.height() / nameLine)));
    const double top = box.center().y() - lines * nameLine / 2;
    painter.setFont(Theme::font(metrics::fontSmall));
    for (const NamedSign& one : signs) {
        if (one.line >= lines)
            break;
        const QRectF place(box.left() + one.left, top + one.line * nameLine, box.width() - one.left,
                           nameLine);
        const QPointF at(place.left() + nameSign / 2 - 2, place.center().y());
        paintDoubt(painter, one.validity, at, 7, tokens);
        if (!one.validity)
            paintTypeSign(painter, one.sign, at, 9, tokens);
        painter.setPen(tokens.text);
        painter.drawText(place.adjusted(nameSign, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, one.name);
    }
}

int typeLegendHeight(const TrendContent& content, double width)
{
    if (!content.points)
        return 0;
    return int(nameLine) * (inLines(namedSigns(content), width - 2 * nameEdge).back().line + 1);
}

QString trendGateNote()
{
    return TrendFigureWords::tr(
        "Dotted lines: where the gate of the type ends at the rates set now; a squeeze "
        "beyond one of them is called unknown.");
}

std::array<QRectF, 3> trendBoxes(const QRectF& room)
{
    const double each = (room.height() - lowestAxis) / 3;
    std::array<QRectF, 3> boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        boxes[i] = QRectF(room.left(), room.top() + double(i) * each, room.width(),
                          each + (i + 1 == boxes.size() ? lowestAxis : 0));
    return boxes;
}

void paintTrendFigure(QPainter& painter, const TrendContent& content, QSizeF size, const ThemeTokens& tokens)
{
    const double legend = typeLegendHeight(content, size.width());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(QRectF(QPointF(), size), tokens.surface);
    if (content.points) {
        paintTypeLegend(painter, content, {nameEdge, 0, size.width() - 2 * nameEdge, legend}, tokens);
        const std::array<QRectF, 3> boxes = trendBoxes({0, legend, size.width(), size.height() - legend});
        for (std::size_t i = 0; i < boxes.size(); ++i)
            TrendPlot(content, int(i), boxes[i], i + 1 == boxes.size()).paint(painter, tokens);
    }
    painter.restore();
}

} // namespace gripscope
