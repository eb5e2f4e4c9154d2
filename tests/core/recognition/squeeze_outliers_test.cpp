// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/enrolment/enrollment_guidance.h"
#include "tests/core/recognition/gaussian_types.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

std::set<std::size_t> indices(const std::vector<SqueezeOutlier>& outliers)
{
    std::set<std::size_t> found;
    for (const SqueezeOutlier& outlier : outliers)
        found.insert(outlier.index);
    return found;
}

/// Share of enrolments without outliers in which one is found.
double falseAlarms(int types, int squeezes, int runs, double rate)
{
    GaussianTypes source(7, 0.5);
    int alarms = 0;
    for (int run = 0; run < runs; ++run)
        alarms += !findOutliers(source.enrolment(types, squeezes), u"A"_s, {rate}).empty();
    return double(alarms) / runs;
}

} // namespace

class SqueezeOutliersTest : public QObject {
    Q_OBJECT
private slots:
    void falseAlarmsStayBelowTheStatedShare_data()
    {
        QTest::addColumn<int>("types");
        QTest::addColumn<int>("squeezes");
        QTest::newRow("alone, 6 squeezes") << 1 << 6;
        QTest::newRow("alone, 12 squeezes") << 1 << 12;
        QTest::newRow("beside 3 others, 5 squeezes") << 4 << 5;
    }
    void falseAlarmsStayBelowTheStatedShare()
    {
        QFETCH(int, types);
        QFETCH(int, squeezes);
        // 10 % of 300: above 47 happens by chance once in a thousand (binomial).
        QVERIFY2(falseAlarms(types, squeezes, 300, 0.1) <= 47.0 / 300,
                 qPrintable(QString::number(falseAlarms(types, squeezes, 300, 0.1))));
    }
    void theSqueezeThatIsStifferIsFoundAndSaidWhy()
    {
        std::vector<TypeSqueeze> squeezes = GaussianTypes(3, 0, 0.01).enrolment(4, 10);
        squeezes[4].parameters.k *= 1.10;
        const auto outliers = findOutliers(squeezes, u"A"_s);
        QCOMPARE(outliers.size(), std::size_t(1));
        QCOMPARE(outliers[0].index, std::size_t(4));
        QCOMPARE(outliers[0].parameter, 2);
        QVERIFY(outliers[0].chance < 0.01);
        QVERIFY2(outliers[0].reason.describe().startsWith(u"Stiffness is "_s) &&
                     outliers[0].reason.describe().contains(u" % above the others, "_s),
                 qPrintable(outliers[0].reason.describe()));
        QVERIFY(findOutliers(squeezes, u"B"_s).empty());
    }
    void anotherPartAmongFewIsFoundWithoutOtherTypes()
    {
        // Six of one can and one of another: 40 % more mass, where the others differ by 3 %.
        std::vector<TypeSqueeze> squeezes = GaussianTypes(9, 0, 0.03).enrolment(1, 7);
        squeezes[6].parameters.m = 1.4;
        const auto outliers = findOutliers(squeezes, u"A"_s);
        QCOMPARE(outliers.size(), std::size_t(1));
        QCOMPARE(outliers[0].index, std::size_t(6));
        QVERIFY2(outliers[0].reason.describe().startsWith(u"Mass is "_s),
                 qPrintable(outliers[0].reason.describe()));
    }
    void twoThatHideEachOtherAreBothFound()
    {
        std::vector<TypeSqueeze> squeezes = GaussianTypes(4, 0, 0.01).enrolment(4, 10);
        squeezes[2].parameters.m *= 0.88;
        squeezes[7].parameters.m *= 0.88;
        const std::set<std::size_t> both{2, 7};
        QVERIFY(indices(findOutliers(squeezes, u"A"_s)) == both);
    }
    void oneThatIsUnusualOnlyInAllThreeTogetherIsSaidSo()
    {
        // m, b and k go together (0.98); this one is 2.5 deviations off in each of two, against each other.
        std::vector<TypeSqueeze> squeezes = GaussianTypes(5, 0.98, 0.02).enrolment(4, 10);
        squeezes[0].parameters = {std::exp(0.04), std::exp(-0.04), std::exp(0.0)};
        const auto outliers = findOutliers(squeezes, u"A"_s);
        QCOMPARE(outliers.size(), std::size_t(1));
        QCOMPARE(outliers[0].index, std::size_t(0));
        QCOMPARE(outliers[0].parameter, -1);
        QVERIFY(outliers[0].reason.describe().contains(u"do not go together"_s));
    }
    void aSqueezeThatWasMeasuredBadlyIsNoOutlier()
    {
        std::vector<TypeSqueeze> squeezes = GaussianTypes(6, 0, 0.01).enrolment(4, 10);
        for (TypeSqueeze& squeeze : squeezes) {
            const Eigen::Vector3d p = squeeze.parameters.vector();
            squeeze.covariance = Eigen::Matrix3d(p.cwiseAbs2().asDiagonal()) * 1e-6;
        }
        squeezes[4].parameters.k *= 1.10;
        QCOMPARE(findOutliers(squeezes, u"A"_s).size(), std::size_t(1));
        *squeezes[4].covariance *= 1e4; // it says itself that it knows k to 10 % only
        QVERIFY(findOutliers(squeezes, u"A"_s).empty());
    }
    void nothingIsSaidOfTooFewOrSenselessSqueezes()
    {
        GaussianTypes source(8, 0);
        QVERIFY(findOutliers({}, u"A"_s).empty());
        QVERIFY(findOutliers(source.enrolment(1, 2), u"A"_s).empty());
        QVERIFY(findOutliers(source.enrolment(4, 10), u"nobody"_s).empty());
        std::vector<TypeSqueeze> same(6, TypeSqueeze{u"A"_s, {1e-300, 1e300, 1}});
        QVERIFY(findOutliers(same, u"A"_s).empty());
        same[0].parameters = {std::nan(""), 1, -1};
        QVERIFY(findOutliers(same, u"A"_s).empty());
        for (const SqueezeOutlier& outlier : findOutliers({{u"A"_s, {1, 1, 1}},
                                                           {u"A"_s, {1e300, 1e-300, 1}},
                                                           {u"A"_s, {1, 1, 1}},
                                                           {u"A"_s, {2, 2, 2}},
                                                           {u"A"_s, {1, 1, 1}},
                                                           {u"A"_s, {1, 1, 1}}},
                                                          u"A"_s))
            QVERIFY(std::isfinite(outlier.deviations));
    }
    void unitsDoNotMatter()
    {
        std::vector<TypeSqueeze> squeezes = GaussianTypes(3, 0, 0.01).enrolment(4, 10);
        squeezes[4].parameters.k *= 1.10;
        const auto plain = findOutliers(squeezes, u"A"_s);
        for (TypeSqueeze& squeeze : squeezes) {
            squeeze.parameters.m *= 1e-6;
            squeeze.parameters.k *= 1e6;
        }
        const auto scaled = findOutliers(squeezes, u"A"_s);
        QVERIFY(indices(plain) == indices(scaled));
        QVERIFY(std::abs(plain[0].deviations / scaled[0].deviations - 1) < 1e-6); // rounding of logs of 1e6
    }
};

GRIPSCOPE_TEST(SqueezeOutliersTest)
#include "squeeze_outliers_test.moc"
