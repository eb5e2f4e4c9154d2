// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/sensor_calibration.h"
#include "core/library/ledger/library_witness.h"
#include "core/library/ledger/station_key.h"
#include "core/library/library.h"
#include "devices/self_check/self_check.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// A computer without grippers, whose clock is kept right.
struct CheckedStation {
    QTemporaryDir folder;
    PassingLibrary library{folder.filePath(u"library.db"_s)};
    SelfCheckSubject subject{library.file(), true, {{}, u"anna"_s, true}, {}, &CheckedStation::answer};

    static std::optional<QString> answer(const QString& program, const QStringList&)
    {
        return program == "timedatectl"_L1 ? std::optional(u"yes\n"_s) : std::nullopt;
    }

    [[nodiscard]] CheckLine line(const QString& id) const
    {
        for (const CheckLine& one : selfCheck(subject))
            if (one.id == id)
                return one;
        return {};
    }
    [[nodiscard]] QByteArray bytes() const
    {
        QFile file(library.file());
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
};

SensorCalibration calibrationDue(const QDate& due)
{
    SensorCalibration one;
    one.gripperSerial = u"GS-1"_s;
    one.unit = u"N"_s;
    one.reference.name = u"Weights"_s;
    one.reference.standardUncertainty = 0.001;
    for (int i = 0; i < 6; ++i)
        one.points.push_back({10.0 * i, 10.0 * i + (i % 2 ? 0.01 : -0.01)});
    one.takenUtc = QDateTime::currentDateTimeUtc();
    one.due = due;
    return one;
}

} // namespace

class SelfCheckTest : public QObject {
    Q_OBJECT
private slots:
    void allIsAskedInOrder()
    {
        const CheckedStation station;
        QStringList ids;
        for (const CheckLine& line : selfCheck(station.subject)) {
            ids << line.id;
            QVERIFY(!line.name.isEmpty() && !line.found.isEmpty());
        }
        QCOMPARE(ids, (QStringList{u"library"_s, u"integrity"_s, u"chain"_s, u"keys"_s, u"disk"_s,
                                   u"calibration"_s, u"clock"_s, u"permissions"_s, u"versions"_s}));
        QVERIFY(!QFileInfo::exists(station.library.file())); // looking makes none
    }

    void aLibraryIsReadAndLeftAsItIs()
    {
        const CheckedStation station;
        QVERIFY((*Library::open(station.library.file()))->addCalibration(calibrationDue(QDate(2100, 1, 1))));
        const QByteArray before = station.bytes();
        QVERIFY(station.line(u"integrity"_s).found.contains(u"rows are as they were written"_s));
        QVERIFY(station.line(u"integrity"_s).outcome == CheckOutcome::Ok);
        QVERIFY(station.line(u"chain"_s).outcome == CheckOutcome::Ok);
        QVERIFY(QFileInfo::exists(StationKey::file()));
        QVERIFY(station.line(u"keys"_s).outcome == CheckOutcome::Ok);
        const CheckLine calibration = station.line(u"calibration"_s);
        QVERIFY(calibration.outcome == CheckOutcome::Look); // the other channel
        QCOMPARE(calibration.found, u"GS-1 has none of its position"_s);
        QCOMPARE(station.bytes(), before);
    }

    void whatDoesNotHaveToBeReadIsNot()
    {
        CheckedStation station;
        QVERIFY(Library::open(station.library.file()));
        station.subject.verified = false;
        QCOMPARE(station.line(u"integrity"_s).found, u"not looked at"_s);
        QVERIFY(station.line(u"library"_s).found.contains(u"version"_s));
    }

    void aFileThatIsNoLibraryIsBroken()
    {
        const CheckedStation station;
        QFile file(station.library.file());
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(QByteArray(5000, 'x'));
        file.close();
        QVERIFY(station.line(u"library"_s).outcome == CheckOutcome::Broken);
    }

    void aGripperThatIsPluggedInAndWasNeverCalibratedIsTold()
    {
        CheckedStation station;
        station.subject.nodes = {
            {station.folder.filePath(u"hidraw9"_s), 0x1209, 1, u"GS-9"_s, u"Bench gripper"_s, true, false}};
        QVERIFY(station.line(u"calibration"_s).found.contains(u"GS-9 has none of its force"_s));
        const CheckLine permission = station.line(u"permissions"_s);
        QVERIFY(permission.outcome == CheckOutcome::Broken);
        QVERIFY2(permission.advice.contains(u"ATTRS{idVendor}==\"1209\""_s), qPrintable(permission.advice));
    }

    void theClockIsAskedOfWhoKeepsIt()
    {
        CheckedStation station;
        QVERIFY(station.line(u"clock"_s).outcome == CheckOutcome::Ok);
        station.subject.ask = [](const QString&, const QStringList&) { return std::nullopt; };
        QVERIFY(station.line(u"clock"_s).found.contains(u"not known"_s));
        station.subject.ask = [](const QString& program, const QStringList&) {
            return program == "timedatectl"_L1 ? std::optional(u"no"_s)
                                               : std::optional(u"Leap status     : Normal"_s);
        };
        QVERIFY(station.line(u"clock"_s).found.contains(u"chronyc"_s));
    }

    void aProgramThatIsNotThereAnswersNothing()
    {
        QVERIFY(!SelfCheckSubject::askProgram(u"no-such-program-here"_s, {}));
        QVERIFY(!SelfCheckSubject::askProgram(u"false"_s, {}));
        QCOMPARE(SelfCheckSubject::askProgram(u"echo"_s, {u"yes"_s}), std::optional(u"yes\n"_s));
    }

    void versionsAreThoseThatRun()
    {
        const CheckLine line = CheckedStation().line(u"versions"_s);
        QVERIFY2(line.found.contains(u"Qt %1, SQLite 3."_s.arg(QString::fromLatin1(qVersion()))),
                 qPrintable(line.found));
        QVERIFY(!line.found.contains(u", ,"_s));
    }
};

GRIPSCOPE_TEST(SelfCheckTest)
#include "self_check_test.moc"
