// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/sql_dialect.h"
#include "devices/self_check/self_check.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const QDate someDay(2026, 5, 20);
const QDateTime someTime(someDay, QTime(12, 0), Qt::UTC);

/// The outcome, and whether there is advice where there has to be.
void expect(const CheckLine& line, CheckOutcome outcome, const QString& found, const QString& advice = {})
{
    QVERIFY2(line.outcome == outcome, qPrintable(toString(line.outcome) + u' ' + line.found));
    QVERIFY2(line.found.contains(found), qPrintable(line.found));
    QCOMPARE(line.advice.isEmpty(), outcome == CheckOutcome::Ok);
    QVERIFY2(line.advice.contains(advice), qPrintable(line.advice));
}

LibraryFacts goodLibrary()
{
    LibraryFacts facts{u"/x/library.db"_s, true, {}, 25, 25, {}, LibraryVerification{}};
    facts.verified->rows = 700;
    facts.verified->chains = {{u"bench-1 0011"_s, 42, true, true}};
    facts.verified->witness = WitnessState::Matched;
    return facts;
}

GripperNode nodeWith(bool read, bool write)
{
    GripperNode one;
    one.node = {u"/dev/hidraw3"_s, 0x1209, 1, u"GS-1"_s, u"Bench gripper"_s, true, read && write};
    one.permission = {read, write, u"root"_s, u"root"_s, u"rw-------"_s, true};
    one.command = u"sudo something"_s;
    return one;
}

} // namespace

class CheckLinesTest : public QObject {
    Q_OBJECT
private slots:
    void aLibraryInOrder()
    {
        const LibraryFacts facts = goodLibrary();
        expect(libraryLine(facts), CheckOutcome::Ok, u"/x/library.db, version 25"_s);
        expect(integrityLine(facts), CheckOutcome::Ok, u"700 rows are as they were written"_s);
        expect(chainLine(facts), CheckOutcome::Ok, u"bench-1 0011: 42 links"_s);
    }

    void aLibraryThatIsNotThereYetIsNoFault()
    {
        LibraryFacts facts{u"/x/library.db"_s, false, {}, 0, 25, {}, {}};
        expect(libraryLine(facts), CheckOutcome::Ok, u"not there yet"_s);
        expect(integrityLine(facts), CheckOutcome::Ok, u"none yet"_s);
        expect(chainLine(facts), CheckOutcome::Ok, u"none yet"_s);
    }

    void aDriverThatIsMissingIsNamed()
    {
        LibraryFacts facts = goodLibrary();
        for (const SqlDialect* dialect : {&SqlDialect::sqlite(), &SqlDialect::postgresql()}) {
            facts.missingPackage = dialect->driverPackage();
            expect(libraryLine(facts), CheckOutcome::Broken, u"driver"_s,
                   u"apt install "_s + dialect->driverPackage());
        }
        QVERIFY(SqlDialect::sqlite().driverPackage() != SqlDialect::postgresql().driverPackage());
    }

    void aLibraryThatCannotBeRead()
    {
        LibraryFacts facts = goodLibrary();
        facts.verified.reset();
        facts.error = Error{ErrorCode::StorageCorrupt, {u"/x/library.db"_s, u"it is cut short"_s}};
        expect(libraryLine(facts), CheckOutcome::Broken, u"it is cut short"_s, u"backup"_s);
    }

    void aLibraryOfAnotherVersion()
    {
        LibraryFacts facts = goodLibrary();
        facts.verified.reset();
        facts.version = 24;
        expect(libraryLine(facts), CheckOutcome::Look, u"version 24"_s, u"version 25"_s);
        expect(integrityLine(facts), CheckOutcome::Ok, u"not looked at"_s);
        facts.version = 26;
        expect(libraryLine(facts), CheckOutcome::Broken, u"version 26"_s, u"newer"_s);
    }

    void whatWasChangedIsTold()
    {
        LibraryFacts facts = goodLibrary();
        facts.verified->differs(u"people"_s, u"0190"_s, u"was changed"_s);
        facts.verified->differs(u"people"_s, u"0191"_s, u"was changed"_s);
        expect(integrityLine(facts), CheckOutcome::Broken, u"2 differences; the first: people 0190"_s,
               u"library verify --library /x/library.db"_s);
    }

    void anUnknownOrUnsignedChainIsLookedAt()
    {
        LibraryFacts facts = goodLibrary();
        facts.verified->chains.front().hasSignatures = false;
        expect(chainLine(facts), CheckOutcome::Look, u"not all signed"_s, u"key"_s);
        facts.verified->witness = WitnessState::Absent;
        expect(chainLine(facts), CheckOutcome::Look, u"does not know"_s, u"who changed it"_s);
        facts.verified->chains.clear();
        expect(chainLine(facts), CheckOutcome::Ok, u"nothing has been written"_s);
    }

    void theKeyIsThisUsersAlone()
    {
        const QFileDevice::Permissions own = QFileDevice::ReadOwner | QFileDevice::WriteOwner;
        expect(keyLine({u"/k"_s, false, false, {}}), CheckOutcome::Ok, u"not there yet"_s);
        expect(keyLine({u"/k"_s, true, true, own}), CheckOutcome::Ok, u"alone"_s);
        expect(keyLine({u"/k"_s, true, true, own | QFileDevice::ReadGroup}), CheckOutcome::Broken,
               u"others"_s, u"chmod 600 '/k'"_s);
        expect(keyLine({u"/k"_s, true, false, own}), CheckOutcome::Broken, u"may not be read"_s, u"chown"_s);
    }

