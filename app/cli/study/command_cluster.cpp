// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/clustering/cluster_method.h"
#include "core/clustering/feature_table.h"

#include <algorithm>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// What is asked for.
struct Task {
    ClusterRequest request;
    QStringList features;
    std::optional<ClusterAdviceOptions> advice; ///< how many clusters is to be found out
};

/// What was found, and in which table.
struct Clustering {
    FeatureTable table;
    ClusterOutcome outcome;
    std::optional<ClusterAgreement> agreement;
    std::optional<ClusterAdvice> advice;
};

Expected<ClusterAdvice> advise(const Eigen::MatrixXd& table, const Task& task)
{
    ASSIGN_OR_RETURN(const FeatureTransform transform, featureTransform(table, task.request.scaling));
    return adviseClusters(transform.apply(table), *task.advice);
}

Expected<Clustering> cluster(FeatureTable table, Task task)
{
    Clustering found;
    if (task.advice) {
        ASSIGN_OR_RETURN(ClusterAdvice advice, advise(table.values, task));
        task.request.clusters = advice.clusters;
        found.advice = std::move(advice);
    }
    ASSIGN_OR_RETURN(ClusterOutcome outcome, groupRows(table.values, task.request));
    if (!table.truth.isEmpty())
        found.agreement = clusterAgreement(table.truth, outcome.labels, int(outcome.centroids.rows()));
    found.outcome = std::move(outcome);
    found.table = std::move(table);
    return found;
}

QString number(std::optional<double> value, int width)
{
    return (value ? QString::number(*value, 'g', 4) : u"-"_qs).rightJustified(width);
}

QStringList adviceLines(const ClusterAdvice& advice, Eigen::Index items)
{
    QStringList lines{advice.reason.describe()};
    if (advice.itemsUsed < items)
        lines << u"judged by %1 of %2 items, drawn by the seed"_qs.arg(advice.itemsUsed).arg(items);
    lines << u"clusters  silhouette  Calinski-H.  Davies-B.       gap     +-   BIC tied   BIC full"_qs;
    for (const ClusterFigures& one : advice.figures)
        lines << u"%1  %2  %3  %4  %5 %6 %7 %8"_qs.arg(
            QString::number(one.clusters).rightJustified(8), number(one.silhouette, 10),
            number(one.calinskiHarabasz, 11), number(one.daviesBouldin, 9),
            number(one.gap ? std::optional(one.gap->value) : std::nullopt, 8),
            number(one.gap ? std::optional(one.gap->error) : std::nullopt, 6), number(one.bicTied, 10),
            number(one.bicFull, 10));
    return lines << QString();
}

/// What the method alone has to say.
QString ownLine(const ClusterOutcome& outcome)
{
    if (const auto* mixture = std::get_if<GaussianMixtureResult>(&outcome.details))
        return u"log-likelihood %1, BIC %2 with %3 free parameters (%4 covariance)"_qs.arg(
            QString::number(mixture->logLikelihood, 'g', 8), QString::number(mixture->bic, 'g', 8),
            QString::number(mixture->freeParameters),
            outcome.request.covariance == MixtureCovariance::Full ? u"full"_qs : u"tied"_qs);
    if (const auto* map = std::get_if<SelfOrganizingMapResult>(&outcome.details))
        return u"map of %1 x %2 units; quantization error %3, topographic error %4 %"_qs.arg(
            QString::number(map->rows), QString::number(map->columns),
            QString::number(map->quantizationError, 'g', 6),
            QString::number(100 * map->topographicError, 'f', 1));
    return {};
}

QStringList groupLines(const Clustering& found)
{
    const ClusterOutcome& outcome = found.outcome;
    QString head = u"cluster   items"_qs;
    for (const QString& feature : found.table.features)
        head += feature.rightJustified(14);
    QStringList lines{head};
    for (int i = 0; i < outcome.centroids.rows(); ++i) {
        const auto items = std::count(outcome.labels.begin(), outcome.labels.end(), i);
        QString row = u"%1  %2"_qs.arg(i, 7).arg(items, 6);
        for (int j = 0; j < outcome.centroids.cols(); ++j)
            row += QString::number(outcome.centroids(i, j), 'g', 6).rightJustified(14);
        lines << row;
    }
    return lines;
}

QStringList agreementLines(const ClusterAgreement& agreement)
{
    QStringList lines{
        u"adjusted Rand index against the truth: %1"_qs.arg(agreement.adjustedRandIndex, 0, 'g', 6)};
    for (int i = 0; i < agreement.counts.rows(); ++i) {
        QString row = u"  %1"_qs.arg(agreement.truths[i], -12);
        for (int j = 0; j < agreement.counts.cols(); ++j)
            row += QString::number(agreement.counts(i, j)).rightJustified(6);
        lines << row;
    }
    return lines;
}

