// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/referenced_readings.h"

#include "core/base/words.h"
#include "core/signal/recording/units.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

bool isInSi(const QString& unit, std::size_t quantity)
{
    const ParameterUnits si =
        comparableUnits(forceUnits().front(), positionUnits().front()); // any that are known
    return unit == std::array{si.m, si.b, si.k}[quantity];
}

tl::unexpected<Error> unreadable(const KeptStudy& study, const Finding& found, const Finding& wanted)
{
    return failure(ErrorCode::BadInput,
                   {Words::say("The study %1").arg(study.record.study.name), found, wanted});
}

} // namespace

Expected<ReferencedReadings> referencedReadings(const KeptStudy& study)
{
    const auto quantity = std::size_t(study.plan.design.quantity);
    ReferencedReadings readings;
    for (const StudyMeasurementRecord* const one : study.counted()) {
        bool isNumber = false;
        const double reference = study.plan.reference(std::size_t(one->measured.row)).toDouble(&isNumber);
        const std::optional<StudyValue>& value = one->measured.values[quantity];
        if (!isNumber || !value)
            return unreadable(study, Words::say("a squeeze without its quantity or reference"),
                              Words::say("the quantity of the study from every squeeze"));
        const QString unit = one->measured.units[quantity];
        if (!readings.values.empty() && unit != readings.unit)
            return unreadable(study, Words::say("measurements in several units"),
                              Words::say("measurements in one unit"));
        readings.references.push_back(reference);
        readings.values.push_back(value->value);
        readings.unit = unit;
    }
    if (readings.values.empty())
        return unreadable(study, Words::say("nothing that counts was measured"),
                          Words::say("a squeeze or a verdict of every part"));
    if (isInSi(readings.unit, quantity))
        readings.quantity = static_cast<MechanicalQuantity>(quantity);
    return readings;
}

} // namespace gripscope
