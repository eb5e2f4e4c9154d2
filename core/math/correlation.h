// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace gripscope {

/// Sample correlation over lags, with the half width of the band that 95 % of the values keep to when there
/// is no correlation: 1.96 / sqrt(N), from the asymptotic normal law (Box and Jenkins, Time Series Analysis,
/// section 2.1.6; for residuals that are white the band of the cross-correlation is the same, whatever the
/// input).
struct Correlation {
    std::vector<int> lags;
    std::vector<double> values; ///< between -1 and 1
    double band = 0;
};

/// r[k] = sum_t (e[t] - mean)(e[t-k] - mean) / sum_t (e[t] - mean)^2 for k = 0 .. lags (fewer when there are
/// not lags + 1 samples). Without samples or without variation: no values.
[[nodiscard]] Correlation autocorrelation(std::span<const double> residual, int lags);

/// r[k] = sum_t (e[t] - mean)(u[t-k] - mean) / sqrt(sum (e - mean)^2 sum (u - mean)^2) for k = -lags .. lags:
/// the residual against the input k samples earlier. Beyond the band at k >= 0: the model misses something
/// the input does; at k < 0: the input answers to the output (feedback). Both series have the same length,
/// else no values.
[[nodiscard]] Correlation crossCorrelation(std::span<const double> residual, std::span<const double> input,
                                           int lags);

/// Sums of the products of regression rows with themselves and with the row before, from which the normal
/// matrix under first-order autoregressive noise of any pole follows without reading the rows again.
///
/// With e[t] = p e[t-1] + w[t], w white, the rows that matter are sqrt(1 - p^2) r[0] and r[t] - p r[t-1], and
/// the sum of their products is
///     W(p) = (1 + p^2) S0 - p^2 E - p (S1 + S1'),
/// S0 = sum r[t]'r[t], S1 = sum r[t]'r[t-1], E = the products of the first and the last row (Box and Jenkins,
/// Time Series Analysis, the exact likelihood of an AR(1) process). Across samples that are missing the noise
/// is taken as begun anew.
class LaggedProducts {
public:
    static constexpr int mostColumns = 7;
    using Matrix =
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, mostColumns, mostColumns>;
    using Row = Eigen::Matrix<double, 1, Eigen::Dynamic, Eigen::RowMajor, 1, mostColumns>;

    explicit LaggedProducts(Eigen::Index columns);

    /// The row at `time`, counted in samples and rising.
    void add(Eigen::Index time, const Eigen::Ref<const Eigen::RowVectorXd>& row);

    [[nodiscard]] Eigen::Index columns() const { return m_same.rows(); }
    [[nodiscard]] Eigen::Index rows() const { return m_rows; }
    /// How often the noise began: once, and once more after every gap.
    [[nodiscard]] Eigen::Index stretches() const { return m_stretches; }
    /// W for a pole between -1 and 1.
    [[nodiscard]] Matrix whitened(double pole) const;

private:
    Matrix m_same, m_next, m_ends;
    Row m_last;
    Eigen::Index m_lastTime = 0, m_rows = 0, m_stretches = 0;
};

} // namespace gripscope
