// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <optional>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace gripscope {

class StripChart;

/// What mouse, finger and keys ask of a strip chart that is held: zoom by the wheel, a drag moves what is in
/// view or the cursor below it, a double click shows all again; arrows move the view, with Shift the first
/// cursor, with Ctrl the second.
class StripGestures : public QObject {
    Q_OBJECT
public:
    explicit StripGestures(StripChart& chart);
    void setEnabled(bool on);

signals:
    void zoomAsked(double factor, double share); ///< share: of the width, from the left
    void panAsked(double share);                 ///< above 0: to later times
    void resetAsked();
    void cursorDragged(int cursor, double share); ///< 0 or 1, to that share of the width
    void cursorStepped(int cursor, int columns);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool wheel(const QWheelEvent& event);
    bool key(const QKeyEvent& event);
    void press(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void showWhatADragDoes(double pixel);
    [[nodiscard]] std::optional<int> cursorNear(double pixel) const;

    StripChart* m_chart;
    bool m_enabled = false;
    bool m_pressed = false;
    std::optional<int> m_cursor; ///< that is being dragged; else the view is
    double m_last = 0;           ///< pixel
};

} // namespace gripscope
