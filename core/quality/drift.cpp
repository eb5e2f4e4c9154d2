// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/drift.h"

#include "core/base/words.h"
#include "core/recognition/types/squeeze_values.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int fewestSqueezes = 3; ///< whose mean is held against the enrolment
constexpr int charts = 4;         ///< a type: m, b, k and T^2
constexpr double leastAgreement = 0.01;
constexpr double clearlyBetter = 4; ///< of chi-square: e^2 times as likely

std::vector<TypeSqueeze> ofType(const std::vector<TypeSqueeze>& squeezes, const QString& type)
{
    std::vector<TypeSqueeze> result;
    std::copy_if(squeezes.begin(), squeezes.end(), std::back_inserter(result),
                 [&](const TypeSqueeze& one) { return one.type == type && isUsable(one.parameters); });
    return result;
}

void follow(const TypeModels& models, std::size_t place, const std::vector<TypeSqueeze>& squeezes,
            const DriftReport& limits, double weight, TypeDrift& drift)
{
    SelfStartingChart chart(models, place, weight);
    for (const TypeSqueeze& squeeze : squeezes) {
        chart.add(logOf(squeeze.parameters), noiseOf(squeeze));
        const bool alarm = chart.average().cwiseAbs().maxCoeff() > limits.averageLimit ||
                           chart.tSquared() > limits.tSquaredLimit;
        if (alarm && !drift.firstAlarm)
            drift.firstAlarm = chart.squeezes();
    }
    drift.average = chart.average();
    drift.tSquared = chart.tSquared();
}

/// Types whose shift has been measured.
std::vector<TypeShift> shiftsOf(const DriftReport& report)
{
    std::vector<TypeShift> shifts;
    for (const TypeDrift& type : report.types)
        if (type.shift)
            shifts.push_back(*type.shift);
    return shifts;
}

DriftCause causeOf(const DriftReport& report, const std::vector<TypeShift>& shifts)
{
    if (shifts.empty())
        return DriftCause::TooFew;
    if (report.moved.isEmpty())
        return DriftCause::Nothing;
    if (shifts.size() == 1)
        return DriftCause::OneTypeOnly;
    std::vector<std::pair<double, DriftCause>> candidates; // by misfit
    const auto consider = [&](const auto& found, DriftCause cause) {
        if (found && found->agreement > leastAgreement)
            candidates.emplace_back(found->misfit, cause);
    };
    consider(report.factor, DriftCause::Sensor);
    consider(report.addition, DriftCause::Fingers);
    consider(loneShift(shifts), DriftCause::Product);
    if (candidates.empty())
        return report.moved.size() < qsizetype(shifts.size()) ? DriftCause::Product
                                                              : DriftCause::NoCommonCause;
    std::sort(candidates.begin(), candidates.end());
    const auto rivals = std::count_if(candidates.begin(), candidates.end(), [&](const auto& candidate) {
        return candidate.first < candidates.front().first + clearlyBetter;
    });
    if (rivals == 1)
        return candidates.front().second;
    const bool product = std::any_of(candidates.begin(), candidates.begin() + rivals,
                                     [](const auto& one) { return one.second == DriftCause::Product; });
    return product ? DriftCause::Unclear : DriftCause::Gripper;
}

Finding causeInWords(const DriftReport& report)
{
    const QString names = report.moved.join(u", "_s);
    switch (report.cause) {
    case DriftCause::TooFew:
        return Words::say("Too few squeezes since the enrolment to say whether anything has moved.");
    case DriftCause::Nothing:
        return Words::say("No type has moved since its enrolment.");
    case DriftCause::Sensor:
        return Words::say(
            "All types have moved by the same factors: the force or the position channel, not the "
            "products. Check the sensors' calibration.");
    case DriftCause::Fingers:
        return Words::say(
            "The same mass, damping and stiffness has come on top of all types: the fingers or their "
            "baseline. Measure the empty gripper again.");
    case DriftCause::Gripper:
        return Words::say("All types have moved together: the gripper, its sensors or its fingers, not the "
                          "products.");
    case DriftCause::Product:
        return Words::say("Of all types only %1 moved: the product itself, not the gripper.").arg(names);
    case DriftCause::Unclear:
        return Words::say(
                   "%1 moved, but the squeezes are too few to tell the product from the gripper. Squeeze "
                   "parts "
                   "of other types too.")
            .arg(names);
    case DriftCause::OneTypeOnly:
        return Words::say(
                   "%1 has moved. Squeeze parts of another type too: only that tells the product from the "
                   "gripper.")
            .arg(names);
    case DriftCause::NoCommonCause:
        return Words::say("%1 have moved, each in its own way: no single cause in the gripper explains it.")
            .arg(names);
    }
    return {};
}

