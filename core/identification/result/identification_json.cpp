// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/result/identification_json.h"

#include "core/base/json_value.h"
#include "core/math/matrix_json.h"
#include "core/signal/recording/units.h"

#include <QJsonArray>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject lineJson(const PeriodicLine& line)
{
    return {{u"frequency_hz"_s, jsonNumber(line.frequency_Hz)},
            {u"real"_s, jsonNumber(line.response.real())},
            {u"imaginary"_s, jsonNumber(line.response.imag())},
            {u"deviation"_s, jsonNumber(line.deviation)}};
}

QJsonObject windowJson(const Window& window)
{
    return {{u"first"_s, static_cast<qint64>(window.first)},
            {u"samples"_s, static_cast<qint64>(window.count)}};
}

QJsonValue validationByName(const std::optional<Eigen::Vector3d>& values)
{
    if (!values)
        return QJsonValue();
    return QJsonObject{{u"m"_s, jsonNumber((*values)(0))},
                       {u"b"_s, jsonNumber((*values)(1))},
                       {u"k"_s, jsonNumber((*values)(2))}};
}

QJsonValue parametersJson(const Validation& validation)
{
    if (!validation.available())
        return QJsonValue();
    QJsonObject object = validationByName(validation.parameters.vector()).toObject();
    if (validation.k3)
        object.insert(u"k3"_s, jsonNumber(*validation.k3));
    return object;
}

QJsonObject byName(const Eigen::Vector3d& values)
{
    return {
        {u"m"_s, jsonNumber(values(0))}, {u"b"_s, jsonNumber(values(1))}, {u"k"_s, jsonNumber(values(2))}};
}

/// The parameters of a motion by name; m, b and k always, null where the motion has none.
QJsonObject motionJson(const MotionEstimate& motion, bool errors)
{
    QJsonObject object{{u"m"_s, QJsonValue()}, {u"b"_s, QJsonValue()}, {u"k"_s, QJsonValue()}};
    for (const MotionParameter parameter : motion.terms.parameters())
        object.insert(toString(parameter), jsonNumber(errors ? motion.standardError(parameter)
                                                             : std::optional(motion.values[parameter])));
    return object;
}

/// In the order m, b, k and the further ones; null where the motion has no such parameter.
QJsonValue motionCovariance(const MotionEstimate& motion)
{
    using P = MotionParameter;
    std::vector<P> order = motion.terms.parameters();
    const std::vector<P> own = order;
    for (const P first : {P::Stiffness, P::Damping, P::Mass}) {
        std::erase(order, first);
        order.insert(order.begin(), first);
    }
    const auto place = [&](P parameter) {
        return static_cast<Eigen::Index>(std::ranges::find(own, parameter) - own.begin());
    };
    const auto cell = [&](P a, P b) {
        const Eigen::Index i = place(a);
        const Eigen::Index j = place(b);
        const auto count = static_cast<Eigen::Index>(own.size());
        return i < count && j < count ? jsonNumber(motion.covariance(i, j)) : QJsonValue();
    };
    QJsonArray rows;
    for (const P a : order) {
        QJsonArray row;
        for (const P b : order)
            row.append(cell(a, b));
        rows.append(row);
    }
    return rows;
}

QJsonValue covarianceOf(const Estimate& e)
{
    if (e.motion)
        return motionCovariance(*e.motion);
    return e.covariance ? QJsonValue(matrixJson(*e.covariance)) : QJsonValue();
}

QJsonValue toJson(const std::optional<AutoregressiveNoise>& noise)
{
    if (!noise)
        return QJsonValue();
    const auto list = [](const std::vector<double>& values) {
        QJsonArray array;
        for (const double value : values)
            array.append(jsonNumber(value));
        return array;
    };
    return QJsonObject{{u"autoregressive"_s, list(noise->coefficients)},
                       {u"moving_average"_s, list(noise->movingAverage)},
                       {u"innovation_deviation"_s, jsonNumber(noise->innovationDeviation)},
                       {u"force_deviation"_s, jsonNumber(noise->forceDeviation)}};
}

QJsonObject toJson(const std::optional<ArxCoefficients>& c)
{
    const auto optional = [&](auto member) {
        return c ? jsonNumber(std::optional<double>((*c).*member)) : QJsonValue();
    };
    return {{u"a1"_s, optional(&ArxCoefficients::a1)},
            {u"a2"_s, optional(&ArxCoefficients::a2)},
            {u"b1"_s, optional(&ArxCoefficients::b1)},
            {u"b2"_s, optional(&ArxCoefficients::b2)},
            {u"constant"_s, optional(&ArxCoefficients::constant)}};
}

QJsonValue foundJson(const Estimate& e)
{
    if (e.motion)
        return motionJson(*e.motion, false);
    return e.parameters ? QJsonValue(byName(e.parameters->vector())) : QJsonValue();
}

