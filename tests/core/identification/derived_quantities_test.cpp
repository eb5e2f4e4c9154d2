// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/result/identification_json.h"
#include "core/identification/uncertainty/derived_quantities.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

UncertaintyBudget budgetWith(const MassDampingStiffness& p, const Eigen::Matrix3d& relative)
{
    Estimate e;
    e.status = EstimateStatus::Converged;
    e.parameters = p;
    e.covariance = p.vector().asDiagonal() * relative * p.vector().asDiagonal();
    e.residuals.degreesOfFreedom = 100;
    // A record that has nothing to say beyond the estimate.
    return uncertaintyBudget(e, {}, {}, {}, {}, {});
}

Eigen::Matrix3d independent(double m, double b, double k)
{
    return Eigen::Vector3d(m * m, b * b, k * k).asDiagonal();
}

const DerivedQuantity* find(const std::vector<DerivedQuantity>& all, const QString& id)
{
    for (const DerivedQuantity& q : all) {
        if (q.id == id)
            return &q;
    }
    return nullptr;
}

/// A quantity as the textbook has it, for differences.
double textbook(const QString& id, const Eigen::Vector3d& p)
{
    const double root = std::sqrt(std::abs(p(1) * p(1) - 4 * p(0) * p(2)));
    if (id == u"natural_frequency"_s)
        return std::sqrt(p(2) / p(0)) / (2 * std::numbers::pi);
    if (id == u"damping_ratio"_s)
        return p(1) / (2 * std::sqrt(p(0) * p(2)));
    if (id == u"damped_frequency"_s)
        return root / (2 * p(0)) / (2 * std::numbers::pi);
    if (id == u"decay_time"_s)
        return 2 * p(0) / p(1);
    if (id == u"time_constant_slow"_s)
        return (p(1) + root) / (2 * p(2));
    if (id == u"time_constant_fast"_s)
        return (p(1) - root) / (2 * p(2));
    return 0;
}

} // namespace

class DerivedQuantitiesTest : public QObject {
    Q_OBJECT
private slots:
    void valuesAndUncertaintiesFollowTheTextbook_data()
    {
        QTest::addColumn<double>("b");
        QTest::addColumn<int>("count");
        QTest::newRow("underdamped") << 10.0 << 4;
        QTest::newRow("overdamped") << 80.0 << 4;
    }
    void valuesAndUncertaintiesFollowTheTextbook()
    {
        QFETCH(double, b);
        QFETCH(int, count);
        const MassDampingStiffness p{0.0396, b, 9990};
        Eigen::Matrix3d relative = independent(0.02, 0.03, 0.01);
        relative(0, 2) = relative(2, 0) = 0.00015;
        const UncertaintyBudget budget = budgetWith(p, relative);
        const std::vector<DerivedQuantity> all = derivedFrom(budget);
        QCOMPARE(all.size(), static_cast<std::size_t>(count));
        for (const DerivedQuantity& q : all) {
            const double value = textbook(q.id, p.vector());
            Eigen::Vector3d gradient;
            for (Eigen::Index i = 0; i < 3; ++i) {
                Eigen::Vector3d up = p.vector();
                Eigen::Vector3d down = up;
                up(i) *= 1 + 1e-5;
                down(i) *= 1 - 1e-5;
                gradient(i) = (textbook(q.id, up) - textbook(q.id, down)) / (2e-5 * p.vector()(i));
            }
            const double u = std::sqrt(gradient.dot(budget.covariance * gradient));
            QVERIFY2(std::abs(*q.value / value - 1) < 1e-12, qPrintable(q.id));
            QVERIFY2(std::abs(q.uncertainty.standardUncertainty / u - 1) < 1e-6, qPrintable(q.id));
            QVERIFY(q.interval.lower < value && value < q.interval.upper);
            QVERIFY(q.words.isEmpty());
        }
    }

