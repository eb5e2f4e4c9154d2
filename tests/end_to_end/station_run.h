// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/end_to_end/small_plc.h"
#include "tests/end_to_end/station_console.h"

namespace gripscope::test {

using namespace Qt::StringLiterals;

/// gripscope-station with a virtual gripper, a PLC, and what else its options name.
class StationRun {
public:
    StationRun(const Workplace& work, const QStringList& more) : m_work(work), m_port(freePort())
    {
        const QStringList own{u"--library"_s,   work.path(u"parts.db"_s),
                              u"--address"_s,   u"virtual:?object=A&seed=7&speed=0"_s,
                              u"--modbus"_s,    u"127.0.0.1:%1"_s.arg(m_port),
                              u"--console"_s,   work.path(u"console"_s),
                              u"--heartbeat"_s, u"60"_s};
        work.prepare(m_station, own + more);
        m_station.setProgram(stationProgram());
        m_station.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_station.start();
    }
    ~StationRun() { kill(); }
    StationRun(const StationRun&) = delete;
    StationRun& operator=(const StationRun&) = delete;

    [[nodiscard]] ProgramRun ask(const QString& command) const { return askStation(m_work, command); }
    [[nodiscard]] bool says(const QString& key, const QString& words) const
    {
        QString said;
        const bool found = QTest::qWaitFor(
            [&] {
                said = ask(u"status"_s).json()[key].toString();
                return said.contains(words);
            },
            longEnough_ms);
        if (!found)
            qWarning("the station says: %s", qPrintable(said));
        return found;
    }
    [[nodiscard]] bool arm()
    {
        return says(u"state"_s, u"Initialized"_s) && m_plc.connectTo(m_port) && m_plc.write(0, 0) &&
               ask(u"arm"_s).exit == 0 && says(u"state"_s, u"Ready"_s);
    }
    /// The part of this token; its result is acknowledged.
    [[nodiscard]] bool inspect(std::uint32_t token)
    {
        const std::uint16_t trigger = ++m_trigger;
        std::vector<std::uint16_t> seen;
        const bool done =
            m_plc.write(trigger, token) && QTest::qWaitFor(
                                               [&] {
                                                   seen = m_plc.read();
                                                   return seen.size() == 48 && seen[23] == token;
                                               },
                                               longEnough_ms);
        return done && m_plc.write(trigger, token, (std::uint32_t(seen[20]) << 16) + seen[21]);
    }
    void kill()
    {
        m_station.kill();
        m_station.waitForFinished(longEnough_ms);
    }

private:
    const Workplace& m_work;
    std::uint16_t m_port;
    QProcess m_station;
    SmallPlc m_plc;
    std::uint16_t m_trigger = 0;
};

} // namespace gripscope::test
