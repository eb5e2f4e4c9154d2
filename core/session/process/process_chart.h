// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/process_values.h"
#include "core/quality/charts/box_cox.h"
#include "core/quality/charts/chart_study.h"
#include "core/quality/charts/percentile_capability.h"
#include "core/quality/charts/run_length.h"
#include "core/session/process/process_options.h"

#include <map>
#include <memory>
#include <mutex>

namespace gripscope {

/// Which of the inspections that were read are charted; what is empty lets all through.
struct ProcessFilter {
    QString station = {}, operatorName = {};
    QString batch = {};
    QDateTime from = {}, to = {}; ///< from the first on, before the second
    friend bool operator==(const ProcessFilter&, const ProcessFilter&) = default;
};

/// Places in the values, in order of time; of the same time by number.
using ProcessRows = std::vector<std::uint32_t>;
[[nodiscard]] ProcessRows processRows(const ProcessValues& values, const ProcessFilter& filter);

/// Something that a chart signals, from its first point to its last in a row: a pattern that goes on is one
/// signal.
struct ProcessSignal {
    std::size_t quantity = 0; ///< 0 to 2 for m, b, k: of T^2 the one that it is mostly by
    bool joint = false;       ///< T^2
    ChartPart part = ChartPart::Location;
    int rule = 1;
    bool rising = false;
    std::size_t first = 0, last = 0; ///< points
    std::size_t since = 0;           ///< the first point of the pattern; of a sum, since when it has grown
};

/// What many points span: so that a million are painted as fast as a thousand.
struct PointBlock {
    float low = 0, high = 0; ///< relative to PointBlocks::origin
    bool signal = false;
};
struct PointBlocks {
    static constexpr std::size_t size = 256; ///< points in a block
    double origin = 0;
    std::vector<PointBlock> blocks;
};

/// The control chart of one quantity.
struct QuantityChart {
    std::size_t quantity = 0;
    int size = 1;     ///< inspections a point, on the last one maybe fewer
    ProcessRows rows; ///< with a value: point p is of rows[p * size] and the following
    ChartStudy study;
    std::vector<ProcessSignal> signalsFound; ///< in order of their first points
    PointBlocks blocks;                      ///< of what is drawn: values, of CUSUM both sums
    std::size_t undetermined = 0;            ///< inspections without this quantity

    [[nodiscard]] std::size_t points() const { return study.points.size(); }
    /// The last inspection of a point, as a place in the values.
    [[nodiscard]] std::uint32_t row(std::size_t point) const;
};
/// Errors as studyChart() has them; BadInput where units differ, or fewer than two points are there.
[[nodiscard]] Expected<QuantityChart> drawQuantity(const ProcessValues& values, const ProcessRows& rows,
                                                   std::size_t quantity, const ProcessOptions& options);

/// T^2 of m, b and k together, of those inspections that determine all three.
struct JointChart {
    ProcessRows rows; ///< a point each
    HotellingReference reference;
    std::vector<HotellingPoint> points;
    std::vector<ProcessSignal> signalsFound;
    PointBlocks blocks;
    Findings messages;
    std::size_t undetermined = 0;
};
/// Errors as studyHotelling() has them; BadInput where units differ.
[[nodiscard]] Expected<JointChart> drawJoint(const ProcessValues& values, const ProcessRows& rows,
                                             const ProcessOptions& options);

/// Points until the first signal, on average: nothing moved, and after a shift by one sigma of a value; of
/// the chart of one quantity. Nelson's rules are simulated, which takes a second.
[[nodiscard]] RunLengths processRunLengths(const ProcessOptions& options);

/// Limits from the inspections with numbers from `first` to `last`: what phase 1 is. Quantities that cannot
/// settle any have none. BadInput where none can.
[[nodiscard]] Expected<FixedLimits> fixLimits(const ProcessValues& values, const ProcessRows& rows,
                                              qint64 first, qint64 last, const ProcessOptions& options);

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
