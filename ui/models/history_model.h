// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/history.h"
#include "ui/models/row_table_model.h"

#include <QHash>
#include <QSet>

#include <vector>

namespace gripscope {

/// Squeezes of the library in the order of a query, any of which can be come to at once: the model knows all
/// keys, asks for the page of two hundred that is looked at, and keeps those looked at last. A row that is
/// not there yet is empty. Numbers are raw; HistoryDelegate words them.
class HistoryModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column {
        Number,
        Time,
        Kind,
        Outcome,
        Expected,
        Type,
        Posterior,
        Mass,
        Damping,
        Stiffness,
        Fit,
        Seconds,
        Operator,
        Device,
        Batch,
        Estimator,
        Program
    };
    static constexpr int columns = 17;
    static constexpr int pageSize = 200;
    static constexpr int pagesKept = 16;
    enum Role {
        SortRole = Qt::UserRole, ///< the raw value
        UnitRole,                ///< of m, b and k: SI where the squeeze's units are known; empty: none
    };

    using RowTableModel::RowTableModel;

    /// Starts anew with these squeezes, of which `first` are the first.
    void restart(HistoryKeys keys, std::vector<HistoryEntry> first);
    /// The answer to pageAsked(); one that is not as long as it should be is taken for what is there.
    void setPage(int page, std::vector<HistoryEntry> entries);
    /// It will not be answered: the page is asked for again when it is looked at.
    void forgetRequest(int page);
    /// The keys of a page that was asked for.
    [[nodiscard]] std::vector<QString> pageKeys(int page) const;

    /// Nothing until its page is there.
    [[nodiscard]] const HistoryEntry* entry(int row) const;
    [[nodiscard]] QString key(int row) const { return m_keys.at(std::size_t(row)); }
    [[nodiscard]] int rowOf(const QString& key) const; ///< -1: not among them
    [[nodiscard]] int pagesHeld() const { return int(m_pages.size()); }
    [[nodiscard]] static HistoryOrder order(Column column);
    [[nodiscard]] static QString columnName(Column column); ///< in full, for a list of columns

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    /// The library orders: emits sortAsked() only.
    void sort(int column, Qt::SortOrder order) override;

signals:
    void pageAsked(int page);
    void sortAsked(gripscope::HistoryModel::Column column, Qt::SortOrder order);

private:
    [[nodiscard]] int length() const override;
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int section, int role) const override;

    struct Page {
        std::vector<HistoryEntry> entries;
        mutable quint64 used = 0;
    };
    [[nodiscard]] static QVariant value(const HistoryEntry& entry, Column column);
    [[nodiscard]] const HistoryEntry* wanted(int row) const;
    void ask(int page);
    void keepFew();

    HistoryKeys m_keys;
    QHash<int, Page> m_pages;
    QSet<int> m_asked;
    mutable quint64 m_uses = 0;
};

} // namespace gripscope
