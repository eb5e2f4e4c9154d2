// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/output_error/output_error_problem.h"
#include "core/math/fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gripscope {

namespace {

/// Longer gaps are judged like this one.
constexpr std::size_t longestTried = 32;
/// Places at which a gap is tried: enough for a variance to 2 %.
constexpr std::size_t mostPlaces = 5000;
/// Least deviation, as a share of the largest force.
constexpr double leastShare = 1e-9;

struct Gap {
    std::size_t first, length;
};

std::vector<Gap> gapsOf(const std::vector<std::size_t>& lost)
{
    std::vector<Gap> gaps;
    for (const std::size_t t : lost) {
        if (!gaps.empty() && gaps.back().first + gaps.back().length == t)
            ++gaps.back().length;
        else
            gaps.push_back({t, 1});
    }
    return gaps;
}

double straight(const std::vector<double>& f, Gap gap, std::size_t inside)
{
    const double share = static_cast<double>(inside) / static_cast<double>(gap.length + 1);
    return (1 - share) * f[gap.first - 1] + share * f[gap.first + gap.length];
}

/// Lagrange's polynomial through the two samples on either side.
double cubic(const std::vector<double>& f, Gap gap, std::size_t inside)
{
    const auto width = static_cast<double>(gap.length + 1);
    const std::array<double, 4> at{-1, 0, width, width + 1};
    const std::array<double, 4> value{f[gap.first - 2], f[gap.first - 1], f[gap.first + gap.length],
                                      f[gap.first + gap.length + 1]};
    const auto x = static_cast<double>(inside);
    double sum = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        double weight = value[i];
        for (std::size_t j = 0; j < 4; ++j)
            weight *= i == j ? 1 : (x - at[j]) / (at[i] - at[j]);
        sum += weight;
    }
    return sum;
}

/// e^2 = constant + slope d^2 over the places where a gap was tried.
struct ErrorLaw {
    double constant = 0, slope = 0, mean = 0;
    std::size_t count = 0;
    /// A variance that was never seen: that of the force over one more than the places tried.
    double least = 0;
    /// How much larger the variance of a gap's mean error is than if its errors were independent: 1 to the
    /// gap's length, where they all go the same way.
    double likeness = 1;
};

/// Sums for the law of one kind of interpolation.
class ErrorSums {
public:
    void add(double error, double difference)
    {
        const double e = error * error;
        const double d = difference * difference;
        ++m_count;
        m_sum += error;
        m_e += e;
        m_d += d;
        m_dd += d * d;
        m_ed += e * d;
    }
    /// After the last error of a place.
    void endPlace()
    {
        m_together += m_sum * m_sum;
        m_sum = 0;
    }
    [[nodiscard]] ErrorLaw law(double forceVariance, std::size_t length) const
    {
        ErrorLaw law;
        law.least = forceVariance * static_cast<double>(length) / static_cast<double>(m_count + length);
        law.likeness = m_e > 0 ? std::clamp(m_together / m_e, 1.0, static_cast<double>(length))
                               : static_cast<double>(length);
        law.count = m_count;
        law.constant = law.mean = forceVariance;
        if (m_count == 0)
            return law;
        const auto n = static_cast<double>(m_count);
        const double spread = m_dd - m_d * m_d / n;
        law.mean = m_e / n;
        law.slope = spread > 0 ? std::max((m_ed - m_e * m_d / n) / spread, 0.0) : 0;
        law.constant = law.mean - law.slope * m_d / n;
        if (law.constant < 0) {
            law.constant = 0;
            law.slope = m_d > 0 ? m_e / m_d : 0;
        }
        return law;
    }

private:
    double m_e = 0, m_d = 0, m_dd = 0, m_ed = 0, m_sum = 0, m_together = 0;
    std::size_t m_count = 0;
};

struct GapLaws {
    ErrorLaw straight, cubic;
};

class Interpolation {
public:
    Interpolation(const std::vector<double>& force, const std::vector<std::size_t>& lost)
        : m_force(force), m_isLost(force.size(), false)
    {
        for (const std::size_t t : lost) {
            m_isLost[t] = true;
            m_force[t] = 0;
        }
        measureVariance();
    }

