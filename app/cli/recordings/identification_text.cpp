// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/recordings/identification_text.h"

#include "app/cli/line/output.h"
#include "core/identification/estimators/estimator_table.h"
#include "core/identification/result/determined_parameters.h"
#include "core/signal/recording/units.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

bool isArx(Estimator estimator)
{
    return estimator == Estimator::Arx || estimator == Estimator::ArxMeanForce ||
           estimator == Estimator::Arx221;
}

QString heading(const Identification& identification, const Recording& recording, const QString& file)
{
    const WindowChoice& choice = identification.choice;
    const QString lost = choice.gaps == 0
                             ? u"no gaps"_qs
                             : u"%1 gaps, %2 samples lost"_qs.arg(choice.gaps).arg(choice.lostSamples);
    return u"%1\n  %2 of %3 samples, %4 s apart, %5; force %6"_qs.arg(
        file, QString::number(choice.window.count), QString::number(recording.size()),
        QString::number(identification.sampleTime_s, 'g', 6), lost,
        identification.hold == ForceHold::Zero ? u"held between samples (zoh)"_qs
                                               : u"straight between samples (foh)"_qs);
}

/// What a motion has besides m, b and k; all of it where it has no mass or no spring.
QStringList motionLines(const Estimate& estimate, const ParameterUnits& units)
{
    QStringList lines;
    const std::vector<MotionParameter> parameters = estimate.motion->terms.parameters();
    for (std::size_t i = estimate.parameters ? 3 : 0; i < parameters.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        const QString unit = unitOf(parameters[i], units);
        lines << u"    %1  %2  %3  (95 %)"_qs.arg(
            toString(parameters[i]),
            withInterval(estimate.motion->values[parameters[i]],
                         std::sqrt(estimate.motion->covariance(at, at))),
            unit == u"1"_qs ? QString() : unit);
    }
    return lines;
}

QStringList parameterLines(const Estimate& estimate, const ParameterUnits& units)
{
    QStringList values;
    const Eigen::Vector3d value = estimate.parameters->vector();
    const std::optional<Eigen::Vector3d> error = estimate.standardErrors();
    for (int i = 0; i < 3; ++i)
        values << withInterval(value[i], error ? std::optional((*error)[i]) : std::nullopt);
    const auto widest = std::max_element(
        values.begin(), values.end(), [](const QString& a, const QString& b) { return a.size() < b.size(); });
    const std::array<QString, 3> names{u"m"_qs, u"b"_qs, u"k"_qs};
    const std::array<QString, 3> unit{units.m, units.b, units.k};
    QStringList lines;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const QString shown = unit[at] == u"1"_qs ? QString() : unit[at];
        lines << u"    %1  %2  %3"_qs.arg(names[at], values[i].leftJustified(widest->size()), shown)
                     .trimmed()
                     .prepend(u"    "_qs);
        if (error)
            lines.back() += u"  (95 %)"_qs;
    }
    return lines;
}

QString fitLine(const Estimate& estimate)
{
    const QString simulation = u"    fit  %1 % simulation"_qs.arg(fixed(estimate.fit.simulationPercent, 2));
    if (!isArx(estimate.estimator))
        return simulation; // its prediction is its simulation
    return simulation + u", %1 % one-step prediction"_qs.arg(fixed(estimate.fit.predictionPercent, 2));
}

QStringList estimateLines(const Estimate& estimate, const ParameterUnits& units, bool recommended)
{
    QString head =
        u"  %1 (%2): %3"_qs.arg(QString::fromLatin1(factsOf(estimate.estimator).title),
                                toString(estimate.estimator), toString(estimate.status).replace(u'_', u' '));
    if (estimate.iterations > 0)
        head += u" in %1 iterations"_qs.arg(estimate.iterations);
    QStringList lines{recommended ? head + u", recommended"_qs : head};
    if (estimate.status != EstimateStatus::Converged && !estimate.message.isEmpty())
        lines << u"    "_qs + estimate.message.describe();
    if (estimate.parameters)
        lines << parameterLines(estimate, units);
    if (estimate.motion)
        lines << motionLines(estimate, units);
    if (estimate.fit.simulationPercent || estimate.fit.predictionPercent)
        lines << fitLine(estimate);
    if (isArx(estimate.estimator) && estimate.parameters)
        lines << u"    An ARX fit says nothing about m, b and k: with noise on the position they can be "
                 u"wrong by half "
                 "and more at a fit of 80 to 93 %."_qs;
    return lines;
}

