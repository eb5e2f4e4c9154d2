// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/excitation_design.h"
#include "core/identification/response_sensitivities.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace gripscope {

/// Binary signals, +1 or -1 on runs of equal length, and their information matrices, one an object. The
/// sensitivities are linear in the signal, so with R_j those to a force of 1 on run j alone the information
/// of signs s is sum_jk s_j s_k R_j' R_k (nuisances projected out): once these products are known a flip
/// costs a few operations, whatever the number of samples.
class BinaryExchange {
public:
    /// `runSamples` samples a run, the last one as long as the record allows. Held force.
    BinaryExchange(const DesignOptions& options, std::size_t runSamples);

    [[nodiscard]] std::size_t runs() const { return m_runs; }
    using Score = std::function<double(const std::vector<Eigen::Matrix3d>&)>;
    /// Flips signs as long as one raises the score, at most `sweeps` times through all runs.
    [[nodiscard]] std::vector<int> improve(std::vector<int> signs, const Score& score, int sweeps) const;
    [[nodiscard]] std::vector<Eigen::Matrix3d> information(const std::vector<int>& signs) const;

private:
    /// R_j' R_k of one object.
    using Products = std::vector<Eigen::Matrix3d>;
    [[nodiscard]] Products productsFor(const ResponseSensitivities& pulse, std::size_t runSamples) const;
    [[nodiscard]] const Eigen::Matrix3d& product(std::size_t object, std::size_t j, std::size_t k) const
    {
        return m_products[object][j * m_runs + k];
    }

    std::size_t m_runs;
    std::vector<Products> m_products; ///< an object
};

} // namespace gripscope
