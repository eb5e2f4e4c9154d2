// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/gaussian_mixture_em.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace gripscope {

namespace {

/// Of each feature's variance, which is 1: what keeps items that coincide from a density without end.
constexpr double leastVariance = 1e-6;

} // namespace

MixtureStart mixtureStart(const ItemRows& items, const std::vector<int>& labels, int components)
{
    const Eigen::Index features = items.cols();
    Eigen::VectorXd counts = Eigen::VectorXd::Zero(components);
    Eigen::MatrixXd means = Eigen::MatrixXd::Zero(components, features);
    for (Eigen::Index i = 0; i < items.rows(); ++i) {
        means.row(labels[std::size_t(i)]) += items.row(i);
        counts(labels[std::size_t(i)]) += 1;
    }
    for (Eigen::Index c = 0; c < components; ++c)
        means.row(c) /= std::max(counts(c), 1.0);
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(features, features);
    for (Eigen::Index i = 0; i < items.rows(); ++i) {
        const Eigen::RowVectorXd away = items.row(i) - means.row(labels[std::size_t(i)]);
        scatter.noalias() += away.transpose() * away;
    }
    MixtureStart start;
    start.priorCovariance = scatter / double(items.rows());
    start.priorCovariance.diagonal().array() += leastVariance;
    start.parameters = {counts / double(items.rows()), means,
                        std::vector<Eigen::MatrixXd>(std::size_t(components), start.priorCovariance)};
    return start;
}

MixtureEm::MixtureEm(const ItemRows& items, MixtureStart start, MixtureCovariance covariance)
    : m_items(items), m_kind(covariance), m_priorItems(double(items.cols()) + 1),
      m_priorCovariance(std::move(start.priorCovariance)), m_parameters(std::move(start.parameters)),
      m_densities(m_parameters.covariances.size()), m_labels(std::size_t(items.rows()), 0),
      m_chunks(chunkCount(m_labels.size()))
{
}

void MixtureEm::prepareDensities()
{
    const Eigen::Index features = m_items.cols();
    m_logPrior = 0;
    for (std::size_t c = 0; c < m_densities.size(); ++c) {
        Density& density = m_densities[c];
        const Eigen::LLT<Eigen::MatrixXd> factor(m_parameters.covariances[c]);
        const Eigen::MatrixXd whitening =
            factor.matrixL().solve(Eigen::MatrixXd::Identity(features, features));
        const double logDeterminant = 2 * factor.matrixLLT().diagonal().array().log().sum();
        density.mean = m_parameters.means.row(Eigen::Index(c));
        density.whitening = whitening;
        density.constant = std::log(m_parameters.weights(Eigen::Index(c))) -
                           (logDeterminant + double(features) * std::log(2 * std::numbers::pi)) / 2;
        if (m_kind == MixtureCovariance::Full || c == 0) // a tied covariance has one prior
            m_logPrior -= m_priorItems / 2 *
                          (logDeterminant + (whitening * m_priorCovariance * whitening.transpose()).trace());
    }
}

template <int Features>
double MixtureEm::responsibilities(const double* item, Eigen::VectorXd& probabilities, ItemRows& away) const
{
    const Eigen::Index features = Features > 0 ? Features : m_items.cols();
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < m_densities.size(); ++c) {
        const Density& density = m_densities[c];
        double* offset = away.data() + Eigen::Index(c) * features;
        const double* row = density.whitening.data();
        double squared = 0;
        for (Eigen::Index j = 0; j < features; ++j, row += features) {
            offset[j] = item[j] - density.mean(j);
            double whitened = 0;
            for (Eigen::Index l = 0; l <= j; ++l)
                whitened += row[l] * offset[l];
            squared += whitened * whitened;
        }
        probabilities(Eigen::Index(c)) = density.constant - squared / 2;
        largest = std::max(largest, probabilities(Eigen::Index(c)));
    }
    probabilities = (probabilities.array() - largest).exp();
    const double sum = probabilities.sum();
    probabilities /= sum;
    return largest + std::log(sum);
}

