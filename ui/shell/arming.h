// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/device_button.h"
#include "ui/station/station_watch.h"

#include <QObject>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

class QKeyEvent;
class QWidget;

namespace gripscope {

class Workbench;

/// Arms without a mouse: Ctrl+Shift+A, held for a second. A scanner is a keyboard, and whatever it types is
/// over in a moment; so is a key that is struck in passing. Letting any of the keys go, another key, a dialog
/// or another window ends it, and nothing was done. What follows is what the Arm button does, with all that
/// it asks.
class ArmChord : public QObject {
    Q_OBJECT
public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;
    static constexpr std::chrono::milliseconds duration{1000};

    /// Keys count anywhere in the window of `place`.
    ArmChord(Workbench& workbench, QWidget* place);
    ~ArmChord() override;
    void setClock(Clock clock); ///< for tests
    /// How far it is, 0 to 1; nothing while the keys are not held.
    [[nodiscard]] std::optional<double> progress() const;

signals:
    void changed(); ///< progress()

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void press(const QKeyEvent& key);
    void release(const QKeyEvent& key);
    void follow();
    void cancel();
    [[nodiscard]] bool possible() const;
    Workbench* m_workbench;
    QWidget* m_place;
    Clock m_clock;
    std::optional<std::chrono::steady_clock::time_point> m_since;
};

/// Nothing stays armed that nobody attends: the gripper is stopped and disarmed when the station is locked or
/// goes to sleep, when the user or the person of the program changes, and when nothing was done for a time:
/// no key, press, touch or scan, no button of the gripper, and no squeeze.
class Attendance : public QObject {
    Q_OBJECT
public:
    using Clock = std::function<std::chrono::steady_clock::time_point()>;
    Attendance(Workbench& workbench, std::unique_ptr<StationWatch> station, QObject* parent = nullptr);
    ~Attendance() override;

    void setClock(Clock clock); ///< for tests; else the steady clock

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow();
    void noticePerson();
    void leave(const QString& why);
    [[nodiscard]] std::chrono::milliseconds limit() const;
    Workbench* m_workbench;
    std::unique_ptr<StationWatch> m_station;
    Clock m_clock;
    std::chrono::steady_clock::time_point m_lastDone;
    ButtonWatch m_button;
    int m_listener = 0;
    bool m_armed = false;
    QString m_person; ///< who has signed in; empty: nobody
};

} // namespace gripscope
