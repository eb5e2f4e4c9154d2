// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace gripscope {

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

} // namespace gripscope
