// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <array>
#include <cmath>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class ControlChartCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;
    const QString m_cusum = QStringLiteral(GRIPSCOPE_SHARED_DATA "/quality/cusum.csv");

    [[nodiscard]] ProgramRun study(const QString& text) const
    {
        return m_work.cli(u"study "_s.append(text).split(u' ', Qt::SkipEmptyParts));
    }
    /// diameter,sample of phase 1 (TRUE) or of all, with commas.
    static QByteArray pistonRings(bool phaseOneOnly)
    {
        QFile file(QStringLiteral(GRIPSCOPE_SHARED_DATA "/quality/piston_rings.txt"));
        if (!file.open(QIODevice::ReadOnly))
            return {};
        QByteArray table = "diameter,sample\n";
        for (const QByteArray& line : file.readAll().split('\n').mid(1)) {
            const QList<QByteArray> cells = line.simplified().split(' ');
            if (cells.size() == 3 && (!phaseOneOnly || cells[2] == "TRUE"))
                table += cells[0] + ',' + cells[1] + '\n';
        }
        return table;
    }

private slots:
    void initTestCase()
    {
        m_work.write(u"few.csv"_s, "x,y,g\n1,2,a\n2,1,a\n4,3,b\n3,5,b\n5,4,c\n2,2,c\n3,1,d\n4,6,d\n");
        m_work.write(u"same.csv"_s, "x\n5\n5\n5\n5\n");
        m_work.write(u"gap.csv"_s, "x\n5\n\"\"\n6\n");
    }
    void pistonRingsAsPublished()
    {
        if (pistonRings(true).isEmpty())
            QSKIP("the piston rings are not in ../shared/data/quality");
        m_work.write(u"rings.csv"_s, pistonRings(true));
        m_work.write(u"all.csv"_s, pistonRings(false));
        const QJsonObject chart =
            study(u"chart rings.csv --value diameter --kind xbar-r --subgroup sample --json"_s).json();
        QVERIFY(std::abs(chart[u"centre"].toDouble() - 74.001176) < 5e-7);
        QVERIFY(std::abs(chart[u"sigma"].toDouble() - 0.009785338) < 5e-10);
        QCOMPARE(chart[u"points"].toArray().size(), 25);
        QVERIFY(chart[u"signals"].toArray().isEmpty());
        QVERIFY(std::abs(chart[u"arl"][u"in_control"].toDouble() - 370.398) < 1e-3);
        const QJsonObject later =
            study(u"chart all.csv --value diameter --kind xbar-r --subgroup 5 --phase-one 25 --json"_s)
                .json();
        QCOMPARE(later[u"signals"][0][u"point"].toInt(), 37);
        QCOMPARE(later[u"points"][36][u"rules"].toArray(), QJsonArray{1});
        const QJsonObject capable =
            study(u"capability rings.csv --value diameter --lower 73.95 --upper 74.05 "
                  "--subgroup sample --json"_s)
                .json();
        QVERIFY(std::abs(capable[u"within"][u"cp"].toDouble() / 1.70328 - 1) < 4e-5);
        QVERIFY(std::abs(capable[u"within"][u"cpk"].toDouble() / 1.66322 - 1) < 4e-5);
        QVERIFY(std::abs(capable[u"within"][u"cp_interval"][0].toDouble() / 1.49141 - 1) < 4e-5);
        QVERIFY(std::abs(capable[u"within"][u"cp_interval"][1].toDouble() / 1.91483 - 1) < 4e-5);
        QVERIFY(capable[u"normality"][u"p"].toDouble() > 0.5);
    }
    void cusumAsPublished()
    {
        if (!QFile::exists(m_cusum))
            QSKIP("the CUSUM's table is not in ../shared/data/quality");
        const QStringList arguments{u"study"_s, u"chart"_s,    m_cusum, u"--value"_s, u"value"_s, u"--kind"_s,
                                    u"cusum"_s, u"--target"_s, u"99"_s, u"--sigma"_s, u"2"_s};
        const QJsonObject chart = m_work.cli(arguments + QStringList{u"--json"_s}).json();
        QCOMPARE(chart[u"points"][0][u"upper_sum"].toDouble(), 2.0);
        QVERIFY(std::abs(chart[u"points"][5][u"upper_sum"].toDouble() - 0.5) < 1e-9);
        QVERIFY(std::abs(chart[u"arl"][u"in_control"].toDouble() - 465.4435) < 1e-3);
        const ProgramRun text = m_work.cli(arguments);
        QCOMPARE(text.exit, 0);
        QVERIFY(text.out.contains("Steady: no signal in 20 points."));
    }
    /// K 1 and H 10, of sigma 1, are those of the published sums; H 3 is not passed but by the lower ones.
    void decisionIntervalsAreTaken()
    {
        m_work.write(u"sums.csv"_s, "value\n102.0\n94.8\n98.3\n98.4\n102.0\n98.5\n99.0\n97.7\n100.0\n98.1\n"
                                    "101.3\n98.7\n101.1\n98.4\n97.0\n96.7\n100.3\n101.4\n97.2\n101.0\n");
        const QString sums =
            u"chart sums.csv --value value --kind cusum --target 99 --sigma 1 --k 1 --json"_s;
        const QJsonObject chart = study(sums + u" --h 10"_s).json();
        double largest = 0;
        const std::array<double, 6> upper{2, 0, 0, 0, 2, 0.5};
        for (int i = 0; i < 20; ++i) {
            const QJsonValue point = chart[u"points"][i];
            largest = std::max(largest, point[u"lower_sum"].toDouble());
            if (i < 6)
                QVERIFY(std::abs(point[u"upper_sum"].toDouble() - upper[std::size_t(i)]) < 1e-9);
        }
        QVERIFY(std::abs(largest - 3.2) < 1e-9);
        QVERIFY(chart[u"signals"].toArray().isEmpty());
        QCOMPARE(study(sums + u" --h 3"_s).json()[u"signals"].toArray().size(), 1);
        QVERIFY(study(u"chart --help"_s).out.contains("--help"));
    }
    void everyKindHasWords_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::newRow("i-mr") << u"chart few.csv --value x --rules nelson"_s;
        QTest::newRow("xbar-s") << u"chart few.csv --value x --kind xbar-s --subgroup g"_s;
        QTest::newRow("ewma") << u"chart few.csv --value x --kind ewma --lambda 0.1"_s;
        QTest::newRow("hotelling") << u"chart few.csv --value x,y --kind hotelling"_s;
        QTest::newRow("capability") << u"capability few.csv --value x --lower 0 --upper 9"_s;
        QTest::newRow("box-cox") << u"capability few.csv --value y --upper 9 --distribution box-cox"_s;
        QTest::newRow("percentiles")
            << u"capability few.csv --value y --upper 9 --distribution percentiles"_s;
    }
    void everyKindHasWords()
    {
        QFETCH(QString, arguments);
        const ProgramRun text = study(arguments);
        QVERIFY2(text.exit == 0, text.err.constData());
        QVERIFY(text.out.contains("teady") || text.out.contains("apable"));
        QVERIFY(!text.out.contains("nan") && !text.out.contains("inf "));
        QVERIFY(!study(arguments + u" --json"_s).json().isEmpty());
    }
    void whatMakesNoSenseIsRefused_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<int>("exit");
        QTest::newRow("no table") << u"chart --value x"_s << 2;
        QTest::newRow("no such table") << u"chart none.csv --value x"_s << 3;
        QTest::newRow("no value") << u"chart few.csv"_s << 2;
        QTest::newRow("no such column") << u"chart few.csv --value z"_s << 3;
        QTest::newRow("words") << u"chart few.csv --value g"_s << 3;
        QTest::newRow("a gap") << u"chart gap.csv --value x"_s << 3;
        QTest::newRow("constant") << u"chart same.csv --value x"_s << 3;
        QTest::newRow("kind") << u"chart few.csv --value x --kind pie"_s << 2;
        QTest::newRow("rules") << u"chart few.csv --value x --rules house"_s << 2;
        QTest::newRow("no subgroups") << u"chart few.csv --value x --kind xbar-r"_s << 2;
        QTest::newRow("subgroup") << u"chart few.csv --value x --kind xbar-r --subgroup 0"_s << 2;
        QTest::newRow("subgroups of one") << u"chart few.csv --value x --kind xbar-r --subgroup 1"_s << 3;
        QTest::newRow("one subgroup") << u"chart few.csv --value x --kind xbar-r --subgroup 8"_s << 3;
        QTest::newRow("lambda") << u"chart few.csv --value x --kind ewma --lambda 2"_s << 2;
        QTest::newRow("two columns") << u"chart few.csv --value x,y"_s << 2;
        QTest::newRow("the same twice") << u"chart few.csv --value x,x --kind hotelling"_s << 3;
        QTest::newRow("no limits") << u"capability few.csv --value x"_s << 2;
        QTest::newRow("limits crossed") << u"capability few.csv --value x --lower 3 --upper 2"_s << 2;
        QTest::newRow("constant part") << u"capability same.csv --value x --upper 9"_s << 3;
    }
    void whatMakesNoSenseIsRefused()
    {
        QFETCH(QString, arguments);
        QFETCH(int, exit);
        const ProgramRun run = study(arguments + u" --json"_s);
        QCOMPARE(run.exit, exit);
        QVERIFY(run.err.size() > 20);
    }
};

GRIPSCOPE_TEST(ControlChartCommandTest)
#include "control_chart_command_test.moc"
