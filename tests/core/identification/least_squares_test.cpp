// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/least_squares.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

/// Whole numbers, and the columns are independent.
Eigen::MatrixXd table()
{
    return Eigen::MatrixXd{{1, 2, 0}, {3, 1, 4}, {0, 5, 1}, {2, 2, 2}, {1, 0, 7}};
}

/// A few roundings of numbers below 10.
constexpr double rounding = 1e-13;

bool near(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return a.rows() == b.rows() && a.cols() == b.cols() && (a - b).cwiseAbs().maxCoeff() < rounding;
}

} // namespace

class LeastSquaresTest : public QObject {
    Q_OBJECT
private slots:
    void whatTheColumnsExplainAndWhatNot()
    {
        const Eigen::MatrixXd a = table();
        const Eigen::MatrixXd factors{{1, -2}, {3, 0.5}, {-1, 4}};
        // A vector that no column has a part in: a' r = 0, in whole numbers.
        Eigen::MatrixXd outside(5, 1);
        outside << -14, -12, -2, 25, 0;
        QVERIFY(near(a.transpose() * outside, Eigen::MatrixXd::Zero(3, 1)));
        Eigen::MatrixXd right = a * factors;
        right.col(1) += outside;
        const PivotedSolution solved = solvePivoted(a, right);
        QCOMPARE(solved.rank, 3);
        QVERIFY((solved.solution - factors).cwiseAbs().maxCoeff() < 1e-12);
        QVERIFY(solved.rest(0) < 1e-24);
        QVERIFY(std::abs(solved.rest(1) / outside.squaredNorm() - 1) < 1e-14);
        QVERIFY(std::abs(solved.explained(0) / (a * factors.col(0)).squaredNorm() - 1) < 1e-14);
    }
    void aColumnThatAddsNothingDoesNotCount()
    {
        Eigen::MatrixXd a(5, 4);
        a << table(), table().col(0) + 2 * table().col(1);
        const Eigen::VectorXd right = table() * Eigen::Vector3d(1, 2, 3);
        const PivotedSolution solved = solvePivoted(a, right);
        QCOMPARE(solved.rank, 3);
        QVERIFY(near(a * solved.solution, right));
        QCOMPARE((solved.solution.array() == 0).count(), 1);
    }
    void whatCountsIsForTheCallerToSay()
    {
        const Eigen::MatrixXd a = Eigen::Vector3d(100, 1, 0.01).asDiagonal();
        const Eigen::Vector3d right(1, 1, 1);
        QCOMPARE(solvePivoted(a, right).rank, 3);
        QCOMPARE(solvePivoted(a, right, {.relative = 1e-3}).rank, 2);
        QCOMPARE(solvePivoted(a, right, {.absolute = 2}).rank, 1);
        QCOMPARE(solvePivoted(a, right, {.absolute = 200}).rank, 0);
        QCOMPARE(solvePivoted(a, right, {.absolute = 2}).rest(0), 2.0);
    }
    void trianglesAndBases()
    {
        const Eigen::MatrixXd a = table();
        const Eigen::MatrixXd right = Eigen::MatrixXd{{1}, {0}, {2}, {0}, {3}};
        const Triangularized qr = triangularize(a, right);
        QVERIFY(near(qr.triangle.transpose() * qr.triangle, a.transpose() * a));
        QVERIFY(near(qr.triangle.transpose() * qr.right, a.transpose() * right));
        QVERIFY(qr.triangle.isUpperTriangular(0.0));
        QVERIFY(near(triangleOf(a), qr.triangle));
        const Eigen::MatrixXd basis = orthonormalColumns(a);
        QVERIFY(near(basis.transpose() * basis, Eigen::MatrixXd::Identity(3, 3)));
        QVERIFY(near(basis * qr.triangle, a));
        QVERIFY(near(inverseOfTriangle(qr.triangle) * qr.triangle, Eigen::MatrixXd::Identity(3, 3)));
    }
    void dampingShortensTheStep()
    {
        // (R'R + damping D^2) d = R'c, here with diagonals: d = r c / (r^2 + damping s^2).
        const Eigen::MatrixXd r = Eigen::Vector2d(2, 1e-6).asDiagonal();
        const Eigen::VectorXd step =
            dampedLeastSquares(r, Eigen::Vector2d(6, 3e-6), Eigen::Vector2d(2, 1e-6), 0.5);
        QVERIFY(std::abs(step(0) - 2) < 1e-14 && std::abs(step(1) - 2) < 1e-14);
    }
};

GRIPSCOPE_TEST(LeastSquaresTest)
#include "least_squares_test.moc"
