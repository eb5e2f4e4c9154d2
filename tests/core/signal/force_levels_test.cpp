// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/excitation/force_levels.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

std::vector<double> squeezed(const ForceLevels& force, double sampleTime_s, std::size_t samples)
{
    ExcitationOptions options;
    options.kind = ExcitationKind::Levels;
    options.bias = force.bias;
    options.peak = force.peak;
    options.bit_s = force.bit_s;
    options.levels = force.levels;
    options.sampleTime_s = sampleTime_s;
    options.samples = samples;
    return makeExcitation(options).value_or(std::vector<double>());
}

} // namespace

class ForceLevelsTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsInTheFileIsSqueezed()
    {
        const auto force = parseForceLevels("time_s,force\n0,12\n0.01,18\n0.02,15\n0.03,9\n"_ba, u"f.csv"_s);
        QVERIFY(force);
        QCOMPARE(force->bias, 13.5);
        QCOMPARE(force->peak, 4.5);
        QCOMPARE(force->bit_s, 0.01);
        QVERIFY(std::abs(force->seconds() - 0.04) < 1e-12);
        const std::vector<double> made = squeezed(*force, 0.0025, 20); // and from its start again
        const double wanted[] = {12, 18, 15, 9, 12};
        QCOMPARE(made.size(), std::size_t(20));
        for (std::size_t i = 0; i < made.size(); ++i)
            QVERIFY2(std::abs(made[i] - wanted[i / 4]) < 1e-12, qPrintable(QString::number(made[i])));
    }
    /// 3 ms levels on samples of 2 ms: each sample has the level of its time, and nothing drifts.
    void levelsNeedNotBeWholeSamples()
    {
        ForceLevels force{20, 10, 0.003, {-1, 0, 1}, {}};
        const std::vector<double> made = squeezed(force, 0.002, 3000);
        for (std::size_t i = 0; i < made.size(); ++i) {
            const std::size_t level = 2 * i / 3;
            QCOMPARE(made[i], 20 + 10 * force.levels[level % 3]);
        }
    }
    void equalNeighboursAreOneLevel()
    {
        std::vector<double> force;
        for (const double level : {5.0, 7.0, 7.0, 6.0})
            force.insert(force.end(), 6, level);
        force.insert(force.end(), 4, 5.0); // cut short
        const auto levels = levelsOf(force, 0.001, {}, u"f"_s);
        QVERIFY(levels);
        QCOMPARE(levels->levels.size(), std::size_t(5));
        QCOMPARE(levels->bit_s, 0.006);
    }
    void aRecordingHasAForceToo()
    {
        Recording recording;
        recording.sampleTime_s = 0.001;
        recording.forceUnit = u"mN"_s;
        recording.positionUnit = u"mm"_s;
        for (int i = 0; i < 50; ++i) {
            recording.time_s.push_back(0.001 * i);
            recording.force.push_back(1000 + 10 * std::sin(i));
            recording.position.push_back(0.1 * i);
        }
        const auto force = parseForceLevels(toCsv(recording), u"r.csv"_s);
        QVERIFY(force);
        QCOMPARE(force->levels.size(), recording.size());
        QCOMPARE(force->unit, u"mN"_s);
        const auto newtons = inNewtons(*force, u"r.csv"_s);
        QVERIFY(newtons && newtons->unit == u"N"_s);
        const std::vector<double> made = squeezed(*newtons, 0.001, recording.size());
        for (std::size_t i = 0; i < made.size(); ++i)
            QVERIFY(std::abs(made[i] - 1e-3 * recording.force[i]) < 1e-12);
    }
    void whatIsWrittenReadsBack()
    {
        const ForceLevels force{20, 7.3, 0.004, {1, -1, 0.1, 1.0 / 3, -1}, u"N"_s};
        const auto read = parseForceLevels(toCsv(force), u"f.csv"_s);
        QVERIFY(read);
        QCOMPARE(read->bit_s, force.bit_s);
        QCOMPARE(read->unit, force.unit);
        QCOMPARE(read->levels.size(), force.levels.size());
        for (std::size_t i = 0; i < force.levels.size(); ++i)
            QVERIFY(std::abs(read->bias + read->peak * read->levels[i] - force.bias -
                             force.peak * force.levels[i]) < 1e-12);
    }
    /// Other programs' tables: semicolons, decimal commas, no times.
    void tablesOfOthersAreRead()
    {
        const QByteArray text = "force;remark\n10,5;a\n12,5;b\n9,0;c\n";
        QVERIFY(!parseForceLevels(text, u"f.csv"_s));
        const auto force = parseForceLevels(text, u"f.csv"_s, 0.02);
        QVERIFY2(force, qPrintable(test::whyNot(force)));
        QCOMPARE(force->bit_s, 0.02);
        QCOMPARE(force->bias, 10.75);
    }
    void whatCannotBeSqueezedSaysWhy_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("word");
        QTest::newRow("no such column") << "time_s,kraft\n0,1\n0.1,2\n"_ba << u"\"force\""_s;
        QTest::newRow("no times") << "force\n1\n2\n"_ba << u"time_s"_s;
        QTest::newRow("no number") << "time_s,force\n0,1\n0.1,two\n"_ba << u"f.csv:3:2"_s;
        QTest::newRow("the same throughout") << "time_s,force\n0,5\n0.1,5\n0.2,5\n"_ba << u"varies"_s;
        QTest::newRow("uneven steps") << "time_s,force\n0,1\n0.1,2\n0.2,3\n0.5,4\n"_ba << u"row 4"_s;
        QByteArray many = "# sample_time_s: 0.001\nforce\n";
        for (std::size_t i = 0; i <= mostLevels; ++i)
            many += QByteArray::number(i % 7) + '\n';
        QTest::newRow("too many") << many << u"20001"_s;
    }
    void whatCannotBeSqueezedSaysWhy()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, word);
        const auto force = parseForceLevels(text, u"f.csv"_s);
        QVERIFY(!force);
        QCOMPARE(force.error().code, ErrorCode::BadInput);
        const QString words = force.error().describe();
        QVERIFY2(words.contains(word) && words.contains(u"f.csv"_s), qPrintable(words));
    }
    void levelsThatDoNotFitAreRefused()
    {
        ExcitationOptions options;
        options.kind = ExcitationKind::Levels;
        QVERIFY(options.validate()); // none
        options.levels = {0, 1.5};
        QVERIFY(options.validate()); // beyond the peak
        options.levels = {0, std::nan("")};
        QVERIFY(options.validate());
        options.levels = {0, 1};
        QVERIFY(!options.validate());
        options.bit_s = options.sampleTime_s / 2; // every other one would be passed over
        QVERIFY(options.validate() && options.validate()->describe().contains(u"sample"_s));
        options.bit_s = options.sampleTime_s;
        options.levels.assign(mostLevels + 1, 0.5);
        QVERIFY(options.validate());
    }
    void aForceThatComesTwiceRepeats()
    {
        ExcitationOptions options;
        options.kind = ExcitationKind::Levels;
        options.levels = {-1, 1, 0.5, 0.2};
        options.bit_s = 0.005;
        options.sampleTime_s = 0.0005;
        options.samples = 80;
        QCOMPARE(excitationPeriod(options), std::optional<std::size_t>(40));
        options.samples = 79;
        QVERIFY(!excitationPeriod(options));
        options.bit_s = 0.00512; // not the same samples each time
        options.samples = 2000;
        QVERIFY(!excitationPeriod(options));
    }
};

GRIPSCOPE_TEST(ForceLevelsTest)
#include "force_levels_test.moc"
