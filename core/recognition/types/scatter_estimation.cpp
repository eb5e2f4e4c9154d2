// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/scatter_estimation.h"

#include "core/math/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace gripscope {

namespace {

/// Sums before they are divided.
struct Sums {
    explicit Sums(Eigen::Index p) : noise(LogMatrix::Zero(p, p))
    {
        scatter.between = scatter.within = LogMatrix::Zero(p, p);
    }

    PartScatter scatter;
    double inverse = 0;
    LogMatrix noise;
    double noiseWeight = 0;

    void add(const std::vector<LogSqueeze>& squeezes)
    {
        const std::vector<PartSqueezes> parts = byPart(squeezes);
        LogVector mean = LogVector::Zero(noise.rows());
        for (const PartSqueezes& part : parts)
            mean += meanOf(part) / double(parts.size());
        // 1 - 1/n: what a squeeze's own noise leaves of itself in its distance from the mean.
        const double weight = 1 - 1.0 / double(parts.size());
        for (const PartSqueezes& part : parts) {
            const LogVector partMean = meanOf(part);
            scatter.between += (partMean - mean) * (partMean - mean).transpose();
            for (const LogSqueeze* squeeze : part) {
                const LogVector difference = squeeze->x - partMean;
                scatter.within += difference * difference.transpose();
                addNoise(*squeeze, part.size() > 1 || weight == 0 ? 1 : weight);
            }
            scatter.withinDegrees += int(part.size()) - 1;
            inverse += weight / double(part.size());
        }
        scatter.betweenDegrees += int(parts.size()) - 1;
    }

private:
    void addNoise(const LogSqueeze& squeeze, double weight)
    {
        if (!squeeze.noise)
            return;
        noise += weight * *squeeze.noise;
        noiseWeight += weight;
    }
};

} // namespace

std::vector<PartSqueezes> byPart(const std::vector<LogSqueeze>& squeezes)
{
    std::vector<PartSqueezes> parts;
    std::map<int, std::size_t> places;
    for (const LogSqueeze& squeeze : squeezes) {
        const auto known = squeeze.part < 0 ? places.end() : places.find(squeeze.part);
        if (known != places.end()) {
            parts[known->second].push_back(&squeeze);
            continue;
        }
        if (squeeze.part >= 0)
            places[squeeze.part] = parts.size();
        parts.push_back({&squeeze});
    }
    return parts;
}

LogVector meanOf(const PartSqueezes& squeezes)
{
    LogVector mean = LogVector::Zero(squeezes.empty() ? 0 : squeezes.front()->x.size());
    for (const LogSqueeze* squeeze : squeezes)
        mean += squeeze->x / double(squeezes.size());
    return mean;
}

PartScatter partScatter(const std::vector<std::vector<LogSqueeze>>& types)
{
    const auto some = std::find_if(types.begin(), types.end(),
                                   [](const std::vector<LogSqueeze>& squeezes) { return !squeezes.empty(); });
    if (some == types.end())
        return {};
    Sums sums(some->front().x.size());
    for (const std::vector<LogSqueeze>& squeezes : types)
        if (!squeezes.empty())
            sums.add(squeezes);
    PartScatter& scatter = sums.scatter;
    if (scatter.betweenDegrees > 0) {
        scatter.between /= scatter.betweenDegrees;
        scatter.meanInverse = sums.inverse / scatter.betweenDegrees;
    }
    if (scatter.withinDegrees > 0)
        scatter.within /= scatter.withinDegrees;
    if (sums.noiseWeight > 0)
        scatter.noise = sums.noise / sums.noiseWeight;
    return scatter;
}

