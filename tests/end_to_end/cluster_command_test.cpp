// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QSet>

#include <cmath>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class ClusterCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;
    const QString m_table = QStringLiteral(GRIPSCOPE_SOURCE_DIR "/resources/paper/appendix.csv");

private slots:
    void thePapersTableIsGroupedRight_data()
    {
        QTest::addColumn<double>("inertia");
        QTest::newRow("none") << 0.0011127767646;
        QTest::newRow("zscore") << 3.14528774528;
        QTest::newRow("log") << 0.161962421918;
    }
    void thePapersTableIsGroupedRight()
    {
        QFETCH(double, inertia);
        const QString scaling = QLatin1String(QTest::currentDataTag());
        for (const QString& seed : {u"1"_s, u"2"_s}) {
            const ProgramRun run = m_work.cli({u"cluster"_s, m_table, u"--scaling"_s, scaling, u"--seed"_s,
                                               seed, u"--truth"_s, u"object"_s, u"--json"_s});
            QCOMPARE(run.exit, 0);
            const QJsonObject document = run.json();
            QVERIFY(std::abs(document[u"inertia"].toDouble() / inertia - 1) < 1e-9);
            QCOMPARE(document[u"adjusted_rand_index"].toDouble(), 1.0);
            QCOMPARE(document[u"labels"].toArray().size(), 40);
            QCOMPARE(document[u"labels"][0].toInt(-1), 0);
            QCOMPARE(document[u"confusion"][u"A"][u"0"].toInt(), 10);
            // the table's own units: a mass between that of the lightest and the heaviest squeeze
            const double mass = document[u"centroids"][0][0].toDouble();
            QVERIFY(mass > 0.036 && mass < 0.043);
        }
    }
    void everyMethodFindsThePapersGroups_data()
    {
        QTest::addColumn<QString>("own");
        QTest::newRow("kmeans") << QString();
        QTest::newRow("som") << u"map"_s;
        QTest::newRow("gmm") << u"mixture"_s;
    }
    void everyMethodFindsThePapersGroups()
    {
        QFETCH(QString, own);
        const QString method = QLatin1String(QTest::currentDataTag());
        const QStringList arguments{u"cluster"_s, m_table, u"--method"_s, method, u"--truth"_s, u"object"_s};
        const ProgramRun run = m_work.cli(arguments + QStringList{u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        QCOMPARE(document[u"method"].toString(), method);
        QCOMPARE(document[u"adjusted_rand_index"].toDouble(), 1.0);
        QCOMPARE(document[u"confusion"][u"D"][u"3"].toInt(), 10);
        QCOMPARE(document[u"labels"].toArray().size(), 40);
        QCOMPARE(document[u"centroids"].toArray().size(), 4);
        for (const QString& member : {u"map"_s, u"mixture"_s})
            QCOMPARE(document.contains(member), member == own);
        QVERIFY(m_work.cli(arguments).out.contains("adjusted Rand index against the truth: 1"));
    }
    void autoGivesTheNumberAndTheReason()
    {
        const QStringList arguments{u"cluster"_s, m_table, u"--clusters"_s, u"auto"_s};
        const QJsonObject document = m_work.cli(arguments + QStringList{u"--json"_s}).json();
        QCOMPARE(document[u"advice"][u"clusters"].toInt(), 4);
        QCOMPARE(document[u"advice"][u"votes"][u"silhouette"].toInt(), 4);
        QCOMPARE(document[u"advice"][u"figures"].toArray().size(), 8);
        QCOMPARE(document[u"centroids"].toArray().size(), 4);
        QVERIFY(m_work.cli(arguments).out.contains("4 groups: silhouette"));
        QCOMPARE(m_work.cli({u"cluster"_s, m_table, u"--clusters"_s, u"many"_s}).exit, 2);
        QCOMPARE(m_work.cli({u"cluster"_s, m_table, u"--method"_s, u"dbscan"_s}).exit, 2);
        QCOMPARE(m_work.cli({u"cluster"_s, m_table, u"--covariance"_s, u"round"_s}).exit, 2);
    }
    void withoutTruthThereIsNothingToAgreeWith()
    {
        const QJsonObject document = m_work.cli({u"cluster"_s, m_table, u"--json"_s}).json();
        QVERIFY(document[u"adjusted_rand_index"].isNull());
        QVERIFY(document[u"confusion"].isNull());
    }
    void aBadTableNamesThePlace()
    {
        m_work.write(u"bad.csv"_s, "m,b,k\n1,2,3\n1,two,3\n");
        const ProgramRun run = m_work.cli({u"cluster"_s, u"bad.csv"_s, u"--json"_s});
        QCOMPARE(run.exit, 3);
        QVERIFY(run.err.contains("bad.csv:3:2"));
        QCOMPARE(run.json()[u"error"][u"code"].toString(), u"bad_input"_s);
        QCOMPARE(m_work.cli({u"cluster"_s, u"missing.csv"_s}).exit, 3);
        QCOMPARE(m_work.cli({u"cluster"_s, m_table, u"--features"_s, u"m,weight"_s}).exit, 3);
        m_work.write(u"short.csv"_s, "m,b,k\n1,2,3\n");
        for (const QString& method : {u"kmeans"_s, u"som"_s, u"gmm"_s})
            QCOMPARE(m_work.cli({u"cluster"_s, u"short.csv"_s, u"--method"_s, method}).exit, 3);
        // A logarithm of what is not above 0, and more groups than a map has units.
        m_work.write(u"zero.csv"_s, "m,b,k\n1,2,3\n0,2,3\n");
        QCOMPARE(
            m_work.cli({u"cluster"_s, u"zero.csv"_s, u"--clusters"_s, u"2"_s, u"--scaling"_s, u"log"_s}).exit,
            3);
        QCOMPARE(
            m_work.cli({u"cluster"_s, u"zero.csv"_s, u"--clusters"_s, u"auto"_s, u"--scaling"_s, u"log"_s})
                .exit,
            3);
    }
    void thePaperIsReproduced()
    {
        const ProgramRun run = m_work.cli({u"reproduce-paper"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        for (const QString& scaling : {u"none"_s, u"zscore"_s, u"log"_s}) {
            const QJsonObject found = document[u"scalings"][scaling].toObject();
            QCOMPARE(found[u"adjusted_rand_index"].toDouble(), 1.0);
            const QJsonArray table = found[u"table1"].toArray();
            QCOMPARE(table.size(), 10);
            QSet<int> columns;
            for (const QJsonValue& cluster : table[0].toArray())
                columns << cluster.toInt();
            QCOMPARE(columns, (QSet<int>{1, 2, 3, 4}));
            for (const QJsonValue& row : table)
                QCOMPARE(row, table[0]);
        }
        QCOMPARE(document[u"best_fit"][u"min"].toDouble(), 83.99);
        QCOMPARE(document[u"best_fit"][u"max"].toDouble(), 92.08);
        QCOMPARE(document[u"leave_one_out_correct"].toInt(), 40);
        QVERIFY(m_work.cli({u"reproduce-paper"_s}).out.contains("Table 1"));
    }
};

GRIPSCOPE_TEST(ClusterCommandTest)
#include "cluster_command_test.moc"
