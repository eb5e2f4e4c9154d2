// SPDX-License-Identifier: GPL-3.0-or-later
// Residuals that are not white: what output error says about its errors then, in repeated experiments.
#include "core/identification/noise/noise_model.h"
#include "core/identification/noise/residual_noise.h"
#include "core/identification/output_error/output_error.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <boost/math/distributions/binomial.hpp>

using namespace gripscope;
using test::Synthetic;

namespace {

/// Noise of the force channel reaches the record, not the object; position noise is e[t] = a e[t-1] + w[t].
struct Noise {
    double force = 0, correlation = 0;
};

Recording record(Synthetic synthetic, const Noise& noise)
{
    const double fit = synthetic.fitPercent;
    synthetic.fitPercent = 100;
    Recording recording = synthetic.make();
    double mean = 0;
    double power = 0;
    const auto count = static_cast<double>(recording.size());
    for (const double y : recording.position)
        mean += y / count;
    for (const double y : recording.position)
        power += (y - mean) * (y - mean) / count;
    const double deviation = std::sqrt(power) * (1 - fit / 100);
    GaussianNoise random(synthetic.seed + 900000);
    const double fresh = std::sqrt(1 - noise.correlation * noise.correlation);
    double e = random();
    for (double& y : recording.position) {
        e = noise.correlation * e + fresh * random();
        y += deviation * e;
    }
    for (double& u : recording.force)
        u += noise.force * random();
    return recording;
}

Estimate noiseEstimate(const Recording& recording)
{
    OutputErrorOptions options;
    options.sampleTime_s = recording.sampleTime_s;
    options.hold = *recording.hold;
    return estimateOutputError(recording.force, recording.position, options);
}

} // namespace

class ResidualNoiseTest : public QObject {
    Q_OBJECT
private slots:
    void intervalsCover_data()
    {
        QTest::addColumn<double>("fit");
        QTest::addColumn<int>("samples");
        QTest::addColumn<double>("forceNoise");
        QTest::addColumn<double>("correlation");
        QTest::addColumn<bool>("straight");
        QTest::newRow("force noise 10 %, 400 samples") << 95.0 << 400 << 0.1 << 0.0 << false;
        QTest::newRow("force noise 10 %, 1000 samples") << 95.0 << 1000 << 0.1 << 0.0 << false;
        QTest::newRow("force noise 10 %, straight force") << 95.0 << 400 << 0.1 << 0.0 << true;
        QTest::newRow("correlated position noise, 400") << 90.0 << 400 << 0.0 << 0.8 << false;
        QTest::newRow("correlated position noise, 1000") << 90.0 << 1000 << 0.0 << 0.8 << false;
        QTest::newRow("white") << 90.0 << 400 << 0.0 << 0.0 << false;
    }
    void intervalsCover()
    {
        // Over 2,000 runs a setting: 95 to 96 % with force noise, 94 to 96 % with the correlated one, where
        // without a noise model it is 43 to 65 %. Here 120 to 200 runs, and the binomial bound around 93 to
        // 97 %.
        QFETCH(double, fit);
        QFETCH(int, samples);
        QFETCH(double, forceNoise);
        QFETCH(double, correlation);
        QFETCH(bool, straight);
        const int runs = samples > 400 ? 120 : 200;
        std::array<int, 3> covered{};
        int modelled = 0;
        double deviation = 0;
        for (int run = 0; run < runs; ++run) {
            Synthetic synthetic;
            synthetic.seed = std::uint64_t(run) + 1;
            synthetic.samples = std::size_t(samples);
            synthetic.fitPercent = fit;
            synthetic.hold = straight ? ForceHold::First : ForceHold::Zero;
            const Estimate e = noiseEstimate(record(synthetic, {forceNoise, correlation}));
            QVERIFY(e.status == EstimateStatus::Converged);
            const Eigen::Vector3d z =
                (e.parameters->vector() - synthetic.truth.vector()).cwiseQuotient(*e.standardErrors());
            for (std::size_t i = 0; i < 3; ++i)
                covered[i] += std::abs(z(Eigen::Index(i))) < 1.959964 ? 1 : 0;
            modelled += e.noise ? 1 : 0;
            if (e.noise && e.noise->forceDeviation)
                deviation += *e.noise->forceDeviation;
        }
        const boost::math::binomial least(runs, 0.93);
        const boost::math::binomial most(runs, 0.97);
        for (const int count : covered) {
            QVERIFY2(count >= boost::math::quantile(least, 1e-3) &&
                         count <= boost::math::quantile(boost::math::complement(most, 1e-3)),
                     qPrintable(QString::number(count)));
        }
        const bool white = forceNoise == 0 && correlation == 0;
        // White records pass for coloured once in 300 at the stated rates; 6 of 200 is beyond 1 in 10,000.
        QVERIFY2(white ? modelled <= 6 : modelled >= runs * 0.9, qPrintable(QString::number(modelled)));
        if (forceNoise > 0)
            QVERIFY(std::abs(deviation / modelled / forceNoise - 1) < 0.1);
    }
    void whiteResidualsKeepTheCramerRaoCovariance()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 90;
        const Estimate e = noiseEstimate(synthetic.make());
        QVERIFY(!e.noise);
        QCOMPARE(*e.residuals.errorInflation, 1.0);
    }
    void scaleDoesNotMatter()
    {
        Synthetic synthetic;
        synthetic.fitPercent = 95;
        const Recording recording = record(synthetic, {0.1, 0});
        const Estimate e = noiseEstimate(recording);
        QVERIFY(e.noise && e.noise->forceDeviation);
        for (const double scale : {1e-6, 1e6}) {
            Recording scaled = recording;
            for (double& u : scaled.force)
                u *= scale;
            for (double& y : scaled.position)
                y /= scale;
            const Estimate s = noiseEstimate(scaled);
            QVERIFY(s.noise && s.noise->forceDeviation);
            QVERIFY(std::abs(*s.noise->forceDeviation / scale / *e.noise->forceDeviation - 1) < 1e-6);
            const Eigen::Vector3d ratio = s.standardErrors()->cwiseQuotient(*e.standardErrors());
            QVERIFY((ratio / (scale * scale)).cwiseAbs().maxCoeff() < 1 + 1e-6);
            QVERIFY((ratio / (scale * scale)).cwiseAbs().minCoeff() > 1 - 1e-6);
        }
    }
    void theResponseToForceIsThatOfTheSimulation()
    {
        const MassDampingStiffness object{0.04, 0.14, 0.1};
        for (const ForceHold hold : {ForceHold::Zero, ForceHold::First}) {
            const ForceResponse g = forceResponse(object, 0.05, hold);
            std::vector<double> force(50, 0.0);
            force[5] = 1; // a sample with others before it, as a straight force needs
            const std::vector<double> x = simulate(object, force, {0.05, hold, 0, 0, 0, 0});
            std::vector<double> h(50, 0.0);
            for (std::size_t t = 5; t < 50; ++t) {
                h[t] = (t < 8 ? g.b[t - 5] : 0) - g.a[1] * h[t - 1] - g.a[2] * h[t - 2];
                QVERIFY(std::abs(h[t] - x[t]) < 1e-12);
            }
        }
    }
};

GRIPSCOPE_TEST(ResidualNoiseTest)
#include "residual_noise_test.moc"
