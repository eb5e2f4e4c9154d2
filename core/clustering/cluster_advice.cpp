// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_advice.h"

#include "core/base/words.h"
#include "core/clustering/cluster_items.h"
#include "core/clustering/gaussian_mixture.h"

#include <QMap>

#include <algorithm>
#include <functional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// How much of the time the criteria other than the gap take.
constexpr double shareOfFigures = 0.5;

Finding nameOf(ClusterCriterion criterion)
{
    switch (criterion) {
    case ClusterCriterion::Silhouette:
        return Words::say("silhouette");
    case ClusterCriterion::CalinskiHarabasz:
        return Words::say("Calinski-Harabasz");
    case ClusterCriterion::DaviesBouldin:
        return Words::say("Davies-Bouldin");
    case ClusterCriterion::Gap:
        return Words::say("gap");
    case ClusterCriterion::Bic:
        return Words::say("BIC");
    }
    return {};
}

/// How many different items there are, counted up to `enough`.
int differentItems(const Eigen::MatrixXd& items, int enough)
{
    std::vector<Eigen::Index> kept;
    for (Eigen::Index i = 0; i < items.rows() && int(kept.size()) < enough; ++i)
        if (std::none_of(kept.begin(), kept.end(),
                         [&](Eigen::Index other) { return items.row(i) == items.row(other); }))
            kept.push_back(i);
    return int(kept.size());
}

double bicOf(const Eigen::MatrixXd& items, int components, MixtureCovariance covariance, std::uint64_t seed)
{
    GaussianMixtureOptions options;
    options.components = components;
    options.covariance = covariance;
    options.restarts = 3;
    options.maxIterations = 100; // what later iterations gain changes no choice
    options.seed = seed;
    options.recordSteps = false;
    return gaussianMixture(items, options).value().bic; // the items have been checked
}

ClusterFigures figuresFor(const Eigen::MatrixXd& items, int clusters, bool exact,
                          const ClusterAdviceOptions& options)
{
    KMeansOptions grouping;
    grouping.clusters = clusters;
    grouping.restarts = options.restarts;
    grouping.seed = options.seed;
    grouping.recordSteps = false;
    const KMeansResult found = kMeans(items, grouping).value();
    ClusterFigures figures;
    figures.clusters = clusters;
    // With a cluster for every different item nothing is left over but rounding.
    figures.inertia = exact ? 0 : found.inertia;
    figures.silhouette = silhouette(items, found.labels);
    figures.daviesBouldin = daviesBouldin(items, found.labels);
    if (!exact)
        figures.calinskiHarabasz = calinskiHarabasz(items, found.labels);
    figures.bicTied = bicOf(items, clusters, MixtureCovariance::Tied, options.seed);
    figures.bicFull = bicOf(items, clusters, MixtureCovariance::Full, options.seed);
    return figures;
}

/// The number of clusters with the highest score; the smallest of equals.
std::optional<int> highest(const std::vector<ClusterFigures>& all,
                           const std::function<std::optional<double>(const ClusterFigures&)>& score)
{
    std::optional<int> clusters;
    double best = 0;
    for (const ClusterFigures& figures : all)
        if (const std::optional<double> value = score(figures); value && (!clusters || *value > best)) {
            best = *value;
            clusters = figures.clusters;
        }
    return clusters;
}

std::vector<ClusterVote> votes(const std::vector<ClusterFigures>& figures)
{
    std::vector<std::optional<GapStatistic>> gaps;
    gaps.reserve(figures.size());
    for (const ClusterFigures& one : figures)
        gaps.push_back(one.gap);
    const auto lowDaviesBouldin = [](const ClusterFigures& one) -> std::optional<double> {
        return one.daviesBouldin ? std::optional(-*one.daviesBouldin) : std::nullopt;
    };
    return {{ClusterCriterion::Silhouette,
             highest(figures, [](const ClusterFigures& one) { return one.silhouette; })},
            {ClusterCriterion::CalinskiHarabasz,
             highest(figures, [](const ClusterFigures& one) { return one.calinskiHarabasz; })},
            {ClusterCriterion::DaviesBouldin, highest(figures, lowDaviesBouldin)},
            {ClusterCriterion::Gap, clustersByGap(gaps)},
            {ClusterCriterion::Bic, highest(figures, [](const ClusterFigures& one) {
                 return std::optional(-std::min(one.bicTied, one.bicFull));
             })}};
}

/// Who is for which number, the numbers ascending.
QMap<int, Findings> supporters(const std::vector<ClusterVote>& votes)
{
    QMap<int, Findings> found;
    for (const ClusterVote& vote : votes)
        if (vote.clusters)
            found[*vote.clusters].push_back(nameOf(vote.criterion));
    return found;
}

/// Only the gap and the BIC look at one cluster at all: one is advised when neither wants more.
bool saysOneGroup(const std::vector<ClusterVote>& votes)
{
    bool said = false;
    for (const ClusterVote& vote : votes) {
        if (vote.criterion != ClusterCriterion::Gap && vote.criterion != ClusterCriterion::Bic)
            continue;
        if (vote.clusters.value_or(1) != 1)
            return false;
        said = said || vote.clusters.has_value();
    }
    return said;
}

