// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/shift/drift_look.h"

#include "core/base/words.h"

#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

std::optional<ChangePoint> changeOf(const DriftLook& look)
{
    switch (look.report.cause) {
    case DriftCause::TooFew:
    case DriftCause::Nothing:
        return {};
    case DriftCause::Sensor:
    case DriftCause::Gripper:
        return findChange(look.models, look.inspected.squeezes, ShiftKind::Factor);
    case DriftCause::Fingers:
        return findChange(look.models, look.inspected.squeezes, ShiftKind::Addition);
    case DriftCause::Product:
    case DriftCause::Unclear:
    case DriftCause::OneTypeOnly:
    case DriftCause::NoCommonCause:
        break;
    }
    return findChange(look.models, look.inspected.squeezes, ShiftKind::Factor, look.report.moved);
}

Finding inspectionAt(const InspectedSqueezes::Origin& origin)
{
    return Words::say("inspection %1 of %2")
        .arg(QString::number(origin.number), origin.inspected.toLocalTime().toString(u"yyyy-MM-dd hh:mm"_s));
}

Findings sinceInWords(const DriftLook& look)
{
    if (!look.change)
        return {};
    const auto& origins = look.inspected.origins;
    const ChangePoint& change = *look.change;
    Findings words;
    if (change.before == 0) {
        words.push_back(Words::say("It was so from the first of these inspections on: the change is older."));
    } else {
        words.push_back(Words::say("Since %1.").arg(inspectionAt(origins[std::size_t(change.before)])));
    }
    if (change.latest > change.earliest)
        words.push_back(Words::say("With 95 % between %1 and %2.")
                            .arg(inspectionAt(origins[std::size_t(change.earliest)]),
                                 inspectionAt(origins[std::size_t(change.latest)])));
    const QString& batch = origins[std::size_t(change.before)].batch;
    if (!batch.isEmpty() && change.before > 0)
        words.push_back(Words::say("That was in the batch %1.").arg(batch));
    return words;
}

} // namespace

Expected<DriftMaterial> readDriftMaterial(Library& library, const InspectedChoice& choice)
{
    ASSIGN_OR_RETURN(TypeModels models, approvedModels(library));
    ASSIGN_OR_RETURN(InspectedSqueezes inspected, inspectedSqueezes(library, choice));
    return DriftMaterial{std::move(models), std::move(inspected)};
}

Expected<DriftLook> lookForDrift(DriftMaterial material, const DriftOptions& options)
{
    DriftLook look{std::move(material.models), std::move(material.inspected), {}, {}, {}};
    ASSIGN_OR_RETURN(look.report, findDrift(look.models, look.inspected.squeezes, options));
    look.change = changeOf(look);
    look.since = sinceInWords(look);
    return look;
}

} // namespace gripscope
