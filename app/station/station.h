// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/station/console.h"
#include "app/station/options.h"
#include "app/station/service_notice.h"
#include "core/session/line/line_session.h"
#include "core/session/squeeze/stored_chain.h"
#include "devices/factory/gripper_factory.h"
#include "devices/line/mqtt/result_sender.h"

#include <QTimer>

namespace gripscope {

/// A station without a screen: the sessions that the window drives as well, polled by a timer of its own.
/// What a PLC asks for is inspected; only a person at this computer arms (Console), and only as the library's
/// policy allows.
class Station {
public:
    explicit Station(const StationOptions& options);
    ~Station(); ///< stops and disarms
    Station(const Station&) = delete;
    Station& operator=(const Station&) = delete;

    /// StorageOpen, Usage: it cannot run like this.
    [[nodiscard]] Expected<void> start();
    /// StopNotObeyed: what was said last.
    [[nodiscard]] Expected<void> end();

private:
    void tick();
    void noticeGripper();
    void applyKnown(const QString& serial);
    void tellNews();
    void notePlant();
    void noticeError(std::optional<Error>& known, const std::optional<Error>& now);
    void answer(const QJsonObject& request, const Console::Answer& answer);
    void arm(const QJsonObject& request, const Console::Answer& answer);
    void armNow(const QString& person, const Console::Answer& answer);
    void followArming();
    [[nodiscard]] QJsonObject status() const;
    [[nodiscard]] LineWords words() const;

    StationOptions m_options;
    DeviceFactory m_factory;
    LibraryService m_library;
    ConnectSession m_connection;
    InspectSession m_inspection;
    std::shared_ptr<SharedJobDesk> m_desk;
    LineSession m_line;
    std::unique_ptr<ModbusServer> m_server;
    ResultSender m_sender;
    std::unique_ptr<PlantLink> m_plant;
    Console m_console;
    ServiceNotice m_notice;
    QTimer m_timer;
    bool m_ready = false;
    QString m_known; ///< the gripper whose calibrations are in force, with how often it came back
    PendingCall m_asking, m_arming;
    Console::Answer m_armed; ///< to be told once the gripper is
    std::chrono::steady_clock::time_point m_armBy;
    std::optional<Error> m_connectionError, m_inspectionError;
    LineWords m_mqttWords, m_plantWords; ///< as they were told last
    qint64 m_typesTaken = 0;             ///< from the plant
};

} // namespace gripscope
