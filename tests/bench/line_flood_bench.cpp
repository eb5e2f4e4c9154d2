// SPDX-License-Identifier: GPL-3.0-or-later
// Squeezes and Stop with the PLC's server off, on, flooded, and flooded beside a broker and a plant's server
// that are out of reach, side by side: how long from a squeeze's start to its verdict, how late samples are
// taken over, and how long until the gripper has obeyed Stop.
//   build/bench/bin/line_flood_bench [ROUNDS]
#include "core/library/link/plant_link.h"
#include "core/session/line/line_session.h"
#include "devices/factory/gripper_factory.h"
#include "devices/line/modbus_server.h"
#include "devices/line/mqtt/result_sender.h"

#include <QCoreApplication>
#include <QTemporaryDir>

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <atomic>
#include <cstdio>
#include <functional>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

using namespace gripscope;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

namespace {

constexpr int floodingClients = 6;

/// Clients that ask as fast as they are answered, a hundred requests at a time.
class Flood {
public:
    explicit Flood(std::uint16_t port)
    {
        for (int i = 0; i < floodingClients; ++i)
            m_threads.emplace_back([this, port] { run(port); });
    }
    ~Flood()
    {
        m_ends = true;
        for (std::thread& thread : m_threads)
            thread.join();
    }

private:
    void run(std::uint16_t port)
    {
        const int client = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in to{};
        to.sin_family = AF_INET;
        to.sin_port = htons(port);
        to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        const timeval patience{1, 0};
        ::setsockopt(client, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
        const bool connected = ::connect(client, reinterpret_cast<const sockaddr*>(&to), sizeof(to)) == 0;
        constexpr std::array<std::uint8_t, 12> request{0, 1, 0, 0, 0, 6, 1, 4, 0, 100, 0, 48};
        std::vector<std::uint8_t> many;
        for (int i = 0; i < 100; ++i)
            many.insert(many.end(), request.begin(), request.end());
        std::vector<std::uint8_t> answers(64 * 1024);
        while (connected && !m_ends) {
            if (::send(client, many.data(), many.size(), MSG_NOSIGNAL) < 0)
                break;
            static_cast<void>(!::recv(client, answers.data(), answers.size(), 0));
        }
        ::close(client);
    }
    std::atomic<bool> m_ends{false};
    std::vector<std::thread> m_threads;
};

struct Station {
    explicit Station(const QString& file)
        : library(file), inspection(connection, library), line(connection, inspection, desk)
    {
        inspection.setStoring(false);
    }
    bool until(const std::function<bool()>& done)
    {
        const auto end = Clock::now() + 30s;
        while (!done() && Clock::now() < end) {
            connection.poll();
            inspection.poll();
            sender.poll();
            line.poll();
            std::this_thread::sleep_for(500us);
        }
        return done();
    }
    bool arm()
    {
        return connection.arm(QStringLiteral("bench")) && until([this] { return connection.armed(); });
    }
    DeviceFactory devices;
    LibraryService library;
    ConnectSession connection{devices};
    InspectSession inspection;
    std::shared_ptr<SharedJobDesk> desk = std::make_shared<SharedJobDesk>(1);
    LineSession line;
    ResultSender sender{connection, inspection};
};

double since_ms(Clock::time_point start)
{
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void tell(const char* what, std::vector<double> times)
{
    std::ranges::sort(times);
    if (times.empty())
        return;
    std::printf("  %-34s median %8.2f ms  p90 %8.2f ms  most %8.2f ms\n", what, times[times.size() / 2],
                times[times.size() * 9 / 10], times.back());
}

bool measure(Station& station, int rounds)
{
    std::vector<double> verdicts, late, stops;
    for (int round = 0; round < rounds; ++round) {
        auto start = Clock::now();
        if (!station.inspection.squeeze() ||
            !station.until([&] { return station.inspection.state() == InspectSession::State::Ready; }))
            return false;
        verdicts.push_back(since_ms(start));
        late.push_back(station.connection.counters().latency99_ms);
        if (!station.inspection.squeeze())
            return false;
        const auto middle = Clock::now() + 200ms;
        station.until([&] { return Clock::now() > middle; });
        start = Clock::now();
        station.connection.stop();
        if (!station.until([&] { return station.connection.stopState() == StopState::Obeyed; }))
            return false;
        stops.push_back(since_ms(start));
        station.until([&] { return station.inspection.state() == InspectSession::State::Ready; });
        if (!station.arm())
            return false;
    }
    tell("start of a squeeze to its verdict", verdicts);
    tell("samples taken over after (p99)", late);
    tell("Stop to obeyed, while squeezing", stops);
    return true;
}

std::uint16_t portOf(const ModbusServer& server)
{
    while (server.link().listening.isEmpty())
        std::this_thread::sleep_for(1ms);
    return static_cast<std::uint16_t>(server.link().listening.section(u':', -1).toUInt());
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 20;
    const QTemporaryDir folder;
    Station station(folder.filePath(QStringLiteral("bench.db")));
    if (!station.connection.connectTo(QStringLiteral("virtual:?object=A")) || !station.until([&] {
            return station.connection.state() == ConnectSession::State::Connected &&
                   station.inspection.state() == InspectSession::State::Ready;
        }) ||
        !station.arm())
        return 1;
    const ModbusServerOptions options{QStringLiteral("127.0.0.1"), 0, {}};
    for (int turn = 0; turn < 2; ++turn) { // twice, since a computer warms up
        std::printf("server off\n");
        if (!measure(station, rounds))
            return 1;
        const ModbusServer server(options, station.desk);
        const std::uint16_t port = portOf(server);
        std::printf("server on\n");
        if (!measure(station, rounds))
            return 1;
        const Flood flood(port);
        const std::uint64_t before = server.link().requests;
        const auto start = Clock::now();
        std::printf("server flooded\n");
        if (!measure(station, rounds))
            return 1;
        std::printf("  %.0f requests a second\n",
                    double(server.link().requests - before) * 1000 / since_ms(start));
        MqttOptions broker;
        broker.host = QStringLiteral("192.0.2.1"); // an address of RFC 5737: nobody has it
        broker.jsonTopic = QStringLiteral("plant/results");
        station.sender.begin(broker, folder.filePath(QStringLiteral("bench.db")));
        const PlantLink plant({folder.filePath(QStringLiteral("bench.db")),
                               QStringLiteral("postgresql://station@192.0.2.1/plant")});
        std::printf("server flooded, a broker and a plant's server that no packet reaches\n");
        if (!measure(station, rounds))
            return 1;
        std::printf("  %zu results wait\n", station.sender.link().waiting);
        static_cast<void>(station.sender.end(10ms));
    }
    return 0;
}
