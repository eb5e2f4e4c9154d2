// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/lag_profile.h"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gripscope {

namespace {

constexpr double scanStep = 0.5; ///< sample times
/// Away from whole samples by this much, so that the same rows are used on both sides of one.
constexpr double smallestRest = 1e-6;
constexpr double anySse = std::numeric_limits<double>::max();

} // namespace

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

} // namespace gripscope
