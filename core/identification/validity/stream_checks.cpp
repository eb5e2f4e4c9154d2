// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/identification/validity/validity_checks.h"
#include "core/signal/preparation/preparation.h"
#include "core/signal/recording/stream_account.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A crystal keeps time to 100 ppm, a resonator to 5,000.
constexpr double suspectClock_ppm = 1000, invalidClock_ppm = 10000;
/// More jumps of the clock than this, and in more than this share of the samples, are no accident.
constexpr std::uint64_t fewJumps = 5;
constexpr double largestShareOfJumps = 0.01;

/// Steps of the device's clock: found in the samples' times, or known from the stream where they do not show.
std::uint64_t clockSteps(const Identification& data, const StreamAccount& stream)
{
    double breaks = 0;
    for (const PreparationStep& step : data.preparation)
        if (step.id == u"clock_break"_s)
            breaks = std::max(breaks, step.value);
    return std::max(stream.clockSteps, static_cast<std::uint64_t>(breaks));
}

Finding lossWords(const Identification& data, bool tooMuch)
{
    const WindowChoice& choice = data.choice;
    const Finding missing =
        Words::say("%1 samples are missing in %2 places").arg(choice.lostSamples).arg(choice.gaps);
    if (tooMuch)
        return missing +
               Words::say(", too much of the squeeze. Check the cable and the load of the computer, then "
                          "squeeze again.");
    if (const Estimate* const best = data.best(); best && best->part.count < data.position.size())
        return missing +
               Words::say(". The estimate (%1) is of the longest stretch without any, %2 of %3 samples; oe "
                          "uses all. Check the cable and the load of the computer.")
                   .arg(toString(best->estimator))
                   .arg(best->part.count)
                   .arg(data.position.size());
    return missing +
           Words::say(". Their forces count as unknown, which the errors include. Check the cable and the "
                      "load of the computer.");
}

Finding clockWords(std::uint64_t steps)
{
    return Words::say(
               "the gripper's clock jumped %1 times during the squeeze, so how long things took is in doubt. "
               "Squeeze again; where it happens again, check the gripper's power supply and firmware.")
        .arg(steps);
}

Finding stallWords(const StreamAccount& stream)
{
    return Words::
        say("the gripper fell silent %1 times during the squeeze, for up to %2 s. Check its cable and hub, "
            "then squeeze again.")
            .arg(stream.stalls)
            .arg(stream.longestStall_s, 'g', 2);
}

/// The clock and the sample count do not go together at all.
bool contradictsEverywhere(const Identification& data, const Recording& recording)
{
    const std::uint64_t steps = clockSteps(data, streamAccount(recording).value_or(StreamAccount()));
    return steps > fewJumps &&
           static_cast<double>(steps) > largestShareOfJumps * static_cast<double>(recording.size());
}

/// The value of "fast by" in percent or ppm, whichever reads better.
Finding inWords(double ppm)
{
    const double size = std::abs(ppm);
    return size >= 1000 ? Words::say("%1 %").arg(1e-4 * size, 'g', 2)
                        : Words::say("%1 ppm").arg(size, 'f', 0);
}

/// m goes with the square of time.
Finding effectOn_m(double ppm)
{
    const double rate = 1 + 1e-6 * ppm;
    return Finding::number(100 * std::abs(rate * rate - 1), 'g', 2);
}

/// Judges by what is known; false where nothing is.
bool judgeRate(ValidityCheck& check, const std::optional<RateDifference>& rate)
{
    check.limit = suspectClock_ppm;
    if (!rate)
        return false;
    check.value = rate->ppm;
    check.ok = !rate->beyond(suspectClock_ppm);
    check.decisive = rate->beyond(invalidClock_ppm);
    return true;
}

/// How much the device's own stamps differ from the sample time that is stated, as a share; 0: not so much
/// that it counts.
double stampedDrift(const Identification& data)
{
    for (const PreparationStep& step : data.preparation)
        if (step.id == u"clock_drift"_s && !step.ok)
            return step.value;
    return 0;
}

/// `stated`: what the stamps make of it is in `drift`.
Finding stampWords(double stated_s, double drift)
{
    return Words::say("the sample time that the gripper states, %1 ms, does not hold: its time stamps come "
                      "every %2 ms, and m, b and k are wrong. Correct the stated sample time, then squeeze "
                      "again.")
        .arg(Finding::number(1e3 * stated_s, 'g', 4), Finding::number(1e3 * stated_s * (1 + drift), 'g', 4));
}

Finding jumpWords(double stated_s, std::uint64_t steps)
{
    return Words::say("the sample time that the gripper states, %1 ms, does not hold: its clock contradicts "
                      "its sample count %2 times, and m, b and k are wrong. Correct the stated sample time, "
                      "then squeeze again.")
        .arg(1e3 * stated_s, 'g', 4)
        .arg(steps);
}

