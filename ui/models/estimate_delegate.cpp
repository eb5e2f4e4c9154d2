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
}

EstimateDelegate::Lines EstimateDelegate::linesOf(const QModelIndex& index)
{
    const auto column = Column(index.column());
    if (column == Column::Estimator)
        return {index.data().toString(), index.siblingAtColumn(int(Column::Verdict)).data().toString()};
    if (column == Column::Verdict)
        return {index.data().toString(), {}};
    const QVariant value = index.data(EstimateTableModel::SortRole);
    if (!value.isValid())
        return {QString(QChar(0x2013)), {}};
    if (column == Column::SimulationFit || column == Column::PredictionFit)
        return {formatNumber(value.toDouble(), std::nullopt, {}, 3).value, {}};
    const QVariant half = index.data(EstimateTableModel::HalfWidthRole);
    const FormattedNumber number =
        formatNumber(value.toDouble(), half.isValid() ? std::optional(half.toDouble()) : std::nullopt, {});
    return {number.value, number.error.isEmpty() ? QString() : QStringLiteral("± ") + number.error};
}

QSize EstimateDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const
{
    const Lines lines = linesOf(index);
    const QFontMetrics first(Theme::font(metrics::fontBase)), second(Theme::font(metrics::fontSmall));
    const bool name = Column(index.column()) == Column::Estimator;
    const int width =
        name ? first.horizontalAdvance(lines.first)
             : std::max(first.horizontalAdvance(lines.first), second.horizontalAdvance(lines.second));
    return {width + 2 * side, first.height() + second.height() + 10};
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
    const auto draw = [&](const QString& line, const QFont& font, const QColor& color,
                          Qt::Alignment vertical) {
        painter->setFont(font);
        painter->setPen(color);
        const QString shown = QFontMetrics(font).elidedText(line, Qt::ElideRight, box.width());
        painter->drawText(box, int(align | vertical), shown);
    };
    draw(lines.first, Theme::font(metrics::fontBase), tokens.text, Qt::AlignTop);
    draw(lines.second, Theme::font(metrics::fontSmall), tokens.secondText, Qt::AlignBottom);
    painter->restore();
}

} // namespace gripscope
