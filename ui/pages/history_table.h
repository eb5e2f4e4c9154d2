// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/history_model.h"

#include <QStringList>
#include <QTableView>

class QMenu;

namespace gripscope {

/// The list of squeezes: sorted by the header, columns chosen by a person, any number of rows selected, the
/// selection kept when the list starts anew.
class HistoryTable : public QTableView {
    Q_OBJECT
public:
    explicit HistoryTable(HistoryModel* model, QWidget* parent = nullptr);

    /// Tick marks that show and hide columns.
    [[nodiscard]] QMenu* columnsMenu() const { return m_columns; }
    [[nodiscard]] std::vector<QString> selectedKeys() const; ///< in the order of the list
    [[nodiscard]] QString currentKey() const;                ///< empty: none
    void select(const QString& key);                         ///< alone, and brings it into view
    /// Starts the model anew; what was selected and is still there stays so.
    void restart(HistoryKeys keys, std::vector<HistoryEntry> first);

signals:
    void chosen(); ///< another current row, another selection

protected:
    void selectionChanged(const QItemSelection& selected, const QItemSelection& deselected) override;
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    void buildHeader();
    void buildColumnsMenu();
    [[nodiscard]] int titleWidth(int column) const;
    void fitColumns();
    void reselect(const std::vector<QString>& keys, const QString& current);

    HistoryModel* m_model;
    QMenu* m_columns;
    bool m_restarting = false, m_fitted = false;
};

} // namespace gripscope
