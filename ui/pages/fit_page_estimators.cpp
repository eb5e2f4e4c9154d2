// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_estimators.h"

#include "ui/models/estimate_delegate.h"
#include "ui/models/estimate_table_model.h"
#include "ui/pages/fit_page_table.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QTableView>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

EstimatorPanel::EstimatorPanel(QWidget* parent)
    : QWidget(parent), m_model(new EstimateTableModel(this)), m_table(makePanelTable(m_model)),
      m_note(makeLabel({}, "second"))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    buildTable();
    m_note->setWordWrap(true);
    column->addWidget(m_table);
    column->addWidget(m_note);
    column->addStretch();
}

void EstimatorPanel::buildTable()
{
    m_table->setItemDelegate(new EstimateDelegate(this));
    // The delegate writes these below the name and the simulation fit.
    m_table->setColumnHidden(int(EstimateTableModel::Column::Verdict), true);
    m_table->setColumnHidden(int(EstimateTableModel::Column::PredictionFit), true);
    m_table->setAccessibleName(tr("Estimators against each other"));
    addCopyAction(m_table, [this] { return m_model->toTsv(); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (const auto estimator = m_model->estimatorAt(now.row()))
                    emit estimatorChosen(*estimator);
            });
}

void EstimatorPanel::setIdentification(const Identification& identification, const QString& forceUnit,
                                       const QString& positionUnit)
{
    m_model->setIdentification(identification, forceUnit, positionUnit);
    QStringList notes;
    if (identification.budget.parameters)
        notes << tr("The error bars here are those of noise alone; the intervals above count everything that "
                    "is known (see Uncertainty).");
    if (identification.baseline)
        notes << tr("The table holds what was measured; the empty gripper's own m, b and k are taken off the "
                    "numbers above.");
    if (identification.find(Estimator::Arx) || identification.find(Estimator::ArxMeanForce) ||
        identification.find(Estimator::Arx221))
        notes << tr(
            "ARX predicts one step ahead from the last two measured positions. With noise that reads "
            "high even when m, b and k are far off: a good ARX prediction fit says nothing about them.");
    m_note->setText(notes.join(u"\n\n"_s));
    m_note->setVisible(!notes.isEmpty());
    fitPanelTable(m_table);
    if (const Estimate* best = identification.best())
        m_table->selectRow(m_model->rowOf(best->estimator));
}

} // namespace gripscope
