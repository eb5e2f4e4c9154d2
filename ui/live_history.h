// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/gripper_port.h"
#include "core/signal/decimation.h"

#include <cstddef>
#include <vector>

namespace gripscope {

/// The last ten minutes of samples in bounded memory, read as min/max columns so that drawing costs what the width
/// of the plot costs, whatever the time shown.
class LiveHistory {
public:
    explicit LiveHistory(double seconds = 600, double sampleTime_s = 0.0005);

    void reset(double sampleTime_s);
    void append(const std::vector<Sample>& samples);

    enum class Channel { Force, Position };
    /// The last `seconds`, at most two points a column; x is seconds relative to `until_s` (<= 0). Gaps in the device's
    /// time stay gaps.
    [[nodiscard]] std::vector<PlotPoint> columns(Channel channel, double until_s, double seconds,
                                                 std::size_t columns) const;
    [[nodiscard]] double newestTime_s() const;
    [[nodiscard]] bool empty() const;

private:
    struct Bin {
        double time_s = 0;
        float low[2]{}, high[2]{};
    };
    /// A ring of bins at one resolution; each level covers twice the time per bin of the one below.
    struct Level {
        std::vector<Bin> ring;
        std::size_t first = 0, count = 0;
        Bin open;
        int filled = 0;
    };
    void push(std::size_t level, const Bin& bin);

    std::vector<Level> m_levels;
    double m_sampleTime_s;
    double m_seconds;
    double m_newest_s = 0;
};

} // namespace gripscope
