// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/modbus_server.h"
#include "tests/support/patience.h"
#include "tests/support/test_registry.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTcpSocket>
#include <QTest>

#include <atomic>
#include <thread>

using namespace gripscope;
using namespace std::chrono_literals;

namespace {

/// A station that answers each job at once, by the part's token; see plc_simulator.py.
class AnsweringStation {
public:
    explicit AnsweringStation(std::shared_ptr<SharedJobDesk> desk) : m_desk(std::move(desk)) {}
    ~AnsweringStation()
    {
        m_ends = true;
        m_thread.join();
    }
    [[nodiscard]] std::uint32_t inspected() const { return m_inspected; }
    [[nodiscard]] std::uint32_t told() const { return m_told; }

private:
    void run()
    {
        while (!m_ends) {
            m_desk->with([this](JobDesk& desk) { look(desk); });
            std::this_thread::sleep_for(100us);
        }
    }
    void look(JobDesk& desk)
    {
        const auto now = std::chrono::steady_clock::now();
        desk.setStation({LineState::Ready, true, true, 1});
        for (const JobDesk::Refusal& refusal : desk.takeRefusals())
            m_told += isOverrun(refusal.answer) ? 1 : 0;
        const std::optional<LineJob> job = desk.takeJob();
        if (!job)
            return;
        LineResult result;
        result.state = ResultState::Completed;
        result.evaluation = static_cast<ResultEvaluation>(job->partToken % 3 + 1);
        result.quantities[0] = LineQuantity{double(job->partToken % 100003), {}};
        result.quantities[2] = LineQuantity{double(++m_inspected % 65521), {}};
        desk.finish(result, now);
    }
    std::shared_ptr<SharedJobDesk> m_desk;
    std::atomic<bool> m_ends{false};
    std::atomic<std::uint32_t> m_inspected{0}, m_told{0};
    std::thread m_thread{[this] { run(); }};
};

struct RunningServer {
    explicit RunningServer(ModbusServerOptions options = {QStringLiteral("127.0.0.1"), 0, {}})
        : server(std::move(options), desk)
    {
    }
    /// 0 when it does not come to listen.
    std::uint16_t port()
    {
        if (!QTest::qWaitFor([this] { return !server.link().listening.isEmpty(); },
                             int(test::patience.count())))
            return 0;
        return static_cast<std::uint16_t>(server.link().listening.section(u':', -1).toUInt());
    }
    std::shared_ptr<SharedJobDesk> desk = std::make_shared<SharedJobDesk>(1);
    ModbusServer server;
};

bool comesTrue(const std::function<bool()>& done)
{
    return QTest::qWaitFor(done, 20'000);
}

} // namespace

class ModbusServerTest : public QObject {
    Q_OBJECT
private slots:
    void listenAddressesAreChecked_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("good");
        for (const auto& [text, good] : {std::pair{"127.0.0.1:1502", true}, std::pair{"[::1]:502", true},
                                         std::pair{"0.0.0.0:0", true}, std::pair{"station:502", false},
                                         std::pair{"127.0.0.1", false}, std::pair{"127.0.0.1:70000", false}})
            QTest::newRow(text) << QString::fromLatin1(text) << good;
    }
    void listenAddressesAreChecked()
    {
        QFETCH(QString, text);
        QFETCH(bool, good);
        QCOMPARE(parseListenAddress(text).has_value(), good);
    }
    void peersAreAddressesOrNetworks()
    {
        QVERIFY(checkOptions({QStringLiteral("127.0.0.1"), 1, {QStringLiteral("10.1.2.0/24")}}));
        QVERIFY(!checkOptions({QStringLiteral("127.0.0.1"), 1, {QStringLiteral("plc")}}));
    }
    void whatIsNoModbusIsCutOff()
    {
        RunningServer running;
        QTcpSocket socket;
        socket.connectToHost(QStringLiteral("127.0.0.1"), running.port());
        QVERIFY(socket.waitForConnected());
        socket.write("GET / HTTP/1.0\r\n\r\n");
        QVERIFY(comesTrue([&] { return socket.state() == QAbstractSocket::UnconnectedState; }));
        QVERIFY(comesTrue([&] { return running.server.link().malformed == 1; }));
        QVERIFY(comesTrue([&] { return running.server.link().clients == 0; }));
    }
    void requestsInPiecesAndInARowAreAnswered()
    {
        RunningServer running;
        QTcpSocket socket;
        socket.connectToHost(QStringLiteral("127.0.0.1"), running.port());
        QVERIFY(socket.waitForConnected());
        const QByteArray request = QByteArray::fromHex("000100000006ff0400640001");
        for (const char byte : request) {
            socket.write(&byte, 1);
            QVERIFY(socket.waitForBytesWritten());
        }
        QVERIFY(comesTrue([&] { return socket.bytesAvailable() == 11; }));
        QCOMPARE(socket.readAll().toHex(), QByteArray("000100000005ff04020001"));
        socket.write(request.repeated(1000)); // more than it serves at once
        QVERIFY(comesTrue([&] { return socket.bytesAvailable() == 11 * 1000; }));
    }
    void answersThatNobodyFetchesPileUpToABound()
    {
        RunningServer running;
        QTcpSocket socket;
        socket.setReadBufferSize(1);
        socket.connectToHost(QStringLiteral("127.0.0.1"), running.port());
        QVERIFY(socket.waitForConnected());
        const QByteArray request = QByteArray::fromHex("000100000006ff0400640030"); // 48 registers
        QVERIFY(comesTrue([&] {
            if (socket.bytesToWrite() < 100'000)
                socket.write(request.repeated(5000));
            return running.server.link().clients == 0 && running.server.link().requests > 0;
        }));
    }
    void noMoreClientsThanThereIsRoomFor()
    {
        RunningServer running;
        const std::uint16_t port = running.port();
        std::vector<std::unique_ptr<QTcpSocket>> sockets;
        for (int i = 0; i < ModbusServer::mostClients + 3; ++i) {
            sockets.push_back(std::make_unique<QTcpSocket>());
            sockets.back()->connectToHost(QStringLiteral("127.0.0.1"), port);
            QVERIFY(sockets.back()->waitForConnected());
        }
        QVERIFY(comesTrue([&] { return !running.server.link().refusedPeer.isEmpty(); }));
        QVERIFY(comesTrue([&] { return running.server.link().clients == ModbusServer::mostClients; }));
    }
    void aPortThatIsTakenIsToldAndTriedAgain()
    {
        auto first = std::make_unique<RunningServer>();
        const std::uint16_t port = first->port();
        RunningServer second({QStringLiteral("127.0.0.1"), port, {}});
        QVERIFY(comesTrue([&] { return second.server.link().failed.has_value(); }));
        QVERIFY(second.server.link().failed->describe().contains(QString::number(port)));
        first.reset();
        QVERIFY(comesTrue([&] { return !second.server.link().listening.isEmpty(); }));
        QVERIFY(!second.server.link().failed);
    }
    /// GRIPSCOPE_LINE_CYCLES: by hand 100000.
    void aPlcThatBehavesBadlyMixesAndLosesNothing()
    {
        RunningServer running;
        const AnsweringStation station(running.desk);
        const int cycles = qEnvironmentVariableIntValue("GRIPSCOPE_LINE_CYCLES");
        QProcess plc;
        plc.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        plc.start(QStringLiteral("/usr/bin/python3"), // Debian's, which has its packages
                  {QStringLiteral(GRIPSCOPE_SOURCE_DIR "/tests/devices/plc_simulator.py"),
                   QString::number(running.port()), QString::number(cycles > 0 ? cycles : 2000),
                   QStringLiteral("11")});
        QVERIFY2(plc.waitForStarted(), "python3 is missing");
        QVERIFY(plc.waitForFinished(cycles > 0 ? 3'600'000 : 120'000));
        const QByteArray told = plc.readAllStandardOutput();
        qInfo().noquote() << told.trimmed();
        QVERIFY2(plc.exitCode() == 0, "python3-pymodbus is missing, or see above");
        const QJsonObject count = QJsonDocument::fromJson(told).object();
        QCOMPARE(count[QStringLiteral("mixed")].toInt(-1), 0);
        QCOMPARE(int(station.inspected()),
                 count[QStringLiteral("cycles")].toInt()); // no part twice, none lost
        QVERIFY(comesTrue([&] { return int(station.told()) == count[QStringLiteral("overruns")].toInt(); }));
    }
};

GRIPSCOPE_TEST(ModbusServerTest)
#include "modbus_server_test.moc"
