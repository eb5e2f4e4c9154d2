// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class DeviceCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

private slots:
    void saysWhatTheGripperIs()
    {
        const ProgramRun run = m_work.cli(
            {u"device"_s, u"--device"_s, u"virtual:?object=B&seed=7"_s, u"--reports"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject identity = run.json()[u"identity"].toObject();
        QCOMPARE(identity[u"serial"].toString(), u"VG-7"_s);
        QCOMPARE(identity[u"max_force_N"].toDouble(), 100.0);
        QCOMPARE(run.json()[u"descriptor"][0][u"words"].toString(), u"Usage page 0xff00 (vendor-defined)"_s);
        const QJsonArray reports = run.json()[u"reports"].toArray();
        QCOMPARE(reports[0][u"kind"].toString(), u"Identity"_s);
        QCOMPARE(reports[0][u"fields"][u"serial number"].toString(), u"VG-7"_s);
    }
    void testsItselfAndExitsWith4WhenSomethingIsWrong()
    {
        const ProgramRun run = m_work.cli(
            {u"device"_s, u"--device"_s, u"virtual:?fault=loss:0.05"_s, u"--self-test"_s, u"--json"_s});
        QCOMPARE(run.exit, 4);
        const QJsonObject test = run.json()[u"self_test"].toObject();
        QCOMPARE(test[u"passed"].toBool(true), false);
        QStringList failed;
        for (const QJsonValue& line : test[u"lines"].toArray())
            if (line[u"outcome"].toString() == u"failed"_s)
                failed << line[u"id"].toString();
        QVERIFY2(failed.contains(u"sequence"_s), qPrintable(failed.join(u' ')));
        QVERIFY(!failed.contains(u"stop"_s) && !failed.contains(u"features"_s));
    }
};

GRIPSCOPE_TEST(DeviceCommandTest)
#include "device_command_test.moc"
