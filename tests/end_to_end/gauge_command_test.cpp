// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <cmath>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// 3 prototypes x 3 operators x 3 runs, and half of each value as a second column.
QByteArray prototypeTable()
{
    const std::array<const char*, 27> values{"1.27", "0.9",  "1.09", "1.12", "1.09", "1.15", "1.73",
                                             "1.28", "1.77", "1.34", "1.32", "1.27", "1.24", "1",
                                             "1.14", "1.64", "1.65", "1.77", "1.09", "1.26", "1.09",
                                             "1.48", "1.15", "1.15", "1.64", "1.44", "1.68"};
    QByteArray text = "part,operator,value,other,u\n";
    for (int i = 0; i < 27; ++i)
        text += "\"part " + QByteArray::number(i / 3 % 3) + "\",op" + QByteArray::number(i / 9) + ',' +
                values[std::size_t(i)] + ',' + QByteArray::number((i * 7 % 11) + 5 * (i / 3 % 3)) + ",0.1\n";
    return text;
}

} // namespace

class GaugeCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;
    const QStringList m_arguments{u"study"_s, u"gauge"_s,      u"t.csv"_s,   u"--part"_s,
                                  u"part"_s,  u"--operator"_s, u"operator"_s};

    [[nodiscard]] ProgramRun study(const QStringList& more) const { return m_work.cli(m_arguments + more); }

private slots:
    void initTestCase() { m_work.write(u"t.csv"_s, prototypeTable()); }
    void thePublishedFiguresComeOut_data()
    {
        QTest::addColumn<QStringList>("more");
        QTest::addColumn<double>("contribution");
        QTest::addColumn<double>("studyVariation");
        QTest::newRow("pooled") << QStringList() << 25.379 << 50.378;
        QTest::newRow("kept") << QStringList{u"--no-pooling"_s} << 25.497 << 50.494;
        QTest::newRow("reml") << QStringList{u"--method"_s, u"reml"_s} << 25.379 << 50.378;
    }
    void thePublishedFiguresComeOut()
    {
        QFETCH(QStringList, more);
        QFETCH(double, contribution);
        QFETCH(double, studyVariation);
        const ProgramRun run =
            study(QStringList{u"--value"_s, u"value"_s, u"--tolerance"_s, u"2"_s, u"--json"_s} + more);
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        QCOMPARE(document[u"design"].toString(), u"crossed"_s);
        const QJsonObject value = document[u"values"][u"value"].toObject();
        const QJsonObject gauge = value[u"components"][u"gauge"].toObject();
        QVERIFY(std::abs(gauge[u"percent_contribution"].toDouble() - contribution) < 6e-4);
        QVERIFY(std::abs(gauge[u"percent_study_variation"].toDouble() - studyVariation) < 6e-4);
        QVERIFY(std::abs(gauge[u"percent_tolerance"].toDouble() -
                         100 * 6 * std::sqrt(gauge[u"variance"].toDouble()) / 2) < 1e-9);
        QVERIFY(!value[u"messages"].toArray().isEmpty());
    }
    void aPersonReadsTheVerdict()
    {
        const ProgramRun run = study({u"--value"_s, u"value,other"_s, u"--uncertainty"_s, u"u,u"_s});
        QCOMPARE(run.exit, 0);
        QVERIFY(run.out.contains("This gripper is not good enough"));
        QVERIFY(run.out.contains("part_operator"));
        QVERIFY(run.out.contains("Together the values tell"));
        QVERIFY(run.out.contains("own uncertainties say"));
        const QJsonObject document = study({u"--value"_s, u"value,other"_s, u"--json"_s}).json();
        QVERIFY(document[u"joint"][u"kinds"].toDouble() >= 1);
    }
    void whatMakesNoSenseIsRefused_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("exit");
        const QStringList head{u"study"_s, u"gauge"_s, u"t.csv"_s};
        const QStringList part{u"--part"_s, u"part"_s}, value{u"--value"_s, u"value"_s};
        QTest::newRow("no table") << QStringList{u"study"_s, u"gauge"_s} + part + value << 2;
        QTest::newRow("no part") << head + value << 2;
        QTest::newRow("no value") << head + part << 2;
        QTest::newRow("value twice") << head + part + QStringList{u"--value"_s, u"value,value"_s} << 2;
        QTest::newRow("method") << head + part + value + QStringList{u"--method"_s, u"guess"_s} << 2;
        QTest::newRow("design") << head + part + value + QStringList{u"--design"_s, u"square"_s} << 2;
        QTest::newRow("tolerance") << head + part + value + QStringList{u"--tolerance"_s, u"-1"_s} << 2;
        QTest::newRow("tolerances") << head + part + value + QStringList{u"--tolerance"_s, u"1,2"_s} << 2;
        QTest::newRow("uncertainties")
            << head + part + value + QStringList{u"--uncertainty"_s, u"u,u"_s} << 2;
        QTest::newRow("missing column") << head + part + QStringList{u"--value"_s, u"weight"_s} << 3;
        QTest::newRow("words") << head + part + QStringList{u"--value"_s, u"operator"_s} << 3;
        QTest::newRow("one a part") << head + QStringList{u"--part"_s, u"value"_s,      u"--value"_s,
                                                          u"other"_s,  u"--operator"_s, u"u"_s}
                                    << 0;
    }
    void whatMakesNoSenseIsRefused()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, exit);
        const ProgramRun run = m_work.cli(arguments + QStringList{u"--json"_s});
        QCOMPARE(run.exit, exit);
        if (exit == 3)
            QCOMPARE(run.json()[u"error"][u"code"].toString(), u"bad_input"_s);
        if (exit != 0)
            QVERIFY(!run.err.isEmpty());
    }
    void badTablesNameThePlace()
    {
        m_work.write(u"bad.csv"_s, "part,value\nA,1\nA,x\n");
        const ProgramRun run = m_work.cli(
            {u"study"_s, u"gauge"_s, u"bad.csv"_s, u"--part"_s, u"part"_s, u"--value"_s, u"value"_s});
        QCOMPARE(run.exit, 3);
        QVERIFY(run.err.contains("bad.csv:3:2"));
        m_work.write(u"once.csv"_s, "part,value\nA,1\nB,2\nC,3\n");
        const ProgramRun once = m_work.cli(
            {u"study"_s, u"gauge"_s, u"once.csv"_s, u"--part"_s, u"part"_s, u"--value"_s, u"value"_s});
        QCOMPARE(once.exit, 3);
        QVERIFY(once.err.contains("measured once"));
    }
};

GRIPSCOPE_TEST(GaugeCommandTest)
#include "gauge_command_test.moc"
