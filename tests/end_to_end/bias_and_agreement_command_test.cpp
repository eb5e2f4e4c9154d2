// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <cmath>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

class BiasAndAgreementCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;

    [[nodiscard]] ProgramRun study(const QStringList& arguments) const
    {
        return m_work.cli(QStringList{u"study"_s} + arguments);
    }

private slots:
    void initTestCase()
    {
        m_work.write(u"one.csv"_s, "k\n10\n10.01\n9.99\n10.02\n9.98\n10\n");
        m_work.write(u"line.csv"_s, "early,k\n1,1.2\n1,1.1\n2,2.1\n2,2.2\n3,3.0\n3,3.1\n");
        m_work.write(u"verdicts.csv"_s, "part,who,verdict,truth\n1,A,OK,OK\n1,B,OK,OK\n2,A,NotOK,NotOK\n"
                                        "2,B,OK,NotOK\n3,A,NotDecidable,OK\n3,B,OK,OK\n");
        m_work.write(u"wide.csv"_s, "r1,r2\n%1,%1\nb,%1\nb,\nb,b\n");
    }
    void typeOne()
    {
        const QStringList arguments{u"type1"_s,       u"one.csv"_s, u"--value"_s,     u"k"_s,
                                    u"--reference"_s, u"10"_s,      u"--tolerance"_s, u"1"_s};
        const ProgramRun run = study(arguments + QStringList{u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        const double s = document[u"repeatability"].toDouble();
        QVERIFY(std::abs(s - std::sqrt(0.0002)) < 1e-12);
        QVERIFY(std::abs(document[u"cg"].toDouble() - 0.2 / (6 * s)) < 1e-9);
        QVERIFY(document[u"p"].toDouble() > 0.99 && document[u"bias_interval"].toArray().size() == 2);
        QVERIFY(study(arguments).out.contains("Capable"));
        const QJsonObject other =
            study(arguments + QStringList{u"--share"_s, u"10"_s, u"--sigmas"_s, u"4"_s, u"--json"_s}).json();
        QVERIFY(std::abs(other[u"cg"].toDouble() - 0.1 / (4 * s)) < 1e-9);
    }
    void linearity()
    {
        // A column may be called as another study is.
        const QStringList arguments{u"linearity"_s, u"line.csv"_s, u"--reference"_s,
                                    u"early"_s,     u"--value"_s,  u"k"_s};
        const ProgramRun run = study(arguments + QStringList{u"--process-variation"_s, u"3"_s, u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        QVERIFY(std::abs(document[u"slope"].toDouble() + 0.05) < 1e-12);
        QVERIFY(std::abs(document[u"percent_linearity"].toDouble() - 5) < 1e-9);
        QVERIFY(std::abs(document[u"linearity"].toDouble() - 0.15) < 1e-12);
        QCOMPARE(document[u"bias"].toArray().size(), 3);
        QVERIFY(document[u"bias"][0][u"p"].isDouble());
        QVERIFY(study(arguments).out.contains("intercept"));
    }
    void attributes()
    {
        const QStringList arguments{u"attributes"_s,  u"verdicts.csv"_s, u"--part"_s,    u"part"_s,
                                    u"--rater"_s,     u"who"_s,          u"--verdict"_s, u"verdict"_s,
                                    u"--reference"_s, u"truth"_s};
        const ProgramRun run = study(arguments + QStringList{u"--json"_s});
        QCOMPARE(run.exit, 0);
        const QJsonObject document = run.json();
        QVERIFY(std::abs(document[u"raters"][u"A"][u"effectiveness"].toDouble() - 2.0 / 3) < 1e-12);
        QCOMPARE(document[u"raters"][u"B"][u"miss_rate"].toDouble(), 1.0);
        QCOMPARE(document[u"raters"][u"A"][u"false_alarm_rate"].toDouble(), 0.0);
        QVERIFY(document[u"kappa"][u"pairs"][0][u"value"].isDouble());
        QVERIFY(document[u"kappa"][u"fleiss"][u"z"].isDouble());
        QVERIFY(study(arguments).out.contains("Fleiss' kappa"));
        const QStringList wide{u"attributes"_s, u"wide.csv"_s, u"--rater-columns"_s, u"r1,r2"_s};
        const QJsonObject gaps = study(wide + QStringList{u"--json"_s}).json();
        QCOMPARE(gaps[u"incomplete_parts"].toInt(), 1);
        QVERIFY(gaps[u"kappa"][u"reference"].isNull());
        QVERIFY(study(wide).out.contains("%1: kappa"));
    }
    void badInputNamesThePlace_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<int>("exit");
        QTest::addColumn<QString>("told");
        const auto row = [](const char* name, const QString& arguments, int exit, const QString& told) {
            QTest::newRow(name) << arguments.split(u' ') << exit << told;
        };
        row("no table", u"type1 --value k --reference 1 --tolerance 1"_s, 2, u"TABLE.csv"_s);
        row("no reference", u"type1 one.csv --value k --tolerance 1"_s, 2, u"--reference is missing"_s);
        row("tolerance of 0", u"type1 one.csv --value k --reference 1 --tolerance 0"_s, 2, u"--tolerance"_s);
        row("share of 200 %", u"type1 one.csv --value k --reference 1 --tolerance 1 --share 200"_s, 2,
            u"share"_s);
        row("no such file", u"type1 none.csv --value k --reference 1 --tolerance 1"_s, 3, u"none.csv"_s);
        row("no such column", u"type1 one.csv --value m --reference 1 --tolerance 1"_s, 3, u"one.csv:1:1"_s);
        row("a word", u"linearity verdicts.csv --reference part --value who"_s, 3, u"verdicts.csv:2:2"_s);
        row("one reference", u"linearity verdicts.csv --reference part --value part --deviation none"_s, 2,
            u"own, pooled"_s);
        row("no rater", u"attributes verdicts.csv --part part --verdict verdict"_s, 2,
            u"--rater is missing"_s);
        row("both forms", u"attributes verdicts.csv --rater-columns who --verdict verdict"_s, 2,
            u"column a rater"_s);
        row("an empty cell", u"attributes wide.csv --part r1 --rater r1 --verdict r2"_s, 3,
            u"wide.csv:4:2"_s);
        row("no such class", u"attributes wide.csv --rater-columns r1,r2 --accepted c"_s, 2, u"called c"_s);
        row("two references",
            u"attributes verdicts.csv --part who --rater part --verdict verdict --reference truth"_s, 3,
            u"for part"_s);
    }
    void badInputNamesThePlace()
    {
        QFETCH(QStringList, arguments);
        QFETCH(int, exit);
        QFETCH(QString, told);
        const ProgramRun run = study(arguments + QStringList{u"--json"_s});
        QCOMPARE(run.exit, exit);
        QVERIFY2(QString::fromUtf8(run.err).contains(told), run.err.constData());
    }
};

GRIPSCOPE_TEST(BiasAndAgreementCommandTest)
#include "bias_and_agreement_command_test.moc"