namespace {

using EntryPlaces = std::vector<std::pair<int, int>>;

EntryPlaces placesOfEntries(int p)
{
    EntryPlaces places;
    for (int i = 0; i < p; ++i)
        places.emplace_back(i, i);
    for (int i = 0; i < p; ++i)
        for (int j = i + 1; j < p; ++j)
            places.emplace_back(i, j);
    return places;
}

/// Of the entries of a symmetric p x p matrix, in the order of SymmetricCovariance.
const EntryPlaces& entriesOf(Eigen::Index p)
{
    static const std::array<EntryPlaces, mostDimensions + 1> all{
        placesOfEntries(0), placesOfEntries(1), placesOfEntries(2), placesOfEntries(3),
        placesOfEntries(4), placesOfEntries(5), placesOfEntries(6)};
    return all[std::size_t(p)];
}

constexpr int mostIterations = 40;
constexpr double convergedStep = 1e-9;
/// Keeps S + C invertible where both are zero; the pooled covariance is one.
constexpr double leastLikelyVariance = 1e-9;

using Information = SymmetricCovariance;
using Entries = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, mostEntries, 1>;
using Place = std::pair<int, int>;

/// tr(P E_a Q E_b) with E_a = e_i e_j' + e_j e_i' (e_i e_i' on the diagonal), for symmetric P and Q.
double traceOf(const LogMatrix& p, const Place& a, const LogMatrix& q, const Place& b)
{
    const auto [i, j] = a;
    const auto [k, l] = b;
    double sum = p(l, i) * q(j, k);
    if (i != j)
        sum += p(l, j) * q(i, k);
    if (k != l)
        sum += p(k, i) * q(j, l);
    if (i != j && k != l)
        sum += p(k, j) * q(i, l);
    return sum;
}

LogMatrix fromEntries(const Entries& values, Eigen::Index p)
{
    LogMatrix result(p, p);
    const EntryPlaces& places = entriesOf(p);
    for (std::size_t a = 0; a < places.size(); ++a) {
        const auto [i, j] = places[a];
        result(i, j) = values(Eigen::Index(a));
        result(j, i) = values(Eigen::Index(a));
    }
    return result;
}

/// X_a += P E_a P
void addProducts(std::vector<LogMatrix>& sums, const LogMatrix& p)
{
    const EntryPlaces& places = entriesOf(p.rows());
    for (std::size_t a = 0; a < places.size(); ++a) {
        const auto [i, j] = places[a];
        if (i == j)
            sums[a] += p.col(i) * p.col(i).transpose();
        else
            sums[a] += p.col(i) * p.col(j).transpose() + p.col(j) * p.col(i).transpose();
    }
}

/// Score and expected information of the entries of S, summed over types.
struct Derivatives {
    explicit Derivatives(Eigen::Index p)
        : places(entriesOf(p)), score(LogMatrix::Zero(p, p)),
          information(Information::Zero(Eigen::Index(places.size()), Eigen::Index(places.size())))
    {
    }

    const EntryPlaces& places;
    LogMatrix score; ///< half its product with E_a, traced, is the score
    Information information;

    void add(const std::vector<WhitenedSqueeze>& squeezes, const LogMatrix& between)
    {
        if (squeezes.size() < 2)
            return; // one squeeze says only where its type is
        std::vector<LogMatrix> precisions;
        LogMatrix sum = LogMatrix::Zero(between.rows(), between.rows());
        LogVector weighted = LogVector::Zero(between.rows());
        for (const WhitenedSqueeze& squeeze : squeezes) {
            LogMatrix covariance = between + squeeze.noise;
            covariance.diagonal().array() += leastLikelyVariance;
            precisions.push_back(covariance.inverse());
            sum += precisions.back();
            weighted += precisions.back() * squeeze.x;
        }
        const LogMatrix meanCovariance = sum.inverse();
        const LogVector mean = meanCovariance * weighted;
        std::vector<LogMatrix> products(places.size(), LogMatrix::Zero(between.rows(), between.rows()));
        for (std::size_t j = 0; j < squeezes.size(); ++j) {
            const LogMatrix& p = precisions[j];
            const LogMatrix q = p * meanCovariance * p;
            const LogVector residual = p * (squeezes[j].x - mean);
            score += residual * residual.transpose() - p + q;
            addProducts(products, p);
            for (std::size_t a = 0; a < places.size(); ++a)
                for (std::size_t b = 0; b <= a; ++b)
                    information(Eigen::Index(a), Eigen::Index(b)) +=
                        (traceOf(p, places[a], p, places[b]) - traceOf(p, places[a], q, places[b]) -
                         traceOf(q, places[a], p, places[b])) /
                        2;
        }
        for (std::size_t a = 0; a < places.size(); ++a)
            for (std::size_t b = 0; b <= a; ++b)
                information(Eigen::Index(a), Eigen::Index(b)) +=
                    (meanCovariance * products[a] * meanCovariance).cwiseProduct(products[b]).sum() / 2;
    }

