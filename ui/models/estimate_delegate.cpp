// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/estimate_delegate.h"

#include "ui/models/estimate_table_model.h"
#include "ui/theme/theme.h"
#include "ui/widgets/number_format.h"

#include <QPainter>

namespace gripscope {

using Column = EstimateTableModel::Column;

namespace {
constexpr int side = 5; // the table stands in a third of the window

QString fitText(const QVariant& percent)
{
    return percent.isValid() ? formatNumber(percent.toDouble(), std::nullopt, {}, 3).value
                             : QString(QChar(0x2013));
}
} // namespace

EstimateDelegate::Lines EstimateDelegate::linesOf(const QModelIndex& index)
{
    const auto column = Column(index.column());
    if (column == Column::Estimator)
        return {index.data().toString(), index.siblingAtColumn(int(Column::Verdict)).data().toString(),
                index.data(EstimateTableModel::CubicRole).toString()};
    if (column == Column::Verdict)
        return {index.data().toString(), {}, {}};
    const QVariant value = index.data(EstimateTableModel::SortRole);
    if (!value.isValid())
        return {QString(QChar(0x2013)), {}, {}};
    if (column == Column::SimulationFit)
        return {fitText(value), fitText(index.siblingAtColumn(int(Column::PredictionFit)).data()), {}};
    const QVariant half = index.data(EstimateTableModel::HalfWidthRole);
    const FormattedNumber number =
        formatNumber(value.toDouble(), half.isValid() ? std::optional(half.toDouble()) : std::nullopt, {});
    return {number.value, number.error.isEmpty() ? QString() : QStringLiteral("± ") + number.error, {}};
}

QSize EstimateDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const
{
    const Lines lines = linesOf(index);
    const QFontMetrics first(Theme::font(metrics::fontBase)), second(Theme::font(metrics::fontSmall));
    const bool name = Column(index.column()) == Column::Estimator;
    const int width =
        name ? first.horizontalAdvance(lines.first)
             : std::max(first.horizontalAdvance(lines.first), second.horizontalAdvance(lines.second));
    const int smallLines = lines.third.isEmpty() ? 1 : 2;
    return {width + 2 * side, first.height() + smallLines * second.height() + 10};
}

void EstimateDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const bool selected = option.state & QStyle::State_Selected;
    painter->save();
    painter->fillRect(option.rect,
                      selected ? Theme::mix(tokens.surface, tokens.accent, 0.12) : tokens.surface);
    painter->setPen(QPen(tokens.line, 1));
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    const Lines lines = linesOf(index);
    const QRect box = option.rect.adjusted(side, 4, -side, -4);
    const bool text =
        Column(index.column()) == Column::Estimator || Column(index.column()) == Column::Verdict;
    const Qt::Alignment align = text ? Qt::AlignLeft : Qt::AlignRight;
    int y = box.top();
    const auto draw = [&](const QString& line, const QFont& font, const QColor& color) {
        const QFontMetrics measures(font);
        painter->setFont(font);
        painter->setPen(color);
        painter->drawText(QRect(box.left(), y, box.width(), measures.height()), int(align | Qt::AlignVCenter),
                          measures.elidedText(line, Qt::ElideRight, box.width()));
        y += measures.height();
    };
    const QFont small = Theme::font(metrics::fontSmall);
    draw(lines.first, Theme::font(metrics::fontBase), tokens.text);
    draw(lines.second, small, tokens.secondText);
    draw(lines.third, small, tokens.secondText);
    painter->restore();
}

} // namespace gripscope
