// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/number_format.h"
#include "ui/models/estimate_table_model.h"
#include "ui/theme/elided_text.h"
#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

using EstimateColumn = EstimateTableModel::Column;

constexpr int estimateSide = 5; // the table stands in a third of the window

QString fitText(const QVariant& percent)
{
    return percent.isValid() ? formatNumber(percent.toDouble(), std::nullopt, {}, 3).value
                             : QString(QChar(0x2013));
}

} // namespace

EstimateDelegate::Lines EstimateDelegate::linesOf(const QModelIndex& index)
{
    const auto column = EstimateColumn(index.column());
    if (column == EstimateColumn::Estimator)
        return {index.data().toString(),
                QStringList(index.siblingAtColumn(int(EstimateColumn::Verdict)).data().toString()) +
                    index.data(EstimateTableModel::FurtherRole).toStringList()};
    if (column == EstimateColumn::Verdict)
        return {index.data().toString(), {QString()}};
    const QVariant value = index.data(EstimateTableModel::SortRole);
    if (!value.isValid())
        return {QString(QChar(0x2013)), {QString()}};
    if (column == EstimateColumn::SimulationFit)
        return {fitText(value), {fitText(index.siblingAtColumn(int(EstimateColumn::PredictionFit)).data())}};
    const QVariant half = index.data(EstimateTableModel::HalfWidthRole);
    const FormattedNumber number =
        formatNumber(value.toDouble(), half.isValid() ? std::optional(half.toDouble()) : std::nullopt, {});
    return {number.value, {number.error.isEmpty() ? QString() : u"± "_s + number.error}};
}

QStringList EstimateDelegate::brokenTo(int width, const QStringList& lines)
{
    const QFontMetrics metrics(Theme::font(metrics::fontSmall));
    QStringList broken;
    for (const QString& line : lines) {
        if (metrics.horizontalAdvance(line) <= width) {
            broken << line;
            continue;
        }
        QStringList parts = line.split(u", "_s);
        for (qsizetype i = 0; i + 1 < parts.size(); ++i)
            parts[i] += u',';
        for (const QString& part : filledLines(metrics, parts, width))
            broken << (metrics.horizontalAdvance(part) <= width
                           ? QStringList(part)
                           : filledLines(metrics, part.split(u' '), width));
    }
    return broken;
}

QSize EstimateDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const
{
    const Lines lines = linesOf(index);
    const QFontMetrics first(Theme::font(metrics::fontBase)), second(Theme::font(metrics::fontSmall));
    const int room = option.rect.width() - 2 * estimateSide;
    const bool name = EstimateColumn(index.column()) == EstimateColumn::Estimator;
    int width = first.horizontalAdvance(lines.first);
    if (!name)
        for (const QString& line : lines.small)
            width = std::max(width, second.horizontalAdvance(line));
    const auto smallLines = name && room > 0 ? brokenTo(room, lines.small).size() : lines.small.size();
    return {width + 2 * estimateSide, first.height() + int(smallLines) * second.height() + 10};
}

void EstimateDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    painter->save();
    Theme::paintRow(*painter, option.rect, option.state & QStyle::State_Selected);
    const Lines lines = linesOf(index);
    const QRect box = option.rect.adjusted(estimateSide, 4, -estimateSide, -4);
    const bool text = EstimateColumn(index.column()) == EstimateColumn::Estimator ||
                      EstimateColumn(index.column()) == EstimateColumn::Verdict;
    const Qt::Alignment align = text ? Qt::AlignLeft : Qt::AlignRight;
    int y = box.top();
    const auto draw = [&](const QString& line, const QFont& font, const QColor& color) {
        const QFontMetrics measures(font);
        painter->setFont(font);
        painter->setPen(color);
        painter->drawText(QRect(box.left(), y, box.width(), measures.height()), int(align | Qt::AlignVCenter),
                          elided(measures, line, box.width()));
        y += measures.height();
    };
    const QFont small = Theme::font(metrics::fontSmall);
    draw(lines.first, Theme::font(metrics::fontBase), tokens.text);
    for (const QString& line : brokenTo(box.width(), lines.small))
        draw(line, small, tokens.secondText);
    painter->restore();
}

} // namespace gripscope
