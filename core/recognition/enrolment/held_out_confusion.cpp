// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/enrolment/enrollment_guidance.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/verdict_by_space.h"

#include <QMap>

#include <algorithm>
#include <utility>

namespace gripscope {

namespace {

constexpr std::size_t mostOneByOne = 400;
constexpr std::size_t mostFolds = 50;

/// One part of a type: its squeezes, by place.
struct Part {
    int type = 0;
    std::vector<std::size_t> squeezes;
};

std::vector<Part> partsOf(const std::vector<TypeSqueeze>& squeezes, const QuantitySpace& space,
                          const QStringList& types)
{
    std::vector<Part> parts;
    QMap<std::pair<QString, QString>, std::size_t> known;
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        const TypeSqueeze& squeeze = squeezes[i];
        if (!coordinatesOf(squeeze, space))
            continue;
        const auto key = std::make_pair(squeeze.type, squeeze.part);
        const bool again = !squeeze.part.isEmpty() && known.contains(key);
        if (!again) {
            known[key] = parts.size();
            parts.push_back({int(types.indexOf(squeeze.type)), {}});
        }
        parts[known[key]].squeezes.push_back(i);
    }
    return parts;
}

/// Which parts are left out together.
std::vector<std::vector<std::size_t>> foldsOf(const std::vector<Part>& parts, const std::vector<int>& perType)
{
    std::vector<std::vector<std::size_t>> folds;
    const bool oneByOne = parts.size() <= mostOneByOne;
    std::vector<std::size_t> seen(perType.size());
    for (std::size_t part = 0; part < parts.size(); ++part) {
        const auto type = std::size_t(parts[part].type);
        if (perType[type] < 2)
            continue;
        const std::size_t fold = oneByOne ? folds.size() : seen[type]++;
        if (!oneByOne && fold >= mostFolds)
            continue;
        if (fold >= folds.size())
            folds.resize(fold + 1);
        folds[fold].push_back(part);
    }
    return folds;
}

std::vector<TypeSqueeze> without(const std::vector<TypeSqueeze>& squeezes, const std::vector<Part>& parts,
                                 const std::vector<std::size_t>& fold)
{
    std::vector<bool> out(squeezes.size());
    for (const std::size_t part : fold)
        for (const std::size_t squeeze : parts[part].squeezes)
            out[squeeze] = true;
    std::vector<TypeSqueeze> kept;
    kept.reserve(squeezes.size());
    for (std::size_t i = 0; i < squeezes.size(); ++i)
        if (!out[i])
            kept.push_back(squeezes[i]);
    return kept;
}

/// Column of a verdict in the table.
int columnOf(const Verdict& verdict, const QStringList& types)
{
    switch (verdict.kind) {
    case VerdictKind::Type:
        return int(types.indexOf(verdict.type));
    case VerdictKind::Unknown:
    case VerdictKind::Invalid:
        return int(types.size());
    case VerdictKind::Inconclusive:
        break;
    }
    return int(types.size()) + 1;
}

/// Parts tested, and how many were judged wrongly.
struct Tally {
    int parts = 0, wrong = 0, unknown = 0;
    [[nodiscard]] BinomialEvidence wrongEvidence() const { return binomialEvidence(wrong, parts); }
    [[nodiscard]] BinomialEvidence unknownEvidence() const { return binomialEvidence(unknown, parts); }
};

} // namespace

HeldOutConfusion heldOutConfusion(const std::vector<TypeSqueeze>& squeezes, const VerdictOptions& options)
{
    HeldOutConfusion result;
    const QuantitySpace space = spaceOf(squeezes);
    for (const TypeSqueeze& squeeze : squeezes)
        if (coordinatesOf(squeeze, space))
            result.types.append(squeeze.type);
    result.types.removeDuplicates();
    result.types.sort();
    const auto types = std::size_t(result.types.size());
    result.counts = Eigen::MatrixXi::Zero(result.types.size(), result.types.size() + 2);
    const std::vector<Part> parts = partsOf(squeezes, space, result.types);
    std::vector<int> perType(types);
    for (const Part& part : parts)
        ++perType[std::size_t(part.type)];
    result.untested = int(std::count(perType.begin(), perType.end(), 1));
    std::vector<Tally> tallies(types);
    for (const std::vector<std::size_t>& fold : foldsOf(parts, perType)) {
        const ModelsBySpace models(without(squeezes, parts, fold));
        for (const std::size_t number : fold) {
            const Part& part = parts[number];
            bool wrong = false, unknown = false;
            for (const std::size_t place : part.squeezes) {
                const int column = columnOf(judge(models, squeezes[place], options), result.types);
                ++result.counts(part.type, column);
                ++result.squeezes;
                wrong = wrong || (column < int(types) && column != part.type);
                unknown = unknown || column == int(types);
            }
            Tally& tally = tallies[std::size_t(part.type)];
            ++tally.parts;
            tally.wrong += wrong;
            tally.unknown += unknown;
        }
    }
    Tally all;
    result.wrongTypeOf.reserve(tallies.size());
    for (const Tally& tally : tallies) {
        all.parts += tally.parts;
        all.wrong += tally.wrong;
        all.unknown += tally.unknown;
        result.wrongTypeOf.push_back(tally.wrongEvidence());
    }
    result.parts = all.parts;
    result.wrongType = all.wrongEvidence();
    result.unknown = all.unknownEvidence();
    return result;
}

} // namespace gripscope
