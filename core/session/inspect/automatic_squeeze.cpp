// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/automatic_squeeze.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gripscope {

namespace {

/// A whole period of the mains' hum, and enough samples for a standard deviation.
constexpr double block_s = 0.02;
constexpr int leastSamples = 8;
constexpr double learn_s = 1;
constexpr std::size_t learnBlocks = 10;
constexpr std::size_t fallBlocks = 3; ///< that kept still before a fall
/// How fast the level and the noise at rest follow.
constexpr double levelFollows_s = 1, noiseFollows_s = 10;
constexpr double still_s = 0.3, gone_s = 0.5;
/// Longer without samples is blind; longer without a step is a screen that showed no countdown.
constexpr double longestSilence_s = 0.25, longestPause_s = 0.5;
constexpr double rounding_s = 1e-9; ///< of times that are added up

} // namespace

double AutomaticSqueeze::threshold(double variance) const
{
    return std::max(m_options.touchTimes * std::sqrt(variance), m_options.leastTouch);
}

bool AutomaticSqueeze::permits(const Conditions& conditions) const
{
    return conditions.armed && conditions.allowed && !conditions.squeezing && !m_stopped;
}

void AutomaticSqueeze::reset()
{
    m_newest.reset();
    m_count = 0;
    beginLearning(false);
}

void AutomaticSqueeze::interrupt()
{
    if (m_state == State::Settling || m_state == State::Counting)
        occupy();
}

void AutomaticSqueeze::stop()
{
    m_stopped = true;
    interrupt();
}

void AutomaticSqueeze::take(const Reading& reading)
{
    if (!std::isfinite(reading.force) || !std::isfinite(reading.time_s))
        return noteLoss();
    if (m_newest && (reading.sequence <= m_newest->sequence || reading.time_s <= m_newest->time_s))
        reset(); // it counts anew
    else if (m_newest && reading.sequence > m_newest->sequence + 1)
        noteLoss();
    m_newest = reading;
    m_fresh = true;
    if (reading.moving) {
        m_count = 0;
        return occupy();
    }
    if (m_count >= leastSamples && reading.time_s - m_first_s >= block_s - rounding_s)
        close(reading.time_s);
    if (m_count == 0) {
        m_first_s = reading.time_s;
        m_origin = reading.force;
        m_sum = m_squares = 0;
    }
    const double from = reading.force - m_origin;
    m_sum += from;
    m_squares += from * from;
    ++m_count;
}

/// The block that is open ends where the next begins.
void AutomaticSqueeze::close(double until_s)
{
    const double mean = m_sum / m_count;
    const double variance = std::max(0.0, (m_squares - m_count * mean * mean) / (m_count - 1));
    m_count = 0;
    takeBlock({m_origin + mean, variance, until_s - m_first_s});
}

void AutomaticSqueeze::takeBlock(const Block& block)
{
    if (m_state == State::Learning)
        return learn(block);
    const double touch = threshold(m_variance);
    if (block.mean < m_rest - touch)
        return beginLearning(false); // the jaws were not empty, and are now
    const bool atRest = block.mean <= m_rest + touch / 2;
    switch (m_state) {
    case State::Learning:
        break;
    case State::Waiting:
        if (block.mean > m_rest + touch) {
            if (m_permitted)
                settle(block.mean);
            else
                occupy();
            break;
        }
        m_rest += std::min(1.0, block.seconds / levelFollows_s) * (block.mean - m_rest);
        m_variance += std::min(1.0, block.seconds / noiseFollows_s) * (block.variance - m_variance);
        break;
    case State::Settling:
    case State::Counting:
        if (atRest)
            m_state = State::Waiting; // it bounced, or left
        else if (m_anchor && std::abs(block.mean - *m_anchor) <= touch)
            stayStill(block);
        else if (m_state == State::Counting)
            occupy(); // a hand may be there that was not
        else
            settle(block.mean);
        break;
    case State::Occupied: {
        m_highest = std::max(m_highest, block.mean);
        // The rest may have drifted while it was hidden; below the threshold is no part, once one has left.
        const bool gone = atRest || (block.mean <= m_rest + touch && block.mean < m_highest - touch);
        m_left_s = gone && !m_occupied ? m_left_s + block.seconds : 0;
        if (m_left_s >= gone_s - rounding_s)
            m_state = State::Waiting;
        break;
    }
    }
}