    LostForcePrior run(const std::vector<std::size_t>& lost)
    {
        LostForcePrior prior;
        prior.force = m_force;
        for (const Gap& gap : gapsOf(lost)) {
            const bool open = gap.first == 0 || gap.first + gap.length == m_force.size();
            for (std::size_t inside = 1; inside <= gap.length; ++inside) {
                double variance = 2 * m_variance * static_cast<double>(gap.length);
                prior.force[gap.first + inside - 1] =
                    open ? nearest(gap) : interpolate(gap, inside, variance);
                prior.deviation.push_back(std::max(std::sqrt(variance), m_least));
            }
        }
        return prior;
    }

private:
    void measureVariance()
    {
        double sum = 0;
        double squares = 0;
        double count = 0;
        double largest = 0;
        for (std::size_t t = 0; t < m_force.size(); ++t) {
            if (m_isLost[t])
                continue;
            ++count;
            sum += m_force[t];
            squares += m_force[t] * m_force[t];
            largest = std::max(largest, std::abs(m_force[t]));
        }
        m_variance = count > 0 ? std::max(squares / count - sum / count * (sum / count), 0.0) : 0;
        m_least = largest > 0 ? leastShare * largest : 1;
    }

    [[nodiscard]] double nearest(const Gap& gap) const
    {
        if (gap.first > 0)
            return m_force[gap.first - 1];
        return gap.length < m_force.size() ? m_force[gap.length] : 0;
    }

    [[nodiscard]] bool hasTwoOnEitherSide(const Gap& gap) const
    {
        return gap.first >= 2 && gap.first + gap.length + 1 < m_force.size() && !m_isLost[gap.first - 2] &&
               !m_isLost[gap.first + gap.length + 1];
    }

    double interpolate(const Gap& gap, std::size_t inside, double& variance)
    {
        const GapLaws& laws = lawsOf(std::min(gap.length, longestTried));
        const bool byCubic =
            hasTwoOnEitherSide(gap) && laws.cubic.count > 0 && laws.cubic.mean < laws.straight.mean;
        const ErrorLaw& law = byCubic ? laws.cubic : laws.straight;
        const double difference = m_force[gap.first + gap.length] - m_force[gap.first - 1];
        variance = std::max(law.likeness * (law.constant + law.slope * difference * difference), law.least);
        return byCubic ? cubic(m_force, gap, inside) : straight(m_force, gap, inside);
    }

    const GapLaws& lawsOf(std::size_t length)
    {
        const auto known = m_laws.find(length);
        if (known != m_laws.end())
            return known->second;
        ErrorSums byLine;
        ErrorSums byCubic;
        const std::size_t width = length + 2;
        const std::size_t places = m_force.size() >= width ? m_force.size() - width + 1 : 0;
        const std::size_t stride = std::max<std::size_t>(places / mostPlaces, 1);
        for (std::size_t start = 0; start < places; start += stride) {
            const auto begin = m_isLost.begin() + static_cast<std::ptrdiff_t>(start);
            const auto end = begin + static_cast<std::ptrdiff_t>(width);
            if (std::find(begin, end, true) == end)
                tryGap({start + 1, length}, byLine, byCubic);
        }
        return m_laws
            .emplace(length, GapLaws{byLine.law(m_variance, length), byCubic.law(m_variance, length)})
            .first->second;
    }

    /// Lays it over measured samples.
    void tryGap(const Gap& gap, ErrorSums& byLine, ErrorSums& byCubic) const
    {
        const bool tryCubic = hasTwoOnEitherSide(gap);
        const double difference = m_force[gap.first + gap.length] - m_force[gap.first - 1];
        for (std::size_t inside = 1; inside <= gap.length; ++inside) {
            const double truth = m_force[gap.first + inside - 1];
            byLine.add(truth - straight(m_force, gap, inside), difference);
            if (tryCubic)
                byCubic.add(truth - cubic(m_force, gap, inside), difference);
        }
        byLine.endPlace();
        if (tryCubic)
            byCubic.endPlace();
    }

    std::vector<double> m_force;
    std::vector<bool> m_isLost;
    double m_variance = 0, m_least = 1;
    std::map<std::size_t, GapLaws> m_laws;
};

} // namespace

LostForcePrior lostForcePrior(const std::vector<double>& force, const std::vector<std::size_t>& lost)
{
    std::vector<double> scaled = force;
    for (const std::size_t t : lost)
        scaled[t] = 0;
    const double scale = powerOfTwoScale(scaled);
    for (double& value : scaled)
        value /= scale;
    LostForcePrior prior = Interpolation(scaled, lost).run(lost);
    for (double& value : prior.force)
        value *= scale;
    for (double& value : prior.deviation)
        value *= scale;
    return prior;
}

} // namespace gripscope
