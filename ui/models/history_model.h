// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/inspect_session.h"
#include "core/store/library.h"

#include <QAbstractTableModel>

#include <vector>

namespace gripscope {

/// Inspections, newest first, page by page: the view asks for more as it is scrolled, the owner fetches each
/// page away from the screen's thread and appends it. Numbers are raw; HistoryDelegate words them.
class HistoryModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Column {
        Number,
        Time,
        Expected,
        Outcome,
        Type,
        Posterior,
        Mass,
        Damping,
        Stiffness,
        Seconds,
        Operator
    };
    static constexpr int columns = 11;
    static constexpr int pageSize = 200;
    enum Role {
        SortRole = Qt::UserRole, ///< the raw value
        UnitRole,                ///< of m, b and k: SI where the squeeze's units are known; empty: none
    };

    using QAbstractTableModel::QAbstractTableModel;

    /// Starts anew with a list of `total` rows, of which `page` are the first.
    void restart(qint64 total, std::vector<InspectionRecord> page);
    /// The page that was asked for at `offset`; ignored when that is no longer where the list ends. An empty
    /// one ends the list.
    void append(int offset, const std::vector<InspectionRecord>& page);
    [[nodiscard]] const InspectionRecord& record(int row) const { return m_rows[std::size_t(row)]; }
    [[nodiscard]] qint64 total() const { return m_total; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] bool canFetchMore(const QModelIndex& parent) const override;
    void fetchMore(const QModelIndex& parent) override;

signals:
    void pageAsked(int offset);

private:
    [[nodiscard]] static QVariant value(const InspectionRecord& record, Column column);

    std::vector<InspectionRecord> m_rows;
    qint64 m_total = 0;
    bool m_waiting = false;
};

/// The outcome that an inspection had for the one who stood there.
[[nodiscard]] InspectionOutcome outcomeOf(const InspectionRecord& record);

} // namespace gripscope
