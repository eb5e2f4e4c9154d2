// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/link/plant_link.h"
#include "core/session/line/line_session.h"
#include "core/session/line/line_status.h"
#include "devices/line/modbus_server.h"
#include "devices/line/mqtt/result_sender.h"

#include <QObject>

#include <memory>
#include <optional>

namespace gripscope {

class Settings;
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

/// The broker as the settings have it. Usage: what is missing, in words.
[[nodiscard]] Expected<MqttOptions> mqttOptions(const Settings& settings);

/// Sends the results of a station with a screen to a broker while the settings say so. One a workbench.
class MqttStation : public QObject {
    Q_OBJECT
public:
    [[nodiscard]] static MqttStation& of(Workbench& workbench);
    ~MqttStation() override; ///< tells the broker that the station leaves, if that takes milliseconds
    [[nodiscard]] bool on() const { return m_on; }
    [[nodiscard]] LineWords words() const;

private:
    explicit MqttStation(Workbench& workbench);
    void configure();
    Workbench* m_workbench;
    ResultSender m_sender;
    bool m_on = false;
    std::optional<Error> m_problem; ///< of the settings
};

/// Keeps the library of a station with a screen in step with its plant's server while the settings say so.
/// One a workbench.
class PlantStation : public QObject {
    Q_OBJECT
public:
    [[nodiscard]] static PlantStation& of(Workbench& workbench);
    ~PlantStation() override; ///< takes milliseconds
    [[nodiscard]] bool on() const { return m_on; }
    [[nodiscard]] LineWords words() const;

private:
    explicit PlantStation(Workbench& workbench);
    void configure();
    void noticeTypes();
    Workbench* m_workbench;
    std::unique_ptr<PlantLink> m_link;
    bool m_on = false;
    qint64 m_typesTaken = 0;
    std::optional<Error> m_problem; ///< of the settings
};

} // namespace gripscope
