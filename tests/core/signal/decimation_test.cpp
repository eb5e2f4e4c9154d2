// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/decimation.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <numeric>

using namespace gripscope;

class DecimationTest : public QObject {
    Q_OBJECT
private slots:
    void shortInputStaysAsItIs()
    {
        const std::vector<double> x{0, 1, 2, 3};
        const std::vector<double> y{5, -1, 7, 2};
        const std::vector<PlotPoint> points = decimateMinMax(x, y, 2);
        QCOMPARE(points.size(), std::size_t(4));
        QVERIFY((points[2] == PlotPoint{2, 7}));
    }
    void aSinglePeakSurvives()
    {
        std::vector<double> x(100000);
        std::iota(x.begin(), x.end(), 0.0);
        std::vector<double> y(x.size(), 1.0);
        y[54321] = 9;
        y[54322] = -9;
        const std::vector<PlotPoint> points = decimateMinMax(x, y, 300);
        QVERIFY(points.size() <= 600);
        QVERIFY(std::find(points.begin(), points.end(), PlotPoint{54321, 9}) != points.end());
        QVERIFY(std::find(points.begin(), points.end(), PlotPoint{54322, -9}) != points.end());
        QVERIFY(std::is_sorted(points.begin(), points.end(), [](auto a, auto b) { return a.x < b.x; }));
    }
};

GRIPSCOPE_TEST(DecimationTest)
#include "decimation_test.moc"
