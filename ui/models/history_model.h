// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/history/history_fields.h"
#include "core/library/records/history_list.h"
#include "ui/format/shown_unit.h"
#include "ui/models/row_table_model.h"

#include <QHash>
#include <QSet>
#include <QStyledItemDelegate>

#include <memory>
#include <vector>

namespace gripscope {

/// Squeezes of the library in the order of a query, any of which can be come to at once: the model knows how
/// many there are, asks for the page of two hundred that is looked at, and keeps those looked at last. A row
/// that is not there yet is empty. Numbers are raw; HistoryDelegate words them.
class HistoryModel : public RowTableModel {
    Q_OBJECT
public:
    using Column = HistoryColumn;
    static constexpr int pageSize = 200;
    static constexpr int pagesKept = 16;
    enum Role {
        SortRole = Qt::UserRole, ///< the raw value
        UnitRole,                ///< of m, b and k: SI where the squeeze's units are known; empty: none
        SuspectRole,             ///< a verdict, but none to rely on
        AskedRole,               ///< a type was expected
    };

    using RowTableModel::RowTableModel;

    /// Starts anew with these squeezes, of which `first` are the first.
    void restart(std::shared_ptr<const HistoryList> list, std::vector<HistoryEntry> first);
    /// The same list, of which more is known: it may be longer.
    void goOn(std::shared_ptr<const HistoryList> list);
    /// The answer to pageAsked(); one that is not as long as it should be is taken for what is there.
    void setPage(int page, std::vector<HistoryEntry> entries);
    /// It will not be answered: the page is asked for again when it is looked at.
    void forgetRequest(int page);

    /// Nothing until its page is there.
    [[nodiscard]] const HistoryEntry* entry(int row) const;
    /// Of a list that is walked: only what its pages hold is known.
    [[nodiscard]] QString key(int row) const;          ///< empty: not known
    [[nodiscard]] int rowOf(const QString& key) const; ///< -1: not among them, or not known
    [[nodiscard]] int pagesHeld() const { return int(m_pages.size()); }
    /// The unit at the head of m, b or k, for numbers in SI.
    [[nodiscard]] static ShownUnit shownIn(Column column);
    [[nodiscard]] static QString columnName(Column column); ///< in full, for a list of columns

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    /// The library orders: emits sortAsked() only.
    void sort(int column, Qt::SortOrder order) override;

signals:
    void pageAsked(int page);
    void sortAsked(gripscope::HistoryColumn column, Qt::SortOrder order);

private:
    [[nodiscard]] int length() const override;
    [[nodiscard]] int width() const override { return int(historyColumns().size()); }
    [[nodiscard]] QVariant head(int section, int role) const override;

    struct Page {
        std::vector<HistoryEntry> entries;
        mutable quint64 used = 0;
    };
    [[nodiscard]] const HistoryEntry* wanted(int row) const;
    void ask(int page);
    void keepFew();

    std::shared_ptr<const HistoryList> m_list = std::make_shared<HistoryList>();
    QHash<int, Page> m_pages;
    QSet<int> m_asked;
    mutable quint64 m_uses = 0;
};

/// Words the raw values of HistoryModel: outcome as sign and word, numbers with their units, local time.
class HistoryDelegate : public QStyledItemDelegate {
    Q_OBJECT
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    /// The text of a cell.
    [[nodiscard]] static QString text(const QModelIndex& index);

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override;
};

} // namespace gripscope
