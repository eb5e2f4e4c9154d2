// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/lag/lag_estimation.h"

#include "core/base/words.h"
#include "core/identification/output_error/output_error.h"
#include "core/math/robust_statistics.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Lags searched, in sample times: [middle - half, middle + half].
struct LagRange {
    double middle = 0, half = 2;
};

struct LagMinimum {
    double lag = 0; ///< sample times
    double sse = 0;
    double degreesOfFreedom = 0; ///< the lag counted as a parameter
    std::optional<double> error; ///< standard error in sample times; none where the profile does not rise
    bool atEnd = false;
};

/// The sum of squared residuals of output error, smallest in everything but the lag. Whole samples of lag are
/// taken by shifting the force against the position, within rows that are there for every lag of the range,
/// so that values for different lags compare.
class LagProfile {
public:
    /// The data must outlive it.
    LagProfile(const std::vector<double>& force, const std::vector<double>& position,
               const LagEstimationOptions& options, LagRange range);

    [[nodiscard]] std::optional<LagMinimum> minimum() const;
    [[nodiscard]] LagProfile withOtherHold() const;

private:
    struct Value {
        double sse = 0, degreesOfFreedom = 0;
        MassDampingStiffness parameters;
    };
    [[nodiscard]] std::optional<Value> at(double lag, std::optional<MassDampingStiffness> start) const;
    [[nodiscard]] std::optional<double> errorAt(double lag, const Value& best) const;

    const std::vector<double>& m_force;
    const std::vector<double>& m_position;
    OutputErrorOptions m_options;
    LagRange m_range;
};

constexpr double scanStep = 0.5; ///< sample times
/// Away from whole samples by this much, so that the same rows are used on both sides of one.
constexpr double smallestRest = 1e-6;
constexpr double anySse = std::numeric_limits<double>::max();

LagProfile::LagProfile(const std::vector<double>& force, const std::vector<double>& position,
                       const LagEstimationOptions& options, LagRange range)
    : m_force(force), m_position(position), m_range(range)
{
    m_options.sampleTime_s = options.sampleTime_s;
    m_options.hold = options.hold;
    m_options.lost = options.lost;
    std::sort(m_options.lost.begin(), m_options.lost.end());
}

LagProfile LagProfile::withOtherHold() const
{
    LagProfile other = *this;
    other.m_options.hold = m_options.hold == ForceHold::Zero ? ForceHold::First : ForceHold::Zero;
    return other;
}

std::optional<LagProfile::Value> LagProfile::at(double lag, std::optional<MassDampingStiffness> start) const
{
    const auto count = static_cast<std::ptrdiff_t>(m_force.size());
    const double lowest = std::floor(m_range.middle - m_range.half - 1);
    const double highest = std::floor(m_range.middle + m_range.half + 1);
    if (!(std::abs(lowest) < static_cast<double>(count)) || !(std::abs(highest) < static_cast<double>(count)))
        return std::nullopt;
    // Position rows [first, end) whose force lies within the record for every lag; a straight force needs the
    // sample behind the last row too, whose position then is no row.
    const auto first = std::max<std::ptrdiff_t>(0, -static_cast<std::ptrdiff_t>(lowest));
    const auto end = std::min(count, count - static_cast<std::ptrdiff_t>(highest) - 1) -
                     (m_options.hold == ForceHold::First ? 1 : 0);
    const std::ptrdiff_t length = end - first + (m_options.hold == ForceHold::First ? 1 : 0);
    if (length <= 0)
        return std::nullopt;
    const auto whole = static_cast<std::ptrdiff_t>(std::floor(lag));
    const std::vector<double> force(m_force.begin() + first + whole,
                                    m_force.begin() + first + whole + length);
    const std::vector<double> position(m_position.begin() + first, m_position.begin() + first + length);
    OutputErrorOptions options = m_options;
    options.lag_s =
        std::clamp(lag - std::floor(lag), smallestRest, 1 - smallestRest) * m_options.sampleTime_s;
    options.start = start;
    options.residuals = ResidualDepth::Sums;
    options.lost.clear();
    for (const std::size_t index : m_options.lost) {
        // A lost sample is a force at one place and a position at another.
        for (const std::ptrdiff_t shift : {first + whole, first}) {
            const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(index) - shift;
            if (place >= 0 && place < length)
                options.lost.push_back(static_cast<std::size_t>(place));
        }
    }
    std::sort(options.lost.begin(), options.lost.end());
    options.lost.erase(std::unique(options.lost.begin(), options.lost.end()), options.lost.end());
    const Estimate estimate = estimateOutputError(force, position, options);
    if (estimate.status != EstimateStatus::Converged || !estimate.parameters)
        return std::nullopt;
    return Value{estimate.residuals.sse, estimate.residuals.degreesOfFreedom - 1, *estimate.parameters};
}

