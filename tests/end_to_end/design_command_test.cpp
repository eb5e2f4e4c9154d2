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
    /// What the designer found is squeezed with, at its forces, and tells what it promised.
    void theBestForceIsSqueezedWith()
    {
        const QStringList one{
            u"design"_s, u"--object"_s, u"A=0.0396,43,9990"_s, u"--shortest-run"_s, u"0.005"_s, u"--limit"_s,
            u"40"_s,     u"-o"_s,       u"best.csv"_s};
        QCOMPARE(m_work.cli(one).exit, 0);
        QCOMPARE(m_work.cli(one).exit, 5); // it is no recording, and is not replaced
        QCOMPARE(m_work.cli(one + QStringList{u"--force"_s}).exit, 0);
        const QStringList record{
            u"record"_s, u"--device"_s,     u"virtual:?object=0.0396,43,9990&seed=3&speed=0"_s,
            u"--arm"_s,  u"--force-file"_s, u"best.csv"_s,
            u"-o"_s,     u"r.csv"_s,        u"--json"_s};
        const ProgramRun squeezed = m_work.cli(record);
        QVERIFY2(squeezed.exit == 0, squeezed.err.constData());
        const int samples =
            squeezed.json()[u"samples"].toInt(); // as long as the force, and the rest before it
        QVERIFY2(samples >= 2000 && samples < 2200, qPrintable(QString::number(samples)));
        QFile file(m_work.path(u"r.csv"_s));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        QVERIFY(text.contains("# excitation: levels") && text.contains("# excitation_bias_N: 20\n") &&
                text.contains("# excitation_peak_N: 10\n"));
        const ProgramRun found = m_work.cli({u"identify"_s, u"r.csv"_s, u"--json"_s});
        QCOMPARE(found.exit, 0);
        // Below the crush limit that is asked for, nothing is squeezed.
        const ProgramRun refused = m_work.cli(record + QStringList{u"--max-force"_s, u"25"_s});
        QCOMPARE(refused.exit, 4);
        // Elsewhere, softer, slower.
        const ProgramRun moved =
            m_work.cli(record + QStringList{u"--bias"_s, u"12"_s, u"--peak"_s, u"4"_s, u"--bit"_s, u"0.01"_s,
                                            u"--seconds"_s, u"2"_s});
        QVERIFY2(moved.exit == 0, moved.err.constData());
        QCOMPARE(moved.json()[u"samples"].toInt(), samples + 2000);
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
