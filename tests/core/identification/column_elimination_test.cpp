// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/decompositions.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;

namespace {

SmallMatrix noise(Eigen::Index rows, Eigen::Index columns)
{
    GaussianNoise random(11);
    SmallMatrix matrix(rows, columns);
    for (Eigen::Index i = 0; i < matrix.size(); ++i)
        matrix.data()[i] = random();
    return matrix;
}

} // namespace

class ColumnEliminationTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsLeftIsOrthogonalToWhatWasTakenOut()
    {
        SmallMatrix a = noise(12, 7);
        a.col(1) *= 1e9; // units do not matter
        const ColumnElimination e = eliminateColumns(a, 3, 1e-12);
        QCOMPARE(e.rank, 3);
        const Eigen::MatrixXd rest = a.rightCols(4) - a.leftCols(3) * e.solution;
        for (Eigen::Index j = 0; j < 3; ++j)
            QVERIFY((a.col(j).transpose() * rest).norm() < 1e-12 * a.col(j).norm());
        QVERIFY((e.rest.transpose() * e.rest - rest.transpose() * rest).norm() < 1e-12);
        const SmallMatrix taken = a.leftCols(3) * e.solution;
        QVERIFY((e.taken.transpose() * e.taken - taken.transpose() * taken).norm() < 1e-11);
    }
    void dependentColumnsDoNotCount()
    {
        SmallMatrix a = noise(8, 5);
        a.col(1) = -3 * a.col(0);
        a.col(2).setZero();
        const ColumnElimination e = eliminateColumns(a, 3, 1e-12);
        QCOMPARE(e.rank, 1);
        QVERIFY(e.solution.allFinite());
        const Eigen::VectorXd rest = a.col(4) - a.leftCols(3) * e.solution.col(1);
        QVERIFY(std::abs(a.col(0).dot(rest)) < 1e-13);
        QCOMPARE(e.rest.rows(), 7);
    }
    void nothingToEliminateLeavesEverything()
    {
        const SmallMatrix a = noise(4, 3);
        const ColumnElimination e = eliminateColumns(a, 0, 1e-12);
        QCOMPARE(e.rank, 0);
        QVERIFY(e.rest == a);
    }
    void inOrderTheColumnsBecomeATriangle()
    {
        const SmallMatrix a = noise(9, 4);
        const SmallMatrix r = eliminateOrdered(a, 3);
        QVERIFY(r.leftCols(3).isUpperTriangular(0));
        QVERIFY((r.transpose() * r - a.transpose() * a).norm() < 1e-13 * a.squaredNorm());
    }
};

GRIPSCOPE_TEST(ColumnEliminationTest)
#include "column_elimination_test.moc"
