// SPDX-License-Identifier: GPL-3.0-or-later
// What the Live page costs the screen's thread with a gripper of 6 kHz, the 3-D page having been opened
// before: a frame with 60 s of force and position shown, and the memory held after an hour. Needs a display:
//   xvfb-run -a -s "-screen 0 1600x1000x24" build/bench/bin/live_page_bench
#include "devices/line/mqtt/mqtt_publisher.h"
#include "ui/charts/strip_chart.h"
#include "ui/context/workbench.h"
#include "ui/pages/page.h"
#include "ui/settings/values/settings.h"
#include "ui/shell/main_window.h"
#include "ui/theme/theme.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QPushButton>
#include <QStandardPaths>
#include <QTemporaryDir>

#include <algorithm>
#include <benchmark/benchmark.h>
#include <ctime>
#include <functional>
#include <vector>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// The layout of the floating-point example in resources/profiles, with more and faster reports.
const char profile[] = R"({
  "gripscope_profile": 1, "name": "Bench of 6 kHz", "commandable": false,
  "device": { "vendor": "1209", "product": "0006" },
  "report": { "length": 56, "samples_per_second": 6000, "samples": 6, "stride": 8 },
  "force_hold": "zoh",
  "fields": {
    "time": { "byte": 0, "type": "u32", "endian": "little", "unit": "us" },
    "force": { "byte": 8, "type": "f32", "endian": "little", "unit": "N" },
    "position": { "byte": 12, "type": "f32", "endian": "little", "unit": "m" }
  }
})";

void waitUntil(const std::function<bool()>& reached, int patience_s)
{
    QElapsedTimer clock;
    clock.start();
    while (!reached()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        if (clock.elapsed() > 1000 * patience_s)
            qFatal("it did not come to it");
    }
}

double threadTime_s()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Megabytes; `key`: VmRSS now, VmHWM the most so far.
double memory_MB(const QByteArray& key)
{
    QFile file(u"/proc/self/status"_s);
    if (file.open(QIODevice::ReadOnly))
        for (const QByteArray& line : file.readAll().split('\n'))
            if (line.startsWith(key))
                return line.mid(key.size() + 1).simplified().split(' ').first().toDouble() / 1024;
    return 0;
}

/// The window with the example types, its 3-D page opened once, then on the Live page.
class LiveWindow {
public:
    LiveWindow() : bench(m_folder.filePath(u"bench.gripscope"_s)), window(bench)
    {
        QFile file(m_folder.filePath(u"profile.json"_s));
        if (!file.open(QIODevice::WriteOnly) || file.write(profile) < 0)
            qFatal("the profile could not be written");
        bool loaded = false;
        bench.background().ask<void>(
            nullptr, [](Library& library) { return library.loadExampleTypes(); },
            [&](const Expected<void>&) { loaded = true; });
        window.resize(1440, 900);
        window.show();
        waitUntil([&] { return loaded; }, 60);
        bench.tellLibraryChanged();
        window.showPage(u"types"_s);
        Page* types = window.currentPage();
        types->prepareTour();
        waitUntil([&] { return types->tourReady(); }, 60);
        window.showPage(u"live"_s);
    }
    /// `speed`: times the real one.
    void connectTo(int speed, double seconds)
    {
        bench.connectTo(
            u"virtual:?profile=%1&speed=%2"_s.arg(m_folder.filePath(u"profile.json"_s)).arg(speed));
        waitUntil([&] { return bench.connection().state() == ConnectSession::State::Connected; }, 30);
        waitUntil([&] { return bench.live().history().newestTime_s() >= seconds; },
                  static_cast<int>(60 + 3 * seconds / speed));
    }
    void switchEverythingOn()
    {
        const QString nobody = u"192.0.2.1"_s; // an address of RFC 5737
        {
            MqttOutbox waiting(mqttFile(bench.library().file()));
            constexpr std::size_t many = 2000, atOnce = 100; // it takes 256 that are not in its file yet
            for (std::size_t i = 1; i <= many; ++i) {
                waiting.offer(LineReport{});
                if (i % atOnce == 0)
                    waitUntil([&] { return waiting.waiting(0, many).size() == i; }, 60);
            }
        }
        Settings& settings = bench.settings();
        settings.set(setting::linePort, 15020.0);
        settings.set(setting::lineOn, true);
        settings.set(setting::mqttBroker, nobody + u":1883"_s);
        settings.set(setting::mqttTopic, u"plant/results"_s);
        settings.set(setting::mqttSparkplug, u"plant/bench"_s);
        settings.set(setting::mqttOn, true);
        settings.set(setting::plantServer, u"postgresql://station@%1/plant"_s.arg(nobody));
    }
    void showLast(const QString& span)
    {
        for (auto* button : window.currentPage()->findChildren<QPushButton*>())
            if (button->text() == span)
                button->click();
    }

private:
    QTemporaryDir m_folder;

public:
    Workbench bench;
    MainWindow window;
};

/// Time that the screen's thread works (processor time: it waits for the display in between) from one painted
/// force chart to the next: drained samples, histories, both charts, all the rest of the window, and its way
/// to the display.
/// With 1: a PLC's server on, results to a broker that no packet reaches, many of which wait, and a plant's
/// server that none reaches either.
void frame(benchmark::State& state)
{
    LiveWindow live;
    if (state.range(0) == 1)
        live.switchEverythingOn();
    live.connectTo(1, 1);
    live.showLast(u"1 min"_s);
    waitUntil([&] { return live.bench.live().history().newestTime_s() >= 62; }, 200);

    double before_s = threadTime_s();
    bool painted = false;
    std::vector<double> frames_ms;
    QObject context;
    QObject::connect(live.window.findChild<StripChart*>(), &StripChart::painted, &context,
                     [&] { painted = true; });
    QElapsedTimer whole;
    whole.start();
    for (auto _ : state) {
        painted = false;
        while (!painted)
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
        const double now_s = threadTime_s();
        state.SetIterationTime(now_s - before_s);
        frames_ms.push_back(1000 * (now_s - before_s));
        before_s = now_s;
    }
    const auto at = [](std::vector<double> values, double share) {
        std::sort(values.begin(), values.end());
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    state.counters["median_ms"] = at(frames_ms, 0.5);
    state.counters["p99_ms"] = at(frames_ms, 0.99);
    state.counters["frames_per_s"] =
        static_cast<double>(frames_ms.size()) / (1e-3 * static_cast<double>(whole.elapsed()));
    state.counters["samples_per_s"] = live.bench.connection().counters().sampleRate_Hz;
}
BENCHMARK(frame)->Arg(0)->Arg(1)->UseManualTime()->Iterations(600)->Unit(benchmark::kMillisecond);

/// An hour of reports, 50 times as fast, through the acquisition, the queue and the window.
void hour(benchmark::State& state)
{
    for (auto _ : state) {
        LiveWindow live;
        live.showLast(u"10 min"_s);
        state.counters["before_MB"] = memory_MB("VmRSS");
        live.connectTo(50, 3600);
        const LinkCounters counters = live.bench.connection().counters();
        state.counters["samples"] = static_cast<double>(counters.samples);
        state.counters["dropped"] = static_cast<double>(counters.droppedSamples);
        state.counters["resident_MB"] = memory_MB("VmRSS");
        state.counters["most_MB"] = memory_MB("VmHWM");
    }
}
BENCHMARK(hour)->Iterations(1)->Unit(benchmark::kSecond);

} // namespace

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);
    Theme::instance().apply(ThemeKind::Light);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
