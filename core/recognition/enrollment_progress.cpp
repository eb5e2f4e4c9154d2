// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/enrollment_progress.h"

#include "core/recognition/gates.h"
#include "core/recognition/predictive.h"
#include "core/recognition/quantity_text.h"
#include "core/recognition/quiet_policy.h"
#include "core/words.h"

#include <boost/math/distributions/non_central_chi_squared.hpp>
#include <boost/math/distributions/non_central_f.hpp>
#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double dimensions = 3;
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
std::optional<double> gateOf(const Knowledge& known, const VerdictOptions& options)
{
    if (!(known.squeezes >= 1))
        return {};
    if (options.confidence)
        return toleranceGate(int(std::min(1e6, known.squeezes) + 1e-6), known.degreesOfFreedom,
                             options.falseReject, *options.confidence);
    return falseRejectGate(known.squeezes, known.degreesOfFreedom, options.falseReject);
}

double strangersPassing(const Knowledge& known, double gate)
{
    using NonCentralF = boost::math::non_central_f_distribution<double, QuietPolicy>;
    const double v = known.degreesOfFreedom;
    const double away = strangerDeviations * strangerDeviations / known.spread();
    return boost::math::cdf(NonCentralF(dimensions, v - 2, away),
                            gate / known.spread() * (v - 2) / (dimensions * v));
}

double limitOfStrangers(double gate)
{
    using NonCentral = boost::math::non_central_chi_squared_distribution<double, QuietPolicy>;
    return boost::math::cdf(NonCentral(dimensions, strangerDeviations * strangerDeviations), gate);
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
    if (models.degreesOfFreedom < 1)
        return {};
    const boost::math::students_t_distribution<double, QuietPolicy> student(models.degreesOfFreedom);
    const double halfWidth = boost::math::quantile(student, 0.975) * std::sqrt(model.meanCovarianceLog(2, 2));
    return std::isfinite(halfWidth) ? std::optional(std::expm1(std::min(halfWidth, 10.0))) : std::nullopt;
}

QString inHundred(double share)
{
    return share < 0.005 ? Words::tr("fewer than 1 in 100")
                         : Words::tr("%1 in 100").arg(int(std::round(100 * share)));
}

QString squeezes(int count)
{
    return count == 1 ? Words::tr("1 more squeeze") : Words::tr("%1 more squeezes").arg(count);
}

} // namespace

EnrollmentProgress enrollmentProgress(const TypeModels& models, const QString& type,
                                      const VerdictOptions& options)
{
    EnrollmentProgress progress;
    progress.type = type;
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
    const double limit = chiSquaredGate(options.falseReject);
    progress.gateLimit = std::sqrt(limit);
    progress.strangersLimit = limitOfStrangers(limit);
    progress.moreForGate = fewestMore([&](int more) {
                               return gateOf(known.after(more), options).has_value();
                           }).value_or(mostAhead);
    progress.moreForMost = fewestMore([&](int more) {
        const auto gate = gateOf(known.after(more), options);
        return gate && std::sqrt(*gate) <= nearLimit * progress.gateLimit;
    });
    if (const auto gate = gateOf(known, options)) {
        progress.gate = std::sqrt(*gate);
        progress.strangersPassing = strangersPassing(known, *gate);
    }
    return progress;
}

QStringList inWords(const EnrollmentProgress& progress)
{
    QStringList words;
    if (progress.squeezes == 1 && !progress.stiffnessUncertainty)
        words += Words::tr("One squeeze says where %1 is, but nothing of how squeezes of it differ.")
                     .arg(progress.type);
    else if (progress.squeezes == 1)
        words +=
            Words::tr(
                "One squeeze tells the stiffness of %1 only to %2 % (95 %), if its squeezes differ as those "
                "of the other types do.")
                .arg(progress.type, shortNumber(100 * *progress.stiffnessUncertainty));
    if (!progress.gate) {
        words += Words::tr("No verdict can be given yet: %1 and there is a gate.")
                     .arg(squeezes(progress.moreForGate));
        return words;
    }
    words +=
        Words::tr("A squeeze further than %1 sd from %2 is called unknown; with all known it would be %3 sd.")
            .arg(*progress.gate, 0, 'f', 1)
            .arg(progress.type)
            .arg(progress.gateLimit, 0, 'f', 1);
    words += Words::tr("A foreign part 6 sd away passes for it %1 times (at best %2).")
                 .arg(inHundred(*progress.strangersPassing), inHundred(progress.strangersLimit));
    if (!progress.moreForMost)
        words += Words::tr("It takes more than 100 more squeezes to come near that.");
    else if (*progress.moreForMost > 0)
        words += Words::tr("%1 bring it near that.").arg(squeezes(*progress.moreForMost));
    else
        words += Words::tr("More squeezes would gain little.");
    return words;
}

} // namespace gripscope
