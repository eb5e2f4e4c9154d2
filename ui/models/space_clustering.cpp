// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/space_clustering.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace gripscope {

namespace {

QString clusteringWord(const char* text)
{
    return QCoreApplication::translate("gripscope::SpaceClustering", text);
}

/// Longer types would make a table that nobody reads: counts then tell more.
constexpr int mostTrials = 12;
/// The share of a component's squeezes that its ellipsoid holds.
constexpr double clusterShare = 0.95;

const KMeansResult* kMeansOf(const SpaceClustering& clustering)
{
    return std::get_if<KMeansResult>(&clustering.outcome.details);
}
const GaussianMixtureResult* mixtureOf(const SpaceClustering& clustering)
{
    return std::get_if<GaussianMixtureResult>(&clustering.outcome.details);
}
const SelfOrganizingMapResult* mapOf(const SpaceClustering& clustering)
{
    return std::get_if<SelfOrganizingMapResult>(&clustering.outcome.details);
}

Eigen::MatrixXd tableOf(const TypeSpace& space)
{
    Eigen::MatrixXd table(Eigen::Index(space.squeezes.size()), 3);
    for (std::size_t i = 0; i < space.squeezes.size(); ++i)
        table.row(Eigen::Index(i)) = space.squeezes[i].parameters.vector().transpose();
    return table;
}

/// The derivative of the way back from the scaled space, where that way leads to `at`.
Eigen::Vector3d slopes(const FeatureTransform& transform, const Eigen::Vector3d& at)
{
    const Eigen::Vector3d scale = transform.scale.transpose();
    return transform.logarithm ? scale.cwiseProduct(at).eval() : scale;
}

std::optional<Error> tooFewSqueezes(const TypeSpace& space, int clusters)
{
    const auto squeezes = int(space.squeezes.size());
    if (squeezes < 2)
        return Error{
            ErrorCode::Usage,
            {clusteringWord(QT_TRANSLATE_NOOP("gripscope::SpaceClustering",
                                              "Clusters need at least two squeezes. Enrol some more."))}};
    if (squeezes < clusters)
        return Error{
            ErrorCode::Usage,
            {clusteringWord(QT_TRANSLATE_NOOP("gripscope::SpaceClustering",
                                              "%1 clusters need at least %1 squeezes; there are %2. Ask for "
                                              "fewer clusters, or enrol more squeezes."))
                 .arg(clusters)
                 .arg(squeezes)}};
    return {};
}

} // namespace

int SpaceClustering::states() const
{
    return std::visit([](const auto& details) { return int(details.steps.size()); }, outcome.details);
}

const std::vector<int>& SpaceClustering::labels(int state) const
{
    if (const auto* found = kMeansOf(*this))
        return found->steps[std::size_t(state)].labels;
    if (const auto* found = mixtureOf(*this))
        return found->steps[std::size_t(state)].labels;
    return outcome.labels;
}

Eigen::MatrixXd SpaceClustering::centres(int state) const
{
    if (const auto* found = kMeansOf(*this))
        return outcome.transform.undo(found->steps[std::size_t(state)].centroids);
    if (const auto* found = mixtureOf(*this))
        return outcome.transform.undo(found->steps[std::size_t(state)].parameters.means);
    return {};
}

std::vector<std::optional<Ellipsoid>> SpaceClustering::ellipsoids(int state) const
{
    std::vector<std::optional<Ellipsoid>> result;
    const auto* found = mixtureOf(*this);
    if (!found)
        return result;
    const MixtureParameters& parameters = found->steps[std::size_t(state)].parameters;
    const Eigen::MatrixXd means = outcome.transform.undo(parameters.means);
    for (Eigen::Index component = 0; component < means.rows(); ++component) {
        const Eigen::Vector3d mean = means.row(component).transpose();
        const Eigen::Vector3d slope = slopes(outcome.transform, mean);
        const Eigen::Matrix3d covariance =
            slope.asDiagonal() * parameters.covariances[std::size_t(component)] * slope.asDiagonal();
        result.push_back(estimateEllipsoid({mean.x(), mean.y(), mean.z()}, covariance, clusterShare));
    }
    return result;
}

