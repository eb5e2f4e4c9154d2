// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/people/audit_entry.h"
#include "ui/models/row_table_model.h"

#include <vector>

namespace gripscope {

/// The audit trail, newest first, page by page: the view asks for more as it is scrolled, the owner fetches
/// each page away from the screen's thread and appends it.
class AuditModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Number, Time, Person, Action, Subject, Reason, Details, Station };
    static constexpr int columns = 8;
    static constexpr int pageSize = 200;

    using RowTableModel::RowTableModel;

    /// Starts anew with a list of `total` rows, of which `page` are the first.
    void restart(qint64 total, std::vector<AuditEntry> page);
    /// The page that was asked for at `offset`; ignored when that is no longer where the list ends. An empty
    /// one ends the list.
    void append(int offset, const std::vector<AuditEntry>& page);
    [[nodiscard]] const AuditEntry& entry(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    [[nodiscard]] qint64 total() const { return m_total; }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;

signals:
    void pageAsked(int offset);

private:
    [[nodiscard]] int length() const override { return static_cast<int>(m_rows.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int section, int role) const override;

    [[nodiscard]] static QString text(const AuditEntry& entry, Column column);
    std::vector<AuditEntry> m_rows;
    qint64 m_total = 0;
    bool m_waiting = false;
};

} // namespace gripscope