Finding joinedByAnd(const Findings& parts)
{
    Finding all;
    for (const Finding& part : parts)
        all = all.isEmpty() ? part : all + Words::say(" and ") + part;
    return all;
}

void decide(ClusterAdvice& advice)
{
    const QMap<int, Findings> named = supporters(advice.votes);
    if (named.isEmpty() || saysOneGroup(advice.votes)) {
        advice.clusters = 1;
        advice.reason = named.isEmpty()
                            ? Words::say("One group: nothing speaks for more.")
                            : Words::say("One group: %1 can say so and do; the other criteria compare "
                                         "two groups and more only.")
                                  .arg(joinedByAnd(named.value(1)));
        return;
    }
    std::size_t most = 0;
    for (const Findings& names : named)
        most = std::max(most, names.size());
    const std::optional<int> silhouettes = advice.votes.front().clusters;
    const bool tie = std::count_if(named.begin(), named.end(),
                                   [&](const Findings& names) { return names.size() == most; }) > 1;
    for (auto number = named.end(); number != named.begin();) {
        --number;
        if (number->size() == most)
            advice.clusters = number.key(); // ends at the smallest
    }
    if (silhouettes && named[*silhouettes].size() == most)
        advice.clusters = *silhouettes;
    Findings others;
    for (auto number = named.begin(); number != named.end(); ++number)
        if (number.key() != advice.clusters)
            others.push_back(
                Words::say("%1 for %2").arg(Finding::joined(*number, u", "_s)).arg(number.key()));
    advice.reason = Words::say("%1 groups: %2 for it")
                        .arg(advice.clusters)
                        .arg(Finding::joined(named[advice.clusters], u", "_s));
    if (!others.empty())
        advice.reason += Words::say("; %1").arg(Finding::joined(others, u"; "_s));
    if (tie)
        advice.reason += silhouettes == advice.clusters ? Words::say("; of equals the silhouette's")
                                                        : Words::say("; of equals the fewest groups");
    advice.reason += u"."_s;
}

} // namespace

QString toString(ClusterCriterion criterion)
{
    switch (criterion) {
    case ClusterCriterion::Silhouette:
        return u"silhouette"_s;
    case ClusterCriterion::CalinskiHarabasz:
        return u"calinski_harabasz"_s;
    case ClusterCriterion::DaviesBouldin:
        return u"davies_bouldin"_s;
    case ClusterCriterion::Gap:
        return u"gap"_s;
    case ClusterCriterion::Bic:
        return u"bic"_s;
    }
    return {};
}

Expected<ClusterAdvice> adviseClusters(const Eigen::MatrixXd& items, const ClusterAdviceOptions& options)
{
    for (const auto& problem :
         {countProblem(u"maxClusters"_s, options.maxClusters), countProblem(u"restarts"_s, options.restarts),
          countProblem(u"mostItems"_s, int(std::min<Eigen::Index>(options.mostItems, 1'000'000)))})
        if (problem)
            return tl::unexpected(*problem);
    RETURN_IF_ERROR(clusterItemsProblem(items));
    if (items.size() == 0)
        return failure(ErrorCode::BadInput,
                       {Words::say("The table to be clustered"), Words::say("found no rows"),
                        Words::say("expected at least one")});
    ClusterAdvice advice;
    const Eigen::MatrixXd sample = sampleOfItems(items, options.mostItems, options.seed);
    const double scale = powerOfTwoScale(sample);
    const Eigen::MatrixXd judged = sample * scale;
    advice.itemsUsed = judged.rows();
    const int different = differentItems(judged, options.maxClusters + 1);
    const int most = std::min(options.maxClusters, different);
    for (int clusters = 1; clusters <= most; ++clusters) {
        advice.figures.push_back(figuresFor(judged, clusters, clusters == different, options));
        if (isStopped(options.watch))
            return tl::unexpected(clusteringCancelled());
        if (options.watch)
            options.watch->setShare(shareOfFigures * clusters / most);
    }
    std::vector<double> inertias;
    for (const ClusterFigures& figures : advice.figures)
        inertias.push_back(figures.inertia);
    GapOptions gapOptions;
    gapOptions.seed = options.seed;
    gapOptions.watch = options.watch;
    gapOptions.shareBefore = shareOfFigures;
    const std::vector<std::optional<GapStatistic>> gaps = gapStatistics(judged, inertias, gapOptions);
    if (isStopped(options.watch))
        return tl::unexpected(clusteringCancelled());
    for (std::size_t i = 0; i < gaps.size(); ++i) {
        advice.figures[i].gap = gaps[i];
        advice.figures[i].inertia = inertias[i] / scale / scale;
    }
    advice.votes = votes(advice.figures);
    decide(advice);
    return advice;
}

} // namespace gripscope
