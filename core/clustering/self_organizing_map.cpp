// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/self_organizing_map.h"

#include "core/base/words.h"
#include "core/clustering/cluster_items.h"
#include "core/clustering/map_training.h"
#include "core/math/decompositions.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double lastRadius = 0.5;
constexpr int orderingPasses = 30;
constexpr int mostSettlingPasses = 100;
constexpr Eigen::Index mostOrderedItems = 10'000;
/// One in so many: on a long table some item is always about to change its unit.
constexpr std::size_t itemsThatMayChange = 500;

/// What one start came to.
struct Training {
    Eigen::MatrixXd weights;
    double distortion = 0;
    std::vector<SelfOrganizingMapStep> steps;
    int passes = 0;
    bool converged = false;
};

void pass(MapTraining& map, double radius, Training& training, bool recordStep)
{
    training.converged = map.move(radius) <= map.best().size() / itemsThatMayChange;
    ++training.passes;
    if (recordStep)
        training.steps.push_back({map.weights(), radius, map.quantizationError()});
}

/// Passes with the last radius until no item changes its unit.
void settle(MapTraining& map, Training& training, const SelfOrganizingMapOptions& options)
{
    training.converged = false;
    for (int i = 0; i < mostSettlingPasses && !training.converged && !isStopped(options.watch); ++i)
        pass(map, lastRadius, training, options.recordSteps);
    training.weights = map.weights();
    training.distortion = map.distortion(lastRadius);
}

Training train(MapTraining& map, const MapGrid& grid, const Eigen::MatrixXd& start,
               const SelfOrganizingMapOptions& options)
{
    Training training;
    map.place(start);
    if (options.recordSteps)
        training.steps.push_back({start, 0, map.quantizationError()});
    const double firstRadius = std::max(std::max(grid.rows, grid.columns) / 2.0, lastRadius);
    for (int i = 0; i < orderingPasses && !isStopped(options.watch); ++i)
        pass(map, firstRadius * std::pow(lastRadius / firstRadius, double(i) / (orderingPasses - 1)),
             training, options.recordSteps);
    settle(map, training, options);
    return training;
}

/// Groups the units that hold items and hands the groups on to the items and to the other units.
void formGroups(SelfOrganizingMapResult& result, const Eigen::MatrixXd& items, int groups)
{
    const std::size_t units = result.hits.size();
    ItemRows sums = ItemRows::Zero(Eigen::Index(units), items.cols());
    for (Eigen::Index i = 0; i < items.rows(); ++i)
        sums.row(result.unitOfItem[std::size_t(i)]) += items.row(i);
    // In the order in which they appear in the table, so that the groups are numbered by first appearance.
    const std::vector<int> order = numbersByAppearance(result.unitOfItem, int(units));
    const auto used =
        Eigen::Index(std::count_if(result.hits.begin(), result.hits.end(), [](int n) { return n > 0; }));
    Eigen::MatrixXd means(used, items.cols());
    Eigen::VectorXd counts(used);
    for (std::size_t unit = 0; unit < units; ++unit)
        if (result.hits[unit] > 0) {
            counts(order[unit]) = result.hits[unit];
            means.row(order[unit]) = sums.row(Eigen::Index(unit)) / result.hits[unit];
        }
    const std::vector<int> group = wardGroups(means, counts, groups);
    const int found = 1 + *std::max_element(group.begin(), group.end());
    result.centroids = Eigen::MatrixXd::Zero(found, items.cols());
    Eigen::VectorXd members = Eigen::VectorXd::Zero(found);
    for (Eigen::Index point = 0; point < used; ++point) {
        result.centroids.row(group[std::size_t(point)]) += counts(point) * means.row(point);
        members(group[std::size_t(point)]) += counts(point);
    }
    result.centroids.array().colwise() /= members.array();
    result.groupOfUnit.resize(units);
    for (std::size_t unit = 0; unit < units; ++unit) {
        Eigen::Index nearest = 0;
        if (result.hits[unit] > 0)
            nearest = group[std::size_t(order[unit])];
        else
            (result.centroids.rowwise() - result.weights.row(Eigen::Index(unit)))
                .rowwise()
                .squaredNorm()
                .minCoeff(&nearest);
        result.groupOfUnit[unit] = int(nearest);
    }
    for (const int unit : result.unitOfItem)
        result.labels.push_back(result.groupOfUnit[std::size_t(unit)]);
}

