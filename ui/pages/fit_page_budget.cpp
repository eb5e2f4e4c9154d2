// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_budget.h"

#include "ui/models/budget_delegate.h"
#include "ui/models/budget_table_model.h"
#include "ui/pages/fit_page_table.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QTableView>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

BudgetPanel::BudgetPanel(QWidget* parent)
    : QWidget(parent), m_model(new BudgetTableModel(this)), m_table(makePanelTable(m_model)),
      m_words(makeLabel({}, "second")), m_message(makeLabel({}, "second"))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::insideControl);
    m_table->setItemDelegate(new BudgetDelegate(this));
    m_table->setAccessibleName(tr("Uncertainty budget"));
    addCopyAction(m_table, [this] { return m_model->toTsv(); });
    m_words->setWordWrap(true);
    m_message->setWordWrap(true);
    column->addWidget(m_table);
    column->addWidget(m_words);
    column->addWidget(m_message);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { showWords(now.row()); });
}

void BudgetPanel::setBudget(const UncertaintyBudget& budget, const QString& forceUnit,
                            const QString& positionUnit)
{
    m_model->setBudget(budget, forceUnit, positionUnit);
    m_table->setVisible(m_model->rowCount() > 0);
    fitPanelTable(m_table);
    m_message->setText(budget.message);
    m_message->setVisible(!budget.message.isEmpty());
    m_table->selectRow(0);
    showWords(0);
}

void BudgetPanel::showWords(int row)
{
    const QModelIndex index = m_model->index(row, 0);
    const QString words = index.data(BudgetTableModel::WordsRole).toString();
    m_words->setText(words.isEmpty() ? QString() : tr("%1: %2").arg(index.data().toString(), words));
    m_words->setVisible(!words.isEmpty());
}

} // namespace gripscope