    [[nodiscard]] Entries gradient() const
    {
        Entries result(information.rows());
        for (Eigen::Index a = 0; a < result.size(); ++a) {
            const auto [i, j] = places[std::size_t(a)];
            result(a) = i == j ? score(i, j) / 2 : score(i, j);
        }
        return result;
    }
};

LogMatrix withoutNegativeParts(const LogMatrix& matrix)
{
    const SmallSymmetricAxes eigen = smallSymmetricAxes(matrix);
    return eigen.directions * eigen.values.cwiseMax(0).asDiagonal() * eigen.directions.transpose();
}

} // namespace

double expectedSquare(const SymmetricCovariance& covariance, const LogMatrix& p)
{
    const EntryPlaces& places = entriesOf(p.rows());
    double sum = 0;
    for (std::size_t a = 0; a < places.size(); ++a)
        for (std::size_t b = 0; b < places.size(); ++b)
            sum += covariance(Eigen::Index(a), Eigen::Index(b)) * traceOf(p, places[a], p, places[b]);
    return sum;
}

SymmetricCovariance wishartCovariance(const LogMatrix& v, double degreesOfFreedom)
{
    const EntryPlaces& places = entriesOf(v.rows());
    const auto entries = Eigen::Index(places.size());
    SymmetricCovariance result(entries, entries);
    for (Eigen::Index a = 0; a < entries; ++a) {
        for (Eigen::Index b = 0; b < entries; ++b) {
            const auto [i, j] = places[std::size_t(a)];
            const auto [k, l] = places[std::size_t(b)];
            result(a, b) = (v(i, k) * v(j, l) + v(i, l) * v(j, k)) / degreesOfFreedom;
        }
    }
    return result;
}

SymmetricCovariance transformed(const SymmetricCovariance& covariance, const LogMatrix& t)
{
    const EntryPlaces& places = entriesOf(t.rows());
    const auto entries = Eigen::Index(places.size());
    Information map(entries, entries); // column b: entries of T E_b T'
    for (Eigen::Index b = 0; b < entries; ++b) {
        Entries unit = Entries::Zero(entries);
        unit(b) = 1;
        const LogMatrix moved = t * fromEntries(unit, t.rows()) * t.transpose();
        for (Eigen::Index a = 0; a < entries; ++a)
            map(a, b) = moved(places[std::size_t(a)].first, places[std::size_t(a)].second);
    }
    return map * covariance * map.transpose();
}

ScatterLikelihood maximizeLikelihood(const std::vector<std::vector<WhitenedSqueeze>>& types,
                                     const LogMatrix& start)
{
    ScatterLikelihood result;
    result.between = withoutNegativeParts(start);
    for (int iteration = 0; iteration < mostIterations; ++iteration) {
        Derivatives derivatives(start.rows());
        for (const std::vector<WhitenedSqueeze>& type : types)
            derivatives.add(type, result.between);
        const Information information = derivatives.information.selfadjointView<Eigen::Lower>();
        const Eigen::LDLT<Information> solver(information);
        if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 0))
            return result;
        result.uncertainty = solver.solve(Information::Identity(information.rows(), information.rows()));
        const LogMatrix step = fromEntries(solver.solve(derivatives.gradient()), start.rows());
        if (!step.allFinite())
            return result;
        const LogMatrix next = withoutNegativeParts(result.between + step);
        const double moved = (next - result.between).norm();
        result.between = next;
        if (moved < convergedStep) {
            result.converged = result.uncertainty.allFinite();
            return result;
        }
    }
    // At the edge of what S may be the steps only shorten slowly; the place is good, if not exact.
    result.converged = result.uncertainty.allFinite();
    return result;
}

} // namespace gripscope
