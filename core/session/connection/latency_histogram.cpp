// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/latency_histogram.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {
constexpr double linearWidth_ms = 0.25;
constexpr double linearEnd_ms = 64;
constexpr double growth = 1.125;

std::int64_t secondOf(LatencyHistogram::TimePoint t)
{
    return std::chrono::duration_cast<std::chrono::seconds>(t.time_since_epoch()).count();
}
} // namespace

std::size_t LatencyHistogram::binOf(double milliseconds)
{
    if (!(milliseconds > 0))
        return 0;
    if (milliseconds < linearEnd_ms)
        return static_cast<std::size_t>(milliseconds / linearWidth_ms);
    const double beyond = std::log(milliseconds / linearEnd_ms) / std::log(growth);
    return linearBins +
           static_cast<std::size_t>(std::min(beyond, static_cast<double>(bins - linearBins - 1)));
}

double LatencyHistogram::upperEnd_ms(std::size_t bin)
{
    if (bin < linearBins)
        return linearWidth_ms * static_cast<double>(bin + 1);
    return linearEnd_ms * std::pow(growth, static_cast<double>(bin - linearBins + 1));
}

void LatencyHistogram::add(double milliseconds, TimePoint now, std::uint32_t times)
{
    const std::int64_t second = secondOf(now);
    Slot& slot = m_slots[static_cast<std::size_t>(second) % seconds];
    if (slot.second != second) {
        slot.second = second;
        slot.counts.fill(0);
    }
    slot.counts[binOf(milliseconds)] += times;
}

double LatencyHistogram::quantile_ms(double share, TimePoint now) const
{
    const std::int64_t oldest = secondOf(now) - static_cast<std::int64_t>(seconds) + 1;
    std::array<std::uint64_t, bins> sum{};
    std::uint64_t all = 0;
    for (const Slot& slot : m_slots) {
        if (slot.second < oldest)
            continue;
        for (std::size_t bin = 0; bin < bins; ++bin) {
            sum[bin] += slot.counts[bin];
            all += slot.counts[bin];
        }
    }
    if (all == 0)
        return 0;
    const double wanted = share * static_cast<double>(all);
    std::uint64_t below = 0;
    for (std::size_t bin = 0; bin < bins; ++bin) {
        below += sum[bin];
        if (static_cast<double>(below) >= wanted)
            return upperEnd_ms(bin);
    }
    return upperEnd_ms(bins - 1);
}

} // namespace gripscope
