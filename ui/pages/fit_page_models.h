// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model_comparison.h"

#include <QWidget>

class QLabel;
class QTableView;

namespace gripscope {

class ComparisonTableModel;

/// Which model explains the squeeze, in one sentence and as a table.
class ModelPanel : public QWidget {
    Q_OBJECT
public:
    explicit ModelPanel(QWidget* parent = nullptr);

    void setComparison(const ModelComparison& comparison);

private:
    ComparisonTableModel* m_model;
    QLabel* m_sentence;
    QTableView* m_table;
    QLabel* m_note;
};

} // namespace gripscope
