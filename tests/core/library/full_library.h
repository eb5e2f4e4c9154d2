// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/library/merge/library_merge.h"
#include "core/library/records/batch.h"
#include "core/library/records/enrollment_draft.h"
#include "core/library/records/gripper_adjustment.h"
#include "core/library/records/history.h"
#include "core/library/records/study_record.h"
#include "core/library/sql/time_ordered_id.h"
#include "tests/core/library/people_fixture.h"

namespace gripscope::test {

inline NewMeasuringChain aMeasuringChain()
{
    NewMeasuringChain measured;
    measured.gripperSerial = u"0001"_s;
    measured.forceLag_s = 1e-4;
    measured.operatorName = u"Ada"_s;
    measured.basis = u"a step"_s;
    return measured;
}

inline SensorCalibration aCalibration()
{
    SensorCalibration calibration;
    calibration.gripperSerial = u"0001"_s;
    calibration.unit = u"N"_s;
    calibration.reference = {u"Weights M1"_s, u"D-K-17 4711"_s, 0.001, 1e-5};
    for (const double load : {0.0, 10.0, 20.0, 10.0, 1.0, 0.0})
        calibration.points.push_back({load, 1.02 * load + 1e-3 * (load > 5)});
    calibration.operatorName = u"Ada"_s;
    calibration.takenUtc = QDateTime(QDate(2026, 3, 1), QTime(7, 30), Qt::UTC);
    calibration.due = QDate(2027, 3, 1);
    return calibration;
}

inline void addReference(Library& library)
{
    ReferenceObject reference;
    reference.gripperSerial = u"0001"_s;
    reference.name = u"Spring S-12"_s;
    reference.stated[2] = ReferenceQuantity{10000.0 / 3, 5, 100};
    reference.bias_N = 15;
    reference.peak_N = 7.5;
    reference.squeezes = 4;
    reference.intervalHours = 8;
    valueOf(library.addReferenceObject(reference));
    ReferenceCheck check;
    check.gripperSerial = u"0001"_s;
    check.referenceId = valueOf(library.calibrationsInForce(u"0001"_s)).reference->reference.id;
    check.verdict = CheckVerdict::Passed;
    check.measured[2] = MeasuredQuantity{1e4 / 3.1, 0.1};
    check.squeezes = 4;
    valueOf(library.addReferenceCheck(check));
}

inline void addDraft(Library& library)
{
    EnrollmentDraft draft;
    draft.name = u"Cola"_s;
    draft.recipe.peak_N = 7;
    draft.step = EnrollmentDraft::Step::Squeeze;
    valueOf(library.saveDraft(draft));
    DraftSqueeze squeeze;
    squeeze.id = newTimeOrderedId();
    squeeze.name = draft.name;
    squeeze.recording = awkwardRecording();
    valueOf(library.addDraftSqueeze(squeeze));
}

inline void addStudy(Library& library)
{
    NewStudy study;
    study.kind = u"gauge"_s;
    study.name = u"Cans"_s;
    study.plan = {{u"seed"_s, u"1"_s}};
    NewStudyMeasurement measured;
    measured.studyId = valueOf(library.beginStudy(study)).id;
    measured.outcome = u"measured"_s;
    measured.values[2] = StudyValue{1e4 / 3, 0.1};
    measured.squeeze = DraftSqueeze{newTimeOrderedId(), study.name, awkwardRecording(), {}, {}};
    const QString id = valueOf(library.addStudyMeasurement(measured)).id;
    valueOf(library.undoStudyMeasurement(id, u"the wrong part"_s, u"Ada"_s));
    valueOf(library.endStudy(measured.studyId, StudyState::Abandoned, {}, u"Ada"_s));
}

inline void addAdjustment(Library& library)
{
    NewAdjustment adjustment;
    adjustment.gripperSerial = u"0002"_s;
    adjustment.types = QStringList{u"A"_s};
    adjustment.squeezes = 3;
    adjustment.error.value = Eigen::Vector3d(0.05, 1.0 / 30, -1e-17);
    adjustment.error.covariance = 1e-4 / 3 * Eigen::Matrix3d::Identity();
    adjustment.reason = u"second line"_s;
    const QString id = valueOf(library.acceptAdjustment(adjustment)).id;
    valueOf(library.withdrawAdjustment(id, u"calibrated"_s, u"Ada"_s));
}

/// Another station enrolled a type of the same name: merged, and seen.
inline void mergeAnother(Library& library)
{
    const LibraryFolder other;
    {
        const auto there = other.open();
        const QString a = valueOf(there->addType(u"A"_s, {}, u"N"_s, u"m"_s, u"Ben"_s)).id;
        valueOf(there->addGrasp(aGrasp(a, 7000)));
        valueOf(there->addInspection(anInspection()));
    }
    const MergeReport report = valueOf(library.mergeLibrary(other.file(), {u"Ada"_s, u"one plant"_s}));
    valueOf(library.noteConflictsSeen(report.conflicts, {u"Ada"_s, {}}));
}

/// At least one row in every table, by what the program itself does.
inline void fillEveryTable(Library& library)
{
    const QString a = valueOf(library.addType(u"A"_s, {}, u"N"_s, u"m"_s, u"Ada"_s)).id;
    QString last;
    for (int i = 0; i < 3; ++i)
        last = valueOf(library.addGrasp(aGrasp(a, 9990 + i))).id;
    valueOf(library.dropGrasp(last, u"slipped"_s, u"Ada"_s));
    NewGrasp yielding = aGrasp(a);
    yielding.determined = someQuantities();
    valueOf(library.addGrasp(yielding));
    const PartPicture picture{newTimeOrderedId(), u"png"_s, 3, 2, QByteArray("\x89PNG\0bytes", 10)};
    valueOf(library.addPicture(picture));
    valueOf(library.setTypePicture(a, picture.id, u"Ada"_s));
    valueOf(library.approveType(a, u"Ada"_s));
    const BatchRecord batch = valueOf(library.beginBatch({u"7"_s, 3, u"A"_s, u"Ada"_s}));
    NewInspection inspection = anInspection();
    inspection.batchId = batch.id;
    const InspectionRecord inspected = valueOf(library.addInspection(inspection));
    valueOf(library.voidInspection(valueOf(library.addInspection(anInspection(VerdictKind::Invalid))).number,
                                   u"squeezed twice"_s, u"Ada"_s));
    valueOf(library.endBatch(batch.id, u"Ada"_s));
    valueOf(library.addReidentification(inspected.graspId, anEstimate(), {}));
    valueOf(library.addMeasuringChain(aMeasuringChain()));
    valueOf(library.addCalibration(aCalibration()));
    addReference(library);
    addDraft(library);
    addStudy(library);
    addAdjustment(library);
    valueOf(library.fixProcessLimits(u"A"_s, u"{}"_s, u"Ada"_s));
    mergeAnother(library);
    const People people(library);
    library.actAs(people.supervisor(library));
    valueOf(library.people().setArming(ArmingPolicy::Supervisors));
    library.actAs({});
}

} // namespace gripscope::test
