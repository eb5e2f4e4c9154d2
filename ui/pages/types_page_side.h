// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/type_space.h"

#include <QScrollArea>

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace gripscope {

class ClustersPanel;

/// The right quarter of the Types page: legend with counts and visibility, the point picked, how far the
/// nearest pair is apart; while clusters are shown, first of all how they are found.
class TypesSide : public QScrollArea {
    Q_OBJECT
public:
    explicit TypesSide(QWidget* parent = nullptr);

    void setSpace(const TypeSpace& space);
    void showClusters(bool clusters);
    void setHighlight(const QString& text); ///< empty: none
    void setPicked(const QString& text, bool canOpen);
    [[nodiscard]] std::vector<bool> visibility() const;
    [[nodiscard]] ClustersPanel* clusters() const { return m_clusters; }

signals:
    void visibilityChanged();
    void openAsked(); ///< the picked squeeze on the Fit page

private:
    [[nodiscard]] QWidget* buildTypes();
    [[nodiscard]] QWidget* buildPicked();
    [[nodiscard]] QWidget* buildNearest();
    void refreshLegend();

    QStringList m_types;
    bool m_showsClusters = true;
    std::vector<QCheckBox*> m_checks;
    ClustersPanel* m_clusters;
    QWidget* m_rule;
    QGridLayout* m_legend;
    QLabel* m_spread;
    QLabel* m_highlight;
    QLabel* m_picked;
    QPushButton* m_open;
    QLabel* m_nearest;
    QWidget* m_nearestPart = nullptr;
};

} // namespace gripscope
