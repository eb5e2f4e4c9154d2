// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/gripper_port.h"
#include "core/signal/decimation.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace gripscope {

/// The last ten minutes of samples in bounded memory, read as min/max columns so that drawing costs what the
/// width of the plot costs, whatever the time shown.
class LiveHistory {
public:
    explicit LiveHistory(double seconds = 600, double sampleTime_s = 0.0005);

    void reset(double sampleTime_s);
    void append(const std::vector<Sample>& samples);

    enum class Channel { Force, Position };
    /// A stretch without a gap, to be drawn as one line.
    using Stretch = std::vector<PlotPoint>;
    /// The last `seconds`, at most two points a column (lowest, highest); x is seconds relative to `until_s`
    /// (<= 0). Columns stand at fixed device times, so that a scrolling picture does not flicker. A gap in
    /// the device's time that is wider than a column starts a new stretch.
    [[nodiscard]] std::vector<Stretch> columns(Channel channel, double until_s, double seconds,
                                               std::size_t columns) const;
    /// Where samples are missing or the device's clock jumped, oldest first, as far as the last 512 reach; x
    /// as above.
    struct Gap {
        double begin = 0, end = 0;
    };
    [[nodiscard]] std::vector<Gap> gaps(double until_s, double seconds) const;
    [[nodiscard]] double sampleTime_s() const { return m_sampleTime_s; }
    [[nodiscard]] double newestTime_s() const;
    [[nodiscard]] bool empty() const;

private:
    struct Bin {
        double begin_s = 0, end_s = 0; ///< times of its first and last sample
        float low[2]{}, high[2]{};
        void merge(const Bin& later);
    };
    /// A ring of bins at one resolution; each level covers twice the time per bin of the one below.
    struct Level {
        std::vector<Bin> ring;
        std::size_t first = 0, count = 0;
        std::optional<Bin> open; ///< half of a bin: waits for its other half from the level below
        void append(const Bin& bin);
        [[nodiscard]] const Bin& at(std::size_t i) const { return ring[(first + i) % ring.size()]; }
    };
    void push(Bin bin);
    [[nodiscard]] std::size_t levelFor(double seconds) const;
    class Columns;

    void noteGap(const Sample& sample);

    std::vector<Level> m_levels;
    std::deque<Gap> m_gaps; ///< device's times
    std::uint64_t m_newestSequence = 0;
    double m_sampleTime_s;
    double m_seconds;
    double m_newest_s = 0;
};

} // namespace gripscope
