// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/history_model.h"

#include "core/base/words.h"
#include "ui/format/date_text.h"
#include "ui/format/history_words.h"

#include <QFont>

#include <algorithm>

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

/// What an int and the pixels of a view can count.
constexpr qint64 mostRows = 40'000'000;

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

void HistoryModel::restart(std::shared_ptr<const HistoryList> list, std::vector<HistoryEntry> first)
{
    beginResetModel();
    m_list = std::move(list);
    m_pages.clear();
    m_asked.clear();
    if (!first.empty())
        m_pages.insert(0, {std::move(first), ++m_uses});
    endResetModel();
}

void HistoryModel::goOn(std::shared_ptr<const HistoryList> list)
{
    const int before = length();
    const int after = int(std::min<qint64>(list->rows, mostRows));
    if (after > before)
        beginInsertRows({}, before, after - 1);
    else if (after < before)
        beginRemoveRows({}, after, before - 1);
    m_list = std::move(list);
    if (after > before)
        endInsertRows();
    else if (after < before)
        endRemoveRows();
    // A page that was the last may be longer now.
    if (const auto last = m_pages.constFind(before / pageSize);
        last != m_pages.constEnd() && after > before && last->entries.size() < pageSize)
        m_pages.remove(before / pageSize);
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
    if (!m_list->walked) {
        const std::optional<std::size_t> place = m_list->keys.find(key);
        return place ? int(*place) : -1;
    }
    for (auto page = m_pages.cbegin(); page != m_pages.cend(); ++page)
        for (std::size_t i = 0; i < page->entries.size(); ++i)
            if (page->entries[i].graspId == key)
                return page.key() * pageSize + int(i);
    return -1;
}

QString HistoryModel::key(int row) const
{
    if (!m_list->walked)
        return m_list->keys.at(std::size_t(row));
    const HistoryEntry* held = entry(row);
    return held ? held->graspId : QString();
}

int HistoryModel::length() const
{
    return int(std::min<qint64>(m_list->rows, mostRows));
}

QVariant HistoryModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const auto column = HistoryColumn(index.column());
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (isNumber(column) ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole && role != Qt::EditRole && role != SortRole && role != UnitRole &&
        role != SuspectRole && role != AskedRole && role != Qt::ToolTipRole && role != Qt::FontRole)
        return {};
    const HistoryEntry* row = wanted(index.row());
    if (!row)
        return {};
    if (role == Qt::FontRole) {
        if (row->voided.isEmpty())
            return {};
        QFont struck;
        struck.setStrikeOut(true);
        return struck;
    }
    if (role == UnitRole)
        return parameterUnit(*row, column);
    if (role == SuspectRole)
        return row->suspect();
    if (role == AskedRole)
        return !row->expectedType.isEmpty();
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