QJsonValue errorsOf(const Estimate& e)
{
    if (e.motion)
        return motionJson(*e.motion, true);
    const std::optional<Eigen::Vector3d> errors = e.standardErrors();
    return errors ? QJsonValue(byName(*errors)) : QJsonValue();
}

QJsonObject toJson(const Estimate& e)
{
    const bool tested = !e.residual.empty();
    return {{u"estimator"_s, toString(e.estimator)},
            {u"status"_s, toString(e.status)},
            {u"parameters"_s, foundJson(e)},
            {u"standard_errors"_s, errorsOf(e)},
            {u"covariance"_s, covarianceOf(e)},
            {u"nuisance"_s, QJsonObject{{u"x0"_s, jsonNumber(e.nuisance.x0)},
                                        {u"v0"_s, jsonNumber(e.nuisance.v0)},
                                        {u"offset"_s, jsonNumber(e.nuisance.offset)}}},
            {u"coefficients"_s, toJson(e.coefficients)},
            {u"fit"_s, QJsonObject{{u"simulation_percent"_s, jsonNumber(e.fit.simulationPercent)},
                                   {u"prediction_percent"_s, jsonNumber(e.fit.predictionPercent)}}},
            {u"residuals"_s,
             QJsonObject{
                 {u"sse"_s, tested ? jsonNumber(e.residuals.sse) : QJsonValue()},
                 {u"degrees_of_freedom"_s, tested ? jsonNumber(e.residuals.degreesOfFreedom) : QJsonValue()},
                 {u"whiteness_p"_s, jsonNumber(e.residuals.whitenessP)},
                 {u"input_independence_p"_s, jsonNumber(e.residuals.inputIndependenceP)}}},
            {u"noise"_s, toJson(e.noise)},
            {u"part"_s, QJsonObject{{u"first"_s, static_cast<qint64>(e.part.first)},
                                    {u"samples"_s, static_cast<qint64>(e.part.count)}}},
            {u"iterations"_s, e.iterations}};
}

QJsonObject toJson(const Validity& validity)
{
    QJsonArray checks;
    for (const ValidityCheck& check : validity.checks) {
        checks.append(QJsonObject{{u"id"_s, check.id},
                                  {u"ok"_s, check.ok},
                                  {u"value"_s, jsonNumber(check.value)},
                                  {u"limit"_s, jsonNumber(check.limit)},
                                  {u"message"_s, check.message.english()}});
    }
    return {{u"verdict"_s, toString(validity.verdict)}, {u"checks"_s, checks}};
}

QJsonArray toJson(const std::vector<PreparationStep>& steps)
{
    QJsonArray array;
    for (const PreparationStep& step : steps)
        array.append(QJsonObject{{u"id"_s, step.id},
                                 {u"count"_s, static_cast<qint64>(step.count)},
                                 {u"value"_s, jsonNumber(step.value)},
                                 {u"ok"_s, step.ok},
                                 {u"message"_s, step.message.english()}});
    return array;
}

/// What the evidence says, of one squeeze or a sum of them.
QJsonObject gainsOf(const HoldEvidence& hold)
{
    const bool judged = hold.gain.has_value();
    return {{u"gain"_s, jsonNumber(hold.gain)},
            {u"expected_gain"_s, judged ? jsonNumber(hold.expectedGain) : QJsonValue()},
            {u"limit"_s, judged ? jsonNumber(hold.limit()) : QJsonValue()}};
}

QJsonObject toJson(const HoldEvidence& own, const HoldEvidence& summed)
{
    QJsonObject object = gainsOf(own);
    object.insert(u"other_parameters"_s,
                  own.otherParameters ? QJsonValue(byName(own.otherParameters->vector())) : QJsonValue());
    QJsonObject sum = gainsOf(summed);
    sum.insert(u"squeezes"_s, summed.squeezes);
    object.insert(u"summed"_s, sum);
    return object;
}

} // namespace

QJsonObject toJson(const PeriodicDiagnostics& diagnostics)
{
    QJsonArray lines;
    for (const PeriodicLine& one : diagnostics.lines)
        lines.append(lineJson(one));
    QJsonValue distortion;
    if (diagnostics.distortionPercent && diagnostics.distortionP)
        distortion = QJsonObject{{u"percent"_s, jsonNumber(*diagnostics.distortionPercent)},
                                 {u"p"_s, jsonNumber(*diagnostics.distortionP)}};
    return {{u"period_samples"_s, static_cast<qint64>(diagnostics.periodSamples)},
            {u"periods"_s, static_cast<qint64>(diagnostics.periods)},
            {u"noise"_s, QJsonObject{{u"force"_s, jsonNumber(diagnostics.forceNoise)},
                                     {u"position"_s, jsonNumber(diagnostics.positionNoise)},
                                     {u"correlation"_s, jsonNumber(diagnostics.noiseCorrelation)}}},
            {u"drift"_s, QJsonObject{{u"force"_s, jsonNumber(diagnostics.forceDrift)},
                                     {u"position"_s, jsonNumber(diagnostics.positionDrift)}}},
            {u"cost"_s, QJsonObject{{u"ratio"_s, jsonNumber(diagnostics.costRatio)},
                                    {u"p"_s, jsonNumber(diagnostics.costP)}}},
            {u"distortion"_s, distortion},
            {u"lines"_s, lines}};
}