SelfOrganizingMapResult mapOf(const Eigen::MatrixXd& items, const SelfOrganizingMapOptions& options)
{
    const PrincipalAxes axes = principalAxes(items);
    const MapGrid grid = chooseGrid(options, items.rows(), axes);
    const Eigen::MatrixXd ordered = sampleOfItems(items, mostOrderedItems, options.seed);
    MapTraining ordering(ordered, grid);
    std::mt19937_64 random(options.seed);
    Training best;
    for (int run = 0; run < options.restarts && !isStopped(options.watch); ++run) {
        Training training =
            train(ordering, grid,
                  run == 0 ? weightsOnPlane(grid, axes) : weightsFromItems(grid, ordered, random), options);
        if (run == 0 || training.distortion < best.distortion)
            best = std::move(training);
    }
    if (isStopped(options.watch))
        return {}; // which the caller does not hand on
    MapTraining map(items, grid);
    map.place(best.weights);
    if (ordered.rows() < items.rows())
        settle(map, best, options);
    SelfOrganizingMapResult result;
    result.status =
        best.converged ? SelfOrganizingMapStatus::Converged : SelfOrganizingMapStatus::NotConverged;
    result.rows = grid.rows;
    result.columns = grid.columns;
    result.weights = best.weights;
    result.unitOfItem = map.best();
    result.hits.assign(std::size_t(grid.units()), 0);
    for (const int unit : result.unitOfItem)
        ++result.hits[std::size_t(unit)];
    result.quantizationError = map.quantizationError();
    result.topographicError = map.topographicError();
    result.distortion = best.distortion;
    result.iterations = best.passes;
    result.steps = std::move(best.steps);
    formGroups(result, items, options.groups);
    return result;
}

void divideBy(double scale, SelfOrganizingMapResult& result)
{
    result.weights /= scale;
    result.centroids /= scale;
    result.quantizationError /= scale;
    result.distortion = result.distortion / scale / scale;
    for (SelfOrganizingMapStep& step : result.steps) {
        step.weights /= scale;
        step.quantizationError /= scale;
    }
}

} // namespace

std::optional<Error> SelfOrganizingMapOptions::validate() const
{
    for (auto problem : {countProblem(u"groups"_s, groups), countProblem(u"restarts"_s, restarts)})
        if (problem)
            return problem;
    const auto units = double(std::max(rows, 1)) * double(std::max(columns, 1));
    if (rows < 0 || columns < 0 || units > mostMapUnits)
        return Error{ErrorCode::Usage,
                     {Words::say("A map of %1 x %2 units is not between 1 and %3 units.")
                          .arg(rows)
                          .arg(columns)
                          .arg(mostMapUnits)}};
    if (groups > (rows > 0 && columns > 0 ? int(units) : mostMapUnits))
        return Error{ErrorCode::Usage, {Words::say("A map has too few units for %1 groups.").arg(groups)}};
    return {};
}

Eigen::MatrixXd SelfOrganizingMapResult::uMatrix() const
{
    const MapGrid grid{rows, columns};
    Eigen::MatrixXd heights = Eigen::MatrixXd::Zero(rows, columns);
    for (int one = 0; one < grid.units(); ++one) {
        double sum = 0;
        int count = 0;
        for (int other = 0; other < grid.units(); ++other)
            if (grid.neighbours(one, other)) {
                sum += (weights.row(one) - weights.row(other)).norm();
                ++count;
            }
        heights(one / columns, one % columns) = count > 0 ? sum / count : 0;
    }
    return heights;
}

Eigen::MatrixXd SelfOrganizingMapResult::componentPlane(int feature) const
{
    return Eigen::Map<const ItemRows>(Eigen::VectorXd(weights.col(feature)).data(), rows, columns);
}

Expected<SelfOrganizingMapResult> selfOrganizingMap(const Eigen::MatrixXd& items,
                                                    const SelfOrganizingMapOptions& options)
{
    RETURN_IF_ERROR(options.validate());
    RETURN_IF_ERROR(clusterItemsProblem(items));
    if (items.rows() < options.groups || items.cols() == 0)
        return SelfOrganizingMapResult{};
    const double scale = powerOfTwoScale(items);
    SelfOrganizingMapResult result = mapOf(items * scale, options);
    if (isStopped(options.watch))
        return tl::unexpected(clusteringCancelled());
    divideBy(scale, result);
    return result;
}

} // namespace gripscope
