// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/inspected_squeezes.h"

#include "core/library/records/gripper_adjustment.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/transfer.h"
#include "core/session/squeeze/comparable_units.h"
#include "core/signal/recording/units.h"

#include <QHash>

#include <algorithm>
#include <limits>

namespace gripscope {

namespace {

/// Inspections read at once.
constexpr int pageSize = 1000;

/// By their keys.
using Adjustments = QHash<QString, CommonShift>;

Expected<Adjustments> allAdjustments(Library& library)
{
    ASSIGN_OR_RETURN(const std::vector<AdjustmentRecord> records,
                     library.adjustments(std::numeric_limits<int>::max()));
    Adjustments errors;
    for (const AdjustmentRecord& record : records)
        errors.insert(record.id, record.adjustment.error);
    return errors;
}

TypeSqueeze inCommonUnits(const InspectionRecord& inspection, const QString& type,
                          const std::optional<Eigen::Matrix3d>& covariance, const Adjustments& adjustments)
{
    const double factor = siFactor(inspection.forceUnit, inspection.positionUnit).value_or(1.0);
    const TypeSqueeze squeeze = scaledSqueeze(type, *inspection.parameters, covariance, factor);
    const auto error = adjustments.constFind(inspection.adjustmentId);
    return error == adjustments.cend() ? squeeze : adjusted(squeeze, *error);
}

/// The type that a squeeze is news of; empty: of none.
QString typeToldOf(const InspectionRecord& inspection, const InspectedChoice& choice)
{
    const QString type = inspection.expectedType.isEmpty() ? inspection.type : inspection.expectedType;
    const bool isRecognised = inspection.verdict == VerdictKind::Type && inspection.type == type;
    const bool counts = inspection.parameters && inspection.verdict != VerdictKind::Invalid &&
                        inspection.voided.isEmpty() && (isRecognised || !choice.recognisedOnly);
    return counts ? type : QString();
}

bool isChosen(const InspectionRecord& inspection, const InspectedChoice& choice)
{
    return (choice.gripperSerial.isEmpty() || choice.gripperSerial == inspection.gripperSerial) &&
           (choice.station.isEmpty() || choice.station == inspection.station);
}

void noteOnce(QStringList& names, const QString& name)
{
    if (!name.isEmpty() && !names.contains(name))
        names << name;
}

Expected<void> take(Library& library, const InspectionRecord& inspection, const InspectedChoice& choice,
                    const Adjustments& adjustments, InspectedSqueezes& found)
{
    noteOnce(found.grippers, inspection.gripperSerial);
    noteOnce(found.stations, inspection.station);
    if (!isChosen(inspection, choice))
        return {};
    const QString type = typeToldOf(inspection, choice);
    if (type.isEmpty()) {
        found.leftOut += 1;
        return {};
    }
    ASSIGN_OR_RETURN(const std::optional<GraspRecord> grasp, library.grasp(inspection.graspId));
    found.squeezes.push_back(
        inCommonUnits(inspection, type, grasp ? grasp->covariance : std::nullopt, adjustments));
    found.origins.push_back({inspection.number, inspection.inspected, inspection.batch,
                             inspection.gripperSerial, inspection.station});
    return {};
}

} // namespace

Expected<TypeModels> approvedModels(Library& library)
{
    ASSIGN_OR_RETURN(const std::vector<TypeRecord> types, library.types());
    ASSIGN_OR_RETURN(const std::vector<TypeSqueeze> squeezes, library.approvedSqueezes());
    return ComparableTypes(types, squeezes).main();
}

Expected<InspectedSqueezes> inspectedSqueezes(Library& library, const InspectedChoice& choice)
{
    const std::optional<int>& newest = choice.newest;
    ASSIGN_OR_RETURN(const Adjustments adjustments, allAdjustments(library));
    InspectedSqueezes found;
    HistoryFilter filter;
    while (true) {
        filter.limit = newest ? std::min(pageSize, *newest - static_cast<int>(filter.offset)) : pageSize;
        ASSIGN_OR_RETURN(const std::vector<InspectionRecord> page, library.inspections(filter));
        for (const InspectionRecord& inspection : page)
            RETURN_IF_ERROR(take(library, inspection, choice, adjustments, found));
        filter.offset += filter.limit;
        if (page.size() < std::size_t(filter.limit) || (newest && filter.offset >= *newest))
            break;
    }
    std::reverse(found.squeezes.begin(), found.squeezes.end());
    std::reverse(found.origins.begin(), found.origins.end());
    found.grippers.sort();
    found.stations.sort();
    return found;
}

} // namespace gripscope