QJsonObject toJson(const Validation& validation)
{
    return {
        {u"on"_s, toString(validation.source)},
        {u"file"_s, jsonText(validation.name)},
        {u"as_expected"_s, validation.asExpected ? QJsonValue(*validation.asExpected) : QJsonValue()},
        {u"message"_s, validation.message.english()},
        {u"estimator"_s, toString(validation.estimator)},
        {u"parameters"_s, parametersJson(validation)},
        {u"estimated_on"_s, windowJson(validation.estimatedOn)},
        {u"validated_on"_s, windowJson(validation.validatedOn)},
        {u"fit"_s, QJsonObject{{u"simulation_percent"_s, jsonNumber(validation.fit.simulationPercent)},
                               {u"prediction_percent"_s, jsonNumber(validation.fit.predictionPercent)},
                               {u"expected_percent"_s, jsonNumber(validation.expectedPercent)}}},
        {u"residuals"_s, QJsonObject{{u"whiteness_p"_s, jsonNumber(validation.whitenessP)},
                                     {u"input_independence_p"_s, jsonNumber(validation.inputIndependenceP)}}},
        {u"misfit"_s, QJsonObject{{u"p"_s, jsonNumber(validation.misfitP)},
                                  {u"root_f"_s, jsonNumber(validation.misfit)},
                                  {u"change"_s, validationByName(validation.change)},
                                  {u"change_errors"_s, validationByName(validation.changeErrors)}}},
        {u"nuisance"_s, QJsonObject{{u"x0"_s, jsonNumber(validation.nuisance.x0)},
                                    {u"v0"_s, jsonNumber(validation.nuisance.v0)},
                                    {u"offset"_s, jsonNumber(validation.nuisance.offset)}}}};
}

QJsonObject toJson(const Identification& identification, const Recording& recording, const QString& file)
{
    const ParameterUnits units = parameterUnits(recording.forceUnit, recording.positionUnit);
    QJsonArray estimates;
    for (const Estimate& estimate : identification.estimates) {
        QJsonObject object = toJson(estimate);
        if (estimate.motion && estimate.motion->frictionLimit)
            object.insert(u"upper_limits"_s,
                          QJsonObject{{u"Fc"_s, jsonNumber(*estimate.motion->frictionLimit)}});
        if (const auto& bounds = estimate.stiffnessBounds) {
            object.insert(u"lower_limits"_s, QJsonObject{{u"k"_s, jsonNumber(bounds->lower)}});
            if (bounds->upper)
                object.insert(u"upper_limits"_s, QJsonObject{{u"k"_s, jsonNumber(*bounds->upper)}});
        }
        if (estimate.estimator == Estimator::Periodic)
            object.insert(u"repetition"_s, identification.repetition
                                               ? QJsonValue(toJson(*identification.repetition))
                                               : QJsonValue());
        estimates.append(object);
    }
    return {{u"file"_s, file},
            {u"recording"_s, QJsonObject{{u"samples"_s, static_cast<qint64>(recording.size())},
                                         {u"sample_time_s"_s, jsonNumber(identification.sampleTime_s)},
                                         {u"gaps"_s, static_cast<qint64>(identification.choice.gaps)},
                                         {u"hold"_s, toString(identification.hold)},
                                         {u"units"_s, QJsonObject{{u"force"_s, recording.forceUnit},
                                                                  {u"position"_s, recording.positionUnit},
                                                                  {u"m"_s, units.m},
                                                                  {u"b"_s, units.b},
                                                                  {u"k"_s, units.k}}}}},
            {u"estimates"_s, estimates},
            {u"recommended"_s, toString(identification.recommended)},
            {u"validity"_s, toJson(identification.validity)},
            {u"budget"_s, toJson(identification.budget)},
            {u"derived"_s, toJson(derivedFrom(identification.budget))},
            {u"comparison"_s, toJson(identification.comparison)},
            {u"validation"_s, toJson(identification.validation)},
            {u"hold"_s, toJson(identification.holdEvidence, identification.summedHold)},
            {u"preparation"_s, toJson(identification.preparation)}};
}

QJsonObject documentToKeep(const Identification& identification, const Recording& recording,
                           const QString& source)
{
    QJsonObject document = toJson(identification, recording, source);
    QJsonObject budget = document[u"budget"_s].toObject();
    QJsonArray lines = budget[u"lines"_s].toArray();
    for (qsizetype i = 0; i < lines.size(); ++i) {
        QJsonObject line = lines[i].toObject();
        line[u"finding"_s] = identification.budget.lines[std::size_t(i)].words.toJson();
        lines[i] = line;
    }
    budget[u"lines"_s] = lines;
    document[u"budget"_s] = budget;
    return document;
}

} // namespace gripscope
