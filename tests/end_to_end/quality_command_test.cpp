// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class QualityCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

private slots:
    void guardBandsAreFound()
    {
        const QStringList asked{u"study"_s,
                                u"guardband"_s,
                                u"--lower"_s,
                                u"-2"_s,
                                u"--upper"_s,
                                u"2"_s,
                                u"--process-mean"_s,
                                u"0.1"_s,
                                u"--process-sigma"_s,
                                u"1"_s,
                                u"--measurement-sigma"_s,
                                u"0.2"_s};
        const ProgramRun run = m_work.cli(asked + QStringList{u"--json"_s});
        QVERIFY2(run.exit == 0, run.err.constData());
        const QJsonObject document = run.json();
        QVERIFY(std::abs(document[u"consumers_risk"].toDouble() - 0.0068920787) < 1e-8);
        QVERIFY(std::abs(document[u"producers_risk"].toDouble() - 0.0112715783) < 1e-8);
        QVERIFY(std::abs(document[u"guard_for_risk"][u"0.001"].toDouble() - 0.24435816) < 1e-7);
        const ProgramRun words = m_work.cli(asked + QStringList{u"--guard"_s, u"0.3"_s});
        QCOMPARE(words.exit, 0);
        QVERIFY(words.out.contains("consumer's risk"));
    }
    void whatIsMissingIsSaid()
    {
        const ProgramRun none = m_work.cli({u"study"_s, u"guardband"_s, u"--lower"_s, u"1"_s});
        QCOMPARE(none.exit, 2);
        QVERIFY(none.err.contains("--process-mean"));
        const ProgramRun crossed = m_work.cli({u"study"_s, u"guardband"_s, u"--lower"_s, u"2"_s, u"--upper"_s,
                                               u"1"_s, u"--process-mean"_s, u"0"_s, u"--process-sigma"_s,
                                               u"1"_s, u"--measurement-sigma"_s, u"1"_s});
        QCOMPARE(crossed.exit, 2);
        QVERIFY2(crossed.err.contains("not below"), crossed.err.constData());
    }
};

GRIPSCOPE_TEST(QualityCommandTest)
#include "quality_command_test.moc"