QStringList validityLines(const Validity& validity)
{
    QStringList lines{u"  measurement: "_qs + toString(validity.verdict)};
    for (const ValidityCheck& check : validity.checks)
        if (!check.ok)
            lines << u"    %1: %2"_qs.arg(QString(check.id).replace(u'_', u' '), check.message.describe());
    return lines;
}

/// The intervals that are shown everywhere, and what makes them so wide.
QStringList budgetLines(const UncertaintyBudget& budget, const ParameterUnits& units)
{
    if (!budget.parameters && budget.further.empty())
        return {};
    QStringList lines{u"  with all that is uncertain (95 %)"_qs};
    const std::array<QString, 3> names{u"m"_qs, u"b"_qs, u"k"_qs};
    const std::array<QString, 3> unit{units.m, units.b, units.k};
    const auto range = [](const QString& name, const CoverageInterval& interval, const QString& of) {
        const QString shown = of == u"1"_qs ? QString() : u' ' + of;
        return interval.onlyUpperBound
                   ? u"    %1  at most %2%3"_qs.arg(name, QString::number(interval.upper, 'g', 3), shown)
                   : u"    %1  %2 to %3%4"_qs.arg(name, QString::number(interval.lower, 'g', 5),
                                                  QString::number(interval.upper, 'g', 5), shown);
    };
    for (std::size_t i = 0; i < 3 && budget.parameters; ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        const auto largest = std::max_element(
            budget.lines.begin(), budget.lines.end(),
            [at](const BudgetLine& a, const BudgetLine& b) { return a.share(at) < b.share(at); });
        QString line = range(names[i], budget.intervals[i], unit[i]);
        if (largest != budget.lines.end())
            line += u"  (%1 %: %2)"_qs.arg(100 * largest->share(at), 0, 'f', 0)
                        .arg(QString(largest->id).replace(u'_', u' '));
        lines << line;
    }
    for (const FurtherParameter& further : budget.further)
        lines << range(toString(further.parameter), further.interval, unitOf(further.parameter, units));
    return lines;
}

/// How the model does on data it was not found from.
QStringList validationLines(const Validation& validation)
{
    if (validation.message.isEmpty())
        return {};
    const QString where = validation.source == ValidationSource::OtherRecording
                              ? u"against "_qs + validation.name
                              : u"first 60 % against the rest"_qs;
    QString fits;
    if (validation.fit.simulationPercent)
        fits = u"fit %1 % simulation, "_qs.arg(fixed(validation.fit.simulationPercent, 2));
    if (validation.expectedPercent)
        fits += u"%1 % expected; "_qs.arg(fixed(validation.expectedPercent, 2));
    return {u"  validation, %1: %2%3"_qs.arg(where, fits, validation.message.describe())};
}

} // namespace

QString identificationText(const Identification& identification, const Recording& recording,
                           const QString& file)
{
    QStringList lines{heading(identification, recording, file)};
    const ParameterUnits units = parameterUnits(recording.forceUnit, recording.positionUnit);
    for (const Estimate& estimate : identification.estimates)
        lines << estimateLines(estimate, units,
                               estimate.hasAnswer() && estimate.estimator == identification.recommended);
    lines << budgetLines(identification.budget, units);
    if (!identification.comparison.sentence.isEmpty())
        lines << u"  models: "_qs + identification.comparison.sentence.describe();
    lines << validationLines(identification.validation);
    for (const PreparationStep& step : identification.preparation)
        lines << u"  before: "_qs + step.message.describe();
    lines << validityLines(identification.validity);
    return lines.join(u'\n');
}

} // namespace gripscope::cli
