// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/cluster_items.h"
#include "core/recognition/gaussian_mixture.h"
#include "core/recognition/parallel_chunks.h"

#include <Eigen/Core>

#include <vector>

namespace gripscope {

/// Where EM begins.
struct MixtureStart {
    MixtureParameters parameters;
    Eigen::MatrixXd priorCovariance; ///< of the imaginary items of each component
};

/// From clusters (labels from 0, below `components`): their shares, their means, and the scatter within all
/// of them as the covariance of each and of the prior.
[[nodiscard]] MixtureStart mixtureStart(const ItemRows& items, const std::vector<int>& labels,
                                        int components);

/// The two steps of EM on items that are z-scores. They must outlive it.
class MixtureEm {
public:
    MixtureEm(const ItemRows& items, MixtureStart start, MixtureCovariance covariance);

    /// Who belongs where with which probability; also works out the labels, the likelihood and the sums that
    /// the next maximize() needs.
    void expect();
    void maximize();

    [[nodiscard]] const MixtureParameters& parameters() const { return m_parameters; }
    [[nodiscard]] const std::vector<int>& labels() const { return m_labels; }
    [[nodiscard]] double logLikelihood() const { return m_logLikelihood; }
    /// Log-likelihood plus the logarithm of the prior, up to a constant.
    [[nodiscard]] double objective() const { return m_logLikelihood + m_logPrior; }
    /// Items x components, of the parameters as they are.
    [[nodiscard]] Eigen::MatrixXd probabilities() const;

private:
    /// Sums over items weighted by their probability of one component, about its present mean.
    struct Sums {
        double items = 0;
        Eigen::VectorXd shift;
        ItemRows scatter; ///< lower triangle
    };
    struct ChunkResult {
        std::vector<Sums> components;
        double logLikelihood = 0;
    };
    /// A component ready to be evaluated: log density = constant - |whitening (x - mean)|^2 / 2.
    struct Density {
        Eigen::RowVectorXd mean;
        ItemRows whitening; ///< inverse of the covariance's lower Cholesky factor
        double constant = 0;
    };
    void prepareDensities();
    template <int Features>
    void expectChunk(const Chunk& chunk);
    /// Writes the probabilities of the components for one item and returns its log-density. `away` receives
    /// its offsets from the means, one component a row.
    template <int Features>
    double responsibilities(const double* item, Eigen::VectorXd& probabilities, ItemRows& away) const;
    [[nodiscard]] Eigen::MatrixXd regularized(const Eigen::MatrixXd& scatter, double items) const;

    const ItemRows& m_items;
    MixtureCovariance m_kind;
    double m_priorItems = 0;
    Eigen::MatrixXd m_priorCovariance;
    MixtureParameters m_parameters;
    std::vector<Density> m_densities;
    std::vector<int> m_labels;
    std::vector<ChunkResult> m_chunks;
    double m_logLikelihood = 0, m_logPrior = 0;
};

} // namespace gripscope
