// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/frequency/frequency_response.h"
#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/math/normal_interval.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace gripscope;

namespace {

/// Time in samples: a natural frequency of 0.3 radians a sample, forgotten after some ten of them.
constexpr MassDampingStiffness part{1, 0.42, 0.09};

std::vector<double> noiseOf(std::size_t count, std::uint64_t seed)
{
    GaussianNoise random(seed);
    std::vector<double> values(count);
    for (double& value : values)
        value = random();
    return values;
}

struct Record {
    std::vector<double> force, position;
};

/// White force, and as much white noise on the position (which moves by some four).
Record noisyRecord(std::size_t count, const ResponseSampling& sampling)
{
    Record record{noiseOf(count, 1), {}};
    record.position = simulate(part, record.force, {sampling.sampleTime_s, sampling.hold, sampling.lag_s});
    const std::vector<double> noise = noiseOf(count, 2);
    for (std::size_t i = 0; i < count; ++i)
        record.position[i] += 3 + noise[i];
    return record;
}

std::vector<double> frequenciesOf(const EmpiricalResponse& response)
{
    std::vector<double> result;
    for (const EmpiricalLine& line : response.lines)
        result.push_back(line.frequency_Hz);
    return result;
}

} // namespace

class FrequencyResponseTest : public QObject {
    Q_OBJECT
private slots:
    void theRecordShowsTheObjectAsWellAsItSays_data()
    {
        QTest::addColumn<bool>("held");
        QTest::addColumn<double>("lag");
        QTest::newRow("held") << true << 0.0;
        QTest::newRow("straight") << false << 0.0;
        QTest::newRow("held, lag") << true << 2.3;
    }
    void theRecordShowsTheObjectAsWellAsItSays()
    {
        QFETCH(bool, held);
        QFETCH(double, lag);
        const ResponseSampling sampling{1, held ? ForceHold::Zero : ForceHold::First, lag};
        const Record record = noisyRecord(std::size_t(40) * 2048, sampling);
        const EmpiricalResponse found = empiricalResponse(record.force, record.position, 1);
        QVERIFY(found.status == EmpiricalResponse::Status::Found);
        QCOMPARE(found.sectionSamples, std::size_t(2048));
        QCOMPARE(found.sections, std::size_t(79));
        const std::vector<ModelLine> truth =
            modelResponse(part, std::nullopt, sampling, frequenciesOf(found));
        QCOMPARE(truth.size(), found.lines.size());

        // Errors over their standard errors, of ln|G| and of the phase: mean square 1.
        double sum = 0, worst = 0;
        int count = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const EmpiricalLine& line = found.lines[i];
            QCOMPARE(line.relativeError.has_value(), line.coherence >= found.coherenceLimit);
            if (!line.relativeError)
                continue;
            QVERIFY(*line.relativeError <= EmpiricalResponse::largestRelativeError * (1 + 1e-12));
            const std::complex<double> error = std::log(line.response / truth[i].response);
            for (const double part : {error.real(), error.imag()}) {
                sum += part * part / (*line.relativeError * *line.relativeError);
                worst = std::max(worst, std::abs(part) / *line.relativeError);
                ++count;
            }
        }
        QVERIFY2(count > 600, qPrintable(QString::number(count)));
        // Squares of normal numbers have variance 2; neighbouring lines of a Hann window correlate by 2/3 and
        // 1/6, which makes their mean's larger by 1 + 2 (4/9 + 1/36). 0.07 for the coherence being
        // estimated itself (of the order of 1 / averages) and what sections remember of those before.
        const double deviation = std::sqrt(2 * (1 + 2 * (4.0 / 9 + 1.0 / 36)) / count);
        QVERIFY2(std::abs(sum / count - 1) < 5 * deviation + 0.07, qPrintable(QString::number(sum / count)));
        QVERIFY2(worst < 6, qPrintable(QString::number(worst))); // one in a hundred million each
    }
    void coherenceIsTheShareOfThePower()
    {
        const Record record = noisyRecord(std::size_t(40) * 2048, {1, ForceHold::Zero, 0});
        const EmpiricalResponse found = empiricalResponse(record.force, record.position, 1);
        const std::vector<ModelLine> truth =
            modelResponse(part, std::nullopt, {1, ForceHold::Zero, 0}, frequenciesOf(found));
        // Both spectra are white with variance 1, so that it is |G|^2 / (|G|^2 + 1); averaged over all lines
        // the errors of each (at most 0.06, the root of 2 g2 (1 - g2)^2 / n) are small.
        double difference = 0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double power = std::norm(truth[i].response);
            difference += (found.lines[i].coherence - power / (power + 1)) / double(truth.size());
        }
        QVERIFY2(std::abs(difference) < 0.02, qPrintable(QString::number(difference)));
        QVERIFY(found.lines.front().coherence > 0.95);
        QVERIFY(found.lines.back().coherence < found.coherenceLimit);
        QVERIFY(!found.lines.back().relativeError);
    }
    void lostSamplesTakeTheirSectionsAlong()
    {
        Record record = noisyRecord(std::size_t(7) * 2048, {1, ForceHold::Zero, 0});
        const EmpiricalResponse whole = empiricalResponse(record.force, record.position, 1);
        QCOMPARE(whole.sections, std::size_t(13));
        QVERIFY(std::abs(whole.averages - 169 / (13 + 24.0 / 36)) < 1e-12);
        record.position[5000] = 1e3; // made up
        const std::vector<std::size_t> lost{5000};
        const EmpiricalResponse rest = empiricalResponse(record.force, record.position, 1, lost);
        QCOMPARE(rest.sections, std::size_t(11)); // it is in two of them
        QVERIFY(std::abs(rest.averages - 121 / (11 + 18.0 / 36)) < 1e-12);
        QVERIFY(rest.lines.front().coherence > 0.9);
        QVERIFY(empiricalResponse(record.force, record.position, 1).lines.front().coherence < 0.9);
    }
    void whatTellsNothingSaysSo()
    {
        const Record record = noisyRecord(EmpiricalResponse::leastSamples, {1, ForceHold::Zero, 0});
        using Status = EmpiricalResponse::Status;
        QVERIFY(empiricalResponse(record.force, record.position, 1).status == Status::Found);
        const std::span<const double> force(record.force), position(record.position);
        const EmpiricalResponse shorter =
            empiricalResponse(force.first(force.size() - 1), position.first(force.size() - 1), 1);
        QVERIFY(shorter.status == Status::TooShort && shorter.lines.empty());
        const std::vector<double> still(force.size(), 20.0);
        QVERIFY(empiricalResponse(still, position, 1).status == Status::NotExcited);
        const EmpiricalResponse fixed = empiricalResponse(force, still, 1);
        QVERIFY(fixed.status == Status::Found && !fixed.lines.empty());
        for (const EmpiricalLine& line : fixed.lines)
            QVERIFY(line.coherence == 0 && line.response == 0.0 && !line.relativeError);
        std::vector<std::size_t> lost;
        for (std::size_t i = 10; i < force.size(); i += 20)
            lost.push_back(i);
        QVERIFY(empiricalResponse(force, position, 1, lost).status == Status::TooShort);
    }
    void aModelSampledFastIsTheContinuousOne()
    {
        const MassDampingStiffness can{0.0396, 43.0, 9990};
        const std::vector<double> frequencies = logarithmicFrequencies(1, 500, 40);
        const std::vector<ModelLine> lines =
            modelResponse(can, std::nullopt, {1e-5, ForceHold::First, 0}, frequencies);
        QCOMPARE(lines.size(), frequencies.size());
        QCOMPARE(frequencies.back(), 500.0);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double w = 2 * std::numbers::pi * frequencies[i];
            const std::complex<double> exact = 1.0 / std::complex<double>(can.k - can.m * w * w, can.b * w);
            // (w T)^2 / 12 is at most 8e-5.
            QVERIFY(std::abs(lines[i].response / exact - 1.0) < 1e-4);
            QVERIFY(lines[i].relativeError == 0 && lines[i].phaseError == 0);
            QVERIFY(i == 0 || lines[i].phase < lines[i - 1].phase); // without jumps
        }
    }
    void theBandIsThatOfTheParameters()
    {
        const Eigen::Vector3d values = part.vector();
        Eigen::Matrix3d relative;
        relative << 4, 1, -1, 1, 9, 2, -1, 2, 1;
        relative *= 1e-4;
        const Eigen::Matrix3d covariance = values.asDiagonal() * relative * values.asDiagonal();
        const std::vector<double> frequencies{1e-4, 0.03, 0.05, 0.2};
        const ResponseSampling sampling{1, ForceHold::Zero, 0.4};
        const std::vector<ModelLine> lines = modelResponse(part, covariance, sampling, frequencies);
        // So slow that only the spring counts.
        QVERIFY(std::abs(lines[0].relativeError - 0.01) < 1e-4);
        QVERIFY(lines[0].phaseError < 1e-3);

        const Eigen::Matrix3d root = relative.llt().matrixL();
        GaussianNoise random(3);
        constexpr int draws = 4000;
        std::vector<double> magnitude(frequencies.size()), phase(frequencies.size());
        for (int draw = 0; draw < draws; ++draw) {
            Eigen::Vector3d normal;
            for (double& value : normal)
                value = random();
            const Eigen::Vector3d p = values.array() * (root * normal).array().exp();
            const std::vector<ModelLine> other =
                modelResponse({p(0), p(1), p(2)}, std::nullopt, sampling, frequencies);
            for (std::size_t i = 0; i < lines.size(); ++i) {
                const std::complex<double> change = std::log(other[i].response / lines[i].response);
                magnitude[i] += change.real() * change.real() / draws;
                phase[i] += change.imag() * change.imag() / draws;
            }
        }
        for (std::size_t i = 1; i < lines.size(); ++i) {
            // Five standard deviations of a standard deviation from so many draws, and 2 % for second order.
            const double tolerance = 5 / std::sqrt(2.0 * draws) + 0.02;
            QVERIFY(std::abs(std::sqrt(magnitude[i]) / lines[i].relativeError - 1) < tolerance);
            QVERIFY(std::abs(std::sqrt(phase[i]) / lines[i].phaseError - 1) < tolerance);
        }
    }
    void whatIsNoObjectHasNoResponse()
    {
        const std::vector<double> frequencies{0.1};
        QVERIFY(modelResponse({0, 1, 1}, std::nullopt, {1, ForceHold::Zero, 0}, frequencies).empty());
        QVERIFY(modelResponse({1, 1, 1}, std::nullopt, {0, ForceHold::Zero, 0}, frequencies).empty());
        QVERIFY(modelResponse({1, 1, 1e300}, std::nullopt, {1, ForceHold::Zero, 0}, frequencies).empty());
        QVERIFY(logarithmicFrequencies(0, 1, 5).empty());
    }
};

GRIPSCOPE_TEST(FrequencyResponseTest)
#include "frequency_response_test.moc"
