// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

/// What the library knows of a gripper is in force before anything is squeezed.
class KnownGripperTest : public QObject {
    Q_OBJECT
private slots:
    void nothingIsSqueezedUntilTheLibraryCouldBeAsked()
    {
        WindowFixture f(true, QString());
        InspectSession& inspection = f.bench->inspection();
        RawDatabase raw(f.bench->library().file());
        raw.run(u"ALTER TABLE calibrations RENAME TO calibrations_away"_s);
        f.connectTo(unhurriedA);
        const auto told = [&f] {
            return f.window->message().contains(u"What the library knows of this gripper"_s);
        };
        QTRY_VERIFY_WITH_TIMEOUT(told(), longEnough_ms);
        f.bench->arm();
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), longEnough_ms);
        const Expected<void> refused = inspection.squeeze();
        QVERIFY(!refused && refused.error().describe().contains(u"could not be read"_s));
        QCOMPARE(inspection.counts().total, qint64(0));
        // It is asked again by itself.
        raw.run(u"ALTER TABLE calibrations_away RENAME TO calibrations"_s);
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().calibrationsTold(), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(!told(), longEnough_ms);
        QTRY_VERIFY_WITH_TIMEOUT(inspection.state() == InspectSession::State::Ready, longEnough_ms);
        QVERIFY(inspection.squeeze());
        QTRY_COMPARE_WITH_TIMEOUT(inspection.counts().total, qint64(1), longEnough_ms);
    }
    void whatIsArmedCanSqueeze()
    {
        WindowFixture f(true, QString());
        f.connectTo(unhurriedA);
        f.bench->arm(); // at once: it waits for the library
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->connection().armed(), longEnough_ms);
        QVERIFY(f.bench->connection().calibrationsTold());
        QVERIFY(f.bench->inspection().squeeze());
        QTRY_COMPARE_WITH_TIMEOUT(f.bench->inspection().counts().total, qint64(1), longEnough_ms);
    }
};

GRIPSCOPE_TEST(KnownGripperTest)
#include "known_gripper_test.moc"
