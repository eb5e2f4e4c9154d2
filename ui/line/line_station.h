// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/line/line_session.h"
#include "devices/line/modbus_server.h"

#include <QObject>

namespace gripscope {

class Workbench;

/// The PLC's side of a station with a screen: listens while the settings say so, hands its jobs to the same
/// inspections that a key starts, and tells a person what it refuses. It can't arm. One a workbench.
class LineStation : public QObject {
    Q_OBJECT
public:
    [[nodiscard]] static LineStation& of(Workbench& workbench);
    [[nodiscard]] bool on() const { return m_on; }
    [[nodiscard]] LineLink link() const;
    [[nodiscard]] LineWords words() const;

private:
    explicit LineStation(Workbench& workbench);
    void configure();
    void poll();
    Workbench* m_workbench;
    std::shared_ptr<SharedJobDesk> m_desk;
    LineSession m_session;
    bool m_on = false;
    std::optional<Error> m_problem; ///< of the settings
    std::unique_ptr<ModbusServer> m_server;
};

} // namespace gripscope