QString text(const Clustering& found)
{
    const ClusterOutcome& outcome = found.outcome;
    QStringList lines;
    if (found.advice)
        lines << adviceLines(*found.advice, found.table.values.rows());
    lines << u"%1: %2 items, %3 clusters, scaling %4; inertia %5 after %6 iterations%7"_qs.arg(
        toString(outcome.request.method), QString::number(outcome.labels.size()),
        QString::number(outcome.centroids.rows()), toString(outcome.request.scaling),
        QString::number(outcome.inertia, 'g', 10), QString::number(outcome.iterations),
        outcome.converged ? QString() : u" (not converged)"_qs);
    if (const QString own = ownLine(outcome); !own.isEmpty())
        lines << own;
    if (outcome.centroids.rows() < outcome.request.clusters)
        lines << u"the items are too alike for more than %1 clusters"_qs.arg(outcome.centroids.rows());
    lines << groupLines(found);
    if (found.agreement)
        lines << agreementLines(*found.agreement);
    return lines.join(u'\n');
}

void addClusterOptions(CommandLine& line)
{
    line.option(u"features"_qs, u"LIST"_qs, u"Columns to group by, separated by commas."_qs, u"m,b,k"_qs);
    line.option(u"clusters"_qs, u"K"_qs, u"How many groups; auto: as many as the table seems to have."_qs,
                u"4"_qs);
    line.option(u"max-clusters"_qs, u"K"_qs, u"The most groups that auto looks at."_qs, u"8"_qs);
    line.option(u"method"_qs, u"METHOD"_qs,
                u"kmeans, som (Kohonen's self-organizing map) or gmm (Gaussian mixture)."_qs, u"kmeans"_qs);
    line.option(u"covariance"_qs, u"KIND"_qs, u"Of the mixture: full (one a group) or tied."_qs, u"full"_qs);
    line.option(u"scaling"_qs, u"SCALING"_qs, u"none, zscore, log (natural) or zlog."_qs, u"zscore"_qs);
    line.option(u"seed"_qs, u"N"_qs, u"Seed of the starts."_qs, u"1"_qs);
    line.option(u"restarts"_qs, u"N"_qs, u"Starts, of which the best is kept."_qs, u"10"_qs);
    line.option(u"truth"_qs, u"COLUMN"_qs, u"Column with the true groups, for the adjusted Rand index."_qs);
}

Task readTask(CommandLine& line)
{
    Task task;
    ClusterRequest& request = task.request;
    request.recordSteps = false;
    request.restarts = line.integer(u"restarts"_qs, 1, 1'000'000);
    request.seed = line.seed();
    if (line.text(u"clusters"_qs) == u"auto"_qs) {
        task.advice.emplace();
        task.advice->maxClusters = line.integer(u"max-clusters"_qs, 1, 100);
        task.advice->restarts = request.restarts;
        task.advice->seed = request.seed;
    } else {
        request.clusters = line.integer(u"clusters"_qs, 1, 10'000);
    }
    task.features = line.list(u"features"_qs);
    if (task.features.isEmpty())
        line.reject(u"--features names no column."_qs);
    request.scaling = static_cast<FeatureScaling>(
        line.choice(u"scaling"_qs, {u"none"_qs, u"zscore"_qs, u"log"_qs, u"zlog"_qs}));
    request.method =
        static_cast<ClusterMethod>(line.choice(u"method"_qs, {u"kmeans"_qs, u"som"_qs, u"gmm"_qs}));
    request.covariance =
        static_cast<MixtureCovariance>(line.choice(u"covariance"_qs, {u"tied"_qs, u"full"_qs}));
    return task;
}

} // namespace

int runCluster(const QStringList& arguments)
{
    CommandLine line(u"cluster"_qs, u"Groups the rows of a table without looking at labels."_qs,
                     u"TABLE.csv"_qs);
    addClusterOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const Task task = readTask(line);
    if (line.files().size() != 1)
        line.reject(u"one table at a time, please."_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;

    const bool json = line.isSet(u"json"_qs);
    Expected<FeatureTable> table =
        readFeatureTable(line.files().first(), task.features, line.text(u"truth"_qs));
    if (!table)
        return fail(table.error(), json);
    const Expected<Clustering> found = cluster(std::move(*table), task);
    if (!found)
        return fail(found.error(), json);
    if (json)
        printJson(clusterJson(found->outcome, found->table.features, found->agreement, found->advice));
    else
        print(text(*found));
    return 0;
}

} // namespace gripscope::cli
