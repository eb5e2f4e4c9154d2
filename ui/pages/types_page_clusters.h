// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/space_clustering.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QTableView;

namespace gripscope {

class AdvicePanel;
class ClusterCountsModel;
class ClusterTableModel;
class MapPanel;

/// Groups without labels: how to group, how many groups, what came of it, and how it agrees with the types.
class ClustersPanel : public QWidget {
    Q_OBJECT
public:
    explicit ClustersPanel(QWidget* parent = nullptr);

    /// As many clusters as there are types, when those are others than before.
    void setSpace(const TypeSpace& space);
    /// What was found; null while it is not known, with a reason when it cannot be.
    void setClustering(const TypeSpace& space, const SpaceClustering* clustering, const QString& reason = {});
    void setRunning(bool running); ///< while it takes, with a way to stop it
    [[nodiscard]] ClusterRequest request() const;
    void setClusters(int clusters);
    void setMethod(ClusterMethod method, MixtureCovariance covariance = MixtureCovariance::Full);
    [[nodiscard]] AdvicePanel* advice() const { return m_advice; }

signals:
    void asked(); ///< to be grouped by request()
    void cancelled();
    void scalingChanged(); ///< before asked()

private:
    void buildChoices();
    void buildTables();
    [[nodiscard]] QWidget* buildClusterCount();
    void showRunning(bool running);
    void addNumber(const QString& name, const QString& value, const QString& tip);
    void showNumbers(const SpaceClustering& clustering);
    void showTable(const TypeSpace& space, const SpaceClustering* clustering);
    void refreshChoices();

    QStringList m_types;
    QTimer m_runningSoon;
    QComboBox* m_method;
    QSpinBox* m_clusters;
    QComboBox* m_scaling;
    QComboBox* m_start;
    QLabel* m_running;
    QPushButton* m_cancel;
    QLabel* m_reason;
    QGridLayout* m_numbers;
    AdvicePanel* m_advice;
    MapPanel* m_map;
    QLabel* m_tableTitle;
    ClusterTableModel* m_trials;
    ClusterCountsModel* m_counts;
    QTableView* m_table;
};

} // namespace gripscope
