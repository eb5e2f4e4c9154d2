// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/map_training.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <limits>

using namespace gripscope;

namespace {

/// Ward's clustering as its definition has it: every pair is tried before every merge.
std::vector<int> byTryingAllPairs(const Eigen::MatrixXd& points, const Eigen::VectorXd& items, int groups)
{
    std::vector<std::vector<int>> members;
    for (int i = 0; i < int(points.rows()); ++i)
        members.push_back({i});
    const auto inertia = [&](const std::vector<int>& group) {
        Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(points.cols());
        double count = 0;
        for (const int i : group) {
            mean += items(i) * points.row(i);
            count += items(i);
        }
        mean /= count;
        double sum = 0;
        for (const int i : group)
            sum += items(i) * (points.row(i) - mean).squaredNorm();
        return sum;
    };
    while (int(members.size()) > groups) {
        double least = std::numeric_limits<double>::infinity();
        std::size_t one = 0;
        std::size_t other = 0;
        for (std::size_t a = 0; a < members.size(); ++a)
            for (std::size_t b = a + 1; b < members.size(); ++b) {
                std::vector<int> both = members[a];
                both.insert(both.end(), members[b].begin(), members[b].end());
                const double raised = inertia(both) - inertia(members[a]) - inertia(members[b]);
                if (raised < least) {
                    least = raised;
                    one = a;
                    other = b;
                }
            }
        members[one].insert(members[one].end(), members[other].begin(), members[other].end());
        members.erase(members.begin() + std::ptrdiff_t(other));
    }
    // The group of the lowest point comes first: groups stay in that order by merging into the earlier one.
    std::vector<int> found(std::size_t(points.rows()));
    for (std::size_t g = 0; g < members.size(); ++g)
        for (const int i : members[g])
            found[std::size_t(i)] = int(g);
    return found;
}

} // namespace

class UnitGroupsTest : public QObject {
    Q_OBJECT
private slots:
    void mergesWhatRaisesTheInertiaLeast()
    {
        GaussianNoise noise(4);
        for (int table = 0; table < 20; ++table) {
            Eigen::MatrixXd points(15, 2);
            Eigen::VectorXd items(15);
            for (int i = 0; i < 15; ++i) {
                points.row(i) << noise(), noise();
                items(i) = 1 + int(5 * noise.uniform());
            }
            for (const int groups : {1, 2, 4, 9})
                QCOMPARE(wardGroups(points, items, groups), byTryingAllPairs(points, items, groups));
        }
    }
    void heavyPointsStayApart()
    {
        // 0 and 1 are nearest, but each stands for 1,000 items: merging costs 500; 5 joins 1 for about 16.
        const Eigen::Vector3d points(0, 1, 5);
        QCOMPARE(wardGroups(points, Eigen::Vector3d(1000, 1000, 1), 2), (std::vector<int>{0, 1, 1}));
        QCOMPARE(wardGroups(points, Eigen::Vector3d(1, 1, 1), 2), (std::vector<int>{0, 0, 1}));
    }
    void moreGroupsThanPointsLeavesThePointsAlone()
    {
        QCOMPARE(wardGroups(Eigen::Vector2d(3, 1), Eigen::Vector2d(1, 1), 4), (std::vector<int>{0, 1}));
        QCOMPARE(wardGroups(Eigen::MatrixXd(0, 2), Eigen::VectorXd(0), 4), std::vector<int>());
    }
};

GRIPSCOPE_TEST(UnitGroupsTest)
#include "unit_groups_test.moc"
