// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/gaussian.h"
#include "core/math/sequential_qr.h"
#include "tests/support/test_registry.h"

#include <Eigen/Dense>
#include <QTest>

#include <limits>

using namespace gripscope;

class SequentialQrTest : public QObject {
    Q_OBJECT
private slots:
    void theTriangleIsThatOfTheWholeMatrix_data()
    {
        QTest::addColumn<int>("rows");
        for (const int rows : {1, 4, 5, 127, 128, 129, 1000})
            QTest::addRow("%d rows", rows) << rows;
    }
    void theTriangleIsThatOfTheWholeMatrix()
    {
        QFETCH(int, rows);
        GaussianNoise noise(5);
        Eigen::MatrixXd matrix(rows, 5);
        SequentialQr qr(5);
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < 5; ++j)
                matrix(i, j) = noise();
            qr.nextRow() = matrix.row(i);
        }
        const Eigen::MatrixXd r = qr.triangle();
        QVERIFY(r.isUpperTriangular(0));
        const Eigen::MatrixXd gram = matrix.transpose() * matrix;
        QVERIFY((r.transpose() * r - gram).norm() < 1e-13 * gram.norm());
    }
    void whatIsTakenOutOfRowsLeavesTheResidualsPower()
    {
        // Recursive residuals: no row is left of those that determine the columns, and the squares of the
        // others add up to those of the regression's residuals.
        GaussianNoise noise(6);
        constexpr int rows = 30;
        Eigen::MatrixXd matrix(rows, 4);
        SequentialQr qr(4);
        Eigen::Matrix2d left = Eigen::Matrix2d::Zero();
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < 4; ++j)
                matrix(i, j) = noise();
            qr.nextRow() = matrix.row(i);
            const Eigen::Vector2d rest = qr.takeOut(2);
            QVERIFY(i > 1 || rest.norm() < 1e-14);
            left += rest * rest.transpose();
        }
        const Eigen::MatrixXd regressors = matrix.leftCols(2);
        const Eigen::MatrixXd others = matrix.rightCols(2);
        const Eigen::MatrixXd rest = others - regressors * regressors.householderQr().solve(others);
        QVERIFY((left - rest.transpose() * rest).norm() < 1e-13 * left.norm());
    }
    void nothingIsSquared()
    {
        // Two columns that differ by 1e-10: the normal equations would see no difference.
        SequentialQr qr(2);
        double xx = 0;
        double xe = 0;
        double ee = 0;
        for (int i = 0; i < 500; ++i) {
            const double x = 1 + 0.01 * (i % 7);
            xx += x * x;
            xe += x * (i % 2);
            ee += i % 2;
            auto row = qr.nextRow();
            row(0) = x;
            row(1) = x + 1e-10 * (i % 2);
        }
        const Eigen::MatrixXd r = qr.triangle();
        QVERIFY(std::abs(std::abs(r(1, 1)) / (1e-10 * std::sqrt(ee - xe * xe / xx)) - 1) < 1e-5);
    }
    void theConditionDoesNotDependOnTheColumnsUnits()
    {
        Eigen::Matrix2d a;
        a << 1, 0.5, 0, 1;
        const double condition = scaledConditionNumber(a);
        a.col(1) *= 1e9;
        QVERIFY(std::abs(scaledConditionNumber(a) - condition) < 1e-9);
        a.col(1).setZero();
        QVERIFY(scaledConditionNumber(a) == std::numeric_limits<double>::infinity());
    }
};

GRIPSCOPE_TEST(SequentialQrTest)
#include "sequential_qr_test.moc"
