// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/history_model.h"

#include "core/base/words.h"
#include "ui/format/date_text.h"
#include "ui/format/history_words.h"

#include <algorithm>
#include <limits>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString parameterUnit(const HistoryEntry& entry, HistoryColumn column)
{
    const ParameterUnits units = comparableUnits(entry.forceUnit, entry.positionUnit);
    const QString unit = column == HistoryColumn::Mass      ? units.m
                         : column == HistoryColumn::Damping ? units.b
                                                            : units.k;
    return unit == u"1" ? QString() : unit;
}

bool isNumber(HistoryColumn column)
{
    switch (factsOf(column).format) {
    case ColumnFormat::Count:
    case ColumnFormat::Probability:
    case ColumnFormat::Quantity:
    case ColumnFormat::Percent:
    case ColumnFormat::Seconds:
        return true;
    default:
        return false;
    }
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
    emit dataChanged(index(first, 0), index(std::min(rowCount(), first + pageSize) - 1, width() - 1));
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

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const auto column = HistoryColumn(index.column());
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
        return column == HistoryColumn::Time ? exactTimeText(row->time) : row->reason.describe();
    return factsOf(column).value(*row);
}

QVariant HistoryModel::head(int section, int role) const
{
    const auto column = HistoryColumn(section);
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isNumber(column) ? Qt::AlignRight : Qt::AlignLeft));
    if (role == Qt::ToolTipRole)
        return columnName(column);
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case HistoryColumn::Number:
        return tr("No.");
    case HistoryColumn::Mass:
        return u"m\n"_s + shownIn(column).unit;
    case HistoryColumn::Damping:
        return u"b\n"_s + shownIn(column).unit;
    case HistoryColumn::Stiffness:
        return u"k\n"_s + shownIn(column).unit;
    default:
        return columnName(column);
    }
}

ShownUnit HistoryModel::shownIn(HistoryColumn column)
{
    switch (column) {
    case HistoryColumn::Mass:
        return fieldUnit(MechanicalQuantity::Mass);
    case HistoryColumn::Damping:
        return fieldUnit(MechanicalQuantity::Damping);
    case HistoryColumn::Stiffness:
        return fieldUnit(MechanicalQuantity::Stiffness);
    default:
        return {};
    }
}

QString HistoryModel::columnName(HistoryColumn column)
{
    return Words::say(factsOf(column).title).describe();
}

void HistoryModel::sort(int column, Qt::SortOrder order)
{
    if (column >= 0 && column < width())
        emit sortAsked(HistoryColumn(column), order);
}

} // namespace gripscope
