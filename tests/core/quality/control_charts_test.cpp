// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random_stream.h"
#include "core/math/normal_spread.h"
#include "core/quality/charts/chart_study.h"
#include "tests/core/quality/piston_rings.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;

class ControlChartsTest : public QObject {
    Q_OBJECT
private:
    static Subgroups rowByRow(const std::vector<double>& values, std::size_t size = 1)
    {
        return Subgroups::of(SubgroupLayout::consecutive(values.size(), size).value(), values).value();
    }
    static ChartOptions chartOf(ChartKind kind)
    {
        ChartOptions options;
        options.kind = kind;
        return options;
    }
    static std::vector<double> drawn(int count, std::uint64_t seed)
    {
        RandomStream random(seed, 0, 0);
        std::vector<double> values;
        for (int i = 0; i < count; ++i)
            values.push_back(50 + 3 * random.normal());
        return values;
    }
    static bool near(double found, double expected, double tolerance)
    {
        return std::abs(found - expected) <= tolerance;
    }
    static std::vector<std::size_t> signalPoints(const ChartStudy& study, ChartPart part)
    {
        std::vector<std::size_t> points;
        for (const ChartSignal& signal : study.signalsFound)
            if (signal.part == part)
                points.push_back(signal.point + 1);
        return points;
    }

private slots:
    /// Phase 1 settles the limits, the 15 samples after it are judged. Published with d2 rounded to 2.326:
    /// sigma 0.009785039, limits 73.988048 and 74.014304; here with d2(5) = 2.3259289: 0.009785338.
    void pistonRings()
    {
        const test::PistonRings rings = test::readPistonRings();
        if (rings.diameters.empty())
            QSKIP("the piston rings are not in ../shared/data/quality");
        const Subgroups groups =
            Subgroups::of(SubgroupLayout::labelled(rings.samples, 40), rings.diameters).value();
        ChartOptions options;
        options.kind = ChartKind::MeanRange;
        options.estimateFrom = rings.phaseOne;
        const ChartStudy study = studyChart(groups, options).value();
        QVERIFY(near(study.setting.centre, 74.001176, 5e-7));
        QVERIFY(near(study.setting.sigma, 0.009785338, 5e-10));
        QVERIFY(near(study.setting.sigma * meanNormalRange(5), 0.02276, 5e-6)); // mean range
        QVERIFY(near(study.setting.sigma * meanNormalRange(5) / 2.326, 0.009785039, 5e-10));
        QVERIFY(near(study.points[0].lower, 73.988048, 5e-7));
        QVERIFY(near(study.points[0].upper, 74.014304, 5e-7));
        QVERIFY(near(study.spreadPoints[0]->upper, 0.04812, 2e-5)); // D4 times the mean range
        QCOMPARE(signalPoints(study, ChartPart::Location), (std::vector<std::size_t>{37, 38, 39}));
        options.rules = RunRules::WesternElectric;
        QVERIFY(signalPoints(studyChart(groups, options).value(), ChartPart::Location).front() < 37);
        options.kind = ChartKind::MeanDeviation; // mean s 0.009240037
        QVERIFY(near(studyChart(groups, options)->setting.sigma, 0.009240037 / 0.939985603, 5e-9));
    }
    /// Target 99, K 1, H 10.
    void tabularCusum()
    {
        const std::vector<double> values{102.0, 94.8, 98.3,  98.4, 102.0, 98.5, 99.0,  97.7,  100.0, 98.1,
                                         101.3, 98.7, 101.1, 98.4, 97.0,  96.7, 100.3, 101.4, 97.2,  101.0};
        ChartOptions options;
        options.kind = ChartKind::Cusum;
        options.target = 99;
        options.sigma = 2;
        const ChartStudy study = studyChart(rowByRow(values), options).value();
        const std::vector<double> upper{2, 0, 0, 0, 2, 0.5};
        double largest = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i < upper.size())
                QVERIFY(near(study.points[i].upperSum, upper[i], 1e-9));
            largest = std::max(largest, study.points[i].lowerSum);
        }
        QVERIFY(near(largest, 3.2, 1e-9));
        QVERIFY(study.signalsFound.empty());
        QCOMPARE(study.points[0].upper, 10.0);
        options.sigma = 1;
        options.reference = 1;
        options.decision = 3;
        const ChartStudy tight = studyChart(rowByRow(values), options).value();
        QCOMPARE(tight.signalsFound.size(), std::size_t(1));
        QVERIFY(!tight.signalsFound[0].rising);
        QCOMPARE(tight.signalsFound[0].point, std::size_t(1));
        QCOMPARE(signalInWords(tight.signalsFound[0], tight.setting).english(),
                 u"Point 2: the lower sum is above its limit: lower since about point 2"_s);
    }
    /// The exact limits are those of var(e_t) = s^2 w/(2 - w) (1 - (1 - w)^2t).
    void ewmaLimitsAreExactInTime()
    {
        ChartOptions options;
        options.kind = ChartKind::Ewma;
        options.target = 50;
        options.sigma = 3;
        options.width = 2.7;
        options.weight = 0.1;
        const std::vector<double> values = drawn(80, 5);
        const ChartStudy study = studyChart(rowByRow(values), options).value();
        double average = 50;
        for (int t = 1; t <= 80; ++t) {
            average = 0.1 * values[std::size_t(t - 1)] + 0.9 * average;
            const double half = 2.7 * 3 * std::sqrt(0.1 / 1.9 * (1 - std::pow(0.9, 2 * t)));
            QVERIFY(near(study.points[std::size_t(t - 1)].value, average, 1e-10));
            QVERIFY(near(study.points[std::size_t(t - 1)].upper, 50 + half, 1e-10));
            QVERIFY(near(study.points[std::size_t(t - 1)].lower, 50 - half, 1e-10));
        }
    }
    void individualsAndMovingRanges()
    {
        const ChartStudy study = studyChart(rowByRow({10, 12, 11, 15, 9}), {}).value();
        QVERIFY(near(study.setting.centre, 11.4, 1e-12));
        QVERIFY(near(study.setting.sigma, (2 + 1 + 4 + 6) / 4.0 / 1.1283791671, 1e-9));
        QVERIFY(!study.spreadPoints[0]);
        QCOMPARE(study.spreadPoints[3]->value, 4.0);
        QVERIFY(near(study.spreadPoints[3]->upper, 3.2665 * 3.25, 1e-3)); // D4 of two
        QVERIFY(!study.messages.empty());                                 // few points
    }
    void unequalSubgroupsHaveTheirOwnLimits()
    {
        const std::vector<double> values = drawn(23, 2);
        ChartOptions options = chartOf(ChartKind::MeanDeviation);
        options.target = 50;
        options.sigma = 3;
        options.rules = RunRules::None;
        const ChartStudy study = studyChart(rowByRow(values, 4), options).value();
        QCOMPARE(study.points.size(), std::size_t(6));
        QVERIFY(near(study.points[0].upper, 50 + 9 / 2.0, 1e-12));
        QVERIFY(near(study.points[5].upper, 50 + 9 / std::sqrt(3), 1e-12));
        QVERIFY(near(study.spreadPoints[5]->upper, chartConstants(3).B6() * 3, 1e-12));
        // the rest of one value has a mean and no deviation
        const ChartStudy rest = studyChart(rowByRow(drawn(21, 2), 4), chartOf(ChartKind::MeanRange)).value();
        QVERIFY(!rest.spreadPoints.back());
        QCOMPARE(rest.spread->singles, std::size_t(1));
        QVERIFY(rest.messages.size() >= 2);
    }
    void oneValueAfterAnotherIsTheSame_data()
    {
        QTest::addColumn<int>("kind");
        for (const ChartKind kind : {ChartKind::Individuals, ChartKind::MeanRange, ChartKind::MeanDeviation,
                                     ChartKind::Ewma, ChartKind::Cusum})
            QTest::newRow(qPrintable(toString(kind))) << int(kind);
    }
    void oneValueAfterAnotherIsTheSame()
    {
        QFETCH(int, kind);
        const std::size_t size = ChartKind(kind) == ChartKind::Individuals ? 1 : 5;
        const std::vector<double> values = drawn(500, 9);
        const Subgroups groups = rowByRow(values, size);
        ChartOptions options;
        options.kind = ChartKind(kind);
        options.rules = RunRules::Nelson;
        const ChartStudy study = studyChart(groups, options).value();
        LiveChart live = LiveChart::of(study.setting).value();
        for (std::size_t i = 0; i < groups.count(); ++i) {
            QVERIFY(!live.add(std::nan(""))); // refused, and forgotten
            const ChartStep step = live.add(groups[i]).value();
            QCOMPARE(step.location.value, study.points[i].value);
            QCOMPARE(step.location.lower, study.points[i].lower);
            QCOMPARE(step.location.upper, study.points[i].upper);
            QCOMPARE(step.location.upperSum, study.points[i].upperSum);
            QCOMPARE(step.location.rules, study.points[i].rules);
            if (i < study.spreadPoints.size())
                QCOMPARE(step.spread.has_value(), study.spreadPoints[i].has_value());
        }
    }
    /// Thirteen leading digits that all share cost nothing.
    void largeOffsetsCostNothing()
    {
        std::vector<double> values, far;
        for (int i = 0; i < 40; ++i) {
            values.push_back((i * 7 % 11) / 8.0);
            far.push_back(1e12 + values.back());
        }
        const ChartStudy here = studyChart(rowByRow(values, 4), chartOf(ChartKind::MeanDeviation)).value();
        const ChartStudy there = studyChart(rowByRow(far, 4), chartOf(ChartKind::MeanDeviation)).value();
        QVERIFY(near(there.setting.sigma / here.setting.sigma, 1, 1e-9));
    }
    void rowsOfALabelBelongTogetherWhereverTheyStand()
    {
        const std::vector<int> labels{0, 1, 0, 1};
        const std::vector<double> values{1, 10, 3, 14};
        const Subgroups groups = Subgroups::of(SubgroupLayout::labelled(labels, 2), values).value();
        QCOMPARE(summaryOf(groups[0]).mean, 2.0);
        QCOMPARE(summaryOf(groups[1]).range, 4.0);
    }
    void badInputIsSaid_data()
    {
        QTest::addColumn<QList<double>>("values");
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("size");
        QTest::addColumn<QString>("words");
        const int individuals = int(ChartKind::Individuals), ranges = int(ChartKind::MeanRange);
        QTest::newRow("constant") << QList<double>(30, 5.0) << individuals << 1 << u"do not vary"_s;
        QTest::newRow("constant groups") << QList<double>(30, 5.0) << ranges << 5 << u"do not vary"_s;
        QTest::newRow("one value") << QList<double>{5.0} << individuals << 1 << u"at least two"_s;
        QTest::newRow("one subgroup") << QList<double>{5.0, 6.0} << ranges << 2 << u"there is one"_s;
        QTest::newRow("groups of one") << QList<double>{5.0, 6.0, 7.0} << ranges << 1 << u"i-mr"_s;
        QTest::newRow("individuals in groups")
            << QList<double>{1, 2, 3, 4} << individuals << 2 << u"xbar-r"_s;
    }
    void badInputIsSaid()
    {
        QFETCH(QList<double>, values);
        QFETCH(int, kind);
        QFETCH(int, size);
        QFETCH(QString, words);
        ChartOptions options;
        options.kind = ChartKind(kind);
        const auto study = studyChart(
            rowByRow(std::vector<double>(values.begin(), values.end()), std::size_t(size)), options);
        QVERIFY(!study);
        QVERIFY2(study.error().describe().contains(words), qPrintable(study.error().describe()));
    }
    void settingsThatMakeNoSenseAreRefused()
    {
        const std::vector<double> values = drawn(30, 1);
        QVERIFY(!Subgroups::of(SubgroupLayout::consecutive(1, 1).value(),
                               std::vector<double>{std::numeric_limits<double>::infinity()}));
        QVERIFY(!Subgroups::of(SubgroupLayout::consecutive(0, 1).value(), {}));
        QVERIFY(!SubgroupLayout::consecutive(5, 0));
        ChartOptions options;
        options.sigma = 0;
        QVERIFY(!studyChart(rowByRow(values), options));
        options.sigma.reset();
        options.estimateFrom = 31;
        QVERIFY(!studyChart(rowByRow(values), options));
        options = {};
        options.kind = ChartKind::Ewma;
        options.weight = 1.5;
        QVERIFY(!studyChart(rowByRow(values), options));
        options.weight = 0.2;
        options.width = -1;
        QVERIFY(!studyChart(rowByRow(values), options));
        options = {};
        options.kind = ChartKind::Cusum;
        options.decision = 0;
        QVERIFY(!studyChart(rowByRow(values), options));
        // constant values are no trouble where sigma is known
        options = {};
        options.target = 5;
        options.sigma = 1;
        QVERIFY(studyChart(rowByRow(std::vector<double>(30, 5.0)), options));
        QVERIFY(!LiveChart::of({})->add(std::span<const double>()));
    }
};

GRIPSCOPE_TEST(ControlChartsTest)
#include "control_charts_test.moc"
