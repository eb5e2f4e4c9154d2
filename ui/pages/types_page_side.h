// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/type_space.h"

#include <QScrollArea>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTableView;
class QVBoxLayout;

namespace gripscope {

class ClusterTableModel;

/// The right quarter of the Types page: legend with counts and visibility, the point picked, how far the
/// nearest pair is apart, what K-means made of it, Table 1.
class TypesSide : public QScrollArea {
    Q_OBJECT
public:
    explicit TypesSide(QWidget* parent = nullptr);

    void setSpace(const TypeSpace& space);
    /// What K-means found; null while it is not known, with a reason when it cannot be.
    void setClustering(const SpaceClustering* clustering, const QString& reason = {});
    void setHighlight(const QString& text); ///< empty: none
    void setPicked(const QString& text, bool canOpen);
    [[nodiscard]] std::vector<bool> visibility() const;
    [[nodiscard]] FeatureScaling scaling() const;
    [[nodiscard]] int start() const; ///< as for clusterTypeSpace()

signals:
    void visibilityChanged();
    void clusteringAsked(); ///< another scaling or start
    void openAsked();       ///< the picked squeeze on the Fit page

private:
    void buildClusters(QVBoxLayout* column);
    void buildTable(QVBoxLayout* column);
    void refreshLegend();

    TypeSpace m_space;
    std::vector<QCheckBox*> m_checks;
    QGridLayout* m_legend;
    QLabel* m_highlight;
    QLabel* m_picked;
    QPushButton* m_open;
    QLabel* m_nearest;
    QComboBox* m_scaling;
    QComboBox* m_start;
    QGridLayout* m_numbers;
    QLabel* m_randIndex;
    QLabel* m_inertia;
    QLabel* m_tableTitle;
    ClusterTableModel* m_model;
    QTableView* m_table;
};

} // namespace gripscope
