// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/calibrate/gripper_texts.h"

#include "core/math/normal_interval.h"
#include "core/signal/recording/units.h"
#include "ui/format/date_text.h"
#include "ui/format/reference_words.h"

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

QString whenMeasured(GripperTrait trait, std::span<const MeasuringChainRecord> newestFirst)
{
    const std::optional<MeasuringChainRecord> record = measurementOf(trait, newestFirst);
    if (!record)
        return {};
    const QString date = dateText(record->measured.toLocalTime());
    return record->operatorName.isEmpty() ? date : u"%1, %2"_s.arg(date, record->operatorName);
}

QString stiffnessText(double k, double halfWidth, const GripperIdentity& identity)
{
    // Of m, b, k only k is looked at: the others are there to carry the units.
    return parameterTextsWithin({1, 1, k}, Eigen::Vector3d(0, 0, halfWidth), identity.forceUnit,
                                identity.positionUnit)
        .k.text();
}

} // namespace

ParameterTexts GripperTexts::baseline(const GripperBaseline& baseline, const GripperIdentity& identity)
{
    return parameterTexts(
        {baseline.parameters[0], baseline.parameters[1], baseline.parameters[2]},
        Eigen::Vector3d(baseline.standardErrors[0], baseline.standardErrors[1], baseline.standardErrors[2]),
        identity.forceUnit, identity.positionUnit);
}

QString GripperTexts::friction(const GripperFriction& friction, const GripperIdentity& identity)
{
    const double half = normal95 * friction.standardError;
    if (friction.value < half)
        return tr("at most %1")
            .arg(formatNumber(friction.value + half, {}, identity.forceUnit, 2).valueWithUnit());
    return formatNumber(friction.value, half, identity.forceUnit).text();
}

QString GripperTexts::frame(double compliance, double standardError, const GripperIdentity& identity)
{
    const double k = 1 / compliance;
    return stiffnessText(k, normal95 * standardError * k * k, identity);
}

QString GripperTexts::stiffness(const Identification& squeeze, const GripperIdentity& identity)
{
    if (squeeze.budget.parameters)
        return parameterTexts(squeeze, identity.forceUnit, identity.positionUnit).k.text();
    for (const FurtherParameter& further : squeeze.budget.further)
        if (further.parameter == MotionParameter::Stiffness)
            return stiffnessText(further.value, (further.interval.upper - further.interval.lower) / 2,
                                 identity);
    return {};
}

QString GripperTexts::lag(const LagEstimate& lag)
{
    if (!lag.hasValue())
        return lag.message.describe();
    return formatNumber(lag.lag_s, normal95 * lag.standardError_s, u"s"_s).text();
}

std::vector<GripperTexts::Section> GripperTexts::sections(const NewMeasuringChain& known,
                                                          std::span<const MeasuringChainRecord> newestFirst,
                                                          const GripperIdentity& identity)
{
    const MeasuringChain& chain = known.chain;
    Section empty{tr("Empty gripper"), {}, whenMeasured(GripperTrait::Baseline, newestFirst)};
    if (chain.baseline) {
        const ParameterTexts texts = baseline(*chain.baseline, identity);
        empty.facts = {{ReferenceWords::quantity(2), texts.k.text()},
                       {ReferenceWords::quantity(1), texts.b.text()},
                       {ReferenceWords::quantity(0), texts.m.text()}};
    }
    if (chain.friction)
        empty.facts.push_back({tr("Friction"), friction(*chain.friction, identity)});
    if (chain.forceNoiseDeviation > 0)
        empty.facts.push_back(
            {tr("Noise of the force"),
             formatNumber(chain.forceNoiseDeviation, {}, identity.forceUnit, 2).valueWithUnit()});
    Section frameSection{tr("Frame"), {}, whenMeasured(GripperTrait::Frame, newestFirst)};
    if (chain.frameCompliance > 0)
        frameSection.facts = {{ReferenceWords::quantity(2),
                               frame(chain.frameCompliance, chain.frameComplianceUncertainty, identity)}};
    Section lagSection{tr("Lag of the position"), {}, whenMeasured(GripperTrait::Lag, newestFirst)};
    if (isKnown(GripperTrait::Lag, known))
        lagSection.facts = {
            {tr("Lag"),
             formatNumber(known.forceLag_s, normal95 * chain.forceLagUncertainty_s, u"s"_s).text()}};
    return {empty, frameSection, lagSection};
}

} // namespace gripscope
