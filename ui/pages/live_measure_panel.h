// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

#include <array>

class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTableView;
class QToolButton;

namespace gripscope {

class LiveMarkerModel;

/// What can be done with charts that are held: the buttons of the view, two cursors with what they read, the
/// markers. It shows and asks; what is shown comes from LivePause.
class LiveMeasurePanel : public QFrame {
    Q_OBJECT
public:
    explicit LiveMeasurePanel(LiveMarkerModel& markers, QWidget* parent = nullptr);

    struct CursorTexts {
        double time_s = 0; ///< from the moment of the pause, <= 0
        QString force, position;
    };
    struct Readout {
        std::array<CursorTexts, 2> cursors;
        QString time, force, position; ///< second less first
        QString slope;
    };
    void show(const Readout& readout);
    using QWidget::show;
    /// Times go from `oldest_s` to 0; a step of the fields is `step_s`.
    void setTimes(double oldest_s, double step_s);
    void setSaving(bool on); ///< a file is being written

signals:
    void zoomAsked(double factor);
    void panAsked(double share);
    void resetAsked();
    void cursorsAsked(); ///< into what is in view
    void cursorSet(int cursor, double time_s);
    void saveAsked();
    void markerChosen(int row);

private:
    QWidget* buildReadout();
    QWidget* buildSide();
    void addCursor(QGridLayout* grid, int cursor);
    void removeMarkers();

    LiveMarkerModel* m_markers;
    std::array<QDoubleSpinBox*, 2> m_times{};
    std::array<QLabel*, 2> m_forces{}, m_positions{};
    QLabel* m_timeBetween = nullptr;
    QLabel* m_forceBetween = nullptr;
    QLabel* m_positionBetween = nullptr;
    QLabel* m_slope = nullptr;
    QTableView* m_table = nullptr;
    QToolButton* m_remove = nullptr;
    QPushButton* m_save = nullptr;
};

} // namespace gripscope
