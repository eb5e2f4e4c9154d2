// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/signal/recording/units.h"
#include "devices/inspection/self_test.h"
#include "devices/protocol/report_words.h"

#include <QStringList>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;
using Outcome = SelfTestLine::Outcome;

namespace {

constexpr double largestRateError_percent = 1;
/// Crystals keep 100; a time scale that is a thousandth off moves m by two thousandths.
constexpr double largestDrift_ppm = 1000;
/// Noise of a channel at rest: so many of its counts, or such a share of its range, whichever is more.
constexpr double mostNoise_counts = 5;
constexpr double mostNoiseOfRange = 0.001;
constexpr double stopPatience_s = 0.5;

SelfTestLine line(const QString& id, const QString& name)
{
    SelfTestLine out;
    out.id = id;
    out.name = name;
    return out;
}

void judge(SelfTestLine& out, bool fine, const QString& advice)
{
    out.outcome = fine ? Outcome::Passed : Outcome::Failed;
    if (!fine)
        out.advice = advice;
}

QString figure(double value, int digits = 3)
{
    return Words::number(value, 'g', digits);
}

struct ChannelNoise {
    double deviation = 0;
    double count = 0; ///< the least step between two neighbours
};

ChannelNoise noiseOf(const std::vector<Sample>& samples, double Sample::*channel)
{
    ChannelNoise noise;
    double mean = 0, squares = 0;
    std::size_t n = 0;
    const double first = samples.front().*channel; // near the mean: keeps the sums exact
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double value = samples[i].*channel - first;
        ++n;
        const double off = value - mean;
        mean += off / static_cast<double>(n);
        squares += off * (value - mean);
        if (i == 0)
            continue;
        const double step = std::abs(samples[i].*channel - samples[i - 1].*channel);
        if (step > 0)
            noise.count = noise.count > 0 ? std::min(noise.count, step) : step;
    }
    noise.deviation = n > 1 ? std::sqrt(squares / static_cast<double>(n - 1)) : 0;
    return noise;
}

SelfTestLine noiseLine(SelfTestLine out, const SelfTestEvidence& evidence, double Sample::*channel,
                       const QString& unit, std::optional<double> range)
{
    if (evidence.samples.size() < 2) {
        out.figure = Words::tr("no samples");
        return out;
    }
    const ChannelNoise noise = noiseOf(evidence.samples, channel);
    out.value = noise.deviation;
    if (noise.count == 0) {
        out.figure = Words::tr("always the same number");
        out.advice = Words::tr(
            "Either it is quieter than one count, or it is stuck: touch the gripper and see whether "
            "the number moves.");
        return out;
    }
    const double most = std::max(mostNoise_counts * noise.count, mostNoiseOfRange * range.value_or(0.0));
    out.figure =
        u"%1 %2, %3 counts"_qs.arg(figure(noise.deviation), unit, figure(noise.deviation / noise.count, 2));
    out.limit = Words::tr("at most %1 %2").arg(figure(most), unit);
    judge(out, noise.deviation <= most,
          Words::tr(
              "Take away what shakes the gripper and what it holds, then test again; if it stays, check the "
              "sensor's wiring and shielding."));
    return out;
}

} // namespace

SelfTestLine featuresLine(const GripperIdentity& identity, const std::optional<Error>& error)
{
    SelfTestLine out = line(u"features"_qs, Words::tr("What it says of itself"));
    if (error) {
        out.figure = error->describe();
        judge(out, false,
              Words::tr("Plug the gripper in again. If it stays, its firmware does not answer as "
                        "devices/PROTOCOL.md asks."));
        return out;
    }
    out.limit = Words::tr("all read, checksums right");
    if (identity.protocolMajor > 0) {
        out.figure = Words::tr("identity, measurement and limits read, checksums right");
        out.outcome = Outcome::Passed;
    } else {
        out.figure = Words::tr("said by a profile or a file, not by the gripper");
    }
    return out;
}

SelfTestLine rateLine(const SelfTestEvidence& evidence)
{
    SelfTestLine out = line(u"rate"_qs, Words::tr("Rate"));
    const double stated_Hz = 1 / evidence.identity.sampleTime_s;
    out.limit =
        Words::tr("%1 samples a second within %2 %").arg(figure(stated_Hz, 6)).arg(largestRateError_percent);
    const auto& begin = evidence.before.newestArrival;
    const auto& end = evidence.after.newestArrival;
    const QString advice =
        Words::tr("Check the cable and the load of the computer. If it stays, the sample time that the "
                  "gripper states is wrong.");
    if (!begin || !end || *end <= *begin || evidence.samples.empty()) {
        out.figure = Words::tr("nothing came");
        judge(out, false, advice);
        return out;
    }
    const double seconds = std::chrono::duration<double>(*end - *begin).count();
    const auto lost = static_cast<double>(evidence.after.lostSamples - evidence.before.lostSamples);
    const double taken_Hz = (static_cast<double>(evidence.samples.size()) + lost) / seconds;
    const auto reports = static_cast<double>(evidence.after.reports - evidence.before.reports);
    out.value = taken_Hz;
    out.figure =
        Words::tr("%1 samples in %2 reports a second").arg(figure(taken_Hz, 4), figure(reports / seconds, 4));
    judge(out, std::abs(taken_Hz / stated_Hz - 1) <= largestRateError_percent / 100, advice);
    return out;
}

