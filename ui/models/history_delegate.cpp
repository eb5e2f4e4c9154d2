// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/history_delegate.h"

#include "ui/models/history_model.h"
#include "ui/theme/theme.h"
#include "ui/widgets/number_format.h"
#include "ui/widgets/outcome_view.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;
using Column = HistoryModel::Column;

namespace {

constexpr int signSize = 20;

QIcon outcomeIcon(InspectionOutcome outcome, double ratio)
{
    QPixmap pixmap(QSize(signSize, signSize) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    paintOutcomeSign(painter, QRectF(1, 1, signSize - 2, signSize - 2), outcome,
                     Theme::instance().outcomeColor(outcome));
    painter.end();
    return QIcon(pixmap);
}

/// Without the year while it is this one: the tool tip has it whole.
QString shortTime(const QDateTime& time)
{
    const bool thisYear = time.date().year() == QDate::currentDate().year();
    return QLocale().toString(time, thisYear ? u"MM-dd HH:mm"_s : u"yyyy-MM-dd HH:mm"_s);
}

} // namespace

QString HistoryDelegate::text(const QModelIndex& index)
{
    const QVariant value = index.data(HistoryModel::SortRole);
    switch (Column(index.column())) {
    case Column::Number:
        return QString::number(value.toLongLong());
    case Column::Time:
        return shortTime(value.toDateTime().toLocalTime());
    case Column::Outcome:
        return outcomeWord(InspectionOutcome(value.toInt()));
    case Column::Posterior:
        // In double precision a certain posterior rounds to 1; it never is.
        return value.isValid() ? formatProbability(std::min(value.toDouble(), 1 - 1e-15))
                               : QString(QChar(0x2013));
    case Column::Mass:
    case Column::Damping:
    case Column::Stiffness:
        return value.isValid() ? formatNumber(value.toDouble(), std::nullopt,
                                              index.data(HistoryModel::UnitRole).toString())
                                     .valueWithUnit()
                               : QString();
    case Column::Seconds:
        return QLocale().toString(value.toDouble(), 'f', 2) + QChar::Nbsp + u's';
    case Column::Expected:
    case Column::Type:
    case Column::Operator:
        break;
    }
    return value.toString().isEmpty() ? QString(QChar(0x2013)) : value.toString();
}

void HistoryDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    option->features |= QStyleOptionViewItem::HasDisplay;
    option->text = text(index);
    if (Column(index.column()) != Column::Outcome)
        return;
    const auto outcome = InspectionOutcome(index.data(HistoryModel::SortRole).toInt());
    option->features |= QStyleOptionViewItem::HasDecoration;
    option->icon = outcomeIcon(outcome, option->widget ? option->widget->devicePixelRatioF() : 1);
    option->decorationSize = {signSize, signSize};
}

} // namespace gripscope
