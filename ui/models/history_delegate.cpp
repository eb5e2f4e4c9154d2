// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/history_delegate.h"

#include "core/signal/units.h"
#include "ui/models/history_model.h"
#include "ui/models/history_words.h"
#include "ui/theme/theme.h"
#include "ui/widgets/date_text.h"
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

/// In the unit of the column's head; a recording in units of its own says them.
QString parameterWords(Column column, double value, const QString& unit)
{
    const ParameterUnits si = parameterUnits(u"N"_s, u"m"_s);
    if (unit != si.m && unit != si.b && unit != si.k)
        return formatNumber(value, std::nullopt, unit).valueWithUnit();
    const double factor = column == Column::Mass ? 1e3 : column == Column::Stiffness ? 1e-3 : 1;
    return formatNumber(value * factor, std::nullopt, {}).value;
}

QString wordsOf(Column column, const QVariant& value, const QString& unit)
{
    switch (column) {
    case Column::Number:
        return QString::number(value.toLongLong());
    case Column::Time:
        return shortTimeText(value.toDateTime());
    case Column::Kind:
        return HistoryWords::kind(SqueezeKind(value.toInt()));
    case Column::Outcome:
        return outcomeWord(InspectionOutcome(value.toInt()));
    case Column::Posterior:
        // In double precision a certain posterior rounds to 1; it never is.
        return formatProbability(std::min(value.toDouble(), 1 - 1e-15));
    case Column::Mass:
    case Column::Damping:
    case Column::Stiffness:
        return parameterWords(column, value.toDouble(), unit);
    case Column::Fit:
        return formatPercent(value.toDouble());
    case Column::Seconds:
        return QLocale().toString(value.toDouble(), 'f', 2) + QChar::Nbsp + u's';
    case Column::Estimator:
        return HistoryWords::estimator(value.toString());
    case Column::Expected:
    case Column::Type:
    case Column::Operator:
    case Column::Device:
    case Column::Batch:
    case Column::Program:
        break;
    }
    return value.toString();
}

} // namespace

QString HistoryDelegate::text(const QModelIndex& index)
{
    const QVariant value = index.data(HistoryModel::SortRole);
    const QString words = value.isValid() ? wordsOf(Column(index.column()), value,
                                                    index.data(HistoryModel::UnitRole).toString())
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
    if (Column(index.column()) != Column::Outcome || !value.isValid())
        return;
    option->features |= QStyleOptionViewItem::HasDecoration;
    option->icon = outcomeIcon(InspectionOutcome(value.toInt()),
                               option->widget ? option->widget->devicePixelRatioF() : 1);
    option->decorationSize = {signSize, signSize};
}

} // namespace gripscope
