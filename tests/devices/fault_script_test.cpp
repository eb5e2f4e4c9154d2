// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/report.h"
#include "devices/virtual/virtual_faults.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QFile>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class FaultScriptTest : public QObject {
    Q_OBJECT
private slots:
    void everyLineIsAnEvent()
    {
        const auto events = parseFaultScript("# first nothing\n"
                                             "0.5 loss 0.1   # then a tenth\r\n"
                                             "\n"
                                             "0.5\tclock -0.25\n"
                                             "1 saturate 25\n"
                                             "2 saturate off\n"
                                             "2 hang-write\n"
                                             "3 deaf heartbeat",
                                             u"x"_qs);
        QVERIFY(events.has_value());
        const std::vector<FaultEvent> expected{
            {0.5, Fault::Loss, 0.1},
            {0.5, Fault::Clock, -0.25},
            {1, Fault::Saturate, 25},
            {2, Fault::Saturate, std::nullopt},
            {2, Fault::HangWrite, usualHang_s},
            {3, Fault::Deaf, 0x23},
        };
        QVERIFY(*events == expected);
    }

    void whatIsWrongIsNamedWithItsPlace_data()
    {
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("found");
        QTest::addColumn<QString>("expected"); // part of it
        const auto row = [](const char* script, const char* place, const char* found, const char* expected) {
            QTest::newRow(script) << QByteArray(script) << QString::fromLatin1(place)
                                  << QString::fromLatin1(found) << QString::fromLatin1(expected);
        };
        row("soon loss 1", "f.txt:1:1", "found \"soon\"", "a time in seconds");
        row("1 stall\n-2 resume", "f.txt:2:1", "found \"-2\"", "a time in seconds");
        row("2 stall\n1.5 resume", "f.txt:2:1", "found \"1.5\"", "not before that of the line above, 2 s");
        row("1", "f.txt:1:2", "the line ends", "one of loss, duplicate");
        row("1   fire", "f.txt:1:5", "found \"fire\"", "hang-feature");
        row("1 loss", "f.txt:1:7", "the line ends", "a share from 0 to 1 behind loss");
        row("1 loss 1.5", "f.txt:1:8", "found \"1.5\"", "a share from 0 to 1 behind loss");
        row("1 loss off", "f.txt:1:8", "found \"off\"", "a share from 0 to 1");
        row("1 stall off", "f.txt:1:9", "found \"off\"", "nothing behind stall");
        row("1 clock", "f.txt:1:8", "the line ends", "seconds from -1000 to 1000");
        row("1 clock nan", "f.txt:1:9", "found \"nan\"", "seconds from -1000 to 1000");
        row("1 deaf ears", "f.txt:1:8", "found \"ears\"", "arm, disarm, stop, heartbeat");
        row("1 hang-write 61", "f.txt:1:14", "found \"61\"", "seconds from 0 to 60");
        row("1 loss 0.1 now", "f.txt:1:12", "found \"now\"", "a comment begins with #");
    }
    void whatIsWrongIsNamedWithItsPlace()
    {
        QFETCH(QByteArray, script);
        QFETCH(QString, place);
        QFETCH(QString, found);
        QFETCH(QString, expected);
        const auto events = parseFaultScript(script, u"f.txt"_qs);
        QVERIFY(!events);
        QVERIFY(events.error().code == ErrorCode::BadInput);
        QCOMPARE(events.error().argument(0), place);
        QCOMPARE(events.error().argument(1), found);
        QVERIFY2(events.error().argument(2).contains(expected), qPrintable(events.error().argument(2)));
    }

    void theManualsScriptIsUnderstoodAndItsTableIsWhole()
    {
        QFile page(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/resources/manual/virtual.md"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QByteArray text = page.readAll();
        const qsizetype first = text.indexOf("    # faults.txt");
        QVERIFY(first > 0);
        const auto events =
            parseFaultScript(text.mid(first, text.indexOf("\n\n", first) - first), u"virtual.md"_qs);
        QVERIFY2(events.has_value(), qPrintable(test::whyNot(events)));
        QCOMPARE(events->size(), std::size_t(7));
        const auto unknown = parseFaultScript("0 fire", u"x"_qs);
        const QString words = unknown.error().argument(2).section(u"one of "_qs, 1);
        for (const QString& word : words.split(u", "_qs))
            QVERIFY2(text.contains('`' + word.toUtf8() + '`') || text.contains('`' + word.toUtf8() + ' '),
                     qPrintable(word));
    }

    void aFileThatIsNotThereIsTold()
    {
        const auto events = readFaultScript(u"/nowhere/faults.txt"_qs);
        QVERIFY(!events);
        QVERIFY(events.error().code == ErrorCode::FileUnreadable);
    }

    void faultsComeAndGo()
    {
        FaultTimeline faults(
            parseFaultScript("1 loss 0.1\n1 clock 0.5\n2 stuck\n2 clock -0.2\n"
                             "3 loss 0\n3 stuck off\n3 button\n4 unplug\n4 button off\n5 replug\n6 broken",
                             u"x"_qs)
                .value());
        faults.advanceTo(0.999);
        QVERIFY(faults.state() == FaultState{});
        faults.advanceTo(1);
        QCOMPARE(faults.state().loss, 0.1);
        faults.advanceTo(2.5);
        QVERIFY(faults.state().stuck);
        QCOMPARE(faults.state().clock_s, 0.3);
        faults.advanceTo(3);
        QVERIFY(faults.state().buttonDown);
        faults.advanceTo(4);
        QVERIFY(!faults.state().stuck && !faults.state().buttonDown && faults.state().unplugged);
        QCOMPARE(faults.nextReplug_s(), std::optional<double>(5));
        faults.advanceTo(10);
        QVERIFY(!faults.state().unplugged && faults.state().broken);
        QVERIFY(!faults.nextReplug_s());
    }

    void deafnessAddsUpUntilItIsOff()
    {
        const auto id = [](protocol::ReportId report) { return static_cast<std::uint8_t>(report); };
        FaultTimeline faults(
            parseFaultScript("1 deaf heartbeat\n2 deaf stop\n3 deaf off\n4 deaf", u"x"_qs).value());
        faults.advanceTo(2);
        QVERIFY(faults.state().deaf(id(protocol::ReportId::Heartbeat)));
        QVERIFY(faults.state().deaf(id(protocol::ReportId::Stop)));
        QVERIFY(!faults.state().deaf(id(protocol::ReportId::Arm)));
        faults.advanceTo(3);
        QVERIFY(!faults.state().deaf(id(protocol::ReportId::Heartbeat)));
        faults.advanceTo(4);
        QVERIFY(faults.state().deaf(id(protocol::ReportId::Arm)));
        QVERIFY(faults.state().deaf(0x7F)); // whatever it is
    }
};

GRIPSCOPE_TEST(FaultScriptTest)
#include "fault_script_test.moc"
