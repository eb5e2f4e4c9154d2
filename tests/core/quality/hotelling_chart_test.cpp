// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random_stream.h"
#include "core/quality/charts/hotelling_chart.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

class HotellingChartTest : public QObject {
    Q_OBJECT
private:
    /// Fertility, agriculture and examination of the first 14 provinces of R's `swiss`.
    const std::vector<std::vector<double>> m_swiss{
        {80.2, 83.1, 92.5, 85.8, 76.9, 76.1, 83.8, 92.4, 82.4, 82.9, 87.1, 64.1, 66.9, 68.9},
        {17.0, 45.1, 39.7, 36.5, 43.5, 35.3, 70.2, 67.8, 53.3, 45.2, 64.5, 62.0, 67.5, 60.7},
        {15, 6, 5, 12, 17, 9, 16, 14, 12, 16, 14, 21, 14, 19}};

    static bool near(double found, double expected) { return std::abs(found - expected) < 1e-7; }
    /// The share of points beyond their limits over many tables that nothing is wrong with.
    static double falseAlarms(std::size_t groups, std::size_t size, std::size_t phaseOne, bool later)
    {
        RandomStream random(4, 0, 0);
        int beyond = 0, points = 0;
        for (int table = 0; table < 3000; ++table) {
            std::vector<std::vector<double>> columns(2);
            for (std::size_t i = 0; i < groups * size; ++i) {
                const double common = random.normal();
                columns[0].push_back(10 + common);
                columns[1].push_back(common + 0.5 * random.normal());
            }
            const HotellingStudy study =
                studyHotelling(SubgroupLayout::consecutive(groups * size, size).value(), columns,
                               {0.05, phaseOne})
                    .value();
            for (std::size_t i = later ? phaseOne : 0; i < (later ? groups : phaseOne); ++i, ++points)
                beyond += study.points[i].signal();
        }
        return double(beyond) / points;
    }

private slots:
    /// mahalanobis(), qbeta() and qf() of R 4.2.
    void individualsAreThoseOfR()
    {
        const HotellingStudy study =
            studyHotelling(SubgroupLayout::consecutive(14, 1).value(), m_swiss, {0.0027, 12}).value();
        const std::vector<double> expected{5.814202739, 3.581674907, 3.261319759, 1.011808772, 1.118676423,
                                           3.200644838, 2.017311023, 3.491211437, 0.313893311, 1.082328989,
                                           1.413005898, 6.693921904, 9.579317212, 3.872955622};
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QVERIFY(near(study.points[i].tSquared, expected[i]));
            QVERIFY(near(study.points[i].upper, i < 12 ? 8.210851484 : 41.660370586));
        }
        QVERIFY(!study.messages.empty());
    }
    void subgroupsAreThoseOfR()
    {
        const HotellingStudy study =
            studyHotelling(SubgroupLayout::consecutive(14, 2).value(), {m_swiss[0], m_swiss[1]}, {0.0027, {}})
                .value();
        const std::vector<double> expected{11.475173092, 9.246878996, 3.763322007, 10.882253697,
                                           0.345339833,  6.232189453, 13.763352240};
        for (std::size_t i = 0; i < expected.size(); ++i) {
            QVERIFY(near(study.points[i].tSquared, expected[i]));
            QVERIFY(near(study.points[i].upper, 37.088693801));
        }
    }
    void limitsHoldWhatTheyPromise()
    {
        QVERIFY(std::abs(falseAlarms(15, 1, 15, false) - 0.05) < 0.005);
        QVERIFY(std::abs(falseAlarms(20, 1, 15, true) - 0.05) < 0.01);
        QVERIFY(std::abs(falseAlarms(8, 3, 8, false) - 0.05) < 0.006);
        QVERIFY(std::abs(falseAlarms(10, 3, 8, true) - 0.05) < 0.012);
    }
    void theColumnThatMovedIsNamed()
    {
        HotellingReference known;
        known.mean = Eigen::Vector3d(1, 2, 3);
        known.covariance = Eigen::Vector3d(1, 4, 9).asDiagonal();
        const HotellingChart chart = HotellingChart::of(known).value();
        const HotellingPoint point = chart.at(Eigen::Vector3d(1, 14, 3)).value();
        QVERIFY(near(point.tSquared, 36) && near(point.contribution, 36) && point.column == 1);
        QVERIFY(point.signal());
        QVERIFY(std::abs(point.upper - 14.1563) < 1e-3); // chi^2 of three at 99.73 %
        QVERIFY(!chart.at(Eigen::Vector2d(1, 2)));
        QVERIFY(!chart.at(Eigen::Vector3d(1, std::nan(""), 3)));
        QVERIFY(near(hotellingRunLength(3, 0.0027, 0), 1 / 0.0027));
        QVERIFY(hotellingRunLength(3, 0.0027, 1) < 200 && hotellingRunLength(1, 0.0027, 1) > 43);
        QVERIFY(std::abs(hotellingRunLength(1, 0.002699796, 1) - 43.8947) < 0.01); // Shewhart's
    }
    void badInputIsSaid()
    {
        const SubgroupLayout rows = SubgroupLayout::consecutive(14, 1).value();
        std::vector<std::vector<double>> columns{m_swiss[0], m_swiss[0]};
        for (double& value : columns[1])
            value = 3 * value - 7;
        const auto collinear = studyHotelling(rows, columns, {});
        QVERIFY(!collinear && collinear.error().describe().contains(QStringLiteral("follows from")));
        columns[1].assign(14, 2.0);
        QVERIFY(!studyHotelling(rows, columns, {}));
        QVERIFY(!studyHotelling(rows, m_swiss, {0.0027, 3}));
        QVERIFY(!studyHotelling(rows, m_swiss, {0, {}}));
        QVERIFY(!studyHotelling(rows, {}, {}));
        columns[1].pop_back();
        QVERIFY(!studyHotelling(rows, columns, {}));
    }
};

GRIPSCOPE_TEST(HotellingChartTest)
#include "hotelling_chart_test.moc"
