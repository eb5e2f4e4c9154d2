// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/work_watch.h"
#include "core/clustering/cluster_advice.h"
#include "ui/charts/heat_map.h"
#include "ui/models/space_clustering.h"

#include <QTimer>
#include <QWidget>

#include <array>
#include <memory>

class QComboBox;
class QGridLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;
class QTableView;

namespace gripscope {

class AdviceTableModel;
class ClusterCountsModel;
class ClusterTableModel;
class HeatMap;

/// The planes of a self-organizing map, two by two: U-matrix, m, b, k. Pointing at a unit in one frames it in
/// all.
class MapPanel : public QWidget {
    Q_OBJECT
public:
    explicit MapPanel(QWidget* parent = nullptr);

    void setMap(const MapPlanes& map);
    [[nodiscard]] HeatMap* plane(int number) const { return m_maps[std::size_t(number)]; }

private:
    std::array<HeatMap*, 4> m_maps;
};

/// How many clusters there seem to be: on request the criteria side by side, and the choice in a sentence.
class AdvicePanel : public QWidget {
    Q_OBJECT
public:
    explicit AdvicePanel(QWidget* parent = nullptr);

    /// Shows how far the work is until an answer, a failure or clear() comes.
    void setRunning(const std::shared_ptr<WorkWatch>& watch);
    void setAdvice(const ClusterAdvice& advice);
    void setFailure(const QString& words);
    void clear(); ///< back to the offer
    [[nodiscard]] bool running() const { return m_watch != nullptr; }
    [[nodiscard]] bool showsAdvice() const;

signals:
    void asked();
    void cancelled();
    void chosen(int clusters); ///< the advised number is to be used

private:
    void refresh();

    std::shared_ptr<WorkWatch> m_watch;
    QTimer m_poll;
    int m_advised = 1;
    AdviceTableModel* m_model;
    QPushButton* m_ask;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
    QLabel* m_reason;
    QTableView* m_table;
    QPushButton* m_use;
};

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
