// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/device_button.h"
#include "ui/station/station_watch.h"

#include <chrono>
#include <functional>

namespace gripscope {

class Workbench;

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
