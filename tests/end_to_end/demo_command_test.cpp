// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class DemoCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    QJsonObject demo(const QString& seed)
    {
        const ProgramRun run = m_work.cli({u"demo"_s, u"--seed"_s, seed, u"--json"_s});
        return run.exit == 0 ? run.json() : QJsonObject();
    }

private slots:
    void knownCansAreFoundAndStrangersAreStrange()
    {
        int unknown = 0;
        for (const QString& seed : {u"1"_s, u"2"_s}) {
            const QJsonObject counts = demo(seed);
            QCOMPARE(counts[u"seed"].toInt(), seed.toInt());
            QCOMPARE(counts[u"enrolled"].toInt(), 40);
            QCOMPARE(counts[u"tested"].toInt(), 30);
            QCOMPARE(counts[u"strangers"].toInt(), 5);
            QCOMPARE(counts[u"wrong_type"].toInt(-1), 0);
            QCOMPARE(counts[u"strangers_unknown"].toInt(), 5);
            QCOMPARE(counts[u"confusion"][u"stranger"][u"unknown"].toInt(), 5);
            unknown += counts[u"unknown"].toInt();
            int cells = 0;
            for (const QString& object : {u"A"_s, u"B"_s, u"C"_s, u"D"_s})
                for (const QJsonValue& cell : counts[u"confusion"][object].toObject())
                    cells += cell.toInt();
            QCOMPARE(cells, 30);
        }
        // 1 % of 60 is the stated rate; five would happen by chance once in 3,000 pairs of seeds
        QVERIFY(unknown < 5);
    }
    void theSameSeedTellsTheSame()
    {
        QCOMPARE(demo(u"3"_s), demo(u"3"_s));
        QVERIFY(!demo(u"3"_s).isEmpty());
    }
};

GRIPSCOPE_TEST(DemoCommandTest)
#include "demo_command_test.moc"