SelfTestLine sequenceLine(const SelfTestEvidence& evidence)
{
    SelfTestLine out = line(u"sequence"_qs, Words::tr("Nothing lost"));
    const LinkCounters &a = evidence.before, &b = evidence.after;
    const std::pair<QString, std::uint64_t> counts[] = {
        {Words::tr("%1 samples lost"), b.lostSamples - a.lostSamples},
        {Words::tr("%1 reports twice"), b.duplicateReports - a.duplicateReports},
        {u"%1 damaged"_qs, b.badReports - a.badReports},
        {u"%1 silences"_qs, b.stalls - a.stalls},
        {Words::tr("%1 samples dropped here"), b.droppedSamples - a.droppedSamples}};
    QStringList found;
    std::uint64_t all = 0;
    for (const auto& [words, count] : counts) {
        all += count;
        if (count > 0)
            found << words.arg(count);
    }
    out.value = static_cast<double>(all);
    out.limit = u"0"_qs;
    out.figure = found.isEmpty() ? Words::tr("0 lost, twice, damaged or silent") : found.join(u", "_qs);
    judge(out, all == 0,
          Words::tr("Try a shorter cable and another port, without a hub; close programs that keep the "
                    "computer busy."));
    return out;
}

SelfTestLine clockLine(const SelfTestEvidence& evidence)
{
    SelfTestLine out = line(u"clock"_qs, Words::tr("Clock"));
    out.limit = Words::tr("no jump, within %1 ppm of the computer's").arg(largestDrift_ppm);
    const std::uint64_t steps = evidence.after.clockSteps - evidence.before.clockSteps;
    const std::optional<RateDifference>& drift = evidence.after.clocks.clock;
    QStringList found;
    if (steps > 0)
        found << u"%1 jumps"_qs.arg(steps);
    if (drift)
        found << u"%1%2 ppm"_qs.arg(drift->ppm >= 0 ? u"+"_qs : QString(), figure(drift->ppm));
    out.figure = found.isEmpty() ? Words::tr("not known") : found.join(u", "_qs);
    if (drift)
        out.value = drift->ppm;
    if (!found.isEmpty())
        judge(out, steps == 0 && !(drift && drift->beyond(largestDrift_ppm)),
              Words::tr("Check the gripper's power supply; if it stays, its firmware keeps time badly."));
    return out;
}

SelfTestLine statusLine(const SelfTestEvidence& evidence)
{
    SelfTestLine out = line(u"status"_qs, Words::tr("Status"));
    constexpr std::uint16_t wrong = StatusFault | StatusForceSaturated | StatusPositionSaturated;
    std::uint16_t seen = 0;
    for (const Sample& sample : evidence.samples)
        seen = static_cast<std::uint16_t>(seen | (sample.status & wrong));
    out.limit = Words::tr("no fault, nothing saturated");
    out.figure = seen == 0 ? u"none"_qs : protocol::statusWords(seen);
    if (!evidence.samples.empty())
        judge(out, seen == 0,
              Words::tr("Open the gripper and take out what it holds; if it stays, it needs service."));
    return out;
}

SelfTestLine forceNoiseLine(const SelfTestEvidence& evidence)
{
    const GripperIdentity& identity = evidence.identity;
    std::optional<double> range;
    if (const std::optional<double> newtons = newtonsPer(identity.forceUnit))
        range = identity.limits.maxForce_N / *newtons;
    return noiseLine(line(u"force_noise"_qs, Words::tr("Force at rest")), evidence, &Sample::force,
                     identity.forceUnit, range);
}

SelfTestLine positionNoiseLine(const SelfTestEvidence& evidence)
{
    const GripperIdentity& identity = evidence.identity;
    std::optional<double> range;
    if (const std::optional<double> metres = metresPer(identity.positionUnit))
        range = identity.limits.maxTravel_m / *metres;
    return noiseLine(line(u"position_noise"_qs, Words::tr("Position at rest")), evidence, &Sample::position,
                     identity.positionUnit, range);
}

SelfTestLine stopLine(const SelfTestEvidence& evidence)
{
    SelfTestLine out = line(u"stop"_qs, Words::tr("Stop"));
    if (!evidence.identity.commandable) {
        out.figure = Words::tr("this gripper takes no commands");
        return out;
    }
    out.limit = Words::tr("answered within %1 ms").arg(1000 * stopPatience_s);
    out.value = evidence.stopAnswered_s;
    out.figure = evidence.stopAnswered_s
                     ? Words::tr("answered in %1 ms").arg(figure(1000 * *evidence.stopAnswered_s, 2))
                     : Words::tr("no answer");
    judge(
        out, evidence.stopAnswered_s && *evidence.stopAnswered_s <= stopPatience_s,
        Words::tr("Do not squeeze with this gripper until it answers: check the cable, then its firmware."));
    return out;
}

} // namespace gripscope
