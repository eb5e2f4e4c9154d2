// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class DesignCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;
    const QStringList m_twoCans{
        u"design"_s,  u"--object"_s, u"A=0.0396,43,9990"_s, u"--object"_s, u"B=0.0291,39.6,10500"_s,
        u"--limit"_s, u"28"_s,       u"--peak"_s,           u"10"_s};

private slots:
    void theBestForceStaysBelowTheCrushLimit()
    {
        const ProgramRun run = m_work.cli(m_twoCans + QStringList{u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        QCOMPARE(document[u"peak"].toDouble(), 8.0); // 20 + 8 = 28
        const QJsonArray force = document[u"force"].toArray();
        QCOMPARE(force.size(), 2000);
        for (const QJsonValue& value : force)
            QVERIFY(value.toDouble() <= 28);
        const QJsonObject best = document[u"candidates"][0].toObject();
        QCOMPARE(best[u"nearest"].toArray(), (QJsonArray{u"A"_s, u"B"_s}));
        QVERIFY(best[u"separation"].toDouble() > 0);
        QVERIFY(best[u"standard_errors"][u"A"][u"m"].toDouble() > 0);
        // A lone step determines nothing while start and offset are free.
        for (const QJsonValue& candidate : document[u"candidates"].toArray())
            if (candidate[u"excitation"].toString() == u"step"_s)
                QVERIFY(candidate[u"d_efficiency"].toDouble() < 0.05);
    }
    void theTableNamesEveryExcitation()
    {
        const ProgramRun run = m_work.cli(m_twoCans);
        QCOMPARE(run.exit, 0);
        for (const auto name : {"optimized-binary", "prbs", "inverse-repeat", "multisine", "chirp", "step"})
            QVERIFY2(run.out.contains(name), name);
    }
};

GRIPSCOPE_TEST(DesignCommandTest)
#include "design_command_test.moc"
