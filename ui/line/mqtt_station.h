// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/line/mqtt/result_sender.h"

#include <QObject>

namespace gripscope {

class Settings;
class Workbench;

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

} // namespace gripscope
