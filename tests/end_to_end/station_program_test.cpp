// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/modbus_registers.h"
#include "tests/end_to_end/program_run.h"
#include "tests/end_to_end/small_plc.h"
#include "tests/end_to_end/station_console.h"
#include "tests/support/patience.h"
#include "tests/support/test_registry.h"

#include <QElapsedTimer>

#include <csignal>
#include <cstring>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/un.h>
#include <unistd.h>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

// gripscope-station as systemd and a PLC see it, with a virtual gripper.

namespace {

/// What a service tells systemd.
class ServiceManager {
public:
    explicit ServiceManager(const QString& path) : m_socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0))
    {
        const QByteArray name = path.toLocal8Bit();
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::memcpy(address.sun_path, name.constData(),
                    std::min(std::size_t(name.size()), sizeof(address.sun_path) - 1));
        m_bound = ::bind(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
    }
    ~ServiceManager() { ::close(m_socket); }
    bool bound() const { return m_bound; }
    /// All so far.
    const QByteArray& told()
    {
        char bytes[512];
        for (ssize_t size = 0; (size = ::recv(m_socket, bytes, sizeof(bytes), 0)) > 0;)
            m_told += QByteArray(bytes, qsizetype(size)) + '\n';
        return m_told;
    }

private:
    int m_socket;
    bool m_bound = false;
    QByteArray m_told;
};

} // namespace

class StationProgramTest : public QObject {
    Q_OBJECT
    Workplace m_work;

    ProgramRun ask(const QString& command) const { return askStation(m_work, command); }

private slots:
    void whatMakesNoSenseIsSaid()
    {
        for (const QStringList& arguments :
             {QStringList{}, QStringList{u"fly"_s},
              QStringList{u"--address"_s, u"virtual:"_s, u"--modbus"_s, u"here"_s}}) {
            QProcess process;
            m_work.prepare(process, arguments);
            process.setProgram(stationProgram());
            process.start();
            QVERIFY(process.waitForFinished(longEnough_ms));
            QCOMPARE(process.exitCode(), 2);
        }
        QCOMPARE(ask(u"status"_s).exit, 2); // none runs
    }
    void aStationInspectsOnTriggersOnceAPersonArmedIt()
    {
        QCOMPARE(m_work.cli({u"library"_s, u"examples"_s, u"--library"_s, m_work.path(u"parts.db"_s)}).exit,
                 0);
        ServiceManager manager(m_work.path(u"notify"_s));
        QVERIFY(manager.bound());
        const std::uint16_t port = freePort();
        QProcess station;
        m_work.prepare(station, {u"--library"_s, m_work.path(u"parts.db"_s), u"--address"_s,
                                 u"virtual:?object=A"_s, u"--modbus"_s, u"127.0.0.1:%1"_s.arg(port),
                                 u"--console"_s, m_work.path(u"console"_s), u"--heartbeat"_s, u"3"_s});
        QProcessEnvironment environment = station.processEnvironment();
        environment.insert(u"NOTIFY_SOCKET"_s, m_work.path(u"notify"_s));
        environment.insert(u"WATCHDOG_USEC"_s, u"400000"_s);
        station.setProcessEnvironment(environment);
        station.setProgram(stationProgram());
        station.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        station.start();
        QTRY_VERIFY_WITH_TIMEOUT(manager.told().contains("READY=1"), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(manager.told().count("WATCHDOG=1") > 2, longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT(ask(u"status"_s).json()[u"state"_s].toString(), u"Initialized"_s,
                                  longEnough_ms);

        SmallPlc plc;
        QVERIFY(plc.connectTo(port));
        QVERIFY(plc.write(1, 4711));
        std::vector<std::uint16_t> seen = plc.read();
        QCOMPARE(seen[4], std::uint16_t(1));
        QCOMPARE(seen[5], std::uint16_t(JobAnswer::NotArmed));

        const ProgramRun armed = ask(u"arm"_s);
        QVERIFY2(armed.exit == 0, armed.err.constData());
        QTRY_VERIFY_WITH_TIMEOUT(plc.read()[1] == std::uint16_t(LineState::Ready), longEnough_ms);
        QVERIFY(plc.write(2, 4712));
        QCOMPARE(plc.read()[5], std::uint16_t(JobAnswer::Taken));
        QTRY_VERIFY_WITH_TIMEOUT(plc.write(2, 4712) && (seen = plc.read())[2] & line_status_bit::resultValid,
                                 longEnough_ms);
        QCOMPARE(seen[23], std::uint16_t(4712));
        QCOMPARE(seen[26], std::uint16_t(ResultEvaluation::Ok));
        QVERIFY(seen[27] & line_result_bit::simulated);
        QVERIFY(plc.write(2, 4712, 1));
        QVERIFY(!(plc.read()[2] & line_status_bit::resultValid));

        QTRY_VERIFY_WITH_TIMEOUT(plc.read()[1] == std::uint16_t(LineState::Halted),
                                 longEnough_ms); // no heartbeat
        QCOMPARE(ask(u"status"_s).json()[u"armed"_s].toBool(true), false);

        manager.told(); // its socket holds ten of them
        QVERIFY(::kill(static_cast<pid_t>(station.processId()), SIGTERM) == 0);
        QVERIFY(station.waitForFinished(longEnough_ms));
        QCOMPARE(station.exitCode(), 0);
        QVERIFY(manager.told().contains("STOPPING=1"));
        const QJsonArray squeezes = m_work
                                        .cli({u"history"_s, u"--library"_s, m_work.path(u"parts.db"_s),
                                              u"--kind"_s, u"inspection"_s, u"--json"_s})
                                        .json()[u"squeezes"_s]
                                        .toArray();
        QCOMPARE(squeezes.size(), 1);
        QCOMPARE(squeezes[0].toObject()[u"part_number"_s].toString(), u"4712"_s);
        const ProgramRun audit =
            m_work.cli({u"audit"_s, u"--library"_s, m_work.path(u"parts.db"_s), u"--json"_s});
        QVERIFY(audit.out.contains("gripper.armed"));
        const ProgramRun aqdef =
            m_work.cli({u"history"_s, u"--library"_s, m_work.path(u"parts.db"_s), u"--kind"_s,
                        u"inspection"_s, u"--format"_s, u"aqdef"_s, u"-o"_s, m_work.path(u"parts.dfq"_s)});
        QVERIFY2(aqdef.exit == 0, aqdef.err.constData());
        QFile file(m_work.path(u"parts.dfq"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY(text.startsWith("K0100 3\r\nK1001 "));
        QCOMPARE(text.count('\x0F'), 2); // one part of three characteristics
    }
};

GRIPSCOPE_TEST(StationProgramTest)
#include "station_program_test.moc"
