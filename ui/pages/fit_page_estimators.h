// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"

#include <QWidget>

class QLabel;
class QTableView;

namespace gripscope {

class EstimateTableModel;

/// The estimators against each other: a table whose current row is the model that the plots show.
class EstimatorPanel : public QWidget {
    Q_OBJECT
public:
    explicit EstimatorPanel(QWidget* parent = nullptr);

    void setIdentification(const Identification& identification, const QString& forceUnit,
                           const QString& positionUnit);
    [[nodiscard]] EstimateTableModel* model() const { return m_model; }

signals:
    void estimatorChosen(gripscope::Estimator estimator);

private:
    void buildTable();

    EstimateTableModel* m_model;
    QTableView* m_table;
    QLabel* m_note;
};

} // namespace gripscope
