// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/drift.h"
#include "tests/core/recognition/noisy_types.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const Eigen::Matrix3d driftBetween = covarianceOf(0.03, 0.04, 0.03, 0.2);
const Eigen::Matrix3d driftNoise = covarianceOf(0.01, 0.01, 0.005, 0);

/// Types A, B, C of 10 squeezes, and later ones that something was done to.
struct Bench {
    explicit Bench(std::uint64_t seed, int types = 3, int enrolled = 10)
        : source(seed, driftBetween), models(fitTypeModels(source.enrolment(types, enrolled, driftNoise))),
          count(types)
    {
    }

    std::vector<TypeSqueeze> later(int squeezes,
                                   const std::function<Eigen::Vector3d(int, Eigen::Vector3d)>& change)
    {
        std::vector<TypeSqueeze> result;
        for (int i = 0; i < squeezes; ++i)
            for (int type = 0; type < count; ++type) {
                const Eigen::Vector3d log = source.log(NoisyTypes::mean(type), driftNoise);
                const Eigen::Vector3d p = change(type, log.array().exp());
                result.push_back(
                    NoisyTypes::squeeze(QString(QChar(u'A' + type)), p.array().log(), driftNoise));
            }
        return result;
    }

    NoisyTypes source;
    TypeModels models;
    int count;
};

Eigen::Vector3d same(int /*type*/, Eigen::Vector3d p)
{
    return p;
}

DriftReport reportOf(Bench& bench, int squeezes,
                     const std::function<Eigen::Vector3d(int, Eigen::Vector3d)>& change)
{
    const Expected<DriftReport> report = findDrift(bench.models, bench.later(squeezes, change));
    if (!report)
        qFatal("%s", qPrintable(report.error().describe()));
    return *report;
}

} // namespace

