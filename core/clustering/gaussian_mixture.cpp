// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/gaussian_mixture.h"

#include "core/base/parallel_runs.h"
#include "core/clustering/cluster_items.h"
#include "core/clustering/feature_scaling.h"
#include "core/clustering/kmeans.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Where EM begins.
struct MixtureStart {
    MixtureParameters parameters;
    Eigen::MatrixXd priorCovariance; ///< of the imaginary items of each component
};

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

/// Of each feature's variance, which is 1: what keeps items that coincide from a density without end.
constexpr double leastVariance = 1e-6;

/// From clusters (labels from 0, below `components`): their shares, their means, and the scatter within all
/// of them as the covariance of each and of the prior.
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

constexpr int shortRun = 25;             ///< iterations by which the starts are compared
constexpr double leastGainAnItem = 1e-7; ///< of the objective
/// On longer tables the starts are compared on so many items, drawn by the seed.
constexpr Eigen::Index mostCompared = 10'000;

struct Run {
    std::vector<MixtureStep> steps;
    int iterations = 0;
    bool converged = false;
};

/// EM up to that many iterations.
Run proceed(MixtureEm& em, int mostIterations, Eigen::Index items, const GaussianMixtureOptions& options)
{
    Run run;
    const auto record = [&] {
        if (options.recordSteps)
            run.steps.push_back({em.parameters(), em.labels(), em.logLikelihood(), em.objective()});
    };
    em.expect();
    record();
    while (!run.converged && run.iterations < mostIterations && !isStopped(options.watch)) {
        const double before = em.objective();
        em.maximize();
        em.expect();
        ++run.iterations;
        record();
        run.converged = em.objective() - before < leastGainAnItem * double(items);
    }
    return run;
}

/// The different ends of single K-means runs, the seeds counted up.
std::vector<std::vector<int>> kMeansLabels(const Eigen::MatrixXd& items,
                                           const GaussianMixtureOptions& options)
{
    KMeansOptions start;
    start.clusters = options.components;
    start.restarts = 1;
    start.recordSteps = false;
    std::vector<std::vector<int>> found;
    for (int i = 0; i < options.restarts; ++i) {
        start.seed = options.seed + std::uint64_t(i);
        std::vector<int> labels = kMeans(items, start).value().labels; // the items are z-scores: no error
        if (std::find(found.begin(), found.end(), labels) == found.end())
            found.push_back(std::move(labels));
    }
    return found;
}

/// The start that a short run gets farthest from.
MixtureStart bestStart(const Eigen::MatrixXd& items, const GaussianMixtureOptions& options)
{
    GaussianMixtureOptions trial = options;
    trial.recordSteps = false;
    const ItemRows rows = items;
    const std::vector<std::vector<int>> labels = kMeansLabels(items, options);
    MixtureStart best = mixtureStart(rows, labels.front(), options.components);
    if (labels.size() == 1)
        return best;
    std::optional<double> highest;
    for (const std::vector<int>& own : labels) {
        MixtureStart start = mixtureStart(rows, own, options.components);
        MixtureEm em(rows, start, options.covariance);
        (void)proceed(em, std::min(shortRun, options.maxIterations), items.rows(), trial);
        if (!highest || em.objective() > *highest) {
            highest = em.objective();
            best = std::move(start);
        }
    }
    return best;
}

/// Numbers the components anew and turns z-scores back into the units of the items.
MixtureParameters inUnits(const MixtureParameters& found, const FeatureTransform& transform,
                          const std::vector<int>& numbers)
{
    const Eigen::MatrixXd means = transform.undo(found.means);
    MixtureParameters parameters = found;
    for (std::size_t c = 0; c < numbers.size(); ++c) {
        const auto to = std::size_t(numbers[c]);
        parameters.weights(Eigen::Index(to)) = found.weights(Eigen::Index(c));
        parameters.means.row(Eigen::Index(to)) = means.row(Eigen::Index(c));
        parameters.covariances[to] =
            transform.scale.asDiagonal() * found.covariances[c] * transform.scale.asDiagonal();
    }
    return parameters;
}

void renumber(std::vector<int>& labels, const std::vector<int>& numbers)
{
    for (int& label : labels)
        label = numbers[std::size_t(label)];
}

int freeParameters(const GaussianMixtureOptions& options, int features)
{
    const int covariances = options.covariance == MixtureCovariance::Full ? options.components : 1;
    return options.components - 1 + options.components * features +
           covariances * features * (features + 1) / 2;
}

} // namespace

std::optional<Error> GaussianMixtureOptions::validate() const
{
    for (auto problem : {countProblem(u"components"_s, components), countProblem(u"restarts"_s, restarts),
                         countProblem(u"maxIterations"_s, maxIterations)})
        if (problem)
            return problem;
    return {};
}

Expected<GaussianMixtureResult> gaussianMixture(const Eigen::MatrixXd& items,
                                                const GaussianMixtureOptions& options)
{
    RETURN_IF_ERROR(options.validate());
    RETURN_IF_ERROR(clusterItemsProblem(items));
    GaussianMixtureResult result;
    if (items.rows() < options.components || items.cols() == 0)
        return result;
    const double scale = powerOfTwoScale(items);
    ASSIGN_OR_RETURN(auto transform, featureTransform(items * scale, FeatureScaling::ZScore));
    const Eigen::MatrixXd scores = transform.apply(items * scale);
    const ItemRows rows = scores;
    const Eigen::Index compared = std::max<Eigen::Index>(mostCompared, options.components);
    MixtureEm em(rows, bestStart(sampleOfItems(scores, compared, options.seed), options), options.covariance);
    Run run = proceed(em, options.maxIterations, rows.rows(), options);
    if (isStopped(options.watch))
        return tl::unexpected(clusteringCancelled());

    transform.scale /= scale;
    transform.shift /= scale;
    // A density in units is that in z-scores over their scales.
    const double logUnits = double(items.rows()) * transform.scale.array().log().sum();
    const std::vector<int> numbers = numbersByAppearance(em.labels(), options.components);
    result.status = run.converged ? MixtureStatus::Converged : MixtureStatus::NotConverged;
    result.parameters = inUnits(em.parameters(), transform, numbers);
    result.labels = em.labels();
    renumber(result.labels, numbers);
    const Eigen::MatrixXd probabilities = em.probabilities();
    result.probabilities.resizeLike(probabilities);
    for (std::size_t c = 0; c < numbers.size(); ++c)
        result.probabilities.col(numbers[c]) = probabilities.col(Eigen::Index(c));
    result.logLikelihood = em.logLikelihood() - logUnits;
    result.freeParameters = freeParameters(options, int(items.cols()));
    result.bic = -2 * result.logLikelihood + result.freeParameters * std::log(double(items.rows()));
    result.iterations = run.iterations;
    result.steps = std::move(run.steps);
    for (MixtureStep& step : result.steps) {
        step.parameters = inUnits(step.parameters, transform, numbers);
        renumber(step.labels, numbers);
        step.logLikelihood -= logUnits;
        step.objective -= logUnits;
    }
    return result;
}

} // namespace gripscope
