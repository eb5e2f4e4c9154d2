// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/binomial_evidence.h"
#include "core/math/gaussian.h"
#include "core/recognition/types/gates.h"
#include "tests/support/test_registry.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <QTest>

#include <cmath>
#include <vector>

using namespace gripscope;
using namespace Qt::StringLiterals;

class GatesTest : public QObject {
    Q_OBJECT
private slots:
    void toleranceGateReachesAsFarAsComputedElsewhere()
    {
        // Four types, 99 % with 95 % confidence.
        QVERIFY(std::abs(std::sqrt(*toleranceGate(10, 36, 0.01, 0.95)) - 4.4) < 0.06);
        QVERIFY(std::abs(std::sqrt(*toleranceGate(5, 16, 0.01, 0.95)) - 5.8) < 0.1);
        // With everything known it is the chi-square quantile, 11.345.
        QVERIFY(std::abs(*toleranceGate(1'000'000, 1e5, 0.01, 0.95) / 11.345 - 1) < 0.02);
    }
    void toleranceGateFallsWithWhatIsKnownAndIsSmoothBetweenNodes()
    {
        double last = *toleranceGate(5, 3, 0.01, 0.95);
        for (const double v : {4.0, 5.5, 8.0, 12.0, 16.0, 17.0, 19.2, 30.0, 100.0}) {
            const double gate = *toleranceGate(5, v, 0.01, 0.95);
            QVERIFY(gate < last);
            last = gate;
        }
        QVERIFY(!toleranceGate(5, 2.9, 0.01, 0.95));
        QVERIFY(!toleranceGate(0, 20, 0.01, 0.95));
        QVERIFY(!toleranceGate(5, 20, 0, 0.95));
        QVERIFY(!toleranceGate(5, 20, 0.01, 1));
    }
    void toleranceGateKeepsItsPromise()
    {
        // Each enrolment's own rejected share, counted on 20,000 squeezes.
        constexpr int enrolments = 1000, points = 20'000, n = 5, v = 16;
        const double gate = *toleranceGate(n, v, 0.01, 0.95);
        GaussianNoise noise(3);
        Eigen::Matrix3Xd cloud(3, points);
        for (double& value : cloud.reshaped())
            value = noise();
        int kept = 0;
        for (int run = 0; run < enrolments; ++run) {
            Eigen::Matrix3d w = Eigen::Matrix3d::Zero();
            for (int i = 0; i < v; ++i) {
                const Eigen::Vector3d z(noise(), noise(), noise());
                w += z * z.transpose() / v;
            }
            const Eigen::Vector3d mean = Eigen::Vector3d(noise(), noise(), noise()) / std::sqrt(double(n));
            const Eigen::Matrix3d factor = w.llt().matrixL();
            const Eigen::Matrix3d inverse =
                factor.triangularView<Eigen::Lower>().solve(Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
            const auto distances =
                ((inverse * cloud).colwise() - inverse * mean).colwise().squaredNorm().array();
            kept += (distances > gate).count() <= points / 100;
        }
        // Promised 95 %: 950 +- 7 (1 sd), and 0.2 % for the gate's own draws. A count of 20,000 at the edge
        // errs either way alike.
        QVERIFY2(kept > 925 && kept < 975, qPrintable(QString::number(kept)));
    }
    void heavyTailsWiden()
    {
        // 1.8 F(0.99; 3, 5) = 21.71 over the chi-square quantile 11.345.
        QVERIFY(std::abs(heavyTailFactor(0.01) - 21.71 / 11.345) < 0.002);
        QVERIFY(heavyTailFactor(0.001) > heavyTailFactor(0.01));
        QCOMPARE(heavyTailFactor(0.5), 1.0);
    }
    void binomialBoundsAreThoseOfClopperAndPearson()
    {
        QVERIFY(std::abs(binomialEvidence(0, 40).highest - (1 - std::pow(0.05, 1.0 / 40))) < 1e-12);
        QVERIFY(std::abs(binomialEvidence(0, 30).highest - 0.0950) < 1e-4);
        const BinomialEvidence some = binomialEvidence(5, 100); // tables: 1.99 % to 10.23 %
        QVERIFY(std::abs(some.lowest - 0.0199) < 1e-4);
        QVERIFY(std::abs(some.highest - 0.1023) < 1e-4);
        QCOMPARE(binomialEvidence(7, 7).highest, 1.0);
        QCOMPARE(binomialEvidence(0, 0).highest, 1.0);
        QCOMPARE(binomialEvidence(8, 7).trials, std::int64_t(0));
        QCOMPARE(*trialsNeeded(0.01), std::int64_t(299));
        QCOMPARE(*trialsNeeded(0.001), std::int64_t(2995));
        QVERIFY(!trialsNeeded(0));
        QVERIFY(!trialsNeeded(1e-300));
    }
    void binomialEvidenceInWords()
    {
        QCOMPARE(
            inWords(binomialEvidence(0, 40), 0.001).describe(),
            u"0 wrong of 40: at most 7.2 % with 95 % confidence; 2995 without one are needed to show 0.1 %."_s);
        QCOMPARE(inWords(binomialEvidence(0, 3000), 0.001).describe(),
                 u"0 wrong of 3000: at most 0.1 % with 95 % confidence."_s);
    }
};

GRIPSCOPE_TEST(GatesTest)
#include "gates_test.moc"