class DriftTest : public QObject {
    Q_OBJECT
private slots:
    void limitsAreThoseOfTheLiterature()
    {
        // Lucas and Saccucci, Technometrics 1990: weight 0.25 and L = 3.001, or 0.1 and 2.814, give 500.
        const auto wide = averageRunLength(0.25, 1, 3.001 * 3.001);
        const auto narrow = averageRunLength(0.1, 1, 2.814 * 2.814);
        QVERIFY(wide && std::abs(*wide - 500) < 10);
        QVERIFY(narrow && std::abs(*narrow - 500) < 10);
        // Weight 1 is Shewhart's chart: one squeeze alone, 1 / P(chi-square with 3 > 14.796) = 500.
        const auto single = movingAverageLimit(1, 3, 500);
        QVERIFY(single && std::abs(*single - 14.796) < 0.02);
        QVERIFY(!movingAverageLimit(0, 3, 500) && !movingAverageLimit(0.2, 0, 500));
        QVERIFY(!movingAverageLimit(0.2, 3, 1) && !averageRunLength(0.2, 1, 0));
    }
    void withoutDriftTheRunIsAsLongAsStated_data()
    {
        QTest::addColumn<int>("enrolled");
        QTest::newRow("3") << 3;
        QTest::newRow("10") << 10;
    }
    void withoutDriftTheRunIsAsLongAsStated()
    {
        QFETCH(int, enrolled);
        constexpr double stated = 100, weight = 0.2;
        constexpr int runs = 150, longest = 1500;
        const double limit = std::sqrt(*movingAverageLimit(weight, 1, 4 * stated) * weight / (2 - weight));
        const double joint = *movingAverageLimit(weight, 3, 4 * stated);
        double total = 0;
        for (int run = 0; run < runs; ++run) {
            Bench bench(std::uint64_t(run + 1), 2, enrolled);
            SelfStartingChart chart(bench.models, 0, weight);
            while (chart.squeezes() < longest && chart.average().cwiseAbs().maxCoeff() <= limit &&
                   chart.tSquared() <= joint)
                chart.add(bench.source.log(NoisyTypes::mean(0), driftNoise), driftNoise);
            total += chart.squeezes();
        }
        // At least the stated one, since four charts that go together share it out; with four alike it would
        // be four times that. A run's standard deviation is about its mean: 8 % of the mean of 150 runs.
        const double mean = total / runs;
        QVERIFY2(mean > stated * (1 - 3 * 0.082), qPrintable(QString::number(mean)));
        QVERIFY2(mean < 2 * stated, qPrintable(QString::number(mean)));
    }
    void whatHasNotMovedIsSaidToHaveAtTheStatedRate()
    {
        constexpr int looks = 300;
        int moved = 0, alarms = 0;
        for (int run = 0; run < looks; ++run) {
            Bench bench(std::uint64_t(run + 1000));
            const std::vector<TypeSqueeze> later = bench.later(6, same);
            for (const TypeModel& type : bench.models.types)
                moved += typeShift(bench.models, type, later)->pValue < 0.05;
            alarms += commonShift({*typeShift(bench.models, bench.models.types[0], later),
                                   *typeShift(bench.models, bench.models.types[1], later)},
                                  ShiftKind::Factor)
                          ->pValue < 0.05;
        }
        // 5 % of 900: 45; three types share one scatter: clustered, 6 to 9 (1 sd). 5 % of 300: 15 +- 4.
        QVERIFY2(moved > 20 && moved < 75, qPrintable(QString::number(moved)));
        QVERIFY2(alarms > 3 && alarms < 29, qPrintable(QString::number(alarms)));
    }
    void aGainMovesAllTypesAlike()
    {
        Bench bench(1);
        const DriftReport report =
            reportOf(bench, 20, [](int, const Eigen::Vector3d& p) { return Eigen::Vector3d(1.1 * p); });
        QVERIFY2(report.cause == DriftCause::Sensor, qPrintable(toString(report.cause)));
        QCOMPARE(report.moved, (QStringList{u"A"_s, u"B"_s, u"C"_s}));
        const Eigen::Vector3d error = report.factor->value - Eigen::Vector3d::Constant(std::log(1.1));
        for (int i = 0; i < 3; ++i)
            QVERIFY(std::abs(error(i)) < 4 * std::sqrt(report.factor->covariance(i, i)));
        QVERIFY(report.words[0].describe().contains(u"calibration"_s));
        for (const TypeDrift& type : report.types)
            QVERIFY(type.firstAlarm && *type.firstAlarm <= 20);
    }
    void fingersAddTheSameToAllTypes()
    {
        // The types' means are exp(-2) to exp(2) times each other.
        Bench bench(2);
        const Eigen::Vector3d more(0.1, 0.1, 0.03);
        const DriftReport report =
            reportOf(bench, 20, [&](int, const Eigen::Vector3d& p) { return Eigen::Vector3d(p + more); });
        QVERIFY2(report.cause == DriftCause::Fingers, qPrintable(toString(report.cause)));
        for (int i = 0; i < 3; ++i) // to first order: a tenth of it
            QVERIFY(std::abs(report.addition->value(i) - more(i)) <
                    0.15 * more(i) + 4 * std::sqrt(report.addition->covariance(i, i)));
        QVERIFY(report.words[0].describe().contains(u"fingers"_s));
    }
    void oneTypeAloneIsTheProduct()
    {
        Bench bench(3);
        const DriftReport report = reportOf(bench, 20, [](int type, const Eigen::Vector3d& p) {
            return type == 1 ? Eigen::Vector3d(p.cwiseProduct(Eigen::Vector3d(1, 1, 0.9))) : p;
        });
        QVERIFY2(report.cause == DriftCause::Product, qPrintable(toString(report.cause)));
        QCOMPARE(report.moved, QStringList{u"B"_s});
        QVERIFY2(report.words[0].describe().contains(u"only B"_s), qPrintable(report.words[0].describe()));
        QVERIFY(report.types[1].firstAlarm && !report.types[0].firstAlarm);
        QVERIFY(std::abs(report.types[1].shift->log(2) - std::log(0.9)) < 0.04);
    }
    void slowDriftIsSeenByTheShift()
    {
        Bench bench(4, 2, 10);
        int count = 0;
        const DriftReport report = reportOf(bench, 60, [&](int type, const Eigen::Vector3d& p) {
            return type == 0 ? Eigen::Vector3d(p * (1 + 0.002 * ++count)) : p;
        });
        QVERIFY(report.types[0].moved && !report.types[1].moved);
    }
    void oneTypeOrTooFewSqueezesCannotTell()
    {
        Bench one(5, 1, 10);
        const auto gain = [](int, const Eigen::Vector3d& p) { return Eigen::Vector3d(1.2 * p); };
        QVERIFY(reportOf(one, 10, gain).cause == DriftCause::OneTypeOnly);
        Bench two(6, 2, 10);
        QVERIFY(reportOf(two, 2, gain).cause == DriftCause::TooFew);
        QVERIFY(reportOf(two, 20, same).cause == DriftCause::Nothing);
        QVERIFY(findDrift({}, {})->cause == DriftCause::TooFew);
    }
    void nothingBreaksIt()
    {
        Bench bench(7, 2, 3);
        std::vector<TypeSqueeze> wild;
        for (const double value : {1e-300, 1e300, 0.0, -1.0, std::nan(""), 1.0})
            for (int i = 0; i < 4; ++i)
                wild.push_back({i % 2 ? u"A"_s : u"Z"_s, {value, 1, 1 / value}});
        const Expected<DriftReport> report = findDrift(bench.models, wild);
        QVERIFY(report);
        for (const TypeDrift& type : report->types) {
            QVERIFY(type.average.allFinite() && std::isfinite(type.tSquared));
            QVERIFY(!type.shift || type.shift->log.allFinite());
        }
        DriftOptions options;
        options.recent = 1;
        QVERIFY(!findDrift(bench.models, wild, options));
        options = {};
        options.weight = std::nan("");
        QVERIFY(!findDrift(bench.models, wild, options));
    }
};

GRIPSCOPE_TEST(DriftTest)
#include "drift_test.moc"