void describe(DriftReport& report)
{
    report.words = {causeInWords(report)};
    const bool together = report.cause == DriftCause::Sensor || report.cause == DriftCause::Gripper;
    if (together && report.factor)
        report.words.push_back(
            Words::say("All types: %1.").arg(changeInWords(report.factor->value, report.factor->covariance)));
    for (const TypeDrift& type : report.types) {
        if (type.moved)
            report.words.push_back(Words::say("%1, last %2 squeezes: %3.")
                                       .arg(type.type, QString::number(type.shift->squeezes),
                                            changeInWords(type.shift->log, type.shift->covariance)));
        if (type.firstAlarm)
            report.words.push_back(
                Words::say("%1: its charts gave the alarm at squeeze %2 of %3.")
                    .arg(type.type, QString::number(*type.firstAlarm), QString::number(type.squeezes)));
    }
}

} // namespace

QString toString(DriftCause cause)
{
    switch (cause) {
    case DriftCause::TooFew:
        return u"too_few"_s;
    case DriftCause::Nothing:
        return u"nothing"_s;
    case DriftCause::Sensor:
        return u"sensor"_s;
    case DriftCause::Fingers:
        return u"fingers"_s;
    case DriftCause::Gripper:
        return u"gripper"_s;
    case DriftCause::Product:
        return u"product"_s;
    case DriftCause::Unclear:
        return u"unclear"_s;
    case DriftCause::OneTypeOnly:
        return u"one_type_only"_s;
    case DriftCause::NoCommonCause:
        return u"no_common_cause"_s;
    }
    return {};
}

std::optional<Error> DriftOptions::validate() const
{
    if (!(weight >= 0.05 && weight <= 1))
        return Error{ErrorCode::Usage,
                     {Words::say("The weight of the newest squeeze must be between 0.05 and 1.")}};
    if (!(averageRunLength >= 20 && averageRunLength <= 1e5))
        return Error{ErrorCode::Usage,
                     {Words::say("The run length must be between 20 and 100,000 squeezes.")}};
    if (recent < fewestSqueezes)
        return Error{ErrorCode::Usage, {Words::say("At least %1 recent squeezes.").arg(fewestSqueezes)}};
    if (!(falseAlarm >= 1e-6 && falseAlarm <= 0.5))
        return Error{ErrorCode::Usage,
                     {Words::say("The share of false alarms must be between 1e-6 and 0.5.")}};
    return {};
}

Expected<DriftReport> findDrift(const TypeModels& models, const std::vector<TypeSqueeze>& recent,
                                const DriftOptions& options)
{
    RETURN_IF_ERROR(options.validate());
    const double runLength = charts * options.averageRunLength;
    const auto single = movingAverageLimit(options.weight, 1, runLength);
    const auto joint = movingAverageLimit(options.weight, 3, runLength);
    if (!single || !joint)
        return failure(ErrorCode::Usage, {Words::say("There are no limits for this weight and run length.")});
    DriftReport report;
    report.averageLimit = std::sqrt(*single * options.weight / (2 - options.weight));
    report.tSquaredLimit = *joint;
    for (std::size_t place = 0; place < models.types.size(); ++place) {
        const TypeModel& type = models.types[place];
        std::vector<TypeSqueeze> squeezes = ofType(recent, type.name);
        if (squeezes.empty() || models.space != QuantitySpace{}) // the charts are of m, b and k
            continue;
        TypeDrift drift;
        drift.type = type.name;
        drift.squeezes = int(squeezes.size());
        follow(models, place, squeezes, report, options.weight, drift);
        const auto last = std::ptrdiff_t(std::min(squeezes.size(), std::size_t(options.recent)));
        squeezes.erase(squeezes.begin(), squeezes.end() - last);
        if (last >= fewestSqueezes)
            drift.shift = typeShift(models, type, squeezes);
        report.types.push_back(std::move(drift));
    }
    const std::vector<TypeShift> shifts = shiftsOf(report);
    for (TypeDrift& type : report.types) {
        type.moved = type.shift && type.shift->pValue < options.falseAlarm / double(shifts.size());
        if (type.moved)
            report.moved << type.type;
    }
    report.factor = commonShift(shifts, ShiftKind::Factor);
    report.addition = commonShift(shifts, ShiftKind::Addition);
    report.cause = causeOf(report, shifts);
    describe(report);
    return report;
}

std::optional<Finding> driftSignal(const DriftReport& report)
{
    if (!report.moved.isEmpty() && !report.words.empty())
        return report.words.front();
    QStringList beyond;
    for (const TypeDrift& type : report.types)
        if (type.average.cwiseAbs().maxCoeff() > report.averageLimit || type.tSquared > report.tSquaredLimit)
            beyond << type.type;
    if (beyond.isEmpty())
        return {};
    return Words::say(
               "The last squeezes of %1 lie beside its enrolment, more than chance leaves: its charts are "
               "beyond their limits. Look at the next ones.")
        .arg(beyond.join(QStringLiteral(", ")));
}

} // namespace gripscope
