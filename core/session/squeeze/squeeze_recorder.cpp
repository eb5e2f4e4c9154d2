// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/squeeze_recorder.h"

#include "core/signal/recording/recording_limits.h"
#include "core/signal/recording/stream_account.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// A long recording grows as it comes: who asks for it has not sent it yet.
constexpr std::size_t reservedAtOnce = 65'536;

/// From the marks of the samples; those of the first tell of what was before it.
StreamAccount accountOf(const std::vector<Sample>& samples)
{
    StreamAccount account;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const Sample& sample = samples[i];
        const std::uint64_t before = samples[i - 1].sequence;
        if (sample.sequence > before + 1) {
            account.lostSamples += sample.sequence - before - 1;
            ++account.gaps;
        }
        account.duplicateReports += sample.duplicates;
        account.badReports += sample.badReports;
        account.clockSteps += sample.clockStepped ? 1 : 0;
        account.stalls += sample.stall_ms > 0 ? 1 : 0;
        account.longestStall_s = std::max(account.longestStall_s, 1e-3 * sample.stall_ms);
    }
    return account;
}

} // namespace

void SqueezeRecorder::begin(Mode mode, std::size_t samples, double sampleTime_s)
{
    *this = {};
    m_mode = mode;
    m_wanted = std::min(samples, mostSamples);
    m_sampleTime_s = isSampleTime(sampleTime_s) ? sampleTime_s : longestSampleTime_s;
    m_margin = static_cast<std::size_t>(std::max(1.0, std::round(margin_s / m_sampleTime_s)));
    m_samples.reserve(std::min(m_wanted + 2 * m_margin, reservedAtOnce));
}

void SqueezeRecorder::take(const std::vector<Sample>& batch)
{
    for (const Sample& sample : batch) {
        if (complete())
            return;
        take(sample);
    }
}

void SqueezeRecorder::take(const Sample& sample)
{
    if (m_mode == Mode::Movement)
        return takeMovement(sample);
    m_samples.push_back(sample);
    // By the device's clock, so that lost samples do not make the recording longer.
    const double heard_s = sample.time_s - m_samples.front().time_s + m_sampleTime_s;
    if (heard_s > (static_cast<double>(m_wanted) - 0.5) * m_sampleTime_s || m_samples.size() >= mostSamples)
        m_phase = Phase::Complete;
}

void SqueezeRecorder::takeMovement(const Sample& sample)
{
    const bool moving = sample.status & StatusMoving;
    m_armed = m_armed || moving || (sample.status & StatusArmed);
    if (m_armed)
        m_statusSeen |= sample.status;
    if (m_phase == Phase::Before && !moving) {
        if (m_samples.size() >= m_margin)
            m_samples.erase(m_samples.begin());
        m_samples.push_back(sample);
        return;
    }
    if (m_phase == Phase::Before) {
        m_phase = Phase::Moving;
        m_firstMoving_s = m_lastMoving_s = sample.time_s;
    }
    m_samples.push_back(sample);
    if (m_samples.size() >= mostSamples) // it moves for ever
        m_phase = Phase::Complete;
    else if (m_phase == Phase::Moving && moving)
        m_lastMoving_s = sample.time_s;
    else
        m_phase = ++m_after >= m_margin ? Phase::Complete : Phase::After;
}

double SqueezeRecorder::movingSeconds() const
{
    return moved() ? m_lastMoving_s - m_firstMoving_s + m_sampleTime_s : 0;
}

double SqueezeRecorder::progress() const
{
    if (m_samples.empty() || m_wanted == 0)
        return 0;
    const double heard_s =
        m_mode == Mode::Movement ? movingSeconds() : m_samples.back().time_s - m_samples.front().time_s;
    return std::clamp(heard_s / (static_cast<double>(m_wanted) * m_sampleTime_s), 0.0, 1.0);
}

void SqueezeRecorder::moveTo(Recording& recording, const ClockAccount& clocks)
{
    // One that is cut out of a capture says already what befell it when it was made.
    if (!m_samples.empty() && !recording.provenance.contains(streamAccountKey())) {
        StreamAccount account = accountOf(m_samples);
        account.clocks = clocks;
        recording.provenance[streamAccountKey()] = toText(account);
    }
    for (const Sample& sample : m_samples) {
        recording.time_s.push_back(sample.time_s);
        recording.force.push_back(sample.force);
        recording.position.push_back(sample.position);
        recording.sequence.push_back(sample.sequence);
        recording.status.push_back(sample.status);
    }
    m_samples.clear();
}

} // namespace gripscope
