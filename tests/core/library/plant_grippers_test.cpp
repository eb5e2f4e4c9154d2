// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_calibration.h"
#include "core/library/sql/time_ordered_id.h"
#include "tests/core/library/linked_station.h"
#include "tests/core/library/plant_actions.h"
#include "tests/core/library/raw_database.h"
#include "tests/core/library/study_fixture.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QTest>

#include <random>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// Between rows of two stations: their clocks have milliseconds.
void aMoment()
{
    QTest::qSleep(2);
}

void calibrate(Library& library, const QString& note)
{
    SensorCalibration calibration = aCalibration();
    calibration.note = note;
    valueOf(library.addCalibration(calibration));
    aMoment();
}

QString calibrated(const Library& library)
{
    return valueOf(library.calibrationsInForce(u"0001"_s)).force->note;
}

NewAdjustment adjustmentBecause(const QString& reason)
{
    NewAdjustment adjustment = anAdjustment();
    adjustment.reason = reason;
    return adjustment;
}

QString adjust(Library& library, const NewAdjustment& adjustment)
{
    const QString id = valueOf(library.acceptAdjustment(adjustment)).id;
    aMoment();
    return id;
}

/// Why those in force are.
QStringList adjusted(const Library& library)
{
    QStringList reasons;
    for (const AdjustmentStanding& standing : valueOf(library.adjustmentsInForce()))
        reasons << standing.record.adjustment.reason;
    return reasons;
}

/// A study of two squeezes, of which one was taken back.
QString aFinishedStudy(Library& library)
{
    const QString study = valueOf(library.beginStudy(aStudy())).id;
    for (int row = 0; row < 2; ++row) {
        NewStudyMeasurement measured = aMeasurement(study, row);
        measured.squeeze =
            DraftSqueeze{newTimeOrderedId(), u"Cans"_s, awkwardRecording(), u"virtual:"_s, u"7"_s};
        const auto stored = valueOf(library.addStudyMeasurement(measured));
        if (row == 1)
            valueOf(library.undoStudyMeasurement(stored.id, u"wrong part"_s, u"Ada"_s));
    }
    valueOf(library.endStudy(study, StudyState::Finished, {}, u"Ada"_s));
    return study;
}

} // namespace

/// What is in force of a gripper that goes from station to station of a plant.
class PlantGrippersTest : public QObject {
    Q_OBJECT
private slots:
    void aGripperMeasuresByItsNewestCalibrationWhereverItIs()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        std::array<LinkedStation, 3> stations;
        std::mt19937 random(1);
        for (int i = 0; i < 20; ++i) {
            LinkedStation& station = stations[random() % stations.size()];
            const QString note = u"the %1."_s.arg(i);
            calibrate(*station.library, note);
            // Some know of it only after they have calibrated it themselves.
            if (random() % 2 == 0)
                stations[random() % stations.size()].bringInStep(*plant);
            if (i % 4 != 3)
                continue;
            for (int round = 0; round < 2; ++round)
                for (LinkedStation& linked : stations)
                    linked.bringInStep(*plant);
            for (LinkedStation& linked : stations)
                QCOMPARE(calibrated(*linked.library), note);
            QCOMPARE(calibrated(*plant), note);
        }
        for (LinkedStation& station : stations)
            QVERIFY(isWhole(station.file()));
        QVERIFY(isWhole(server.file()));
    }
    void whatIsStoredInKnowledgeOfAnotherComesBehindItWhateverTheClocksSay()
    {
        GRIPSCOPE_OF_FILES_ALONE("the file is edited")
        const LibraryFolder folder;
        calibrate(*folder.open(), u"by a clock of the year 2100"_s);
        RawDatabase(folder.file()).run(u"UPDATE calibrations SET serial = 4102444800000"_s);
        calibrate(*folder.open(), u"by one that was set right"_s);
        QCOMPARE(calibrated(*folder.open()), u"by one that was set right"_s);
        QCOMPARE(RawDatabase(folder.file()).column(u"SELECT MAX(serial) FROM calibrations"_s),
                 QStringList{u"4102444800001"_s});
    }
    void oneAdjustmentOfAGripperIsInForce()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation one, other, third;
        const auto allInStep = [&] {
            for (int round = 0; round < 2; ++round)
                for (LinkedStation* station : {&one, &other, &third})
                    station->bringInStep(*plant);
        };
        const auto inForceEverywhere = [&](const QStringList& reasons) {
            for (const Library* library :
                 {one.library.get(), other.library.get(), third.library.get(), plant.get()})
                QCOMPARE(adjusted(*library), reasons);
        };
        adjust(*one.library, adjustmentBecause(u"first"_s));
        adjust(*other.library, adjustmentBecause(u"second, not knowing of the first"_s));
        allInStep();
        inForceEverywhere({u"second, not knowing of the first"_s});
        const QString last = adjust(*one.library, adjustmentBecause(u"third"_s));
        allInStep();
        inForceEverywhere({u"third"_s});
        // Withdrawn: none is in force again.
        valueOf(other.library->withdrawAdjustment(last, u"worn"_s, u"Ben"_s));
        allInStep();
        inForceEverywhere({});
    }
    void anAdjustmentComesWithTheStudyItIsFrom()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation one, other;
        NewAdjustment adjustment = adjustmentBecause(u"by a study"_s);
        adjustment.studyId = aFinishedStudy(*one.library);
        static_cast<void>(aFinishedStudy(*one.library)); // of which nothing came
        adjust(*one.library, adjustment);
        one.bringInStep(*plant);
        other.bringInStep(*plant);
        QCOMPARE(adjusted(*other.library), QStringList{u"by a study"_s});
        const auto studies = valueOf(other.library->studies(10));
        QCOMPARE(studies.size(), std::size_t(1));
        QCOMPARE(studies[0].id, adjustment.studyId);
        QVERIFY(studies[0].state == StudyState::Finished);
        const auto here = valueOf(one.library->studyMeasurements(adjustment.studyId));
        const auto there = valueOf(other.library->studyMeasurements(adjustment.studyId));
        QCOMPARE(there.size(), std::size_t(2));
        for (std::size_t i = 0; i < there.size(); ++i) {
            QCOMPARE(there[i].measured.values, here[i].measured.values);
            QCOMPARE(there[i].undone, i == 1);
            QCOMPARE(valueOf(other.library->draftSqueeze(there[i].squeezeId)).recording, awkwardRecording());
        }
        QVERIFY(isWhole(other.file()));
        QVERIFY(isWhole(server.file()));
    }
};

GRIPSCOPE_TEST(PlantGrippersTest)
#include "plant_grippers_test.moc"
