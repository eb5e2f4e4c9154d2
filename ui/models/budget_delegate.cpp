// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/budget_delegate.h"

#include "ui/models/budget_table_model.h"
#include "ui/theme/theme.h"
#include "ui/widgets/number_format.h"

#include <QPainter>

#include <algorithm>

namespace gripscope {

namespace {

using Column = BudgetTableModel::Column;

constexpr int side = 5, barHeight = 4, leastBar = 44;

bool isEffect(const QModelIndex& index)
{
    return Column(index.column()) == Column::Effect;
}

QString textOf(const QModelIndex& index)
{
    if (isEffect(index))
        return index.data().toString();
    const double value = index.data(BudgetTableModel::SortRole).toDouble();
    return value > 0 ? formatNumber(value, std::nullopt, {}, 2).value : QString(QChar(0x2013));
}

} // namespace

QSize BudgetDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const
{
    const bool sum = index.data(BudgetTableModel::SumRole).toBool();
    const QFontMetrics font(Theme::font(metrics::fontBase, sum));
    const int text = font.horizontalAdvance(textOf(index));
    return {(isEffect(index) ? text : std::max(text, leastBar)) + 2 * side,
            font.height() + (sum ? 6 : 10 + barHeight)};
}

void BudgetDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const bool sum = index.data(BudgetTableModel::SumRole).toBool();
    painter->save();
    if (option.state & QStyle::State_Selected)
        painter->fillRect(option.rect, Theme::mix(tokens.surface, tokens.accent, 0.12));
    painter->setPen(QPen(tokens.line, 1));
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    const QRect box = option.rect.adjusted(side, 3, -side, -3);
    const QFont font = Theme::font(metrics::fontBase, sum);
    const QFontMetrics measures(font);
    painter->setFont(font);
    painter->setPen(tokens.text);
    painter->drawText(QRect(box.left(), box.top(), box.width(), measures.height()),
                      int(Qt::AlignVCenter | (isEffect(index) ? Qt::AlignLeft : Qt::AlignRight)),
                      measures.elidedText(textOf(index), Qt::ElideRight, box.width()));
    if (const QVariant share = index.data(BudgetTableModel::ShareRole); share.isValid()) {
        const QRectF groove(box.right() + 1 - leastBar, box.bottom() - barHeight + 1, leastBar, barHeight);
        painter->setPen(Qt::NoPen);
        painter->setBrush(Theme::mix(tokens.surface, tokens.line, 0.8));
        painter->drawRect(groove);
        painter->setBrush(tokens.accent);
        const double part = std::clamp(share.toDouble(), 0.0, 1.0) * groove.width();
        painter->drawRect(QRectF(groove.left(), groove.top(), part, groove.height()));
    }
    painter->restore();
}

} // namespace gripscope
