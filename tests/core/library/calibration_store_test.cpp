// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_record.h"
#include "core/library/migrations/migration.h"
#include "core/library/sql/statement.h"
#include "core/library/verification/library_verification.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;

namespace {

SensorCalibration forceAgainstWeights(double factor = 1.02)
{
    SensorCalibration calibration;
    calibration.gripperSerial = u"0001"_s;
    calibration.gripperName = u"Left cell"_s;
    calibration.unit = u"N"_s;
    calibration.reference = {u"Weights M1"_s, u"D-K-17 4711"_s, 0.001, 1e-5};
    for (const double load : {0.0, 10.0, 20.0, 10.0, 1.0 / 3, 0.0})
        calibration.points.push_back({load, factor * load + 1e-3 * (load > 5)});
    calibration.operatorName = u"Ada"_s;
    calibration.note = u"after the new cable"_s;
    calibration.takenUtc = QDateTime(QDate(2026, 3, 1), QTime(7, 30), Qt::UTC);
    calibration.due = QDate(2027, 3, 1);
    calibration.reference.due = QDate(2028, 1, 31);
    calibration.conditions = {LoadUnit::Kilogram, 9.8123, 21.5, 0.2, DecisionRule::Simple};
    calibration.foundCorrection = u""_s;
    calibration.checkPoints = {{10, factor * 10}, {0, 1e-3}};
    return calibration;
}

bool same(const SensorCalibration& a, const SensorCalibration& b)
{
    const auto samePoint = [](const CalibrationPoint& p, const CalibrationPoint& q) {
        return p.load == q.load && p.reading == q.reading;
    };
    return a.gripperSerial == b.gripperSerial && a.gripperName == b.gripperName && a.channel == b.channel &&
           a.unit == b.unit && a.reference.name == b.reference.name &&
           a.reference.certificate == b.reference.certificate &&
           a.reference.standardUncertainty == b.reference.standardUncertainty &&
           a.reference.relativeUncertainty == b.reference.relativeUncertainty && a.degree == b.degree &&
           std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end(), samePoint) &&
           std::equal(a.checkPoints.begin(), a.checkPoints.end(), b.checkPoints.begin(), b.checkPoints.end(),
                      samePoint) &&
           a.reference.due == b.reference.due && a.conditions == b.conditions &&
           a.foundCorrection == b.foundCorrection && a.operatorName == b.operatorName && a.note == b.note &&
           a.takenUtc == b.takenUtc && a.due == b.due;
}

} // namespace

class CalibrationStoreTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsStoredComesBackToTheLastDigit()
    {
        const LibraryFolder folder;
        const SensorCalibration calibration = forceAgainstWeights();
        QVERIFY(folder.open()->addCalibration(calibration));
        const auto stored = valueOf(folder.open()->calibrations(u"0001"_s, 10));
        QCOMPARE(stored.size(), std::size_t(1));
        QVERIFY(same(stored[0], calibration));
        QVERIFY(stored[0].stored.isValid() && !stored[0].id.isEmpty());
    }

    void conditionsThatCannotBeAreNotComputedWith()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        SensorCalibration wrong = forceAgainstWeights();
        wrong.checkPoints[1].reading = std::nan("");
        const auto refused = library->addCalibration(wrong);
        QVERIFY(!refused && refused.error().code == ErrorCode::Usage);
        QVERIFY(library->addCalibration(forceAgainstWeights()));
        for (const QString& gravity : {u"0"_s, u"-9.8"_s, u"1e300"_s}) {
            RawDatabase(folder.file()).run(u"UPDATE calibrations SET gravity = "_s + gravity);
            const auto read = library->calibrations(u"0001"_s, 10);
            QVERIFY2(!read && read.error().code == ErrorCode::StorageCorrupt, qPrintable(gravity));
        }
    }
    void whatWasNotStatedStaysSo()
    {
        const LibraryFolder folder;
        SensorCalibration bare = forceAgainstWeights();
        bare.reference.due = {};
        bare.conditions = {};
        bare.foundCorrection.reset();
        bare.checkPoints.clear();
        QVERIFY(folder.open()->addCalibration(bare));
        QVERIFY(same(valueOf(folder.open()->calibrations(u"0001"_s, 1)).front(), bare));
        bare.conditions.ambient_C = 200;
        QCOMPARE(folder.open()->addCalibration(bare).error().code, ErrorCode::Usage);
    }

    void certificatesAreNumberedWithoutAHole()
    {
        const LibraryFolder folder;
        for (int i = 0; i < 3; ++i) {
            SensorCalibration calibration = forceAgainstWeights();
            calibration.gripperSerial = u"000%1"_s.arg(i); // one row of numbers for all grippers and channels
            calibration.channel = i == 1 ? SensorChannel::Position : SensorChannel::Force;
            QVERIFY(folder.open()->addCalibration(calibration));
            SensorCalibration refused = calibration;
            refused.due = {};
            QVERIFY(!folder.open()->addCalibration(refused)); // takes no number
        }
        const auto stored = valueOf(folder.open()->calibrations({}, 10));
        QCOMPARE(stored.size(), std::size_t(3));
        for (std::size_t i = 0; i < stored.size(); ++i) { // the newest first
            QCOMPARE(stored[i].certificateNumber, qint64(3 - i));
            QCOMPARE(stored[i].station, stationId());
        }
        QVERIFY(valueOf(verifyLibrary(folder.file())).whole());
    }

    void aLibraryOfTheStepBeforeGetsThem()
    {
        const LibraryFolder folder;
        {
            const std::vector<Migration> before = migrationsUpTo(16);
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(migrate(*database, before));
        }
        RawDatabase(folder.file())
            .run(u"INSERT INTO calibrations (id, station, created_utc, gripper_serial, gripper_name, "
                 u"channel, unit, "
                 "reference_name, reference_certificate, reference_uncertainty, "
                 "reference_relative_uncertainty, "
                 "degree, points, taken_utc, due_date, operator_name, note, serial) VALUES ('old', '%1', "
                 "'2026-01-01T00:00:00.000Z', '0001', 'Left', 'force', 'N', 'Weights', '', 0, 0, 1, "
                 "'0 0\n10 10\n20 20', '2026-01-01T00:00:00.000Z', '2027-01-01', 'Ada', '', 1)"_s.arg(
                     stationId()));
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        QVERIFY(library->addCalibration(forceAgainstWeights()));
        const auto stored = valueOf(library->calibrations(u"0001"_s, 10));
        QCOMPARE(stored.size(), std::size_t(2));
        QCOMPARE(stored[0].certificateNumber, 1);
        QCOMPARE(stored[1].certificateNumber, 0); // from before there were numbers
        QVERIFY(!stored[1].foundCorrection && stored[1].checkPoints.empty());
        QVERIFY(stored[1].conditions == CalibrationConditions());
    }

    void theNewestOfEachChannelIsInForce()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        QVERIFY(!valueOf(library->calibrationsInForce(u"0001"_s)).force);
        QVERIFY(library->addCalibration(forceAgainstWeights()));
        QVERIFY(library->addCalibration(forceAgainstWeights(1.03)));
        SensorCalibration position = forceAgainstWeights(0.99);
        position.channel = SensorChannel::Position;
        QVERIFY(library->addCalibration(position));
        SensorCalibration other = forceAgainstWeights(2);
        other.gripperSerial = u"0002"_s;
        QVERIFY(library->addCalibration(other));
        const CalibrationsInForce found = valueOf(library->calibrationsInForce(u"0001"_s));
        QVERIFY(found.force && same(*found.force, forceAgainstWeights(1.03)));
        QVERIFY(found.position && same(*found.position, position));
        QCOMPARE(valueOf(library->calibrations(u"0001"_s, 10)).size(), std::size_t(3));
        QCOMPARE(valueOf(library->calibrations({}, 10)).size(), std::size_t(4));
        QCOMPARE(valueOf(library->calibrations({}, 2)).size(), std::size_t(2));
    }

    void whatCannotBeUsedLaterIsRefused_data()
    {
        QTest::addColumn<QString>("what");
        for (const char* what : {"serial", "unit", "due", "points", "taken"})
            QTest::newRow(what) << QString::fromLatin1(what);
    }
    void whatCannotBeUsedLaterIsRefused()
    {
        QFETCH(QString, what);
        SensorCalibration calibration = forceAgainstWeights();
        if (what == u"serial")
            calibration.gripperSerial.clear();
        if (what == u"unit")
            calibration.unit.clear();
        if (what == u"due")
            calibration.due = {};
        if (what == u"points")
            calibration.points.resize(2);
        if (what == u"taken")
            calibration.takenUtc = {};
        const LibraryFolder folder;
        const auto library = folder.open();
        QVERIFY(!library->addCalibration(calibration));
        QVERIFY(valueOf(library->calibrations({}, 10)).empty());
    }

    void aPointThatIsDamagedIsToldAndNotGuessed()
    {
        const LibraryFolder folder;
        QVERIFY(folder.open()->addCalibration(forceAgainstWeights()));
        RawDatabase(folder.file()).run(u"UPDATE calibrations SET points = '0 zero'"_s);
        const auto read = folder.open()->calibrationsInForce(u"0001"_s);
        QVERIFY(!read && read.error().code == ErrorCode::StorageCorrupt);
    }
};

GRIPSCOPE_TEST(CalibrationStoreTest)
#include "calibration_store_test.moc"
