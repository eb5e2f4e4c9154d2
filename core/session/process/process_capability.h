// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/charts/box_cox.h"
#include "core/quality/charts/percentile_capability.h"
#include "core/session/process/process_chart.h"

#include <map>
#include <memory>
#include <mutex>

namespace gripscope {

/// How often values fall between equally wide places.
struct ValueHistogram {
    double first = 0, width = 1; ///< where the first bar begins
    std::vector<qint64> counts;
};
/// About sqrt(n) bars, 5 to 60, of a round width; one where all values are one.
[[nodiscard]] ValueHistogram histogramOf(std::span<const double> values);

/// A quantity against its tolerance limits, and the way for values that are not normal: a power that makes
/// them normal where there is one, else percentiles, which 1,000 values or more tell by themselves.
struct ProcessCapability {
    std::size_t quantity = 0;
    std::optional<ToleranceLimits> limits;
    ValueHistogram histogram;
    std::optional<Capability> normal; ///< nothing without limits
    std::optional<TransformedCapability> boxCox;
    std::optional<PercentileCapability> percentiles;

    /// Of what the verdict is: percentiles, a power, or as normal values.
    [[nodiscard]] const CapabilityIndex* verdictIndex() const;
};
/// Ranks of resamples by how many values there are: drawn by the first who asks, shared by all quantities.
/// Any thread may ask.
class SharedRanks {
public:
    [[nodiscard]] std::shared_ptr<const ResampledRanks> of(std::size_t count,
                                                           const PercentileOptions& options);

private:
    std::mutex m_mutex; ///< guards m_known; held while they are drawn, for which others would wait anyway
    std::map<std::size_t, std::shared_ptr<const ResampledRanks>> m_known;
};

/// Errors as studyCapability() has them. `ranks`: of other quantities of the same rows, asked with the same
/// options.
[[nodiscard]] Expected<ProcessCapability> processCapability(const ProcessValues& values,
                                                            const ProcessRows& rows, std::size_t quantity,
                                                            const ProcessOptions& options,
                                                            SharedRanks& ranks);
[[nodiscard]] Expected<ProcessCapability> processCapability(const ProcessValues& values,
                                                            const ProcessRows& rows, std::size_t quantity,
                                                            const ProcessOptions& options);

} // namespace gripscope