    void nearCriticalDampingTheTimeConstantsAreNotToldApart()
    {
        const double critical = 2 * std::sqrt(0.0396 * 9990);
        const std::vector<DerivedQuantity> all =
            derivedFrom(budgetWith({0.0396, 1.01 * critical, 9990}, independent(0.02, 0.02, 0.02)));
        QVERIFY(find(all, u"time_constant_slow"_s) == nullptr);
        const DerivedQuantity* one = find(all, u"time_constant"_s);
        QVERIFY(one != nullptr && one->value && !one->words.isEmpty());
        QVERIFY(std::abs(*one->value - std::sqrt(0.0396 / 9990)) < 1e-12);
    }

    void whatCannotBeHadIsSaid()
    {
        const UncertaintyBudget budget = budgetWith({0.0396, 43, 9990}, independent(0.9, 0.02, 0.01));
        QVERIFY(budget.intervals[0].onlyUpperBound);
        QCOMPARE(budget.intervals[0].lower, 0.0);
        // 0.0396 (1 + 1.984 * 0.9), Student with 100 degrees of freedom
        QVERIFY(std::abs(budget.intervals[0].upper - 0.1103) < 0.0005);
        const std::vector<DerivedQuantity> all = derivedFrom(budget);
        const DerivedQuantity* frequency = find(all, u"natural_frequency"_s);
        QVERIFY(!frequency->value);
        QVERIFY(frequency->words.describe().startsWith(u"at least"_s));
    }

    void extremeNumbersGiveNoNonsense_data()
    {
        QTest::addColumn<double>("m");
        QTest::addColumn<double>("b");
        QTest::addColumn<double>("k");
        QTest::newRow("tiny") << 1e-300 << 1e-300 << 1e-300;
        QTest::newRow("huge") << 1e300 << 1e300 << 1e300;
        QTest::newRow("mixed") << 1e-300 << 1.0 << 1e300;
        QTest::newRow("negative") << -1.0 << 1.0 << 1.0;
        QTest::newRow("zero") << 0.0 << 0.0 << 0.0;
    }
    void extremeNumbersGiveNoNonsense()
    {
        QFETCH(double, m);
        QFETCH(double, b);
        QFETCH(double, k);
        const UncertaintyBudget budget = budgetWith({m, b, k}, independent(0.1, 0.1, 0.1));
        for (const DerivedQuantity& q : derivedFrom(budget)) {
            QVERIFY(std::isfinite(q.value.value_or(0)));
            QVERIFY(std::isfinite(q.uncertainty.standardUncertainty));
            QVERIFY(std::isfinite(q.interval.lower) && std::isfinite(q.interval.upper));
        }
        for (const CoverageInterval& interval : budget.intervals)
            QVERIFY(std::isfinite(interval.lower) && std::isfinite(interval.upper));
    }

    void jsonHoldsTheBudgetAndTheQuantities()
    {
        const UncertaintyBudget budget = budgetWith({0.0396, 43, 9990}, independent(0.02, 0.02, 0.01));
        const QJsonObject json = toJson(budget);
        QCOMPARE(json[u"lines"_s].toArray().size(), 1);
        QCOMPARE(json[u"lines"_s][0][u"id"_s].toString(), u"position_noise"_s);
        QCOMPARE(json[u"parameters"_s][u"k"_s].toDouble(), 9990.0);
        QCOMPARE(json[u"intervals"_s][u"m"_s][u"upper"_s].toDouble(), budget.intervals[0].upper);
        QVERIFY(std::abs(json[u"standard_uncertainties"_s][u"b"_s].toDouble() - 0.86) < 1e-12);
        QVERIFY(toJson(UncertaintyBudget())[u"parameters"_s].isNull());
        const QJsonObject derived = toJson(derivedFrom(budget));
        QCOMPARE(derived[u"natural_frequency"_s][u"unit"_s].toString(), u"Hz"_s);
        QVERIFY(derived[u"damping_ratio"_s][u"value"_s].isDouble());
    }
};

GRIPSCOPE_TEST(DerivedQuantitiesTest)
#include "derived_quantities_test.moc"
