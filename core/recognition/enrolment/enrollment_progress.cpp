// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/recognition/enrolment/enrollment_guidance.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/verdict/quantity_text.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double strangerDeviations = 6;
constexpr double nearLimit = 1.25;
constexpr int mostAhead = 100;

/// How well a type is known: its squeezes and the degrees of freedom of the scatter.
struct Knowledge {
    double squeezes = 0, degreesOfFreedom = 0;
    [[nodiscard]] Knowledge after(int more) const
    {
        // The first squeeze of a type says nothing of the scatter.
        const double informative = squeezes > 0 ? more : std::max(0, more - 1);
        return {squeezes + more, degreesOfFreedom + informative};
    }
    [[nodiscard]] double spread() const { return 1 + 1 / squeezes; }
};

/// Squared, on (x - mean)' S^-1 (x - mean).
std::optional<double> gateOf(const Knowledge& known, const VerdictOptions& options, int dimensions)
{
    if (!(known.squeezes >= 1))
        return {};
    if (options.confidence)
        return toleranceGate(int(std::min(1e6, known.squeezes) + 1e-6), known.degreesOfFreedom,
                             options.falseReject, *options.confidence, dimensions);
    return falseRejectGate(known.squeezes, known.degreesOfFreedom, options.falseReject, dimensions);
}

double strangersPassing(const Knowledge& known, double gate, int dimensions)
{
    const double v = known.degreesOfFreedom;
    const double fisher = v - (dimensions - 1); // degrees of freedom of the denominator
    const double away = strangerDeviations * strangerDeviations / known.spread();
    return nonCentralFisherBelow(gate / known.spread() * fisher / (dimensions * v), dimensions, fisher, away);
}

double limitOfStrangers(double gate, int dimensions)
{
    return nonCentralChiSquaredBelow(gate, dimensions, strangerDeviations * strangerDeviations);
}

/// The fewest more squeezes for which `enough` holds, as it does for all larger numbers; each asks for a
/// gate, and a tolerance gate is dear.
template <typename Enough>
std::optional<int> fewestMore(const Enough& enough)
{
    if (enough(0))
        return 0;
    int below = 0, above = mostAhead;
    if (!enough(above))
        return {};
    while (above - below > 1) {
        const int middle = (above + below) / 2;
        (enough(middle) ? above : below) = middle;
    }
    return above;
}

std::optional<double> stiffnessUncertainty(const TypeModels& models, const TypeModel& model)
{
    const std::optional<int> place = models.space.placeOf(TypeQuantity::Stiffness);
    if (models.degreesOfFreedom < 1 || !place)
        return {};
    const double halfWidth =
        studentQuantile(0.975, models.degreesOfFreedom) * std::sqrt(model.meanCovarianceLog(*place, *place));
    return std::isfinite(halfWidth) ? std::optional(std::expm1(std::min(halfWidth, 10.0))) : std::nullopt;
}

Finding inHundred(double share)
{
    return share < 0.005 ? Words::say("fewer than 1 in 100")
                         : Words::say("%1 in 100").arg(int(std::round(100 * share)));
}

Finding moreSqueezes(int count)
{
    return count == 1 ? Words::say("1 more squeeze") : Words::say("%1 more squeezes").arg(count);
}

} // namespace

EnrollmentProgress enrollmentProgress(const TypeModels& models, const QString& type,
                                      const VerdictOptions& options)
{
    EnrollmentProgress progress;
    progress.type = type;
    progress.falseReject = options.falseReject;
    if (options.strangerRange())
        progress.strangerAccept = options.strangerAccept;
    Knowledge known{0, models.scatter.degreesOfFreedom};
    if (const TypeModel* model = models.find(type)) {
        progress.squeezes = model->squeezes;
        known.squeezes = model->squeezes;
        if (models.degreesOfFreedom >= 1) {
            known.degreesOfFreedom =
                predictType(models, *model, model->meanLog, {}, {options.robust}).degreesOfFreedom;
        }
        progress.stiffnessUncertainty = stiffnessUncertainty(models, *model);
    }
    const int p = models.space.dimensions();
    const double limit = chiSquaredGate(options.falseReject, p);
    progress.gateLimit = std::sqrt(limit);
    progress.strangersLimit = limitOfStrangers(limit, p);
    progress.moreForGate = fewestMore([&](int more) {
                               return gateOf(known.after(more), options, p).has_value();
                           }).value_or(mostAhead);
    progress.moreForMost = fewestMore([&](int more) {
        const auto gate = gateOf(known.after(more), options, p);
        return gate && std::sqrt(*gate) <= nearLimit * progress.gateLimit;
    });
    if (const auto gate = gateOf(known, options, p)) {
        progress.gate = std::sqrt(*gate);
        progress.strangersPassing = strangersPassing(known, *gate, p);
    }
    return progress;
}

Findings inWords(const EnrollmentProgress& progress)
{
    Findings words;
    if (progress.squeezes == 1 && !progress.stiffnessUncertainty)
        words.push_back(Words::say("One squeeze says where %1 is, but nothing of how squeezes of it differ.")
                            .arg(progress.type));
    else if (progress.squeezes == 1)
        words.push_back(
            Words::say(
                "One squeeze tells the stiffness of %1 only to %2 % (95 %), if its squeezes differ as those "
                "of the other types do.")
                .arg(progress.type, shortNumber(100 * *progress.stiffnessUncertainty)));
    if (!progress.gate) {
        words.push_back(Words::say("No verdict can be given yet: %1 and there is a gate.")
                            .arg(moreSqueezes(progress.moreForGate)));
        return words;
    }
    words.push_back(
        Words::say("A squeeze further than %1 sd from %2 is called unknown, as %3 % of its own are; with all "
                   "known that would be %4 sd.")
            .arg(*progress.gate, 'f', 1)
            .arg(progress.type, shortNumber(100 * progress.falseReject))
            .arg(progress.gateLimit, 'f', 1));
    words.push_back(Words::say("A part as near as 6 sd passes this gate %1 times (at best %2).")
                        .arg(inHundred(*progress.strangersPassing), inHundred(progress.strangersLimit)));
    if (progress.strangerAccept)
        words.push_back(Words::say("Of strangers of any kind, at most %1 % are named a type all the same.")
                            .arg(shortNumber(100 * *progress.strangerAccept)));
    if (!progress.moreForMost)
        words.push_back(
            Words::say("Enough for verdicts; it takes more than 100 more squeezes to come near the best."));
    else if (*progress.moreForMost > 0)
        words.push_back(Words::say("Enough for verdicts; %1 would bring them near the best.")
                            .arg(moreSqueezes(*progress.moreForMost)));
    else
        words.push_back(Words::say("Enough for verdicts: more squeezes would gain little."));
    return words;
}

} // namespace gripscope
