// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/agreement/cohen_kappa.h"

#include <cmath>
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

} // namespace gripscope
