// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/arx/arx.h"
#include "core/identification/model/discretization.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <Eigen/LU>
#include <QTest>

using namespace gripscope;

namespace {

/// a1, a2, b1 + b2 of the held-force model.
Eigen::Vector3d exactCoefficients(const MassDampingStiffness& p, double sampleTime_s)
{
    const ExactStep<2> d = discretize(p, sampleTime_s, ForceHold::Zero);
    const double a1 = -d.phi.trace();
    const double a2 = d.phi.determinant();
    return {a1, a2, (1 + a1 + a2) / p.k};
}

using Mapping = std::optional<MassDampingStiffness> (*)(double, double, double, double);

Eigen::Matrix3d numericalJacobian(Mapping mapping, const Eigen::Vector3d& c, double sampleTime_s)
{
    Eigen::Matrix3d jacobian;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double step = 1e-6 * std::abs(c(i));
        Eigen::Vector3d above = c;
        Eigen::Vector3d below = c;
        above(i) += step;
        below(i) -= step;
        jacobian.col(i) = (mapping(above(0), above(1), above(2), sampleTime_s)->vector() -
                           mapping(below(0), below(1), below(2), sampleTime_s)->vector()) /
                          (2 * step);
    }
    return jacobian;
}

} // namespace

class ArxMappingTest : public QObject {
    Q_OBJECT
private slots:
    void polesGiveBackTheObject_data()
    {
        QTest::addColumn<double>("damping");
        for (const double damping : {0.05, 0.5, 0.9999, 1.0, 1.0001, 1.5, 4.0})
            QTest::addRow("damping ratio %g", damping) << damping;
    }
    void polesGiveBackTheObject()
    {
        QFETCH(double, damping);
        const double w = 10;
        const double t = 0.05;
        const MassDampingStiffness p{0.04, 2 * damping * w * 0.04, w * w * 0.04};
        const Eigen::Vector3d c = exactCoefficients(p, t);
        const std::optional<MassDampingStiffness> back = poleMapping(c(0), c(1), c(2), t);
        QVERIFY(back.has_value());
        // 1 + a1 + a2 and the angle of the poles cancel three to four digits here.
        QVERIFY2(test::relativeDifference(*back, p) < 1e-11,
                 qPrintable(QString::number(test::relativeDifference(*back, p))));
    }
    void centralDifferencesGiveBackTheObject()
    {
        const MassDampingStiffness p{0.04, 0.14, 0.1};
        const double t = 0.05;
        const double d = p.m / t / t + p.b / 2 / t;
        const std::optional<MassDampingStiffness> back =
            centralDifferenceMapping((p.k - 2 * p.m / t / t) / d, (p.m / t / t - p.b / 2 / t) / d, 1 / d, t);
        QVERIFY(back.has_value());
        QVERIFY(test::relativeDifference(*back, p) < 1e-12);
    }
    void derivativesAreThoseOfTheMappings_data() { polesGiveBackTheObject_data(); }
    void derivativesAreThoseOfTheMappings()
    {
        QFETCH(double, damping);
        const double t = 0.05;
        const double w = 10;
        const Eigen::Vector3d c = exactCoefficients({0.04, 2 * damping * w * 0.04, w * w * 0.04}, t);
        const Eigen::Matrix3d poles = poleJacobian(c(0), c(1), c(2), t);
        QVERIFY((poles - numericalJacobian(poleMapping, c, t)).norm() < 1e-5 * poles.norm());
        const Eigen::Matrix3d central = centralDifferenceJacobian(c(0), c(1), c(2), t);
        QVERIFY((central - numericalJacobian(centralDifferenceMapping, c, t)).norm() < 1e-6 * central.norm());
    }
    void whatIsNoObjectIsRefused()
    {
        QVERIFY(!centralDifferenceMapping(-1.8, 0.84, -0.05, 0.05)); // negative gain
        QVERIFY(!centralDifferenceMapping(-1.8, 1.01, 0.05, 0.05));  // grows
        QVERIFY(!centralDifferenceMapping(-1.9, 0.84, 0.05, 0.05));  // negative stiffness
        QVERIFY(!poleMapping(-0.7, -0.2, 0.2, 0.05));                // a pole on the negative axis
        QVERIFY(!poleMapping(1.96, 0.95, 0.2, 0.05));                // both of them
        QVERIFY(!poleMapping(-1.99, 0.95, 0.2, 0.05));               // unstable
        QVERIFY(!poleMapping(-1.8, 0.84, -0.2, 0.05));
        QVERIFY(!poleMapping(std::nan(""), 0.84, 0.2, 0.05));
        QVERIFY(!centralDifferenceMapping(-1.8, std::nan(""), 0.2, 0.05));
    }
};

GRIPSCOPE_TEST(ArxMappingTest)
#include "arx_mapping_test.moc"
