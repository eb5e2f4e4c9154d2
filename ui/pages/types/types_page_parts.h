// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/type_space.h"

#include <QScrollArea>
#include <QTimer>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace gripscope {

class ClustersPanel;
class FitExporter;
class SceneView;

/// The types that have no place in the picture, with their squeezes: "foam (6), fruit (12)".
[[nodiscard]] QString elsewhereText(const TypeSpace& space);

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
    void openAsked();   ///< the picked squeeze on the Fit page
    void manageAsked(); ///< what can be done to the enrolled types
    void limitsAsked(); ///< what their parts may be

private:
    [[nodiscard]] QWidget* buildTypes();
    [[nodiscard]] QWidget* buildPicked();
    [[nodiscard]] QWidget* buildNearest();
    void refreshLegend();

    QStringList m_types;
    std::vector<int> m_signs; ///< one a type
    bool m_showsClusters = true;
    std::vector<QCheckBox*> m_checks;
    ClustersPanel* m_clusters;
    QWidget* m_rule;
    QGridLayout* m_legend;
    QLabel* m_spread;
    QLabel* m_elsewhere;
    QLabel* m_highlight;
    QLabel* m_picked;
    QPushButton* m_open;
    QLabel* m_nearest;
    QWidget* m_nearestPart = nullptr;
};

/// Below the scene: types or clusters, and the way through the iterations of the method.
class StepBar : public QWidget {
    Q_OBJECT
public:
    explicit StepBar(QWidget* parent = nullptr);

    /// States of the method, the start among them; 0: there are none. Goes to the last one.
    void setCount(int count);
    void setFigure(const QString& text); ///< what the method has reached in the state shown
    void showClusters(bool clusters);
    [[nodiscard]] int step() const;
    [[nodiscard]] bool byCluster() const { return m_byCluster; }
    /// Shows a step; from then on by cluster.
    void goTo(int step);
    void play(bool on);

signals:
    void changed(); ///< step or colouring

private:
    void refresh();

    bool m_byCluster = false;
    int m_count = 0;
    QTimer m_playing;
    QPushButton* m_types;
    QPushButton* m_clusters;
    QToolButton* m_play;
    QToolButton* m_back;
    QToolButton* m_forward;
    QSlider* m_slider;
    QLabel* m_text;
    QLabel* m_figure;
};

/// Above the scene: which types, from where to look, the picture for elsewhere.
class SceneToolBar : public QWidget {
    Q_OBJECT
public:
    /// `exporter` saves the view as a figure, and its numbers.
    SceneToolBar(SceneView* view, FitExporter* exporter, QWidget* parent = nullptr);

    void setPaper(bool paper);

signals:
    void paperAsked(bool paper);         ///< the paper's tables, or the library
    void failed(const QString& message); ///< the picture could not be written

private:
    void savePicture(); ///< as it is rendered

    SceneView* m_view;
    QComboBox* m_source;
    QToolButton* m_orthographic = nullptr;
};

} // namespace gripscope
