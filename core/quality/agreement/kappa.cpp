// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/distributions.h"
#include "core/quality/agreement/attribute_agreement.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gripscope {

namespace {

/// Counted, not summed in shares: two raters that always agree on one class have exactly 1.
struct PairCounts {
    std::vector<double> first, second;
    double same = 0;
};

PairCounts countPairs(std::span<const VerdictPair> pairs, int classes)
{
    PairCounts counts{std::vector<double>(std::size_t(classes)), std::vector<double>(std::size_t(classes))};
    for (const VerdictPair& pair : pairs) {
        counts.first[pair.first] += 1;
        counts.second[pair.second] += 1;
        counts.same += pair.first == pair.second ? 1 : 0;
    }
    return counts;
}

/// How often each class that a part got; a part.
using PartCounts = std::vector<std::pair<int, int>>;

std::vector<PartCounts> countParts(std::vector<Rating> ratings)
{
    std::sort(ratings.begin(), ratings.end(), [](const Rating& a, const Rating& b) {
        return std::pair(a.part, a.verdict) < std::pair(b.part, b.verdict);
    });
    std::vector<PartCounts> parts;
    for (std::size_t i = 0; i < ratings.size(); ++i) {
        if (i == 0 || ratings[i].part != ratings[i - 1].part)
            parts.emplace_back();
        PartCounts& counts = parts.back();
        if (counts.empty() || counts.back().first != ratings[i].verdict)
            counts.emplace_back(ratings[i].verdict, 0);
        ++counts.back().second;
    }
    return parts;
}

double verdictsOn(const PartCounts& part)
{
    double number = 0;
    for (const auto& [verdict, count] : part)
        number += count;
    return number;
}

struct AgreementBeyondChance {
    std::optional<double> value, standardError;
};

/// `disagreement`: 1 - P, in which rounding is none where all agree.
AgreementBeyondChance beyondChance(double disagreement, const std::vector<double>& shares, double pairWeight)
{
    double squares = 0, cubes = 0, mixed = 0; // mixed: 1 - P_e
    for (const double share : shares) {
        squares += share * share;
        cubes += share * share * share;
        mixed += share * (1 - share);
    }
    if (!(mixed > 0))
        return {};
    const double variance = 2 * (squares + squares * squares - 2 * cubes) / (mixed * mixed) * pairWeight;
    return {1 - disagreement / mixed, variance > 0 ? std::optional(std::sqrt(variance)) : std::nullopt};
}

} // namespace

CohenKappa cohenKappa(std::span<const VerdictPair> pairs, int classes)
{
    CohenKappa kappa;
    kappa.pairs = pairs.size();
    if (pairs.empty())
        return kappa;
    const PairCounts counts = countPairs(pairs, classes);
    const auto n = double(pairs.size());
    double byChance = 0; // times n^2
    for (std::size_t c = 0; c < counts.first.size(); ++c)
        byChance += counts.first[c] * counts.second[c];
    const double observed = counts.same / n, expected = byChance / (n * n);
    kappa.agreement = observed;
    if (byChance >= n * n)
        return kappa;
    kappa.value = (observed - expected) / (1 - expected);
    const bool onePart = pairs.front().part == pairs.back().part;
    if (onePart || counts.same == n)
        return kappa;
    double squares = 0, ofPart = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const VerdictPair& pair = pairs[i];
        const double same = pair.first == pair.second ? 1 : 0;
        ofPart +=
            (same - observed) * (1 - expected) -
            (1 - observed) * ((counts.second[pair.first] + counts.first[pair.second]) / n - 2 * expected);
        if (i + 1 == pairs.size() || pairs[i + 1].part != pair.part) {
            squares += ofPart * ofPart;
            ofPart = 0;
        }
    }
    kappa.standardError = std::sqrt(squares) / n / ((1 - expected) * (1 - expected));
    return kappa;
}

FleissKappa fleissKappa(const std::vector<Rating>& ratings, int classes)
{
    FleissKappa kappa;
    std::vector<PartCounts> parts = countParts(ratings);
    std::erase_if(parts, [](const PartCounts& part) { return verdictsOn(part) < 2; });
    if (parts.empty())
        return kappa;
    const auto number = double(parts.size());
    kappa.parts = parts.size();
    std::vector<double> shares(std::size_t(classes), 0.0), apart(std::size_t(classes), 0.0);
    double disagreement = 0, pairWeight = 0;
    for (const PartCounts& part : parts) {
        const double m = verdictsOn(part);
        kappa.ratings += std::size_t(m);
        pairWeight += 1 / (m * (m - 1)) / (number * number);
        for (const auto& [verdict, count] : part) {
            const double different = count * (m - count) / (m * (m - 1)) / number;
            shares[verdict] += count / m;
            apart[verdict] += 2 * different;
            disagreement += different;
        }
    }
    for (double& share : shares)
        share /= number;
    const AgreementBeyondChance all = beyondChance(disagreement, shares, pairWeight);
    kappa.value = all.value;
    kappa.standardError = all.standardError;
    if (kappa.value && kappa.standardError) {
        kappa.z = *kappa.value / *kappa.standardError;
        kappa.p = normalAbove(*kappa.z);
    }
    for (int c = 0; c < classes; ++c) {
        if (!(shares[c] > 0))
            continue;
        const AgreementBeyondChance one = beyondChance(apart[c], {shares[c], 1 - shares[c]}, pairWeight);
        ClassKappa ofClass{c, shares[c], one.value, {}};
        if (one.value && one.standardError)
            ofClass.z = *one.value / *one.standardError;
        kappa.classes.push_back(ofClass);
    }
    return kappa;
}

} // namespace gripscope
