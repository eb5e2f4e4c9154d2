// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/audit/audit_trail.h"
#include "core/library/migrations/migration.h"
#include "core/library/sql/time_ordered_id.h"
#include "core/library/verification/library_verification.h"
#include "core/people/audit_entry.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/core/library/study_fixture.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QTest>

#include <algorithm>
#include <limits>

using namespace gripscope;
using namespace gripscope::test;

/// Studies of the gripper in the library.
class LibraryStudiesTest : public QObject {
    Q_OBJECT
private slots:
    void aStudyComesBackAsItWasBegun()
    {
        const LibraryFolder folder;
        const QString id = valueOf(folder.open()->beginStudy(aStudy())).id;
        const auto library = folder.open();
        const StudyRecord found = *valueOf(library->study(id));
        QCOMPARE(found.study.name, u"Cans, gripper 1"_s);
        QCOMPARE(found.study.kind, u"gauge"_s);
        QCOMPARE(found.study.plan, aStudy().plan);
        QCOMPARE(found.study.options, aStudy().options);
        QVERIFY(found.study.recipe == aStudy().recipe);
        QCOMPARE(found.study.gripperSerial, u"F-1"_s);
        QCOMPARE(found.study.operatorName, u"Zoë"_s);
        QVERIFY(found.begun.isValid() && found.state == StudyState::Open && !found.ended);
        QVERIFY(!valueOf(library->study(u"none"_s)));
    }
    void aMeasurementIsThereBitForBitWithItsRecording()
    {
        const LibraryFolder folder;
        const QString id = valueOf(folder.open()->beginStudy(aStudy())).id;
        NewStudyMeasurement measured = aMeasurement(id, 4);
        measured.squeeze =
            DraftSqueeze{newTimeOrderedId(), u"Cans"_s, awkwardRecording(), u"virtual:"_s, u"7"_s};
        valueOf(folder.open()->addStudyMeasurement(measured));
        const auto library = folder.open();
        const StudyMeasurementRecord stored = valueOf(library->studyMeasurements(id)).at(0);
        QCOMPARE(stored.measured.values, measured.values);
        QCOMPARE(stored.measured.units, measured.units);
        QVERIFY(stored.measured.reasons == measured.reasons);
        QCOMPARE(stored.measured.row, 4);
        QCOMPARE(stored.measured.outcome, u"measured"_s);
        QCOMPARE(stored.measured.rating, u"good"_s);
        QCOMPARE(stored.measured.validity, u"suspect"_s);
        QCOMPARE(stored.measured.operatorName, u"Ada"_s);
        QVERIFY(!stored.undone && stored.stored.isValid());
        QCOMPARE(valueOf(library->draftSqueeze(stored.squeezeId)).recording, awkwardRecording());
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
    void measurementsKeepTheirOrder()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString id = valueOf(library->beginStudy(aStudy())).id;
        const QString other = valueOf(library->beginStudy(aStudy(u"Another"_s))).id;
        for (const qint64 row : {5, 2, 2, 9}) {
            valueOf(library->addStudyMeasurement(aMeasurement(id, row)));
            valueOf(library->addStudyMeasurement(aMeasurement(other, row)));
        }
        std::vector<qint64> rows;
        for (const StudyMeasurementRecord& one : valueOf(library->studyMeasurements(id)))
            rows.push_back(one.measured.row);
        QCOMPARE(rows, std::vector<qint64>({5, 2, 2, 9}));
        QCOMPARE(valueOf(library->study(id))->measurements, 4);
    }
    void undoingMarksAndDeletesNothing()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString id = valueOf(library->beginStudy(aStudy())).id;
        const QString measurement = valueOf(library->addStudyMeasurement(aMeasurement(id, 3))).id;
        valueOf(library->undoStudyMeasurement(measurement, u"the wrong part"_s, u"Ada"_s));
        valueOf(library->undoStudyMeasurement(measurement, u"again"_s, u"Bo"_s)); // changes nothing
        const StudyMeasurementRecord stored = valueOf(library->studyMeasurements(id)).at(0);
        QVERIFY(stored.undone);
        QCOMPARE(stored.undoReason, u"the wrong part"_s);
        QCOMPARE(valueOf(library->study(id))->measurements, 0);
        RawDatabase raw(folder.file());
        QCOMPARE(raw.count(u"study_measurements"_s), 1);
        QCOMPARE(raw.count(u"study_undos"_s), 1);
        const AuditEntry told = valueOf(library->auditTrail().entries({})).front();
        QCOMPARE(told.action, QString::fromUtf16(audit_action::studyUndone));
        QCOMPARE(told.reason, u"the wrong part"_s);
        QCOMPARE(detailsInWords(told), u"squeeze of the plan: 4"_s);
        QCOMPARE(library->undoStudyMeasurement(u"none"_s, {}, {}).error().code, ErrorCode::NotFound);
    }
    void anEndedStudyIsClosed()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString id = valueOf(library->beginStudy(aStudy())).id;
        const QString other = valueOf(library->beginStudy(aStudy(u"Another"_s))).id;
        const QString measurement = valueOf(library->addStudyMeasurement(aMeasurement(id))).id;
        QCOMPARE(valueOf(library->unfinishedStudies()).size(), std::size_t(2));
        const StudyRecord ended = valueOf(library->endStudy(id, StudyState::Finished, {}, u"Ada"_s));
        QVERIFY(ended.state == StudyState::Finished && ended.ended);
        QVERIFY(valueOf(library->endStudy(id, StudyState::Abandoned, u"late"_s, {})).state ==
                StudyState::Finished);
        QCOMPARE(valueOf(library->endStudy(other, StudyState::Abandoned, u"broken"_s, u"Bo"_s)).endReason,
                 u"broken"_s);
        QVERIFY(valueOf(library->unfinishedStudies()).empty());
        QCOMPARE(valueOf(library->studies(10)).at(0).study.name, u"Another"_s); // newest first
        QCOMPARE(library->addStudyMeasurement(aMeasurement(id)).error().code, ErrorCode::Usage);
        QCOMPARE(library->undoStudyMeasurement(measurement, {}, {}).error().code, ErrorCode::Usage);
        const AuditEntry told = valueOf(library->auditTrail().entries({})).front();
        QCOMPARE(told.action, QString::fromUtf16(audit_action::studyEnded));
        QVERIFY(actionInWords(told.action) != told.action);
        QVERIFY(detailsInWords(told).contains(u"state: abandoned"_s));
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
    void whatMakesNoSenseIsRefused()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        NewStudy study = aStudy(u"  "_s);
        QCOMPARE(library->beginStudy(study).error().code, ErrorCode::Usage);
        study = aStudy();
        study.plan = {};
        QCOMPARE(library->beginStudy(study).error().code, ErrorCode::Usage);
        const QString id = valueOf(library->beginStudy(aStudy())).id;
        QCOMPARE(library->addStudyMeasurement(aMeasurement(u"none"_s)).error().code, ErrorCode::NotFound);
        QCOMPARE(library->addStudyMeasurement(aMeasurement(id, -1)).error().code, ErrorCode::Usage);
        for (const StudyValue& value :
             {StudyValue{std::numeric_limits<double>::quiet_NaN(), 1},
              StudyValue{1, std::numeric_limits<double>::infinity()}, StudyValue{1, -1}}) {
            NewStudyMeasurement measured = aMeasurement(id);
            measured.values[1] = value;
            QCOMPARE(library->addStudyMeasurement(measured).error().code, ErrorCode::Usage);
        }
        QCOMPARE(library->endStudy(id, StudyState::Open, {}, {}).error().code, ErrorCode::Usage);
        QVERIFY(valueOf(library->studyMeasurements(id)).empty());
    }
    void theRecordingOfAMeasurementThatIsRefusedIsNotKept()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        NewStudyMeasurement measured = aMeasurement(valueOf(library->beginStudy(aStudy())).id);
        measured.outcome = u"guessed"_s; // which the table does not take
        measured.squeeze = DraftSqueeze{newTimeOrderedId(), u"Cans"_s, awkwardRecording(), {}, {}};
        QVERIFY(!library->addStudyMeasurement(measured));
        QCOMPARE(RawDatabase(folder.file()).count(u"draft_squeezes"_s), 0);
    }
    void everyEarlierVersionGetsThem_data()
    {
        QTest::addColumn<int>("version");
        for (const Migration& step : migrations()) {
            if (step.name == u"studies of the gripper"_s)
                break;
            QTest::addRow("version %d", step.version) << step.version;
        }
    }
    void everyEarlierVersionGetsThem()
    {
        QFETCH(int, version);
        const LibraryFolder folder;
        {
            const std::vector<Migration> before = migrationsUpTo(version);
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(migrate(*database, before));
            QVERIFY(!valueOf(database->tables()).contains(u"studies"_s));
        }
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        const QString id = valueOf(library->beginStudy(aStudy())).id;
        valueOf(library->addStudyMeasurement(aMeasurement(id)));
        QCOMPARE(valueOf(library->unfinishedStudies()).at(0).measurements, 1);
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }
};
GRIPSCOPE_TEST(LibraryStudiesTest)
#include "library_studies_test.moc"
