// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit_details.h"

#include <QJsonArray>

#include <array>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

void addChange(QJsonObject& details, const QString& key, const QJsonValue& from, const QJsonValue& to)
{
    if (from != to)
        details.insert(key, QJsonObject{{u"from"_s, from}, {u"to"_s, to}});
}

QJsonValue numbersOf(const std::optional<GripperBaseline>& baseline)
{
    QJsonArray numbers;
    if (baseline)
        for (const double one : baseline->parameters)
            numbers.append(one);
    return baseline ? QJsonValue(numbers) : QJsonValue();
}

/// What is stated of one of m, b, k.
void addChanges(QJsonObject& details, const QString& quantity, const std::optional<ReferenceQuantity>& from,
                const std::optional<ReferenceQuantity>& to)
{
    const std::pair<QString, double ReferenceQuantity::*> numbers[] = {
        {u"value"_s, &ReferenceQuantity::value},
        {u"uncertainty"_s, &ReferenceQuantity::standardUncertainty},
        {u"tolerance"_s, &ReferenceQuantity::tolerance}};
    QJsonObject changes;
    for (const auto& [key, member] : numbers)
        addChange(changes, key, from ? QJsonValue((*from).*member) : QJsonValue(),
                  to ? QJsonValue((*to).*member) : QJsonValue());
    if (!changes.isEmpty())
        details.insert(quantity, changes);
}

} // namespace

QJsonObject auditDetails(const std::optional<MeasuringChainRecord>& before, const NewMeasuringChain& now)
{
    const NewMeasuringChain known = before ? NewMeasuringChain(*before) : NewMeasuringChain();
    QJsonObject details{{u"basis"_s, now.basis}};
    addChange(details, u"force_lag_s"_s, known.forceLag_s, now.forceLag_s);
    const std::pair<QString, double MeasuringChain::*> numbers[] = {
        {u"force_lag_uncertainty_s"_s, &MeasuringChain::forceLagUncertainty_s},
        {u"force_noise"_s, &MeasuringChain::forceNoiseDeviation},
        {u"force_scale_uncertainty"_s, &MeasuringChain::forceScaleUncertainty},
        {u"position_scale_uncertainty"_s, &MeasuringChain::positionScaleUncertainty},
        {u"frame_compliance"_s, &MeasuringChain::frameCompliance},
        {u"frame_compliance_uncertainty"_s, &MeasuringChain::frameComplianceUncertainty}};
    for (const auto& [key, member] : numbers)
        addChange(details, key, known.chain.*member, now.chain.*member);
    const auto frictionOf = [](const MeasuringChain& chain) {
        return chain.friction ? QJsonValue(chain.friction->value) : QJsonValue();
    };
    addChange(details, u"friction"_s, frictionOf(known.chain), frictionOf(now.chain));
    addChange(details, u"baseline"_s, numbersOf(known.chain.baseline), numbersOf(now.chain.baseline));
    return details;
}

QJsonObject auditDetails(const std::optional<ReferenceObjectRecord>& before, const ReferenceObject& now)
{
    QJsonObject details{{u"reference"_s, now.name}};
    const ReferenceObject known = before ? ReferenceObject(*before) : ReferenceObject();
    if (before) {
        addChange(details, u"reference"_s, known.name, now.name);
        addChange(details, u"certificate"_s, known.certificate, now.certificate);
        addChange(details, u"preload_n"_s, known.bias_N, now.bias_N);
        addChange(details, u"push_n"_s, known.peak_N, now.peak_N);
        addChange(details, u"squeezes"_s, known.squeezes, now.squeezes);
        addChange(details, u"interval_h"_s, known.intervalHours, now.intervalHours);
    }
    const std::array<QString, 3> names{u"m"_s, u"b"_s, u"k"_s};
    for (std::size_t i = 0; i < names.size(); ++i)
        addChanges(details, names[i], known.stated[i], now.stated[i]);
    return details;
}

} // namespace gripscope
