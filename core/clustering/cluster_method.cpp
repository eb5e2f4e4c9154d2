// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_method.h"

#include "core/base/words.h"
#include "core/clustering/cluster_items.h"

#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

const Eigen::MatrixXd& centroidsOf(const KMeansResult& result)
{
    return result.centroids;
}
const Eigen::MatrixXd& centroidsOf(const SelfOrganizingMapResult& result)
{
    return result.centroids;
}
const Eigen::MatrixXd& centroidsOf(const GaussianMixtureResult& result)
{
    return result.parameters.means;
}

/// Takes over a method's result and what all methods have in common.
template <typename Result>
std::optional<Error> takeOver(ClusterOutcome& outcome, const Eigen::MatrixXd& items, Expected<Result> result)
{
    if (!result)
        return result.error();
    const Eigen::MatrixXd& centroids = centroidsOf(*result);
    outcome.labels = result->labels;
    outcome.centroids = outcome.transform.undo(centroids);
    outcome.inertia = inertiaOf(items, result->labels, centroids);
    outcome.converged = result->status == decltype(result->status)::Converged;
    outcome.iterations = result->iterations;
    outcome.details = std::move(*result);
    return {};
}

/// The options of a method with what all methods are asked for.
template <typename Options>
Options optionsFor(const ClusterRequest& request, int Options::*clusters)
{
    Options options;
    options.*clusters = request.clusters;
    options.restarts = request.restarts;
    options.seed = request.seed;
    options.recordSteps = request.recordSteps;
    options.watch = request.watch;
    return options;
}

std::optional<Error> run(ClusterOutcome& outcome, const Eigen::MatrixXd& items)
{
    const ClusterRequest& request = outcome.request;
    switch (request.method) {
    case ClusterMethod::KMeans: {
        KMeansOptions options = optionsFor(request, &KMeansOptions::clusters);
        options.candidates = request.candidates;
        return takeOver(outcome, items, kMeans(items, options));
    }
    case ClusterMethod::SelfOrganizingMap:
        return takeOver(outcome, items,
                        selfOrganizingMap(items, optionsFor(request, &SelfOrganizingMapOptions::groups)));
    case ClusterMethod::GaussianMixture: {
        GaussianMixtureOptions options = optionsFor(request, &GaussianMixtureOptions::components);
        options.covariance = request.covariance;
        return takeOver(outcome, items, gaussianMixture(items, options));
    }
    }
    return {};
}

} // namespace

QString toString(ClusterMethod method)
{
    switch (method) {
    case ClusterMethod::KMeans:
        return u"kmeans"_s;
    case ClusterMethod::SelfOrganizingMap:
        return u"som"_s;
    case ClusterMethod::GaussianMixture:
        return u"gmm"_s;
    }
    return {};
}

Expected<ClusterOutcome> groupRows(const Eigen::MatrixXd& table, const ClusterRequest& request)
{
    if (table.rows() < request.clusters || table.cols() == 0)
        return failure(ErrorCode::BadInput,
                       {Words::say("The table"), Words::say("it has %1 rows").arg(table.rows()),
                        Words::say("at least %1 rows, one a cluster, were expected").arg(request.clusters)});
    ASSIGN_OR_RETURN(const FeatureTransform transform, featureTransform(table, request.scaling));
    ClusterOutcome outcome;
    outcome.request = request;
    outcome.transform = transform;
    RETURN_IF_ERROR(run(outcome, transform.apply(table)));
    return outcome;
}

} // namespace gripscope
