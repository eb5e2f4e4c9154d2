// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/recording/units.h"
#include "ui/format/date_text.h"
#include "ui/format/history_words.h"
#include "ui/format/number_format.h"
#include "ui/format/outcome_words.h"
#include "ui/models/history_model.h"
#include "ui/theme/theme.h"
#include "ui/widgets/outcome_view.h"

#include <QPainter>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int historySignSize = 20;

QIcon outcomeIcon(InspectionOutcome outcome, bool suspect, double ratio)
{
    QPixmap pixmap(QSize(historySignSize, historySignSize) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paintJudgedSign(painter, QRectF(1, 1, historySignSize - 2, historySignSize - 2), outcome, suspect);
    painter.end();
    return QIcon(pixmap);
}

/// In the unit of the column's head; a recording in units of its own says them.
QString parameterWords(HistoryColumn column, double value, const QString& unit)
{
    const ParameterUnits si = siParameterUnits();
    if (unit != si.m && unit != si.b && unit != si.k)
        return formatNumber(value, std::nullopt, unit).valueWithUnit();
    return formatNumber(value * HistoryModel::shownIn(column).factor, std::nullopt, {}).value;
}

QString wordsOf(HistoryColumn column, const QVariant& value, const QString& unit, bool suspect, bool expected)
{
    switch (factsOf(column).format) {
    case ColumnFormat::Count:
        return value.toString();
    case ColumnFormat::Time:
        return timeText(value.toDateTime());
    case ColumnFormat::Kind:
        return HistoryWords::kind(SqueezeKind(value.toInt()));
    case ColumnFormat::Outcome:
        return outcomeWord(InspectionOutcome(value.toInt()), suspect, expected);
    case ColumnFormat::Validity:
        return value.toInt() < 0 ? HistoryWords::notRecorded()
                                 : HistoryWords::validity(ValidityVerdict(value.toInt()));
    case ColumnFormat::Probability:
        // In double precision a certain posterior rounds to 1; it never is.
        return formatProbability(std::min(value.toDouble(), 1 - 1e-15));
    case ColumnFormat::Quantity:
        return parameterWords(column, value.toDouble(), unit);
    case ColumnFormat::Percent:
        return formatPercent(value.toDouble());
    case ColumnFormat::Seconds:
        return formatLength(value.toDouble());
    case ColumnFormat::Estimator:
        return HistoryWords::estimator(value.toString());
    case ColumnFormat::Conformity:
        return inWords(ConformityDecision(value.toInt())).describe();
    case ColumnFormat::Text:
        break;
    }
    return value.toString();
}

} // namespace

QString HistoryDelegate::text(const QModelIndex& index)
{
    const QVariant value = index.data(HistoryModel::SortRole);
    const QString words = value.isValid() ? wordsOf(HistoryColumn(index.column()), value,
                                                    index.data(HistoryModel::UnitRole).toString(),
                                                    index.data(HistoryModel::SuspectRole).toBool(),
                                                    index.data(HistoryModel::AskedRole).toBool())
                                          : QString();
    if (!words.isEmpty())
        return words;
    const auto* model = qobject_cast<const HistoryModel*>(index.model());
    const bool there = model && model->entry(index.row());
    return there ? QString(QChar(0x2013)) : QString(QChar(0x2026)); // or still on its way
}

void HistoryDelegate::initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const
{
    QStyledItemDelegate::initStyleOption(option, index);
    option->features |= QStyleOptionViewItem::HasDisplay;
    option->text = text(index);
    const QVariant value = index.data(HistoryModel::SortRole);
    if (HistoryColumn(index.column()) != HistoryColumn::Outcome || !value.isValid())
        return;
    option->features |= QStyleOptionViewItem::HasDecoration;
    option->icon =
        outcomeIcon(InspectionOutcome(value.toInt()), index.data(HistoryModel::SuspectRole).toBool(),
                    option->widget ? option->widget->devicePixelRatioF() : 1);
    option->decorationSize = {historySignSize, historySignSize};
}

} // namespace gripscope
