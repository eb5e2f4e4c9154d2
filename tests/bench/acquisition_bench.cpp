// SPDX-License-Identifier: GPL-3.0-or-later
// A thousand reports a second with as many samples as they hold, for ten seconds: what share of a core the
// acquisition takes, and how soon the screen's timer takes the samples over. Argument: seconds.
#include "devices/acquisition/device_port.h"
#include "devices/protocol/codec.h"

#include <cstdio>
#include <cstdlib>
#include <sys/resource.h>
#include <thread>

using namespace gripscope;
using namespace gripscope::protocol;
using Clock = std::chrono::steady_clock;

namespace {

constexpr std::size_t perReport = maxSamplesPerReport;
constexpr double sampleTime_s = 0.001 / perReport;

/// Stream reports that are due, at the pace of a full-speed USB device.
class PacedTransport : public Transport {
public:
    Expected<void> open() override
    {
        m_start = Clock::now();
        return {};
    }
    Expected<Report> feature(ReportId id) override
    {
        if (id == ReportId::Identity)
            return encode(IdentityFeature{"bench", "1", "Bench", versionMinor});
        if (id == ReportId::Limits)
            return encode(LimitsFeature{100000, 1250, 32768});
        MeasurementFeature measurement;
        measurement.forcePerCount = 0.001;
        measurement.positionPerCount = 2e-5;
        measurement.sampleTime_s = sampleTime_s;
        return encode(measurement);
    }
    ReadResult read(Buffer& buffer, std::chrono::milliseconds timeout) override
    {
        const Clock::time_point due = m_start + std::chrono::milliseconds(m_next);
        const Clock::time_point end = Clock::now() + timeout;
        std::this_thread::sleep_until(std::min(due, end));
        if (m_closed)
            return {Outcome::Lost};
        if (due > end)
            return {};
        StreamReport stream;
        stream.reportSequence = m_next;
        stream.firstSample = static_cast<std::uint32_t>(m_next * perReport);
        stream.timestamp_us = 1000 * m_next;
        stream.count = perReport;
        for (std::size_t i = 0; i < perReport; ++i)
            stream.samples[i] = {static_cast<std::int32_t>(m_next % 1000), static_cast<std::int32_t>(i)};
        ++m_next;
        const Report report = encode(stream);
        std::copy(report.begin(), report.end(), buffer.begin());
        return {Outcome::Report, report.size()};
    }
    bool write(const Report&) override { return true; }
    void close() noexcept override { m_closed = true; }

private:
    Clock::time_point m_start;
    std::uint32_t m_next = 0;
    std::atomic<bool> m_closed{false};
};

double seconds(const timeval& t)
{
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

double processorSeconds(int who)
{
    rusage usage{};
    getrusage(who, &usage);
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

} // namespace

int main(int argc, char** argv)
{
    const double length_s = argc > 1 ? std::atof(argv[1]) : 10;
    DevicePort port(QStringLiteral("bench:"), [] { return std::make_shared<PacedTransport>(); });
    port.open();
    std::vector<Sample> samples;
    LinkCounters counters;
    const Clock::time_point begin = Clock::now();
    const double others = processorSeconds(RUSAGE_SELF) - processorSeconds(RUSAGE_THREAD);
    while (std::chrono::duration<double>(Clock::now() - begin).count() < length_s) {
        samples.clear();
        port.drain(samples);
        std::this_thread::sleep_for(std::chrono::milliseconds(16)); // the screen's timer
    }
    counters = port.counters();
    const double used_s = processorSeconds(RUSAGE_SELF) - processorSeconds(RUSAGE_THREAD) - others;
    port.close();
    std::printf("%.0f reports/s, %.0f samples/s, lost %llu, dropped %llu, silent %llu\n"
                "acquisition: %.2f %% of one core\n"
                "taken over within %.1f ms (median), %.1f ms (99 of 100)\n",
                counters.reportRate_Hz, counters.sampleRate_Hz,
                static_cast<unsigned long long>(counters.lostSamples),
                static_cast<unsigned long long>(counters.droppedSamples),
                static_cast<unsigned long long>(counters.stalls), 100 * used_s / length_s,
                counters.latency50_ms, counters.latency99_ms);
    return counters.lostSamples + counters.droppedSamples == 0 ? 0 : 1;
}
