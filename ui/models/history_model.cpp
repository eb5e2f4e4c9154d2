// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/history_model.h"

#include "core/signal/units.h"
#include "ui/models/history_words.h"
#include "ui/widgets/date_text.h"

#include <algorithm>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;
using Column = HistoryModel::Column;

namespace {

QVariant optionalNumber(const std::optional<double>& number)
{
    return number ? QVariant(*number) : QVariant();
}

QVariant parameter(const HistoryEntry& entry, double MassDampingStiffness::*member)
{
    if (!entry.parameters)
        return {};
    return (*entry.parameters).*member * siFactor(entry.forceUnit, entry.positionUnit).value_or(1);
}

QString parameterUnit(const HistoryEntry& entry, Column column)
{
    const ParameterUnits units = HistoryWords::shownUnits(entry);
    const QString unit = column == Column::Mass ? units.m : column == Column::Damping ? units.b : units.k;
    return unit == u"1" ? QString() : unit;
}

bool isNumber(Column column)
{
    return column == Column::Number || column == Column::Posterior || column == Column::Mass ||
           column == Column::Damping || column == Column::Stiffness || column == Column::Fit ||
           column == Column::Seconds;
}

} // namespace

void HistoryModel::restart(HistoryKeys keys, std::vector<HistoryEntry> first)
{
    beginResetModel();
    m_keys = std::move(keys);
    m_pages.clear();
    m_asked.clear();
    if (!first.empty())
        m_pages.insert(0, {std::move(first), ++m_uses});
    endResetModel();
}

void HistoryModel::setPage(int page, std::vector<HistoryEntry> entries)
{
    m_asked.remove(page);
    const int first = page * pageSize;
    if (first < 0 || first >= rowCount())
        return;
    m_pages.insert(page, {std::move(entries), ++m_uses});
    keepFew();
    emit dataChanged(index(first, 0), index(std::min(rowCount(), first + pageSize) - 1, columns - 1));
}

void HistoryModel::forgetRequest(int page)
{
    m_asked.remove(page);
}

void HistoryModel::keepFew()
{
    while (m_pages.size() > pagesKept) {
        auto oldest = m_pages.begin();
        for (auto page = m_pages.begin(); page != m_pages.end(); ++page)
            if (page->used < oldest->used)
                oldest = page;
        m_pages.erase(oldest);
    }
}

std::vector<QString> HistoryModel::pageKeys(int page) const
{
    return m_keys.part(std::size_t(std::max(0, page)) * pageSize, pageSize);
}

const HistoryEntry* HistoryModel::entry(int row) const
{
    const auto page = m_pages.constFind(row / pageSize);
    if (row < 0 || page == m_pages.constEnd())
        return nullptr;
    page->used = ++m_uses;
    const auto place = std::size_t(row % pageSize);
    return place < page->entries.size() ? &page->entries[place] : nullptr;
}

const HistoryEntry* HistoryModel::wanted(int row) const
{
    const HistoryEntry* found = entry(row);
    const int page = row / pageSize;
    if (!found && !m_pages.contains(page) && !m_asked.contains(page))
        const_cast<HistoryModel*>(this)->ask(page); // a view only ever looks
    return found;
}

void HistoryModel::ask(int page)
{
    m_asked.insert(page);
    emit pageAsked(page);
}

int HistoryModel::rowOf(const QString& key) const
{
    const std::optional<std::size_t> place = m_keys.find(key);
    return place ? int(*place) : -1;
}

int HistoryModel::length() const
{
    constexpr auto most = std::size_t(std::numeric_limits<int>::max());
    return int(std::min(m_keys.size(), most));
}

