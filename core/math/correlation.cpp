// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/correlation.h"

#include "core/math/normal_interval.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

/// Deviations from the mean, scaled to a largest of 1 so that squares neither overflow nor vanish. Empty
/// without variation.
std::vector<double> deviations(std::span<const double> values)
{
    // Compared, not subtracted: the mean of equal values is rounded and would leave a variation of its own.
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    if (values.empty() || *low == *high)
        return {};
    double mean = 0;
    for (const double value : values)
        mean += value / static_cast<double>(values.size());
    double largest = 0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value - mean));
    if (!(largest > 0) || !std::isfinite(largest))
        return {};
    std::vector<double> result;
    result.reserve(values.size());
    for (const double value : values)
        result.push_back((value - mean) / largest);
    return result;
}

double sumOfSquares(const std::vector<double>& values)
{
    double sum = 0;
    for (const double value : values)
        sum += value * value;
    return sum;
}

Correlation correlate(std::span<const double> later, std::span<const double> earlier, int from, int to)
{
    const std::vector<double> e = deviations(later);
    const std::vector<double> u = deviations(earlier);
    if (e.empty() || e.size() != u.size())
        return {};
    const int count = static_cast<int>(e.size());
    const double scale = std::sqrt(sumOfSquares(e) * sumOfSquares(u));
    Correlation result;
    result.band = normal95 / std::sqrt(static_cast<double>(count));
    for (int lag = std::max(from, 1 - count); lag <= std::min(to, count - 1); ++lag) {
        double sum = 0;
        for (int t = std::max(0, lag); t < std::min(count, count + lag); ++t)
            sum += e[static_cast<std::size_t>(t)] * u[static_cast<std::size_t>(t - lag)];
        result.lags.push_back(lag);
        result.values.push_back(std::clamp(sum / scale, -1.0, 1.0));
    }
    return result;
}

} // namespace

Correlation autocorrelation(std::span<const double> residual, int lags)
{
    return correlate(residual, residual, 0, lags);
}

Correlation crossCorrelation(std::span<const double> residual, std::span<const double> input, int lags)
{
    return correlate(residual, input, -lags, lags);
}

LaggedProducts::LaggedProducts(Eigen::Index columns)
    : m_same(Matrix::Zero(columns, columns)), m_next(m_same), m_ends(m_same), m_last(Row::Zero(columns))
{
}

void LaggedProducts::add(Eigen::Index time, const Eigen::Ref<const Eigen::RowVectorXd>& row)
{
    if (m_rows > 0 && time == m_lastTime + 1) {
        m_next.noalias() += row.transpose() * m_last;
    } else {
        if (m_rows > 0)
            m_ends.noalias() += m_last.transpose() * m_last;
        m_ends.noalias() += row.transpose() * row;
        ++m_stretches;
    }
    m_same.noalias() += row.transpose() * row;
    m_last = row;
    m_lastTime = time;
    ++m_rows;
}

LaggedProducts::Matrix LaggedProducts::whitened(double pole) const
{
    const Matrix ends = m_ends + m_last.transpose() * m_last;
    const double square = pole * pole;
    return (1 + square) * m_same - square * ends - pole * (m_next + m_next.transpose());
}

} // namespace gripscope
