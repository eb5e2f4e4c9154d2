// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QFrame>
#include <QObject>
#include <QPushButton>
#include <QWidget>

class QLabel;

namespace gripscope {

class ConnectSession;
class Workbench;

/// Why the gripper is armed no longer, for whatever says so: a person stopped it, or it was disarmed though
/// nobody asked for it. Holds until it is armed again or another gripper is connected. One for a workbench.
class StopStanding : public QObject {
    Q_OBJECT
public:
    static StopStanding& of(Workbench& workbench);

    [[nodiscard]] bool stopped() const { return m_stopped; } ///< by a person, while it was armed
    [[nodiscard]] const std::optional<Error>& disarmReason() const { return m_reason; }
    [[nodiscard]] bool notObeyed() const; ///< the gripper did not stop: nothing that it says is believed

signals:
    void changed();

private:
    explicit StopStanding(Workbench& workbench);
    void noticeStop();
    void follow();
    Workbench* m_workbench;
    bool m_armed = false, m_stopped = false, m_notObeyed = false;
    QString m_address;
    std::optional<Error> m_reason;
};

/// The red STOP. Every window has one; all that exist are known, so that a press can be told to be on one of
/// them even where a menu or a list holds the mouse.
class StopButton : public QPushButton {
    Q_OBJECT
public:
    StopButton(Workbench& workbench, int height, QWidget* parent);
    ~StopButton() override;

    /// The STOP that a person sees at a place of the screen, or null. One that lies under a dialog is not
    /// seen.
    [[nodiscard]] static StopButton* at(const QPoint& global);
    /// Where the STOPs are that can be seen, on the screen.
    [[nodiscard]] static QList<QRect> places();

    void press(); ///< stops, as a person's press does

private:
    [[nodiscard]] QRect place() const;
    Workbench* m_workbench;
};

/// The row at the top of every window but the main one: whether the gripper may move, and STOP. There as long
/// as a gripper that takes commands is connected, so that nothing moves under a finger when it is armed.
class StopStrip : public QFrame {
    Q_OBJECT
public:
    static constexpr int height_px = 56;
    StopStrip(Workbench& workbench, QWidget* window);

signals:
    void shown(bool visible); ///< it came or went

private:
    void refresh();
    Workbench* m_workbench;
    QLabel* m_state;
};

/// That the gripper did not obey Stop, over what the window shows, in letters that are read from 3 m. It
/// cannot be put away: it goes when the gripper was connected anew. No STOP lies under it.
class StopNotice : public QWidget {
    Q_OBJECT
public:
    /// Takes the place under `above`, a row at the top of `window`.
    StopNotice(const ConnectSession& connection, QWidget* above, QWidget* window);
    void refresh(); ///< looks at the connection; to be called after its polls
    [[nodiscard]] int fontPixels() const { return m_pixels; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void takePlace();
    const ConnectSession* m_connection;
    QWidget* m_above;
    int m_pixels = 0;
};

} // namespace gripscope