QVariant HistoryModel::value(const HistoryEntry& entry, Column column)
{
    switch (column) {
    case Column::Number:
        return entry.number > 0 ? QVariant(entry.number) : QVariant();
    case Column::Time:
        return entry.time;
    case Column::Kind:
        return int(entry.kind);
    case Column::Outcome: {
        const std::optional<InspectionOutcome> outcome = entry.outcome();
        return outcome ? QVariant(int(*outcome)) : QVariant();
    }
    case Column::Expected:
        return entry.expectedType;
    case Column::Type:
        return entry.type;
    case Column::Posterior:
        return optionalNumber(entry.tellingPosterior());
    case Column::Mass:
        return parameter(entry, &MassDampingStiffness::m);
    case Column::Damping:
        return parameter(entry, &MassDampingStiffness::b);
    case Column::Stiffness:
        return parameter(entry, &MassDampingStiffness::k);
    case Column::Fit:
        return optionalNumber(entry.simulationFitPercent);
    case Column::Seconds:
        return optionalNumber(entry.seconds);
    case Column::Operator:
        return entry.operatorName;
    case Column::Device:
        return HistoryWords::device(entry);
    case Column::Batch:
        return entry.batch;
    case Column::Estimator:
        return entry.estimator;
    case Column::Program:
        return entry.program;
    }
    return {};
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const auto column = Column(index.column());
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isNumber(column) ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole && role != Qt::EditRole && role != SortRole && role != UnitRole &&
        role != Qt::ToolTipRole)
        return {};
    const HistoryEntry* row = wanted(index.row());
    if (!row)
        return {};
    if (role == UnitRole)
        return parameterUnit(*row, column);
    if (role == Qt::ToolTipRole)
        return column == Column::Time ? exactTimeText(row->time) : row->reason;
    return value(*row, column);
}

QVariant HistoryModel::head(int section, int role) const
{
    const auto column = Column(section);
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isNumber(column) ? Qt::AlignRight : Qt::AlignLeft));
    if (role == Qt::ToolTipRole)
        return columnName(column);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case Column::Number:
        return tr("No.");
    case Column::Mass:
        return u"m\ng"_s;
    case Column::Damping:
        return u"b\nN s/m"_s;
    case Column::Stiffness:
        return u"k\nkN/m"_s;
    default:
        return columnName(column);
    }
}

QString HistoryModel::columnName(Column column)
{
    switch (column) {
    case Column::Number:
        return tr("Number");
    case Column::Time:
        return tr("Time");
    case Column::Kind:
        return tr("Kind");
    case Column::Outcome:
        return tr("Outcome");
    case Column::Expected:
        return tr("Expected");
    case Column::Type:
        return tr("Type");
    case Column::Posterior:
        return tr("Posterior");
    case Column::Mass:
        return tr("Mass m");
    case Column::Damping:
        return tr("Damping b");
    case Column::Stiffness:
        return tr("Stiffness k");
    case Column::Fit:
        return tr("Simulation fit");
    case Column::Seconds:
        return tr("Length");
    case Column::Operator:
        return tr("Operator");
    case Column::Device:
        return tr("Gripper");
    case Column::Batch:
        return tr("Batch");
    case Column::Estimator:
        return tr("Estimator");
    case Column::Program:
        return tr("Software");
    }
    return {};
}

HistoryOrder HistoryModel::order(Column column)
{
    switch (column) {
    case Column::Number:
        return HistoryOrder::Number;
    case Column::Time:
        return HistoryOrder::Time;
    case Column::Kind:
        return HistoryOrder::Kind;
    case Column::Outcome:
        return HistoryOrder::Outcome;
    case Column::Expected:
        return HistoryOrder::Expected;
    case Column::Type:
        return HistoryOrder::Type;
    case Column::Posterior:
        return HistoryOrder::Posterior;
    case Column::Mass:
        return HistoryOrder::Mass;
    case Column::Damping:
        return HistoryOrder::Damping;
    case Column::Stiffness:
        return HistoryOrder::Stiffness;
    case Column::Fit:
        return HistoryOrder::Fit;
    case Column::Seconds:
        return HistoryOrder::Seconds;
    case Column::Operator:
        return HistoryOrder::Operator;
    case Column::Device:
        return HistoryOrder::Device;
    case Column::Batch:
        return HistoryOrder::Batch;
    case Column::Estimator:
        return HistoryOrder::Estimator;
    case Column::Program:
        return HistoryOrder::Program;
    }
    return HistoryOrder::Time;
}

void HistoryModel::sort(int column, Qt::SortOrder order)
{
    if (column >= 0 && column < columns)
        emit sortAsked(Column(column), order);
}

} // namespace gripscope
