// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_estimators.h"

#include "ui/models/estimate_delegate.h"
#include "ui/models/estimate_table_model.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QHeaderView>
#include <QTableView>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

EstimatorPanel::EstimatorPanel(QWidget* parent)
    : QWidget(parent), m_model(new EstimateTableModel(this)), m_table(new QTableView),
      m_note(makeLabel({}, "second"))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    buildTable();
    m_note->setWordWrap(true);
    m_note->setText(
        tr("ARX predicts one step ahead from the last two measured positions. With noise that reads high "
           "even when m, b and k are far off: a good ARX prediction fit says nothing about them."));
    column->addWidget(m_table);
    column->addWidget(m_note);
    column->addStretch();
}

void EstimatorPanel::buildTable()
{
    m_table->setModel(m_model);
    m_table->setItemDelegate(new EstimateDelegate(this));
    // The delegate writes these below the name and the simulation fit.
    m_table->setColumnHidden(int(EstimateTableModel::Column::Verdict), true);
    m_table->setColumnHidden(int(EstimateTableModel::Column::PredictionFit), true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    QHeaderView* header = m_table->horizontalHeader();
    header->setHighlightSections(false);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(0, QHeaderView::Stretch);
    header->setMinimumSectionSize(40);
    header->setStyleSheet(u"QHeaderView::section { padding: 4px 5px; }"_s); // as the delegate's
    m_table->setAccessibleName(tr("Estimators against each other"));
    auto* copy = new QAction(tr("Copy table"), m_table);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetShortcut);
    connect(copy, &QAction::triggered, this,
            [this] { QGuiApplication::clipboard()->setText(m_model->toTsv()); });
    m_table->addAction(copy);
    m_table->setContextMenuPolicy(Qt::ActionsContextMenu);
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
    m_note->setVisible(identification.find(Estimator::Arx) || identification.find(Estimator::ArxMeanForce) ||
                       identification.find(Estimator::Arx221));
    fitTable();
    if (const Estimate* best = identification.best())
        m_table->selectRow(m_model->rowOf(best->estimator));
}

void EstimatorPanel::fitTable()
{
    m_table->resizeRowsToContents();
    int height = m_table->horizontalHeader()->sizeHint().height() + 4;
    for (int row = 0; row < m_model->rowCount(); ++row)
        height += m_table->rowHeight(row);
    m_table->setFixedHeight(height);
}

} // namespace gripscope