std::optional<double> LagProfile::errorAt(double lag, const Value& best) const
{
    if (!(best.degreesOfFreedom > 0))
        return std::nullopt;
    const double variance = best.sse / best.degreesOfFreedom;
    // First a step well above rounding, then one over which the sum rises by about one variance, where it is
    // a parabola for the purpose of an interval.
    double step = 0.02;
    double error = 0;
    for (int pass = 0; pass < 2; ++pass) {
        const std::optional<Value> before = at(lag - step, best.parameters);
        const std::optional<Value> behind = at(lag + step, best.parameters);
        if (!before || !behind)
            return std::nullopt;
        const double curvature = (before->sse + behind->sse - 2 * best.sse) / (step * step);
        if (!(curvature > 0) || !std::isfinite(curvature))
            return std::nullopt;
        error = std::sqrt(2 * variance / curvature);
        step = std::clamp(error, 1e-3, 0.25);
    }
    return error;
}

std::optional<LagMinimum> LagProfile::minimum() const
{
    const double lowest = m_range.middle - m_range.half, highest = m_range.middle + m_range.half;
    std::optional<Value> best;
    double bestLag = 0;
    const int scans = static_cast<int>(std::lround((highest - lowest) / scanStep));
    for (int i = 0; i <= scans; ++i) {
        const double lag = lowest + i * scanStep;
        const std::optional<Value> value = at(lag, std::nullopt);
        if (value && (!best || value->sse < best->sse)) {
            best = value;
            bestLag = lag;
        }
    }
    if (!best)
        return std::nullopt;
    LagMinimum result;
    const MassDampingStiffness start = best->parameters;
    const auto sse = [&](double lag) {
        const std::optional<Value> value = at(lag, start);
        return value ? value->sse : anySse;
    };
    constexpr int bits = 24; // half of the digits: a minimum is not known better
    std::uintmax_t evaluations = 60;
    const auto found =
        boost::math::tools::brent_find_minima(sse, bestLag - scanStep, bestLag + scanStep, bits, evaluations);
    if (const std::optional<Value> value = at(found.first, start); value && value->sse <= best->sse) {
        best = value;
        bestLag = found.first;
    }
    result.lag = bestLag;
    result.atEnd = bestLag < lowest || bestLag > highest;
    result.sse = best->sse;
    result.degreesOfFreedom = best->degreesOfFreedom;
    result.error = errorAt(bestLag, *best);
    return result;
}

/// Log-likelihood by which two readings of a record must differ to be told apart.
constexpr double clearLagGain = 10;
constexpr double smallestSearch = 0.5, largestSearch = 20;

LagEstimate failedLag(LagStatus status, const Finding& message)
{
    LagEstimate estimate;
    estimate.status = status;
    estimate.message = message;
    return estimate;
}

double expectedGain(double sampleTime_s, double standardError_s)
{
    constexpr double most = 1e12; // a record without noise tells everything
    const double half = sampleTime_s / 2;
    const double gain = standardError_s > 0 ? half * half / (2 * standardError_s * standardError_s) : most;
    return std::min(gain, most);
}

Finding microseconds(double seconds)
{
    return Finding::number(seconds * 1e6, 'g', 4);
}

