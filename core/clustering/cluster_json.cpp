// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/json_value.h"
#include "core/clustering/cluster_method.h"

#include <QJsonArray>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

template <typename Numbers>
QJsonArray list(const Numbers& numbers)
{
    QJsonArray array;
    for (const auto number : numbers)
        array.append(jsonNumber(double(number)));
    return array;
}

QJsonArray matrix(const Eigen::MatrixXd& values)
{
    QJsonArray rows;
    for (Eigen::Index i = 0; i < values.rows(); ++i)
        rows.append(list(Eigen::VectorXd(values.row(i))));
    return rows;
}

QJsonArray integers(const std::vector<int>& numbers)
{
    QJsonArray array;
    for (const int number : numbers)
        array.append(number);
    return array;
}

/// A number a unit as rows of the map.
QJsonArray onGrid(const std::vector<int>& units, int columns)
{
    QJsonArray rows;
    for (std::size_t at = 0; at < units.size(); at += std::size_t(columns))
        rows.append(
            integers({units.begin() + std::ptrdiff_t(at), units.begin() + std::ptrdiff_t(at) + columns}));
    return rows;
}

QJsonObject confusion(const ClusterAgreement& agreement)
{
    QJsonObject rows;
    for (int i = 0; i < agreement.counts.rows(); ++i) {
        QJsonObject row;
        for (int j = 0; j < agreement.counts.cols(); ++j)
            row[QString::number(j)] = agreement.counts(i, j);
        rows[agreement.truths[i]] = row;
    }
    return rows;
}

QJsonObject mixtureJson(const GaussianMixtureResult& mixture, MixtureCovariance covariance)
{
    QJsonArray covariances;
    for (const Eigen::MatrixXd& one : mixture.parameters.covariances)
        covariances.append(matrix(one));
    return {{u"covariance"_s, covariance == MixtureCovariance::Full ? u"full"_s : u"tied"_s},
            {u"weights"_s, list(mixture.parameters.weights)},
            {u"covariances"_s, covariances},
            {u"log_likelihood"_s, jsonNumber(mixture.logLikelihood)},
            {u"bic"_s, jsonNumber(mixture.bic)},
            {u"free_parameters"_s, mixture.freeParameters}};
}

QJsonObject mapJson(const SelfOrganizingMapResult& map, const FeatureTransform& transform,
                    const QStringList& features)
{
    SelfOrganizingMapResult inUnits = map;
    inUnits.weights = transform.undo(map.weights);
    QJsonObject planes;
    for (qsizetype j = 0; j < features.size(); ++j)
        planes[features[j]] = matrix(inUnits.componentPlane(int(j)));
    return {{u"rows"_s, map.rows},
            {u"columns"_s, map.columns},
            {u"quantization_error"_s, jsonNumber(map.quantizationError)},
            {u"topographic_error"_s, jsonNumber(map.topographicError)},
            {u"hits"_s, onGrid(map.hits, map.columns)},
            {u"group"_s, onGrid(map.groupOfUnit, map.columns)},
            {u"u_matrix"_s, matrix(map.uMatrix())},
            {u"component_planes"_s, planes}};
}

QJsonObject adviceJson(const ClusterAdvice& advice)
{
    QJsonArray figures;
    for (const ClusterFigures& one : advice.figures)
        figures.append(
            QJsonObject{{u"clusters"_s, one.clusters},
                        {u"inertia"_s, jsonNumber(one.inertia)},
                        {u"silhouette"_s, jsonNumber(one.silhouette)},
                        {u"calinski_harabasz"_s, jsonNumber(one.calinskiHarabasz)},
                        {u"davies_bouldin"_s, jsonNumber(one.daviesBouldin)},
                        {u"gap"_s, one.gap ? jsonNumber(one.gap->value) : QJsonValue(QJsonValue::Null)},
                        {u"gap_error"_s, one.gap ? jsonNumber(one.gap->error) : QJsonValue(QJsonValue::Null)},
                        {u"bic_tied"_s, jsonNumber(one.bicTied)},
                        {u"bic_full"_s, jsonNumber(one.bicFull)}});
    QJsonObject votes;
    for (const ClusterVote& vote : advice.votes)
        votes[toString(vote.criterion)] =
            vote.clusters ? QJsonValue(*vote.clusters) : QJsonValue(QJsonValue::Null);
    return {{u"clusters"_s, advice.clusters},
            {u"reason"_s, advice.reason.english()},
            {u"votes"_s, votes},
            {u"figures"_s, figures},
            {u"items_used"_s, qint64(advice.itemsUsed)}};
}

} // namespace

QJsonObject clusterJson(const ClusterOutcome& outcome, const QStringList& features,
                        const std::optional<ClusterAgreement>& agreement,
                        const std::optional<ClusterAdvice>& advice)
{
    QJsonObject document{
        {u"method"_s, toString(outcome.request.method)},
        {u"scaling"_s, toString(outcome.request.scaling)},
        {u"seed"_s, qint64(outcome.request.seed)},
        {u"labels"_s, integers(outcome.labels)},
        {u"centroids"_s, matrix(outcome.centroids)},
        {u"inertia"_s, jsonNumber(outcome.inertia)},
        {u"iterations"_s, outcome.iterations},
        {u"converged"_s, outcome.converged},
        {u"adjusted_rand_index"_s, agreement ? QJsonValue(agreement->adjustedRandIndex) : QJsonValue()},
        {u"confusion"_s, agreement ? QJsonValue(confusion(*agreement)) : QJsonValue()}};
    if (const auto* mixture = std::get_if<GaussianMixtureResult>(&outcome.details))
        document[u"mixture"_s] = mixtureJson(*mixture, outcome.request.covariance);
    if (const auto* map = std::get_if<SelfOrganizingMapResult>(&outcome.details))
        document[u"map"_s] = mapJson(*map, outcome.transform, features);
    if (advice)
        document[u"advice"_s] = adviceJson(*advice);
    return document;
}

} // namespace gripscope
