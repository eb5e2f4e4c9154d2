// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/history_model.h"

#include "core/signal/units.h"

#include <QLocale>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QVariant optionalNumber(const std::optional<double>& number)
{
    return number ? QVariant(*number) : QVariant();
}

QVariant parameter(const InspectionRecord& record, double MassDampingStiffness::*member)
{
    if (!record.parameters)
        return {};
    return (*record.parameters).*member * siFactor(record.forceUnit, record.positionUnit).value_or(1);
}

QString parameterUnit(const InspectionRecord& record, HistoryModel::Column column)
{
    const bool si = siFactor(record.forceUnit, record.positionUnit).has_value();
    const ParameterUnits units =
        si ? parameterUnits(u"N"_s, u"m"_s) : parameterUnits(record.forceUnit, record.positionUnit);
    const QString unit = column == HistoryModel::Column::Mass      ? units.m
                         : column == HistoryModel::Column::Damping ? units.b
                                                                   : units.k;
    return unit == u"1" ? QString() : unit;
}

bool isText(HistoryModel::Column column)
{
    using Column = HistoryModel::Column;
    return column == Column::Time || column == Column::Expected || column == Column::Outcome ||
           column == Column::Type || column == Column::Operator;
}

} // namespace

InspectionOutcome outcomeOf(const InspectionRecord& record)
{
    return inspectionOutcome(record.verdict, record.type, record.expectedType);
}

void HistoryModel::restart(qint64 total, std::vector<InspectionRecord> page)
{
    beginResetModel();
    m_rows = std::move(page);
    m_total = total;
    m_waiting = false;
    endResetModel();
}

void HistoryModel::append(int offset, const std::vector<InspectionRecord>& page)
{
    if (offset != int(m_rows.size()))
        return;
    m_waiting = false;
    if (page.empty()) {
        m_total = qint64(m_rows.size());
        return;
    }
    const int first = int(m_rows.size());
    beginInsertRows({}, first, first + int(page.size()) - 1);
    m_rows.insert(m_rows.end(), page.begin(), page.end());
    endInsertRows();
}

int HistoryModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_rows.size());
}
int HistoryModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : columns;
}

bool HistoryModel::canFetchMore(const QModelIndex& parent) const
{
    return !parent.isValid() && !m_waiting && qint64(m_rows.size()) < m_total;
}

void HistoryModel::fetchMore(const QModelIndex& parent)
{
    if (!canFetchMore(parent))
        return;
    m_waiting = true;
    emit pageAsked(int(m_rows.size()));
}

QVariant HistoryModel::value(const InspectionRecord& record, Column column)
{
    switch (column) {
    case Column::Number:
        return record.number;
    case Column::Time:
        return record.inspected;
    case Column::Expected:
        return record.expectedType;
    case Column::Outcome:
        return int(outcomeOf(record));
    case Column::Type:
        return record.type;
    case Column::Posterior:
        // Among the enrolled types only: for a part that is none of them it would mislead.
        return record.verdict == VerdictKind::Type || record.verdict == VerdictKind::Inconclusive
                   ? optionalNumber(record.posterior)
                   : QVariant();
    case Column::Mass:
        return parameter(record, &MassDampingStiffness::m);
    case Column::Damping:
        return parameter(record, &MassDampingStiffness::b);
    case Column::Stiffness:
        return parameter(record, &MassDampingStiffness::k);
    case Column::Seconds:
        return record.seconds;
    case Column::Operator:
        return record.operatorName;
    }
    return {};
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const InspectionRecord& row = record(index.row());
    const auto column = Column(index.column());
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
    case SortRole:
        return value(row, column);
    case UnitRole:
        return parameterUnit(row, column);
    case Qt::ToolTipRole:
        return column == Column::Time ? QLocale().toString(row.inspected.toLocalTime(), QLocale::LongFormat)
                                      : row.reason;
    case Qt::TextAlignmentRole:
        return int(Qt::AlignVCenter | (isText(column) ? Qt::AlignLeft : Qt::AlignRight));
    default:
        return {};
    }
}

QVariant HistoryModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columns)
        return {};
    const auto column = Column(section);
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isText(column) ? Qt::AlignLeft : Qt::AlignRight));
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case Column::Number:
        return tr("No.");
    case Column::Time:
        return tr("Time");
    case Column::Expected:
        return tr("Expected");
    case Column::Outcome:
        return tr("Outcome");
    case Column::Type:
        return tr("Type");
    case Column::Posterior:
        return tr("Posterior");
    case Column::Mass:
        return tr("m");
    case Column::Damping:
        return tr("b");
    case Column::Stiffness:
        return tr("k");
    case Column::Seconds:
        return tr("Squeeze");
    case Column::Operator:
        return tr("Operator");
    }
    return {};
}

} // namespace gripscope
