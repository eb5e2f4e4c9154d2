// SPDX-License-Identifier: GPL-3.0-or-later
// storm_station FILE SERVER PERIOD_ms SEED [CHANGE_EVERY]
// Stores an inspection every so many milliseconds, the first of them at a moment of its own, and says its key
// and the microseconds that it took once it is stored. Every so many of them it changes a type. SERVER "-":
// it has none. Asked by lines: "status" is answered in one line of JSON, "rest" ends the storing, the end of
// the input ends it.
#include "core/library/link/plant_link.h"
#include "tests/core/library/plant_actions.h"
#include "tests/support/own_home.h"

#include <QCoreApplication>
#include <QJsonDocument>

#include <atomic>
#include <cmath>
#include <iostream>
#include <thread>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// As large as a real one: a second at a kilohertz, with noise.
NewInspection anInspectionOfASecond(std::mt19937& random)
{
    constexpr int samples = 1000;
    std::normal_distribution<double> noise;
    NewInspection inspection = anInspection();
    Recording recording;
    recording.sampleTime_s = 1e-3;
    for (int i = 0; i < samples; ++i) {
        recording.time_s.push_back(1e-3 * i);
        recording.force.push_back(1e-3 * std::round(5e3 * std::sin(0.02 * i) + 10 * noise(random)));
        recording.position.push_back(1e-6 * std::round(2e3 * std::sin(0.02 * i) + 2 * noise(random)));
    }
    inspection.grasp.recording = recording;
    return inspection;
}

class StormStation {
public:
    StormStation(const QString& file, const QString& server, unsigned seed)
        : m_random(seed), m_library(valueOf(Library::open(file)))
    {
        if (server != u"-"_s)
            m_link = std::make_unique<PlantLink>(PlantLinkOptions{file, server});
    }
    void store()
    {
        const NewInspection inspection = anInspectionOfASecond(m_random);
        const auto begun = std::chrono::steady_clock::now();
        const QString key = valueOf(m_library->addInspection(inspection)).id;
        const auto took =
            std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begun);
        say(u"stored %1 %2"_s.arg(key).arg(took.count()));
    }
    void changeType() { changeSomething(*m_library, m_random); }
    void tellStatus()
    {
        const PlantStatus status = m_link ? m_link->status() : PlantStatus();
        say(u"status "_s +
            QString::fromUtf8(
                QJsonDocument(
                    QJsonObject{{u"reached"_s, status.reached},
                                {u"inStep"_s, status.inStep},
                                {u"waiting"_s, status.waiting.value_or(-1)},
                                {u"problem"_s, status.problem ? status.problem->describe() : QString()}})
                    .toJson(QJsonDocument::Compact)));
    }
    [[nodiscard]] std::mt19937& random() { return m_random; }

private:
    static void say(const QString& line)
    {
        std::cout << line.toStdString() << std::endl; // before anything can end this program
    }
    std::mt19937 m_random;
    std::unique_ptr<Library> m_library;
    std::unique_ptr<PlantLink> m_link;
};

/// What was asked for by lines, by a thread that waits for them.
struct Asked {
    std::atomic<bool> rest{false}, over{false};
    std::atomic<int> status{0};

    void read()
    {
        for (std::string line; std::getline(std::cin, line);) {
            if (line == "rest")
                rest = true;
            if (line == "status")
                ++status;
        }
        over = true;
    }
};

} // namespace

int main(int argc, char** argv)
{
    const OwnHome home;
    const QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() < 5)
        return 2;
    const auto period = std::chrono::milliseconds(arguments[3].toInt());
    const int changeEvery = arguments.value(5).toInt();
    StormStation station(arguments[1], arguments[2], arguments[4].toUInt());
    Asked asked;
    std::thread reader([&asked] { asked.read(); });
    auto next = std::chrono::steady_clock::now() + period * int(station.random()() % 1000) / 1000;
    for (int stored = 0; !asked.over;) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        for (; asked.status > 0; --asked.status)
            station.tellStatus();
        if (asked.rest || std::chrono::steady_clock::now() < next)
            continue;
        next = std::max(next + period, std::chrono::steady_clock::now());
        station.store();
        if (changeEvery > 0 && ++stored % changeEvery == 0)
            station.changeType();
    }
    reader.join();
    return 0;
}