QString SpaceClustering::remark() const
{
    const int found = 1 + *std::max_element(outcome.labels.begin(), outcome.labels.end());
    const int wanted = outcome.request.clusters;
    if (found == 1 && wanted > 1)
        return clusteringWord(QT_TRANSLATE_NOOP(
            "gripscope::SpaceClustering", "The squeezes are so much alike that all fell into one cluster."));
    if (found < wanted)
        return clusteringWord(
                   QT_TRANSLATE_NOOP("gripscope::SpaceClustering",
                                     "Only %1 of the %2 clusters hold squeezes: there are no more groups to "
                                     "be found."))
            .arg(found)
            .arg(wanted);
    if (!outcome.converged)
        return clusteringWord(QT_TRANSLATE_NOOP("gripscope::SpaceClustering",
                                                "Not at rest after %1 iterations: take it with care."))
            .arg(outcome.iterations);
    return {};
}

QString SpaceClustering::figure(int state) const
{
    const auto number = [](double value, int digits) { return QLocale().toString(value, 'g', digits); };
    if (const auto* found = kMeansOf(*this))
        return clusteringWord(QT_TRANSLATE_NOOP("gripscope::SpaceClustering", "inertia %1"))
            .arg(number(found->steps[std::size_t(state)].inertia, 4));
    if (const auto* found = mixtureOf(*this))
        return clusteringWord(QT_TRANSLATE_NOOP("gripscope::SpaceClustering", "log-likelihood %1"))
            .arg(QLocale().toString(found->steps[std::size_t(state)].logLikelihood, 'f', 1));
    return clusteringWord(QT_TRANSLATE_NOOP("gripscope::SpaceClustering", "quantisation error %1"))
        .arg(number(mapOf(*this)->steps[std::size_t(state)].quantizationError, 3));
}

Eigen::MatrixXd SpaceClustering::weights(int state) const
{
    if (const auto* found = mapOf(*this))
        return outcome.transform.undo(found->steps[std::size_t(state)].weights);
    return {};
}

ClusterRequest clusterRequest(const TypeSpace& space)
{
    ClusterRequest request;
    request.clusters = std::max(2, int(space.types.size()));
    return request;
}

Expected<SpaceClustering> clusterTypeSpace(const TypeSpace& space, const ClusterRequest& request)
{
    RETURN_IF_ERROR(tooFewSqueezes(space, request.clusters));
    ASSIGN_OR_RETURN(ClusterOutcome outcome, groupRows(tableOf(space), request));
    QStringList truth;
    truth.reserve(qsizetype(space.squeezes.size()));
    for (const SpaceSqueeze& squeeze : space.squeezes)
        truth << space.types[squeeze.type];
    SpaceClustering clustering;
    clustering.agreement = clusterAgreement(truth, outcome.labels, request.clusters);
    if (space.types.size() > 1)
        clustering.randIndex = clustering.agreement.adjustedRandIndex;
    if (*std::max_element(space.counts.begin(), space.counts.end()) <= mostTrials)
        clustering.table = clusterTable(truth, outcome.labels);
    clustering.outcome = std::move(outcome);
    return clustering;
}

Expected<ClusterAdvice> adviseTypeSpace(const TypeSpace& space, FeatureScaling scaling,
                                        const std::shared_ptr<WorkWatch>& watch)
{
    RETURN_IF_ERROR(tooFewSqueezes(space, 2));
    const Eigen::MatrixXd table = tableOf(space);
    ASSIGN_OR_RETURN(const FeatureTransform transform, featureTransform(table, scaling));
    ClusterAdviceOptions options;
    options.watch = watch;
    return adviseClusters(transform.apply(table), options);
}

} // namespace gripscope
