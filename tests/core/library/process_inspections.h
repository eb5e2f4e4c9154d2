// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/library/records/process_values.h"

#include <QTest>

namespace gripscope::test {

/// An inspection in which `type` was recognised, without a recording.
struct ProcessPart {
    MassDampingStiffness parameters{0.04, 43, 9990};
    QString type = QStringLiteral("A");
    QString operatorName = QStringLiteral("Ada");
    QString batchId = {};
    QString forceUnit = QStringLiteral("N"), positionUnit = QStringLiteral("m");
    QString gripper = QStringLiteral("0001");
    QDateTime time = QDateTime(QDate(2026, 5, 4), QTime(8, 0), Qt::UTC);
};

inline NewInspection inspectionOf(const ProcessPart& part)
{
    Estimate estimate;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = part.parameters;
    NewInspection inspection;
    inspection.grasp.estimates = {estimate};
    inspection.grasp.forceUnit = part.forceUnit;
    inspection.grasp.positionUnit = part.positionUnit;
    inspection.grasp.operatorName = part.operatorName;
    inspection.grasp.recorded = part.time;
    Recording recording;
    recording.sampleTime_s = 0.001;
    recording.forceUnit = part.forceUnit;
    recording.positionUnit = part.positionUnit;
    recording.provenance = {{QStringLiteral("serial"), part.gripper},
                            {QStringLiteral("device"), QStringLiteral("Gripper")}};
    for (int i = 0; i < 4; ++i) {
        recording.time_s.push_back(0.001 * i);
        recording.force.push_back(20 + i % 2);
        recording.position.push_back(1e-3 + 1e-6 * i);
    }
    inspection.grasp.recording = recording;
    inspection.verdict.kind = VerdictKind::Type;
    inspection.verdict.type = part.type;
    inspection.verdict.validity.verdict = ValidityVerdict::Valid;
    inspection.batchId = part.batchId;
    return inspection;
}

/// Its number.
inline qint64 addPart(Library& library, const ProcessPart& part)
{
    const Expected<InspectionRecord> stored = library.addInspection(inspectionOf(part));
    if (!stored)
        qFatal("%s", qPrintable(stored.error().describe()));
    return stored->number;
}

inline ProcessValues valuesOf(const Library& library, const ProcessQuery& query)
{
    ProcessValues values;
    ProcessPlace place;
    while (!place.through) {
        Expected<ProcessPlace> next = library.processStretch(query, place, values);
        if (!next)
            qFatal("%s", qPrintable(next.error().describe()));
        place = *std::move(next);
    }
    return values;
}

} // namespace gripscope::test