/// Of one after the other.
AutomaticSqueeze::Block AutomaticSqueeze::together(const std::vector<Block>& blocks)
{
    Block all;
    for (const Block& one : blocks) {
        all.mean += one.mean / static_cast<double>(blocks.size());
        all.variance += one.variance / static_cast<double>(blocks.size());
        all.seconds += one.seconds;
    }
    return all;
}

void AutomaticSqueeze::learn(const Block& block)
{
    const Block before = together(m_learned);
    // What was squeezed leaves before the rest is known: at once, where a part that yields does so slowly.
    if (m_learned.size() >= fallBlocks && block.mean < before.mean - threshold(before.variance))
        m_occupied = false;
    m_learned.push_back(block);
    const auto [mean, variance, seconds] = together(m_learned);
    const double touch = threshold(variance);
    const auto isStill = [mean = mean, touch](const Block& one) {
        return std::abs(one.mean - mean) <= touch / 2;
    };
    if (!std::all_of(m_learned.begin(), m_learned.end(), isStill)) {
        m_learned.assign(1, block);
        return;
    }
    if (seconds < learn_s - rounding_s || m_learned.size() < learnBlocks)
        return;
    m_learned.clear();
    if (touch <= 0)
        return; // neither noise nor a limit: nothing tells a part from none
    m_rest = mean;
    m_variance = variance;
    m_left_s = 0;
    m_highest = mean;
    m_state = m_occupied ? State::Occupied : State::Waiting;
}

void AutomaticSqueeze::beginLearning(bool occupied)
{
    m_state = State::Learning;
    m_occupied = occupied;
    m_learned.clear();
}

void AutomaticSqueeze::settle(std::optional<double> anchor)
{
    m_state = State::Settling;
    m_anchor = anchor;
    m_still_s = 0;
}

/// What the force is to stay at is its mean while it settled; a part arrives amid the first block.
void AutomaticSqueeze::stayStill(const Block& block)
{
    m_still_s += block.seconds;
    if (m_state == State::Settling)
        *m_anchor += block.seconds / m_still_s * (block.mean - *m_anchor);
}

void AutomaticSqueeze::occupy()
{
    m_left_s = 0;
    m_highest = m_rest;
    if (m_state == State::Learning)
        return beginLearning(true);
    m_state = State::Occupied;
}

void AutomaticSqueeze::noteLoss()
{
    m_count = 0;
    m_left_s = 0;
    if (m_state == State::Settling || m_state == State::Counting)
        settle({});
}

AutomaticSqueeze::Decision AutomaticSqueeze::step(double now_s, const Conditions& conditions)
{
    if (std::exchange(m_fresh, false))
        m_lastSample_s = now_s;
    const bool unseen = now_s - std::exchange(m_lastStep_s, now_s) > longestPause_s;
    if (conditions.armed && !m_armed) { // by a person: nothing else arms
        m_stopped = false;
        if (m_state != State::Waiting)
            beginLearning(false); // what is there now is nothing that arrived
    }
    m_armed = conditions.armed;
    m_permitted = permits(conditions);
    if (conditions.squeezing)
        occupy();
    else if (!m_permitted)
        interrupt();
    Decision decision;
    if (m_state == State::Counting && (unseen || now_s - m_lastSample_s > longestSilence_s))
        settle({});
    if (m_state == State::Settling && m_still_s >= still_s - rounding_s) {
        m_state = State::Counting;
        m_until_s = now_s + m_options.countdown_s;
    }
    if (m_state == State::Counting && now_s >= m_until_s - rounding_s) {
        occupy();
        decision.squeeze = true;
    } else if (m_state == State::Counting) {
        decision.remaining_s = std::min(m_until_s - now_s, m_options.countdown_s); // never a rounding more
    }
    decision.state = m_state;
    decision.waitsForPerson = m_stopped;
    return decision;
}

} // namespace gripscope