template <int Features>
void MixtureEm::expectChunk(const Chunk& chunk)
{
    const Eigen::Index features = Features > 0 ? Features : m_items.cols();
    ChunkResult& result = m_chunks[chunk.number];
    result.logLikelihood = 0;
    const Sums none{0, Eigen::VectorXd::Zero(features), ItemRows::Zero(features, features)};
    result.components.assign(m_densities.size(), none);
    Eigen::VectorXd probabilities(m_parameters.weights.size());
    ItemRows away(m_parameters.means.rows(), features);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        result.logLikelihood +=
            responsibilities<Features>(m_items.data() + Eigen::Index(i) * features, probabilities, away);
        Eigen::Index label = 0;
        probabilities.maxCoeff(&label);
        m_labels[i] = int(label);
        for (Eigen::Index c = 0; c < probabilities.size(); ++c) {
            const double probability = probabilities(c);
            if (probability < 1e-16) // would change no digit of the sums
                continue;
            Sums& sums = result.components[std::size_t(c)];
            const double* offset = away.data() + c * features;
            sums.items += probability;
            double* scatter = sums.scatter.data();
            for (Eigen::Index j = 0; j < features; ++j, scatter += features) {
                const double weighted = probability * offset[j];
                sums.shift(j) += weighted;
                for (Eigen::Index l = 0; l <= j; ++l)
                    scatter[l] += weighted * offset[l];
            }
        }
    }
}

void MixtureEm::expect()
{
    prepareDensities();
    forEachChunk(m_labels.size(), [this](const Chunk& chunk) {
        if (m_items.cols() == 3) // mass, damping, stiffness
            expectChunk<3>(chunk);
        else
            expectChunk<0>(chunk);
    });
    m_logLikelihood = 0;
    for (const ChunkResult& chunk : m_chunks)
        m_logLikelihood += chunk.logLikelihood;
}

/// Scatter of own items and of the imaginary ones, over their number: the mode under the prior.
Eigen::MatrixXd MixtureEm::regularized(const Eigen::MatrixXd& scatter, double items) const
{
    return (scatter + m_priorItems * m_priorCovariance) / (items + m_priorItems);
}

void MixtureEm::maximize()
{
    std::vector<Sums> sums = m_chunks.front().components;
    for (std::size_t chunk = 1; chunk < m_chunks.size(); ++chunk)
        for (std::size_t c = 0; c < sums.size(); ++c) {
            sums[c].items += m_chunks[chunk].components[c].items;
            sums[c].shift += m_chunks[chunk].components[c].shift;
            sums[c].scatter += m_chunks[chunk].components[c].scatter;
        }
    Eigen::MatrixXd pooled = Eigen::MatrixXd::Zero(m_items.cols(), m_items.cols());
    double all = 0;
    for (std::size_t c = 0; c < sums.size(); ++c) {
        Sums& own = sums[c];
        Eigen::MatrixXd scatter = own.scatter.selfadjointView<Eigen::Lower>();
        if (own.items > 0) { // else the component stays where it is, without weight
            const Eigen::VectorXd shift = own.shift / own.items;
            m_parameters.means.row(Eigen::Index(c)) += shift.transpose();
            scatter -= own.items * shift * shift.transpose();
        }
        m_parameters.weights(Eigen::Index(c)) = own.items;
        all += own.items;
        pooled += scatter;
        m_parameters.covariances[c] = regularized(scatter, own.items);
    }
    m_parameters.weights /= all;
    if (m_kind == MixtureCovariance::Tied)
        std::fill(m_parameters.covariances.begin(), m_parameters.covariances.end(),
                  regularized(pooled, double(m_items.rows())));
}

Eigen::MatrixXd MixtureEm::probabilities() const
{
    Eigen::MatrixXd all(m_items.rows(), m_parameters.weights.size());
    forEachChunk(std::size_t(m_items.rows()), [&](const Chunk& chunk) {
        Eigen::VectorXd one(m_parameters.weights.size());
        ItemRows away(m_parameters.means.rows(), m_items.cols());
        for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
            (void)responsibilities<0>(m_items.data() + Eigen::Index(i) * m_items.cols(), one, away);
            all.row(Eigen::Index(i)) = one.transpose();
        }
    });
    return all;
}

} // namespace gripscope