/// Status and words for a lag with an error.
void judge(LagEstimate& estimate)
{
    estimate.expectedGain = expectedGain(estimate.sampleTime_s, estimate.standardError_s);
    const Finding value = Words::say("%1 us, known to %2 us")
                              .arg(microseconds(estimate.lag_s), microseconds(estimate.standardError_s));
    if (estimate.holdGain && *estimate.holdGain < clearLagGain) {
        estimate.status = LagStatus::HoldOrLag;
        estimate.message =
            Words::say("a lag of %1; but the other force hold with another lag does as well. Name the hold.")
                .arg(value);
    } else if (estimate.expectedGain < clearLagGain) {
        estimate.status = LagStatus::TooUncertain;
        estimate.message =
            Words::say("a lag of %1: too little to tell it from none. Measure it on more squeezes, or on a "
                       "stiffer object with less noise.")
                .arg(value);
    } else {
        estimate.status = LagStatus::Measured;
        estimate.message =
            Words::say("the position channel samples later than the force channel by %1").arg(value);
    }
}

bool isUsable(const std::vector<double>& force, const std::vector<double>& position,
              const LagEstimationOptions& options)
{
    const auto finite = [](double value) { return std::isfinite(value); };
    return force.size() == position.size() && std::isfinite(options.sampleTime_s) &&
           options.sampleTime_s > 0 && std::isfinite(options.expectedLag_s / options.sampleTime_s) &&
           std::isfinite(options.searchedSamples) && std::all_of(force.begin(), force.end(), finite) &&
           std::all_of(position.begin(), position.end(), finite);
}

/// ln of the likelihood ratio of the best lags under the two holds.
std::optional<double> gainOverOtherHold(const LagProfile& profile, const LagMinimum& best)
{
    const std::optional<LagMinimum> other = profile.withOtherHold().minimum();
    if (!other || !(best.sse > 0))
        return std::nullopt;
    return best.degreesOfFreedom / 2 * std::log(other->sse / best.sse);
}

} // namespace

LagEstimate estimateLag(const std::vector<double>& force, const std::vector<double>& position,
                        const LagEstimationOptions& options)
{
    if (!isUsable(force, position, options))
        return failedLag(LagStatus::NotEstimated,
                         Words::say("the data or the options hold numbers that can't be used"));
    LagRange range;
    range.middle = options.expectedLag_s / options.sampleTime_s;
    range.half = std::clamp(options.searchedSamples, smallestSearch, largestSearch);
    const LagProfile profile(force, position, options, range);
    const std::optional<LagMinimum> best = profile.minimum();
    if (!best)
        return failedLag(
            LagStatus::NotEstimated,
            Words::say("no m, b and k could be found, so there is nothing to measure the lag against"));
    LagEstimate estimate;
    estimate.sampleTime_s = options.sampleTime_s;
    estimate.lag_s = best->lag * options.sampleTime_s;
    if (best->atEnd || !best->error) {
        estimate.status = LagStatus::AtLimit;
        estimate.message =
            Words::say("the best lag, %1 us, lies at the end of what was searched: the object is no mass, "
                       "spring and damper at this force, or the lag is much larger than expected")
                .arg(microseconds(estimate.lag_s));
        return estimate;
    }
    estimate.standardError_s = *best->error * options.sampleTime_s;
    if (!options.holdIsKnown)
        estimate.holdGain = gainOverOtherHold(profile, *best);
    judge(estimate);
    return estimate;
}

LagEstimate combineLags(std::span<const LagEstimate> squeezes)
{
    std::vector<LagEstimate> used;
    for (const LagEstimate& squeeze : squeezes) {
        if (squeeze.hasValue() && std::isfinite(squeeze.lag_s) && squeeze.standardError_s >= 0)
            used.push_back(squeeze);
    }
    if (used.empty())
        return failedLag(LagStatus::NotEstimated, Words::say("none of the squeezes tells the lag"));
    LagEstimate combined;
    combined.squeezes = 0;
    std::vector<ValueWithError> lags;
    for (const LagEstimate& squeeze : used) {
        // No squeeze is perfect: a floor keeps one without noise from outweighing all others without end.
        lags.push_back({squeeze.lag_s, std::max(squeeze.standardError_s, 1e-9 * squeeze.sampleTime_s)});
        combined.squeezes += squeeze.squeezes;
        combined.sampleTime_s = std::max(combined.sampleTime_s, squeeze.sampleTime_s);
    }
    const ValueWithError mean = pooledMean(lags);
    combined.lag_s = mean.value;
    combined.standardError_s = mean.standardError;
    judge(combined);
    return combined;
}

} // namespace gripscope
