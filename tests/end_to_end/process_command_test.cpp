// SPDX-License-Identifier: GPL-3.0-or-later
// Charts and capability of one type, straight from a library; the numbers are those that the window shows.
#include "core/math/gaussian.h"
#include "core/session/process/process_chart.h"
#include "tests/core/library/process_inspections.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

class ProcessCommandTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;
    ProcessValues m_values;

    [[nodiscard]] ProgramRun study(const QString& text) const
    {
        return m_work.cli(u"study "_s.append(text).split(u' ', Qt::SkipEmptyParts));
    }

private slots:
    void initTestCase()
    {
        const auto library = Library::open(m_work.path(u"lib.db"_s));
        QVERIFY(library);
        GaussianNoise noise(3);
        const QDateTime start(QDate(2026, 5, 4), QTime(8, 0), Qt::UTC);
        for (int i = 0; i < 60; ++i)
            addPart(**library,
                    {.parameters = {0.04 + 1e-4 * noise(), 43 + 0.2 * noise(), 9990 + 20 * noise()},
                     .type = i % 6 == 5 ? u"B"_s : u"A"_s,
                     .operatorName = i % 2 == 0 ? u"Ada"_s : u"Bob"_s,
                     .time = start.addSecs(3600 * i)});
        m_values = valuesOf(**library, {.type = u"A"_s});
    }
    void chartsAreThoseOfTheWindow_data()
    {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("more");
        QTest::newRow("i-mr") << u"i-mr"_s << u"--rules nelson"_s;
        QTest::newRow("xbar-r") << u"xbar-r"_s << u"--subgroup 5 --rules nelson"_s;
        QTest::newRow("ewma") << u"ewma"_s << QString();
        QTest::newRow("cusum") << u"cusum"_s << QString();
    }
    void chartsAreThoseOfTheWindow()
    {
        QFETCH(QString, kind);
        QFETCH(QString, more);
        const ProgramRun run =
            study(u"chart --library lib.db --type A --value k --json --kind %1 %2"_s.arg(kind, more));
        QVERIFY2(run.exit == 0, run.err.constData());
        ProcessOptions options;
        options.kind = *processKindFromString(kind);
        options.rules = RunRules::Nelson;
        const QuantityChart chart = *drawQuantity(m_values, processRows(m_values, {}), 2, options);
        const QJsonObject found = run.json();
        QCOMPARE(found[u"centre"].toDouble(), chart.study.setting.centre);
        QCOMPARE(found[u"sigma"].toDouble(), chart.study.setting.sigma);
        QCOMPARE(found[u"points"].toArray().size(), qsizetype(chart.points()));
        QCOMPARE(found[u"signals"].toArray().size(), qsizetype(chart.study.signalsFound.size()));
        QCOMPARE(found[u"arl"][u"in_control"].toDouble(), processRunLengths(options).inControl->points);
    }
    void theJointChartToo()
    {
        const ProgramRun run =
            study(u"chart --library lib.db --type A --value m,b,k --json --kind hotelling"_s);
        QVERIFY2(run.exit == 0, run.err.constData());
        ProcessOptions options;
        options.kind = ProcessKind::Hotelling;
        const JointChart chart = *drawJoint(m_values, processRows(m_values, {}), options);
        const QJsonArray points = run.json()[u"points"].toArray();
        QCOMPARE(points.size(), qsizetype(chart.points.size()));
        QCOMPARE(points[7][u"value"].toDouble(), chart.points[7].tSquared);
        QCOMPARE(points[7][u"upper"].toDouble(), chart.points[7].upper);
    }
    void andTheCapability()
    {
        const ProgramRun run =
            study(u"capability --library lib.db --type A --value k --lower 9900 --upper 10080 --json"_s);
        QVERIFY2(run.exit == 0, run.err.constData());
        ProcessOptions options;
        options.limits[2] = ToleranceLimits{9900, 10080};
        const ProcessCapability found = *processCapability(m_values, processRows(m_values, {}), 2, options);
        QCOMPARE(run.json()[u"within"][u"cpk"].toDouble(), found.normal->within.nearest.value);
        QCOMPARE(run.json()[u"overall"][u"ppk"].toDouble(), found.normal->overall.nearest.value);
        QCOMPARE(run.json()[u"overall"][u"ppk_interval"][0].toDouble(),
                 found.normal->overall.nearest.interval.lower);
        QCOMPARE(run.json()[u"expected_ppm"].toDouble(), found.normal->overall.expectedPpm);
    }
    void aTypeIsNarrowed()
    {
        const auto points = [this](const QString& more) {
            const ProgramRun run = study(u"chart --library lib.db --type A --value k --json "_s + more);
            return run.exit == 0 ? run.json()[u"points"].toArray().size() : -1;
        };
        QCOMPARE(points({}), qsizetype(50));
        QCOMPARE(points(u"--operator Ada"_s), qsizetype(30));
        QCOMPARE(points(u"--from 2030-01-01"_s), qsizetype(-1));
        QCOMPARE(points(u"--gripper nobody"_s), qsizetype(-1));
        QCOMPARE(points(u"--kind xbar-r --subgroup operator"_s), qsizetype(2));
    }
    void badInputIsToldInWords_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<int>("exit");
        QTest::addColumn<QByteArray>("told");
        const auto row = [](const char* name, const QString& arguments, int exit, const char* told) {
            QTest::newRow(name) << arguments << exit << QByteArray(told);
        };
        row("no such type", u"--library lib.db --type C"_s, 3, "an inspection of C");
        row("table and type", u"t.csv --type A"_s, 2, "not from both");
        row("narrowed without a type", u"--library lib.db --station x"_s, 2, "--station goes with --type");
        row("no day", u"--library lib.db --type A --from yesterday"_s, 2, "a day such as 2024-05-31");
        row("no such column", u"--library lib.db --type A --value weight"_s, 3, "weight");
    }
    void badInputIsToldInWords()
    {
        QFETCH(QString, arguments);
        QFETCH(int, exit);
        QFETCH(QByteArray, told);
        const QString value = arguments.contains(u"--value"_s) ? QString() : u"--value k "_s;
        const ProgramRun run = study(u"chart "_s + value + arguments);
        QVERIFY2(run.exit == exit, run.err.constData());
        QVERIFY2(run.err.contains(told), run.err.constData());
    }
};

GRIPSCOPE_TEST(ProcessCommandTest)
#include "process_command_test.moc"