Finding countWords(double stated_s, double ppm)
{
    const Finding stated = Finding::number(1e3 * stated_s, 'g', 4);
    const Finding words =
        ppm > 0
            ? Words::say("the sample time that the gripper states, %1 ms, does not hold: by the computer's "
                         "clock its samples come %2 too often, and m is off by about %3 %. Correct the "
                         "stated sample time, then squeeze again.")
            : Words::say("the sample time that the gripper states, %1 ms, does not hold: by the computer's "
                         "clock its samples come %2 too seldom, and m is off by about %3 %. Correct the "
                         "stated sample time, then squeeze again.");
    return words.arg(stated, inWords(ppm), effectOn_m(ppm));
}

} // namespace

ValidityCheck samplesLost(const Identification& data, const Recording& recording)
{
    ValidityCheck check;
    check.id = u"samples_lost"_s;
    const WindowChoice& choice = data.choice;
    const StreamAccount stream = streamAccount(recording).value_or(StreamAccount());
    const std::uint64_t steps = contradictsEverywhere(data, recording) ? 0 : clockSteps(data, stream);
    const bool lost = choice.lostSamples != 0 || choice.gaps != 0;
    check.value = static_cast<double>(choice.lostSamples);
    check.limit = 0;
    const bool unseen = recording.provenance.contains(unseenLossesKey());
    check.ok = !lost && steps == 0 && !(unseen && stream.stalls > 0);
    // What was measured of the squeeze and used, against all of it.
    const double whole = static_cast<double>(choice.eligible) + static_cast<double>(choice.lostSamples);
    const double used = static_cast<double>(data.position.size()) - static_cast<double>(data.lost.size());
    check.decisive = whole > 0 && 1 - used / whole > PreparationOptions().largestLostShare;
    Findings words;
    if (steps > 0)
        words.push_back(clockWords(steps));
    if (stream.stalls > 0)
        words.push_back(stallWords(stream));
    if (lost)
        words.push_back(lossWords(data, check.decisive));
    if (check.ok && unseen)
        words.push_back(Words::say(
            "whether samples are missing cannot be seen: the gripper sends neither a number nor a clock"));
    else if (check.ok) // a silence that took nothing with it delays the numbers, and changes none
        words.insert(words.begin(), stream.stalls > 0 ? Words::say("no sample is missing, though")
                                                      : Words::say("no sample is missing"));
    check.message = Finding::joined(words, u" "_s);
    return check;
}

ValidityCheck clockAgainstComputer(const Recording& recording)
{
    ValidityCheck check;
    check.id = u"clock"_s;
    const ClockAccount clocks = streamAccount(recording).value_or(StreamAccount()).clocks;
    if (!judgeRate(check, clocks.clock)) {
        check.noted = true;
        check.message =
            clocks.compared
                ? Words::say(
                      "not judged yet: the connection is too young to hold the gripper's clock against "
                      "the computer's")
                : Words::say("not judged: the recording does not tell how the gripper's clock ran beside a "
                             "computer's");
        return check;
    }
    const RateDifference& rate = *clocks.clock;
    if (check.ok) {
        check.message =
            Words::say("the gripper's clock and the computer's differ by %1 ± %2 ppm")
                .arg(Finding::number(rate.ppm, 'f', 0), Finding::number(rate.uncertainty_ppm, 'f', 0));
        return check;
    }
    const Finding words =
        rate.ppm > 0 ? Words::say("the gripper's clock is %1 fast beside the computer's: m is off by "
                                  "about %2 %. Have its clock mended, then squeeze again.")
                     : Words::say("the gripper's clock is %1 slow beside the computer's: m is off by "
                                  "about %2 %. Have its clock mended, then squeeze again.");
    check.message = words.arg(inWords(rate.ppm), effectOn_m(rate.ppm));
    return check;
}

ValidityCheck statedSampleTime(const Identification& data, const Recording& recording)
{
    ValidityCheck check;
    check.id = u"sample_time"_s;
    const StreamAccount stream = streamAccount(recording).value_or(StreamAccount());
    const bool judged = judgeRate(check, stream.clocks.sampling);
    if (const double drift = stampedDrift(data); drift != 0) {
        check.value = -1e6 * drift / (1 + drift);
        check.ok = false;
        check.decisive = true;
        check.message = stampWords(recording.sampleTime_s, drift);
    } else if (contradictsEverywhere(data, recording)) {
        check.ok = false;
        check.decisive = true;
        check.message = jumpWords(recording.sampleTime_s, clockSteps(data, stream));
    } else if (!check.ok && stream.clocks.clock &&
               stream.clocks.clock->beyond(check.decisive ? invalidClock_ppm : suspectClock_ppm)) {
        check.ok = true;
        check.decisive = false;
        check.message = Words::say("the samples come as often as the gripper's own clock says, which is off");
    } else if (!check.ok) {
        check.message = countWords(recording.sampleTime_s, stream.clocks.sampling->ppm);
    } else {
        check.message = judged ? Words::say("the samples come as often as the gripper states")
                               : Words::say("the samples come as often as the time stamps say");
    }
    return check;
}

} // namespace gripscope
