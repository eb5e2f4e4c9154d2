// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model/response_sensitivities.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using test::Synthetic;

namespace {

const MassDampingStiffness can{0.04, 0.14, 0.10};

SensitivityOptions sampled(ForceHold hold)
{
    SensitivityOptions options;
    options.sampleTime_s = 0.05;
    options.hold = hold;
    return options;
}

std::vector<double> force()
{
    return Synthetic().make().force;
}

} // namespace

class ResponseSensitivitiesTest : public QObject {
    Q_OBJECT
private slots:
    void theyAreTheDerivativesOfTheSimulation_data()
    {
        QTest::addColumn<bool>("held");
        QTest::addColumn<double>("damping");
        for (const bool held : {true, false}) {
            QTest::addRow("ringing, held %d", held) << held << 0.01;
            QTest::addRow("overdamped, held %d", held) << held << 0.4;
            QTest::addRow("faster than the samples, held %d", held) << held << 8e-4;
        }
    }
    void theyAreTheDerivativesOfTheSimulation()
    {
        QFETCH(bool, held);
        QFETCH(double, damping);
        const ForceHold hold = held ? ForceHold::Zero : ForceHold::First;
        const bool fast = damping < 1e-3; // natural frequency times sample time 2.5
        const MassDampingStiffness truth{fast ? 4e-5 : 0.04, damping, 0.10};
        const ResponseSensitivities found = responseSensitivities(truth, force(), sampled(hold));
        QVERIFY(found.finite);
        const std::vector<double> position = simulate(truth, force(), {0.05, hold});
        // Central differences: truncation h^2, rounding 1e-16 / h.
        constexpr double h = 1e-5;
        for (Eigen::Index i = 0; i < 3; ++i) {
            Eigen::Vector3d up = truth.vector(), down = truth.vector();
            up(i) *= std::exp(h);
            down(i) *= std::exp(-h);
            const auto above = simulate({up(0), up(1), up(2)}, force(), {0.05, hold});
            const auto below = simulate({down(0), down(1), down(2)}, force(), {0.05, hold});
            const double size = found.parameters.col(i).cwiseAbs().maxCoeff();
            for (std::size_t t = 0; t < position.size(); ++t) {
                const auto row = static_cast<Eigen::Index>(t);
                QVERIFY(std::abs(found.position(row) - position[t]) < 1e-10);
                QVERIFY(std::abs(found.parameters(row, i) - (above[t] - below[t]) / (2 * h)) < 1e-7 * size);
            }
        }
    }
    void theBoundScalesAsUnitsDo()
    {
        // Kilograms in milligrams and seconds in microseconds leave the relative bound as it is.
        const Eigen::Vector3d plain =
            cramerRaoBound(can, force(), sampled(ForceHold::Zero), 0.1)->cwiseQuotient(can.vector());
        SensitivityOptions micro = sampled(ForceHold::Zero);
        micro.sampleTime_s *= 1e6;
        const MassDampingStiffness scaled{can.m * 1e6 * 1e12, can.b * 1e6 * 1e6, can.k * 1e6};
        const Eigen::Vector3d relative =
            cramerRaoBound(scaled, force(), micro, 0.1e-6)->cwiseQuotient(scaled.vector());
        QVERIFY((relative - plain).norm() < 1e-8 * plain.norm());
    }
    void whatIsFreeCostsAndNeverPays()
    {
        SensitivityOptions options = sampled(ForceHold::Zero);
        const Eigen::Vector3d free = *cramerRaoBound(can, force(), options, 0.1);
        options.freeInitialState = options.freeOffset = false;
        const Eigen::Vector3d rest = *cramerRaoBound(can, force(), options, 0.1);
        QVERIFY((free.array() >= rest.array()).all());
        // A binary sequence hardly pays for the offset (science: nothing to speak of).
        QVERIFY((free.array() < 1.25 * rest.array()).all());
    }
    void aForceThatSaysTooLittleHasNoBound()
    {
        const std::vector<double> constant(400, 1.0);
        QVERIFY(!cramerRaoBound(can, constant, sampled(ForceHold::Zero), 0.1));
        QVERIFY(!cramerRaoBound(can, std::vector<double>(400, 0.0), sampled(ForceHold::Zero), 0.1));
        QVERIFY(!cramerRaoBound(can, {}, sampled(ForceHold::Zero), 0.1));
        for (const double extreme : {1e-300, 1e300}) {
            const MassDampingStiffness odd{extreme, 1, 1};
            const ResponseSensitivities found = responseSensitivities(odd, force(), sampled(ForceHold::Zero));
            QVERIFY(found.position.size() == 400);
        }
    }
};

GRIPSCOPE_TEST(ResponseSensitivitiesTest)
#include "response_sensitivities_test.moc"
