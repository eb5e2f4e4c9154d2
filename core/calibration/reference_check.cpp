// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/reference_check.h"

#include "core/base/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double expansion95 = 2; ///< of 95 %, as ISO 13528 has it
constexpr int mostSqueezes = 20;
constexpr int mostHours = 24 * 366;

bool isUsable(const ReferenceQuantity& stated)
{
    return std::isfinite(stated.value) && stated.value > 0 && std::isfinite(stated.standardUncertainty) &&
           stated.standardUncertainty >= 0 && std::isfinite(stated.tolerance) && stated.tolerance > 0;
}

bool isWellKnown(const MeasuredQuantity& measured, const ReferenceQuantity& stated)
{
    return expansion95 * std::hypot(measured.standardUncertainty, stated.standardUncertainty) <=
           stated.tolerance;
}

} // namespace

Finding problemOf(const ReferenceObject& reference)
{
    if (reference.name.isEmpty())
        return Words::say("The reference object needs a name, such as the number on it.");
    if (!reference.stated[2])
        return Words::say("The stiffness of the reference object must be known.");
    for (const std::optional<ReferenceQuantity>& stated : reference.stated) {
        if (stated && !isUsable(*stated))
            return Words::say("What is stated needs a value and a tolerance above zero.");
        if (stated && !isWellKnown({}, *stated))
            return Words::say("A tolerance is smaller than twice the uncertainty of what is stated: no "
                              "measurement could tell. Widen it, or use a better reference object.");
    }
    if (!(reference.peak_N > 0) || !std::isfinite(reference.peak_N) ||
        !(reference.bias_N > reference.peak_N) || !std::isfinite(reference.bias_N))
        return Words::say("The force must stay above zero: let it vary by less than its middle.");
    if (reference.squeezes < 1 || reference.squeezes > mostSqueezes)
        return Words::say("A check may have 1 to %1 squeezes.").arg(mostSqueezes);
    if (reference.intervalHours < 0 || reference.intervalHours > mostHours)
        return Words::say("A check may hold for a year at the most.");
    return {};
}

std::optional<double> enNumber(const MeasuredQuantity& measured, const ReferenceQuantity& stated)
{
    const double error = measured.value - stated.value;
    const double uncertainty = std::hypot(measured.standardUncertainty, stated.standardUncertainty);
    if (uncertainty > 0)
        return error / (expansion95 * uncertainty);
    return error == 0 ? std::optional(0.0) : std::nullopt;
}

QString toString(CheckVerdict verdict)
{
    switch (verdict) {
    case CheckVerdict::Passed:
        return u"passed"_s;
    case CheckVerdict::Failed:
        return u"failed"_s;
    case CheckVerdict::NotValid:
        break;
    }
    return u"not_valid"_s;
}

std::optional<CheckVerdict> checkVerdictFromString(const QString& text)
{
    for (const CheckVerdict verdict : {CheckVerdict::Passed, CheckVerdict::Failed, CheckVerdict::NotValid})
        if (text == toString(verdict))
            return verdict;
    return std::nullopt;
}

CheckVerdict judgeCheck(const ReferenceObject& reference, const MeasuredQuantities& measured)
{
    bool told = true;
    bool within = true;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const std::optional<ReferenceQuantity>& stated = reference.stated[i];
        if (!stated)
            continue;
        const bool known =
            measured[i] && std::isfinite(measured[i]->value) && isWellKnown(*measured[i], *stated);
        told = told && known;
        within = within && (!known || std::abs(measured[i]->value - stated->value) <= stated->tolerance);
    }
    return !within ? CheckVerdict::Failed : told ? CheckVerdict::Passed : CheckVerdict::NotValid;
}

CheckStatus checkStatus(const std::optional<ReferenceStanding>& standing, const QDateTime& now)
{
    if (!standing)
        return CheckStatus::NotAsked;
    if (standing->last && standing->last->verdict == CheckVerdict::Failed)
        return CheckStatus::Failed;
    if (standing->reference.intervalHours == 0)
        return standing->last ? CheckStatus::Passed : CheckStatus::NotAsked;
    const std::optional<QDateTime> until = checkHoldsUntil(*standing);
    return until && now <= *until ? CheckStatus::Passed : CheckStatus::Due;
}

std::optional<QDateTime> checkHoldsUntil(const ReferenceStanding& standing)
{
    if (!standing.last || standing.reference.intervalHours == 0)
        return std::nullopt;
    constexpr int secondsAnHour = 3600;
    return standing.last->made.addSecs(qint64(secondsAnHour) * standing.reference.intervalHours);
}

} // namespace gripscope
