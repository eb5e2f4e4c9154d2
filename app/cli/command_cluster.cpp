// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands.h"
#include "app/cli/exit_code.h"
#include "app/cli/output.h"
#include "app/cli/shared_options.h"
#include "core/recognition/cluster_agreement.h"
#include "core/recognition/feature_scaling.h"
#include "core/recognition/feature_table.h"
#include "core/recognition/kmeans.h"

#include <QJsonArray>

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// What was found, and in which table.
struct Clustering {
    FeatureTable table;
    KMeansResult result;
    Eigen::MatrixXd centroids; ///< in the table's own units
    std::optional<ClusterAgreement> agreement;
};

Expected<Clustering> cluster(FeatureTable table, FeatureScaling scaling, const KMeansOptions& options)
{
    const Expected<FeatureTransform> transform = featureTransform(table.values, scaling);
    if (!transform)
        return tl::unexpected<Error>(transform.error());
    Expected<KMeansResult> result = kMeans(transform->apply(table.values), options);
    if (!result)
        return tl::unexpected<Error>(result.error());
    if (result->status == KMeansStatus::TooFewItems)
        return failure(ErrorCode::BadInput,
                       {u"The table"_qs, u"it has %1 rows"_qs.arg(table.values.rows()),
                        u"at least %1 rows, one a cluster, were expected"_qs.arg(options.clusters)});
    Clustering found;
    found.centroids = transform->undo(result->centroids);
    if (!table.truth.isEmpty())
        found.agreement = clusterAgreement(table.truth, result->labels, options.clusters);
    found.result = std::move(*result);
    found.table = std::move(table);
    return found;
}

QJsonObject confusionJson(const ClusterAgreement& agreement)
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

QJsonObject document(const Clustering& found, const QString& method)
{
    QJsonArray labels;
    for (const int label : found.result.labels)
        labels.append(label);
    QJsonArray centroids;
    for (int i = 0; i < found.centroids.rows(); ++i) {
        QJsonArray row;
        for (int j = 0; j < found.centroids.cols(); ++j)
            row.append(found.centroids(i, j));
        centroids.append(row);
    }
    const std::optional<ClusterAgreement>& agreement = found.agreement;
    return {{u"method"_qs, method},
            {u"labels"_qs, labels},
            {u"centroids"_qs, centroids},
            {u"inertia"_qs, found.result.inertia},
            {u"iterations"_qs, found.result.iterations},
            {u"adjusted_rand_index"_qs, agreement ? QJsonValue(agreement->adjustedRandIndex) : QJsonValue()},
            {u"confusion"_qs, agreement ? QJsonValue(confusionJson(*agreement)) : QJsonValue()}};
}

QString text(const Clustering& found, FeatureScaling scaling)
{
    const KMeansResult& result = found.result;
    QStringList lines{u"k-means: %1 items, %2 clusters, scaling %3; inertia %4 after %5 iterations%6"_qs.arg(
        QString::number(result.labels.size()), QString::number(found.centroids.rows()), toString(scaling),
        QString::number(result.inertia, 'g', 10), QString::number(result.iterations),
        result.status == KMeansStatus::Converged ? QString() : u" (not converged)"_qs)};
    QString head = u"cluster  items"_qs;
    for (const QString& feature : found.table.features)
        head += feature.rightJustified(14);
    lines << head;
    for (int i = 0; i < found.centroids.rows(); ++i) {
        const auto items = std::count(result.labels.begin(), result.labels.end(), i);
        QString row = u"%1  %2"_qs.arg(i, 7).arg(items, 5);
        for (int j = 0; j < found.centroids.cols(); ++j)
            row += QString::number(found.centroids(i, j), 'g', 6).rightJustified(14);
        lines << row;
    }
    if (!found.agreement)
        return lines.join(u'\n');
    lines << u"adjusted Rand index against the truth: %1"_qs.arg(found.agreement->adjustedRandIndex, 0, 'g',
                                                                 6);
    for (int i = 0; i < found.agreement->counts.rows(); ++i) {
        QString row = u"  %1"_qs.arg(found.agreement->truths[i], -12);
        for (int j = 0; j < found.agreement->counts.cols(); ++j)
            row += QString::number(found.agreement->counts(i, j)).rightJustified(5);
        lines << row;
    }
    return lines.join(u'\n');
}

void addOptions(CommandLine& line)
{
    line.option(u"features"_qs, u"LIST"_qs, u"Columns to group by, separated by commas."_qs, u"m,b,k"_qs);
    line.option(u"clusters"_qs, u"K"_qs, u"How many groups."_qs, u"4"_qs);
    line.option(u"method"_qs, u"METHOD"_qs, u"kmeans (som and gmm: not yet)."_qs, u"kmeans"_qs);
    line.option(u"scaling"_qs, u"SCALING"_qs, u"none, zscore, log (natural) or zlog."_qs, u"zscore"_qs);
    line.option(u"seed"_qs, u"N"_qs, u"Seed of the starts."_qs, u"1"_qs);
    line.option(u"restarts"_qs, u"N"_qs, u"Starts, of which the best is kept."_qs, u"10"_qs);
    line.option(u"truth"_qs, u"COLUMN"_qs, u"Column with the true groups, for the adjusted Rand index."_qs);
}

} // namespace

int runCluster(const QStringList& arguments)
{
    CommandLine line(u"cluster"_qs, u"Groups the rows of a table without looking at labels."_qs,
                     u"TABLE.csv"_qs);
    addOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    KMeansOptions options;
    options.clusters = line.integer(u"clusters"_qs, 1, 10'000);
    options.restarts = line.integer(u"restarts"_qs, 1, 1'000'000);
    options.seed = line.seed();
    const QStringList features = line.list(u"features"_qs);
    if (features.isEmpty())
        line.reject(u"--features names no column."_qs);
    (void)line.choice(u"scaling"_qs, {u"none"_qs, u"zscore"_qs, u"log"_qs, u"zlog"_qs});
    const int method = line.choice(u"method"_qs, {u"kmeans"_qs, u"som"_qs, u"gmm"_qs});
    if (line.files().size() != 1)
        line.reject(u"one table at a time, please."_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    if (method != 0)
        return fail({ErrorCode::NotSupportedYet, {u"The method "_qs + line.text(u"method"_qs)}});

    const bool json = line.isSet(u"json"_qs);
    const FeatureScaling scaling = *featureScalingFromString(line.text(u"scaling"_qs));
    Expected<FeatureTable> table = readFeatureTable(line.files().first(), features, line.text(u"truth"_qs));
    if (!table)
        return fail(table.error(), json);
    const Expected<Clustering> found = cluster(std::move(*table), scaling, options);
    if (!found)
        return fail(found.error(), json);
    if (json)
        printJson(document(*found, line.text(u"method"_qs)));
    else
        print(text(*found, scaling));
    return 0;
}

} // namespace gripscope::cli
