// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace gripscope {

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
