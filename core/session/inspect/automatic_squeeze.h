// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace gripscope {

struct AutomaticSqueezeOptions {
    /// The force has changed when the mean of a block is so many standard deviations of one sample at rest
    /// away.
    double touchTimes = 8;
    /// Nor less than this, in the unit of the samples: a sensor that shows no noise says nothing of small
    /// changes.
    double leastTouch = 0;
    double countdown_s = 2;
};

/// Decides when a part that arrived is squeezed without a key, from nothing but samples, times and what is
/// allowed: no clock, no gripper, no screen. Whoever owns it squeezes, by the way that a key takes.
///
///     Learning -> Waiting -> Settling -> Counting -> (squeeze) -> Occupied -> Waiting ...
///
/// Forces are looked at in blocks of 20 ms. Learning: until the force was at rest for a second, which gives
/// its level and its noise. Waiting: the level follows slow drift; a block above it by more than the
/// threshold is a part that touches. Settling: until the force kept still for 0.3 s. Counting: for
/// countdown_s; any change of the force ends it, Occupied; a lost sample goes back to Settling, so that a
/// whole countdown follows it. Occupied: what is there must leave, which is the force back at rest for 0.5 s;
/// a part that was squeezed before the rest was known leaves by a sudden fall.
///
/// What arrives while it is not allowed, and what a person has ended, is Occupied: only a part that came
/// since is counted down. A force that falls below rest means that the jaws were not empty: it is learned
/// anew.
class AutomaticSqueeze {
public:
    struct Reading {
        std::uint64_t sequence = 0; ///< a step of more than one: samples were lost
        double time_s = 0;          ///< the device's
        double force = 0;           ///< what presses is above zero
        bool moving = false;        ///< a squeeze is under way
    };
    struct Conditions {
        bool armed = false;
        bool allowed = false; ///< it is wanted, a person sees it, and a key would squeeze
        bool squeezing = false;
    };
    enum class State { Learning, Waiting, Settling, Counting, Occupied };
    struct Decision {
        State state = State::Learning;
        double remaining_s = 0;      ///< of a countdown
        bool squeeze = false;        ///< now; said once
        bool waitsForPerson = false; ///< stopped: a person is to squeeze or to arm first
    };

    explicit AutomaticSqueeze(const AutomaticSqueezeOptions& options = {}) : m_options(options) {}
    void setOptions(const AutomaticSqueezeOptions& options) { m_options = options; }

    void take(const Reading& reading);
    /// A click, a key, a dialog: ends a countdown, and what is there must leave.
    void interrupt();
    /// Nothing by itself from now on, until a person armed the gripper anew or squeezed.
    void stop();
    void squeezedByHand() { m_stopped = false; }
    /// Another link's samples follow. What a person stopped stays so.
    void reset();
    /// To be called every few milliseconds, behind the samples that came. `now_s`: of any clock that only
    /// goes on.
    [[nodiscard]] Decision step(double now_s, const Conditions& conditions);

private:
    struct Block {
        double mean = 0, variance = 0, seconds = 0;
    };
    void close(double until_s);
    void takeBlock(const Block& block);
    [[nodiscard]] static Block together(const std::vector<Block>& blocks);
    void learn(const Block& block);
    void beginLearning(bool occupied);
    void settle(std::optional<double> anchor);
    void stayStill(const Block& block);
    void occupy();
    void noteLoss();
    [[nodiscard]] double threshold(double variance) const;
    [[nodiscard]] bool permits(const Conditions& conditions) const;

    AutomaticSqueezeOptions m_options;
    State m_state = State::Learning;
    bool m_stopped = false, m_armed = false;
    bool m_permitted = false; ///< at the last step
    bool m_fresh = false;     ///< samples came since
    double m_lastStep_s = 0, m_lastSample_s = 0, m_until_s = 0;

    std::optional<Reading> m_newest;
    double m_first_s = 0, m_origin = 0, m_sum = 0, m_squares = 0; ///< of the block that is open
    int m_count = 0;

    std::vector<Block> m_learned;
    bool m_occupied = false; ///< squeezed before the rest was known: only a fall tells that it left
    double m_rest = 0, m_variance = 0;
    std::optional<double> m_anchor; ///< the force that is to keep still
    double m_still_s = 0, m_left_s = 0;
    double m_highest = 0; ///< the force since it was occupied
};

} // namespace gripscope
