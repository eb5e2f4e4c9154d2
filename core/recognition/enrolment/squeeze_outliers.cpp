// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/recognition/enrolment/enrollment_guidance.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/quantity_text.h"

#include <QMap>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t leastSqueezes = 3;
constexpr std::size_t mostSteps = 5;
/// More squeezes of another type make its scatter no better known than it need be here.
constexpr int lentSqueezes = 30;

/// The squeezes of one type that are still taken for its own, and those that lend their scatter.
class Enrolled {
public:
    Enrolled(const std::vector<TypeSqueeze>& squeezes, const QString& type)
        : m_squeezes(squeezes), m_type(type), m_space(spaceOf(squeezes))
    {
        QMap<QString, int> lent;
        for (std::size_t i = 0; i < squeezes.size(); ++i) {
            if (!coordinatesOf(squeezes[i], m_space))
                continue;
            if (squeezes[i].type == type)
                m_kept.push_back(i);
            else if (++lent[squeezes[i].type] <= lentSqueezes)
                m_others.push_back(squeezes[i]);
        }
    }

    [[nodiscard]] const QuantitySpace& space() const { return m_space; }
    [[nodiscard]] const std::vector<std::size_t>& kept() const { return m_kept; }
    void takeOut(std::size_t index) { m_kept.erase(std::find(m_kept.begin(), m_kept.end(), index)); }

    [[nodiscard]] LogVector logOf(std::size_t index) const
    {
        return coordinatesOf(m_squeezes[index], m_space).value_or(LogVector::Zero(m_space.dimensions()));
    }

    /// The type without this squeeze (where it is still in), as seen from it.
    [[nodiscard]] std::optional<TypePrediction> seenFrom(std::size_t index) const
    {
        std::vector<TypeSqueeze> without = m_others;
        for (const std::size_t own : m_kept)
            if (own != index)
                without.push_back(m_squeezes[own]);
        const TypeModels models = fitTypeModels(without, m_space);
        const TypeModel* model = models.find(m_type);
        if (!model || models.degreesOfFreedom < 1)
            return {};
        return predictType(models, *model, logOf(index), noiseOf(m_squeezes[index], m_space), {});
    }

private:
    const std::vector<TypeSqueeze>& m_squeezes;
    QString m_type;
    QuantitySpace m_space;
    std::vector<TypeSqueeze> m_others;
    std::vector<std::size_t> m_kept;
};

/// How improbable it is that a squeeze of the type lies as far out as this one.
struct Improbability {
    LogVector offset;     ///< of the logarithms from the mean
    LogVector deviations; ///< each on its own
    double together = 1;  ///< probability of D^2
    double alone = 1;     ///< that of the least probable quantity, of p
    [[nodiscard]] double probability() const { return std::min(1.0, 2 * std::min(together, alone)); }
};

Improbability improbability(const LogVector& log, const TypePrediction& seen)
{
    const auto p = int(log.size());
    const double v = seen.degreesOfFreedom;
    Improbability result;
    result.offset = log - seen.meanLog;
    const double spread = std::sqrt(1 + 1 / seen.effectiveSqueezes); // the others' mean is an estimate too
    result.deviations = result.offset.cwiseQuotient(spread * seen.covariance.diagonal().cwiseSqrt());
    if (v >= p)
        result.together = chanceBeyond(seen.squaredDistance, v, p);
    const double farthest = result.deviations.cwiseAbs().maxCoeff();
    result.alone = p * 2 * studentAbove(farthest, v);
    return result;
}

/// The squeeze that is least probable.
struct Farthest {
    std::size_t index = 0;
    double probability = 2; ///< above 1: there is none
};

Farthest farthest(const Enrolled& enrolled)
{
    Farthest result;
    for (const std::size_t index : enrolled.kept()) {
        const auto seen = enrolled.seenFrom(index);
        if (!seen || !(seen->degreesOfFreedom >= 1))
            continue;
        const double probability = improbability(enrolled.logOf(index), *seen).probability();
        if (probability < result.probability)
            result = {index, probability};
    }
    return result;
}

/// "8 % above", "3.2 times".
Finding comparedWithOthers(double offset)
{
    const double ratio = std::exp(offset);
    if (ratio >= 2)
        return Words::say("%1 times that of the others").arg(shortNumber(ratio));
    if (ratio >= 1)
        return Words::say("%1 % above the others").arg(shortNumber(100 * (ratio - 1)));
    return Words::say("%1 % below the others").arg(shortNumber(100 * (1 - ratio)));
}

SqueezeOutlier describe(const Enrolled& enrolled, std::size_t index, const TypePrediction& seen)
{
    SqueezeOutlier outlier;
    outlier.index = index;
    const Improbability found = improbability(enrolled.logOf(index), seen);
    outlier.deviations = std::sqrt(seen.squaredDistance);
    Eigen::Index most = 0;
    const double alone = found.deviations.cwiseAbs().maxCoeff(&most);
    if (found.alone <= found.together || alone >= outlier.deviations / 2) {
        const TypeQuantity quantity = enrolled.space().quantities[std::size_t(most)];
        outlier.parameter = int(quantity);
        outlier.reason =
            Words::say("%1 is %2, %3 of their standard deviations.")
                .arg(nameOf(quantity), comparedWithOthers(found.offset(most)), shortNumber(alone));
    } else if (enrolled.space() != QuantitySpace{}) {
        outlier.reason =
            Words::say("The quantities are each near those of the others, but do not go together as "
                       "theirs do: %1 standard deviations away.")
                .arg(shortNumber(outlier.deviations));
    } else {
        outlier.reason =
            Words::say("Mass, damping and stiffness are each near those of the others, but do not go "
                       "together as theirs do: %1 standard deviations away.")
                .arg(shortNumber(outlier.deviations));
    }
    return outlier;
}

} // namespace

std::vector<SqueezeOutlier> findOutliers(const std::vector<TypeSqueeze>& squeezes, const QString& type,
                                         const OutlierOptions& options)
{
    Enrolled enrolled(squeezes, type);
    const std::size_t count = enrolled.kept().size();
    std::vector<SqueezeOutlier> outliers;
    if (count < leastSqueezes)
        return outliers;
    const std::size_t steps = std::min(mostSteps, count / 3);
    std::vector<Farthest> takenOut;
    std::size_t beyond = 0; ///< as many of them are outliers
    for (std::size_t step = 0; step < steps; ++step) {
        Farthest found = farthest(enrolled);
        if (found.probability > 1)
            break;
        found.probability *= double(enrolled.kept().size() * steps);
        enrolled.takeOut(found.index);
        takenOut.push_back(found);
        if (found.probability < options.falseAlarm)
            beyond = takenOut.size();
    }
    // Words are about what is left when all outliers are out.
    Enrolled clean(squeezes, type);
    for (std::size_t i = 0; i < beyond; ++i)
        clean.takeOut(takenOut[i].index);
    outliers.reserve(beyond);
    for (std::size_t i = 0; i < beyond; ++i) {
        const std::size_t index = takenOut[i].index;
        if (const auto seen = clean.seenFrom(index)) {
            outliers.push_back(describe(clean, index, *seen));
            outliers.back().chance = std::min(1.0, takenOut[i].probability);
        }
    }
    return outliers;
}

} // namespace gripscope
