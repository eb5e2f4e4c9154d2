// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/audit_model.h"

#include "core/people/permission.h"
#include "ui/widgets/date_text.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// What a consent was to is kept by its id.
QString subjectInWords(const AuditEntry& entry)
{
    if (entry.action == QString::fromUtf16(audit_action::authorised))
        for (int i = 0; i <= static_cast<int>(Permission::ChangeSettings); ++i)
            if (toString(static_cast<Permission>(i)) == entry.subject)
                return inWords(static_cast<Permission>(i));
    return entry.subject;
}

} // namespace

void AuditModel::restart(qint64 total, std::vector<AuditEntry> page)
{
    beginResetModel();
    m_rows = std::move(page);
    m_total = total;
    m_waiting = false;
    endResetModel();
}

void AuditModel::append(int offset, const std::vector<AuditEntry>& page)
{
    const int first = rowCount();
    if (offset != first)
        return;
    m_waiting = false;
    if (page.empty()) {
        m_total = first;
        return;
    }
    beginInsertRows({}, first, first + static_cast<int>(page.size()) - 1);
    m_rows.insert(m_rows.end(), page.begin(), page.end());
    endInsertRows();
}

bool AuditModel::canFetchMore(const QModelIndex& parent) const
{
    return !parent.isValid() && !m_waiting && rowCount() < m_total;
}

void AuditModel::fetchMore(const QModelIndex& parent)
{
    if (!canFetchMore(parent))
        return;
    m_waiting = true;
    emit pageAsked(rowCount());
}

QString AuditModel::text(const AuditEntry& entry, Column column)
{
    switch (column) {
    case Column::Number:
        return QString::number(entry.number);
    case Column::Time:
        return exactTimeText(QDateTime::fromString(entry.utc, Qt::ISODateWithMs));
    case Column::Person: {
        const std::optional<Role> role = roleFromString(entry.role);
        return role ? tr("%1 (%2)").arg(entry.person, inWords(*role)) : entry.person;
    }
    case Column::Action:
        return actionInWords(entry.action);
    case Column::Subject:
        return subjectInWords(entry);
    case Column::Reason:
        return entry.reason;
    case Column::Details:
        return detailsInWords(entry);
    case Column::Station:
        return entry.station;
    }
    return {};
}

QVariant AuditModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const AuditEntry& row = entry(index.row());
    const auto column = static_cast<Column>(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::EditRole:
        return column == Column::Number ? QVariant(row.number) : QVariant(text(row, column));
    case Qt::ToolTipRole:
        return column == Column::Time ? row.utc : text(row, column);
    case Qt::TextAlignmentRole:
        return static_cast<int>(Qt::AlignVCenter |
                                (column == Column::Number ? Qt::AlignRight : Qt::AlignLeft));
    default:
        return {};
    }
}

QVariant AuditModel::head(int section, int role) const
{
    const auto column = static_cast<Column>(section);
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>(Qt::AlignVCenter |
                                (column == Column::Number ? Qt::AlignRight : Qt::AlignLeft));
    if (role != Qt::DisplayRole)
        return {};
    switch (column) {
    case Column::Number:
        return tr("No.");
    case Column::Time:
        return tr("Time");
    case Column::Person:
        return tr("Who");
    case Column::Action:
        return tr("What");
    case Column::Subject:
        return tr("To what");
    case Column::Reason:
        return tr("Why");
    case Column::Details:
        return tr("Details");
    case Column::Station:
        return tr("Station");
    }
    return {};
}

} // namespace gripscope
