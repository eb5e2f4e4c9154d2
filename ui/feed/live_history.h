// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "core/signal/preparation/decimation.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace gripscope {

/// The last ten minutes of samples in bounded memory: the newest minute sample by sample, all of it as
/// lowest, highest and mean values of ever longer stretches. Drawing costs what the width of the plot costs,
/// whatever the time shown.
class LiveHistory {
public:
    /// Kept sample by sample; squeezes last seconds.
    static constexpr double fullRateSeconds = 60;

    explicit LiveHistory(double seconds = 600, double sampleTime_s = 0.0005);

    void reset(double sampleTime_s);
    /// `commandedForce`: in the unit of the force, one for each sample, or none at all.
    void append(const std::vector<Sample>& samples,
                std::span<const std::optional<double>> commandedForce = {});

    enum class Channel { Force, Position, CommandedForce };
    /// The lowest or highest value of a column, with the mean of all that are in it; not a number: unknown.
    struct Point : PlotPoint {
        double mean = std::numeric_limits<double>::quiet_NaN();
    };
    /// A stretch without a gap, to be drawn as one line.
    using Stretch = std::vector<Point>;
    /// The `seconds` up to `until_s`, at most two points a column (lowest, highest); x is seconds relative to
    /// `until_s` (<= 0). Columns stand at fixed device times, so that a scrolling picture does not flicker. A
    /// gap in the device's time that is wider than a column starts a new stretch.
    [[nodiscard]] std::vector<Stretch> columns(Channel channel, double until_s, double seconds,
                                               std::size_t columns) const;
    /// Where samples are missing or the device's clock jumped, oldest first, as far as the last 512 reach; x
    /// as above.
    struct Gap {
        double begin = 0, end = 0;
    };
    [[nodiscard]] std::vector<Gap> gaps(double until_s, double seconds) const;

    /// The lowest and highest value of the shortest stretch that is still known around a time: of one sample
    /// where it is kept at full rate. Nothing where nothing was measured.
    struct Reading {
        double low = 0, high = 0;
        [[nodiscard]] double middle() const { return (low + high) / 2; }
    };
    [[nodiscard]] std::optional<Reading> reading(Channel channel, double time_s) const;
    /// The samples from `from_s` to `until_s` that are still kept one by one, oldest first.
    [[nodiscard]] std::vector<Sample> samples(double from_s, double until_s) const;
    /// The sample nearest to a time, as far as they are kept one by one.
    [[nodiscard]] std::optional<Sample> sampleAt(double time_s) const;

    [[nodiscard]] double sampleTime_s() const { return m_sampleTime_s; }
    [[nodiscard]] double newestTime_s() const;
    [[nodiscard]] double oldestTime_s() const;         ///< of what can be shown
    [[nodiscard]] double oldestFullRateTime_s() const; ///< of what is kept sample by sample
    [[nodiscard]] bool empty() const;
    /// How often it began anew: another gripper, or one that counts from zero again.
    [[nodiscard]] int beginnings() const { return m_beginnings; }

private:
    static constexpr int channels = 3;
    struct Bin {
        double begin_s = 0, end_s = 0; ///< times of its first and last sample
        /// A channel without a value: the lowest above the highest.
        std::array<float, channels> low = filled(std::numeric_limits<float>::infinity());
        std::array<float, channels> high = filled(-std::numeric_limits<float>::infinity());
        std::array<float, channels> mean = filled(0);
        std::array<std::uint32_t, channels> count{}; ///< samples with a value
        void merge(const Bin& later);
        static constexpr std::array<float, channels> filled(float value) { return {value, value, value}; }
    };
    template <typename Item>
    struct Ring {
        std::vector<Item> items;
        std::size_t first = 0, count = 0;
        void append(const Item& item);
        [[nodiscard]] const Item& at(std::size_t i) const { return items[(first + i) % items.size()]; }
        [[nodiscard]] bool forgot() const { return count == items.size(); }
    };
    struct Kept {
        Sample sample;
        std::optional<float> commandedForce;
    };
    /// Bins at one resolution; each level covers twice the time per bin of the one below. Level 0 would be
    /// the samples themselves.
    struct Level {
        Ring<Bin> bins;
        std::optional<Bin> open; ///< half of a bin: waits for its other half from the level below
    };
    [[nodiscard]] static Bin binOf(const Kept& kept);
    [[nodiscard]] std::size_t binCount(std::size_t level) const;
    [[nodiscard]] Bin bin(std::size_t level, std::size_t i) const;
    [[nodiscard]] std::size_t firstBinFrom(std::size_t level, double from_s) const;
    void push(Bin bin);
    [[nodiscard]] bool reaches(std::size_t level, double time_s) const;
    [[nodiscard]] std::size_t levelFor(double from_s, double column_s) const;
    class Columns;

    void noteGap(const Sample& sample);

    Ring<Kept> m_samples;
    std::vector<Level> m_levels; ///< from level 1 on
    std::deque<Gap> m_gaps;      ///< device's times
    std::uint64_t m_newestSequence = 0;
    double m_sampleTime_s;
    double m_seconds;
    double m_newest_s = 0;
    int m_beginnings = 0;
};

} // namespace gripscope
