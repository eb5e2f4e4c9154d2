// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/excitation/excitation.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <set>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

ExcitationOptions optionsOf(ExcitationKind kind)
{
    ExcitationOptions options;
    options.kind = kind;
    options.peak = 10;
    options.bias = 20;
    options.bit_s = 0.005;
    options.sampleTime_s = 0.0005;
    options.samples = 2000;
    return options;
}

/// Amplitude of the harmonic `h` of a record.
double amplitude(const std::vector<double>& values, std::size_t h)
{
    std::complex<double> sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        sum += values[i] *
               std::polar(1.0, -2 * std::numbers::pi * double(h * i % values.size()) / double(values.size()));
    return 2 * std::abs(sum) / double(values.size());
}

} // namespace

class ExcitationTest : public QObject {
    Q_OBJECT
private slots:
    void aStepIsThereFromTheFirstSample()
    {
        const std::vector<double> force = *makeExcitation(optionsOf(ExcitationKind::Step));
        QVERIFY(std::all_of(force.begin(), force.end(), [](double f) { return f == 30; }));
    }
    void aBinarySequenceHasWholeBitsOfTwoLevels()
    {
        const std::vector<double> force = *makeExcitation(optionsOf(ExcitationKind::Prbs));
        QCOMPARE(std::set<double>(force.begin(), force.end()), (std::set<double>{10, 30}));
        for (std::size_t i = 0; i < force.size(); ++i)
            QCOMPARE(force[i], force[i - i % 10]);
    }
    void everyRegisterRunsThroughItsWholeSequence_data()
    {
        QTest::addColumn<int>("bits");
        for (int bits = 5; bits <= 16; ++bits)
            QTest::addRow("%d", bits) << bits;
    }
    void everyRegisterRunsThroughItsWholeSequence()
    {
        // A maximum-length sequence has one more +1 than -1 a period, and an autocorrelation of -1 off its
        // peak.
        QFETCH(int, bits);
        const std::size_t period = (std::size_t(1) << bits) - 1;
        ExcitationOptions options = optionsOf(ExcitationKind::Prbs);
        options.bias = 0;
        options.peak = 1;
        options.oneSided = false;
        options.bit_s = options.sampleTime_s;
        options.samples = period;
        const std::vector<double> force = *makeExcitation(options);
        double sum = 0;
        for (const double f : force)
            sum += f;
        QCOMPARE(std::abs(sum), 1.0);
        for (const std::size_t lag : {std::size_t(1), std::size_t(2), period / 3}) {
            double correlation = 0;
            for (std::size_t i = 0; i < period; ++i)
                correlation += force[i] * force[(i + lag) % period];
            QCOMPARE(correlation, -1.0);
        }
    }
    void theSeedPicksTheStart()
    {
        ExcitationOptions options = optionsOf(ExcitationKind::Prbs);
        const std::vector<double> one = *makeExcitation(options);
        QVERIFY(one == *makeExcitation(options));
        options.seed = 2;
        QVERIFY(one != *makeExcitation(options));
    }
    void aMultisineHasEqualAmplitudesUpToItsBandAndNothingAbove()
    {
        ExcitationOptions options = optionsOf(ExcitationKind::Multisine);
        options.oneSided = false;
        const std::vector<double> force = *makeExcitation(options);
        // 1 s, bits of 5 ms: harmonics 1 to 100.
        const double first = amplitude(force, 1);
        QVERIFY(first > 0.5);
        for (const std::size_t h : {2, 37, 100})
            QVERIFY(std::abs(amplitude(force, h) - first) < 1e-9);
        for (const std::size_t h : {101, 500, 999})
            QVERIFY(amplitude(force, h) < 1e-9);
        double largest = 0;
        for (const double f : force)
            largest = std::max(largest, std::abs(f - 20));
        QVERIFY(std::abs(largest - 10) < 1e-9);
    }
    void anInverseRepeatSequenceRepeatsAndTurnsOverHalfWay()
    {
        // 2000 samples, bits of 10, eight periods: 2 times 7 bits are the longest that fit.
        ExcitationOptions options = optionsOf(ExcitationKind::InverseRepeat);
        QCOMPARE(*excitationPeriod(options), std::size_t(140));
        options.periods = 3;
        const std::size_t period = *excitationPeriod(options);
        QCOMPARE(period, std::size_t(620));
        const std::vector<double> force = *makeExcitation(options);
        QCOMPARE(force.size(), options.samples);
        for (std::size_t i = 0; i + period < force.size(); ++i) {
            QCOMPARE(force[i], force[i - i % 10]);
            QCOMPARE(force[i], force[i + period]);
            QCOMPARE(force[i] - 20, 20 - force[i + period / 2]);
        }
        QCOMPARE(std::set<double>(force.begin(), force.end()), (std::set<double>{10, 30}));
        options.seed = 2;
        QVERIFY(force != *makeExcitation(options));
    }
    void anInverseRepeatSequenceHasOddHarmonicsOnly()
    {
        ExcitationOptions options = optionsOf(ExcitationKind::InverseRepeat);
        options.samples = 620;
        options.periods = 1;
        const std::vector<double> force = *makeExcitation(options);
        for (std::size_t h = 2; h < 60; h += 2)
            QVERIFY(amplitude(force, h) < 1e-9);
        for (std::size_t h = 1; h < 31; h += 2)
            QVERIFY(amplitude(force, h) > 0.5);
    }
    /// All pairs of bits but (0, 0) once too seldom in a sequence of the greatest length: of 1,023 pairs 256
    /// for three of the levels and 255 for one; neighbours hardly go together.
    void fourLevelsComeEquallyOften()
    {
        ExcitationOptions options = optionsOf(ExcitationKind::FourLevel);
        options.samples = 10 * 1023;
        const std::vector<double> force = *makeExcitation(options);
        std::map<int, int> levels;
        double neighbours = 0;
        for (std::size_t i = 0; i < force.size(); i += 10) {
            ++levels[static_cast<int>(std::lround(3 * (force[i] - 20)))];
            for (std::size_t j = i; j < i + 10; ++j)
                QCOMPARE(force[j], force[i]);
            if (i > 0)
                neighbours += (force[i] - 20) * (force[i - 10] - 20) / 1022;
        }
        QCOMPARE(levels.size(), 4U);
        for (const int level : {-30, -10, 10, 30})
            QVERIFY2(std::abs(levels[level] - 256) < 60, qPrintable(QString::number(levels[level])));
        QVERIFY2(std::abs(neighbours) < 0.3 * 55.6,
                 qPrintable(QString::number(neighbours))); // of the variance
        options.seed = 2;
        QVERIFY(force != *makeExcitation(options));
    }
    void aMultisineMayRepeat()
    {
        ExcitationOptions options = optionsOf(ExcitationKind::Multisine);
        QVERIFY(!excitationPeriod(options));
        options.periods = 4;
        QCOMPARE(*excitationPeriod(options), std::size_t(500));
        const std::vector<double> force = *makeExcitation(options);
        for (std::size_t i = 0; i + 500 < force.size(); ++i)
            QCOMPARE(force[i], force[i + 500]);
        // 0.25 s, bits of 5 ms: harmonics 1 to 25 of the period.
        QVERIFY(amplitude(force, 4 * 25) > 0.5);
        QVERIFY(amplitude(force, 4 * 26) < 1e-9 && amplitude(force, 4 * 25 - 1) < 1e-9);
    }
    void aRecordTooShortForItsPeriodsIsRefused()
    {
        for (const ExcitationKind kind : {ExcitationKind::InverseRepeat, ExcitationKind::Multisine}) {
            ExcitationOptions options = optionsOf(kind);
            options.periods = 5000;
            const Expected<std::vector<double>> force = makeExcitation(options);
            QVERIFY(!force);
            QVERIFY2(force.error().describe().contains(u"periods"_s), qPrintable(force.error().describe()));
        }
    }
    void aChirpSweepsUpwards()
    {
        const std::vector<double> force = *makeExcitation(optionsOf(ExcitationKind::Chirp));
        const auto crossings = [&](std::size_t begin, std::size_t end) {
            int count = 0;
            for (std::size_t i = begin + 1; i < end; ++i)
                count += (force[i] > 20) != (force[i - 1] > 20) ? 1 : 0;
            return count;
        };
        // From 1 to 100 Hz in 1 s: 13 swings in the first half, 38 in the second, two crossings each.
        QVERIFY(std::abs(crossings(0, 1000) - 26) <= 2);
        QVERIFY(std::abs(crossings(1000, 2000) - 76) <= 2);
    }
    void aOneSidedGripNeverPulls()
    {
        ExcitationOptions options = optionsOf(ExcitationKind::Prbs);
        options.bias = 5;
        const std::vector<double> force = *makeExcitation(options);
        QCOMPARE(*std::min_element(force.begin(), force.end()), 0.0);
        QCOMPARE(*std::max_element(force.begin(), force.end()), 15.0);
    }
    void badOptionsAreNamed_data()
    {
        QTest::addColumn<QString>("word");
        QTest::addColumn<double>("peak");
        QTest::addColumn<double>("bit");
        QTest::addColumn<double>("sampleTime");
        QTest::addColumn<qulonglong>("samples");
        QTest::newRow("negative peak") << u"peak"_s << -1.0 << 0.005 << 0.0005 << qulonglong(100);
        QTest::newRow("nan peak") << u"peak"_s << std::nan("") << 0.005 << 0.0005 << qulonglong(100);
        QTest::newRow("no bit") << u"bit"_s << 1.0 << 0.0 << 0.0005 << qulonglong(100);
        QTest::newRow("no sample time") << u"sample time"_s << 1.0 << 0.005 << 0.0 << qulonglong(100);
        QTest::newRow("no samples") << u"samples"_s << 1.0 << 0.005 << 0.0005 << qulonglong(0);
    }
    void badOptionsAreNamed()
    {
        QFETCH(QString, word);
        QFETCH(double, peak);
        QFETCH(double, bit);
        QFETCH(double, sampleTime);
        QFETCH(qulonglong, samples);
        ExcitationOptions options = optionsOf(ExcitationKind::Prbs);
        options.peak = peak;
        options.bit_s = bit;
        options.sampleTime_s = sampleTime;
        options.samples = samples;
        const Expected<std::vector<double>> force = makeExcitation(options);
        QVERIFY(!force);
        QVERIFY2(force.error().describe().contains(word), qPrintable(force.error().describe()));
    }
    void halfOfTheRecordIsSlow()
    {
        ExcitationOptions options = optionsOf(ExcitationKind::PrbsSine);
        options.samples = 2001;
        const std::vector<double> sine = *makeExcitation(options);
        options.kind = ExcitationKind::PrbsHold;
        const std::vector<double> hold = *makeExcitation(options);
        options.kind = ExcitationKind::Prbs;
        options.samples = 1001;
        const std::vector<double> two = *makeExcitation(options);
        QCOMPARE(sine.size(), std::size_t(2001));
        QCOMPARE(hold.size(), std::size_t(2001));
        QVERIFY(std::equal(two.begin(), two.end(), sine.begin()));
        QVERIFY(std::equal(two.begin(), two.end(), hold.begin()));
        for (std::size_t i = 0; i < 1000; ++i) {
            const double wanted = 20 + 10 * std::sin(2 * std::numbers::pi * static_cast<double>(i) / 1000);
            QVERIFY(std::abs(sine[1001 + i] - wanted) < 1e-9);
            const double ramp = 20 + 10 * std::min(1.0, static_cast<double>(i) / 125 - 1);
            QVERIFY(std::abs(hold[1001 + i] - ramp) < 1e-9);
        }
    }
    void aBitShorterThanASampleIsOneSample()
    {
        ExcitationOptions options = optionsOf(ExcitationKind::Prbs);
        options.bit_s = 1e-9;
        const std::vector<double> force = *makeExcitation(options);
        QVERIFY(force[0] != force[1] || force[1] != force[2] || force[2] != force[3] || force[3] != force[4]);
    }
    void kindsReadBackFromTheirNames()
    {
        QCOMPARE(excitationKinds().size(), std::size_t(9));
        for (const ExcitationKind kind : excitationKinds())
            QVERIFY(excitationKindFromString(toString(kind)) == kind);
        QVERIFY(!excitationKindFromString(u"noise"_s));
    }
};

GRIPSCOPE_TEST(ExcitationTest)
#include "excitation_test.moc"