    void theDisk()
    {
        expect(diskLine({u"/x"_s, 50'000'000'000, true}), CheckOutcome::Ok, u"50.0 GB free in /x"_s);
        expect(diskLine({u"/x"_s, 1'500'000'000, true}), CheckOutcome::Look, u"1.5 GB"_s, u"Make room"_s);
        expect(diskLine({u"/x"_s, 100'000'000, true}), CheckOutcome::Broken, u"0.1 GB"_s, u"Make room"_s);
        expect(diskLine({u"/x"_s, 50'000'000'000, false}), CheckOutcome::Broken, u"nothing may be written"_s,
               u"chown"_s);
        expect(diskLine({u"/x"_s, -1, true}), CheckOutcome::Look, u"not known"_s);
    }

    void calibrations()
    {
        expect(calibrationLine({}, someDay), CheckOutcome::Ok, u"none was calibrated"_s);
        std::vector<CalibratedChannel> channels{{u"GS-1"_s, u"force"_s, someDay.addDays(100)},
                                                {u"GS-1"_s, u"position"_s, someDay.addDays(100)}};
        expect(calibrationLine(channels, someDay), CheckOutcome::Ok,
               u"GS-1, force: holds until 2026-08-28"_s);
        channels[1].due = someDay.addDays(3);
        expect(calibrationLine(channels, someDay), CheckOutcome::Look, u"position: is due on 2026-05-23"_s);
        channels[1].due = someDay.addDays(-1);
        expect(calibrationLine(channels, someDay), CheckOutcome::Look, u"position: was due on 2026-05-19"_s,
               u"Calibrate"_s);
        channels[0].due.reset();
        const CheckLine both = calibrationLine(channels, someDay);
        expect(both, CheckOutcome::Look, u"GS-1 has none of its force; GS-1, position: was due"_s);
    }

    void theClock()
    {
        ClockFacts facts{someTime, someTime.addDays(-1), true, u"timedatectl"_s};
        expect(clockLine(facts), CheckOutcome::Ok, u"kept right by the network (timedatectl)"_s);
        facts.synchronised = false;
        expect(clockLine(facts), CheckOutcome::Look, u"not kept right"_s, u"timedatectl set-ntp true"_s);
        facts.synchronised.reset();
        expect(clockLine(facts), CheckOutcome::Look, u"not known"_s, u"another clock"_s);
        facts.newestEntry = someTime.addSecs(30); // as far as a clock that was set right goes back
        expect(clockLine(facts), CheckOutcome::Look, u"not known"_s);
        facts.newestEntry = someTime.addSecs(90);
        expect(clockLine(facts), CheckOutcome::Broken, u"written at 2026-05-20T12:01:30Z"_s,
               u"Set the clock"_s);
        facts.utc = QDateTime(QDate(1970, 1, 1), QTime(0, 5), Qt::UTC);
        expect(clockLine(facts), CheckOutcome::Broken, u"long gone"_s, u"Set the clock"_s);
    }

    void whoKeepsTheClockIsUnderstood()
    {
        QCOMPARE(synchronisedByTimedatectl(u"yes\n"_s), std::optional(true));
        QCOMPARE(synchronisedByTimedatectl(u"no\n"_s), std::optional(false));
        QVERIFY(!synchronisedByTimedatectl({}));
        const QString tracking =
            u"Reference ID    : C0A80001 (ntp)\nStratum         : 3\nLeap status     : %1\n"_s;
        QCOMPARE(synchronisedByChronyc(tracking.arg(u"Normal"_s)), std::optional(true));
        QCOMPARE(synchronisedByChronyc(tracking.arg(u"Not synchronised"_s)), std::optional(false));
        QVERIFY(!synchronisedByChronyc(u"506 Cannot talk to daemon\n"_s));
    }

    void permissions()
    {
        expect(permissionLine({nodeWith(true, true)}, true, false), CheckOutcome::Ok,
               u"/dev/hidraw3 may be opened"_s);
        expect(permissionLine({nodeWith(true, true), nodeWith(true, false)}, true, false),
               CheckOutcome::Broken,
               u"/dev/hidraw3 (Bench gripper): what is missing is writing (it belongs to root"_s,
               u"sudo something"_s);
        expect(permissionLine({}, true, false), CheckOutcome::Ok,
               u"no gripper is plugged in; one may be opened"_s);
        expect(permissionLine({}, false, true), CheckOutcome::Ok, u"one may be opened"_s);
        expect(permissionLine({}, false, false), CheckOutcome::Look, u"no rule"_s,
               u"ATTRS{idVendor}==\"1209\""_s);
    }

    void versions()
    {
        VersionFacts facts{u"1"_s,      u"6.4.2"_s,  u"6.4.2"_s,   u"3.40.1"_s,
                           u"0.13.1"_s, u"1.0.18"_s, u"linux 6"_s, u"Debian"_s};
        expect(versionLine(facts), CheckOutcome::Ok,
               u"Qt 6.4.2, SQLite 3.40.1, hidapi 0.13.1, libsodium 1.0.18"_s);
        facts.qt = u"6.5.0"_s;
        expect(versionLine(facts), CheckOutcome::Look, u"Qt 6.5.0"_s, u"built with Qt 6.4.2"_s);
    }
};

GRIPSCOPE_TEST(CheckLinesTest)
#include "check_lines_test.moc"
