// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/preparation.h"
#include "tests/core/signal/squeeze_record.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <algorithm>
#include <functional>
#include <limits>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

Recording plainRecording(ExcitationKind kind, ForceHold hold, std::size_t samples = 400)
{
    ExcitationOptions options;
    options.kind = kind;
    options.peak = 1;
    options.bias = 0;
    options.bit_s = 0.5;
    options.sampleTime_s = 0.05;
    options.samples = samples;
    options.oneSided = false;
    Recording recording;
    recording.sampleTime_s = 0.05;
    recording.hold = hold;
    recording.force = *makeExcitation(options);
    recording.position =
        simulate({0.0396209, 0.1374754, 0.1022911}, recording.force, {0.05, hold, 0, 0, 0, 0});
    GaussianNoise noise(4);
    for (std::size_t i = 0; i < samples; ++i) {
        recording.time_s.push_back(static_cast<double>(i) * 0.05);
        recording.position[i] += 0.3 * noise();
    }
    return recording;
}

/// Without the samples for which `isLost`.
template <typename Predicate>
Recording without(const Recording& all, Predicate isLost)
{
    Recording recording = slice(all, {0, 0});
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (isLost(i))
            continue;
        recording.time_s.push_back(all.time_s[i]);
        recording.force.push_back(all.force[i]);
        recording.position.push_back(all.position[i]);
        if (!all.sequence.empty())
            recording.sequence.push_back(all.sequence[i]);
    }
    return recording;
}

QString ids(const PreparedRecord& prepared)
{
    QStringList all;
    for (const PreparationStep& step : prepared.steps)
        all << step.id;
    return all.join(u' ');
}

bool isUntouched(const PreparedRecord& prepared, const Recording& recording)
{
    return prepared.steps.empty() && prepared.lost.empty() && prepared.time_s == recording.time_s &&
           prepared.force == recording.force && prepared.position == recording.position &&
           prepared.sampleTime_s == recording.sampleTime_s &&
           prepared.choice.window == Window{0, recording.size()};
}

std::vector<double> numbers(const QJsonValue& array)
{
    std::vector<double> values;
    for (const QJsonValue value : array.toArray())
        values.push_back(value.toDouble());
    return values;
}

} // namespace

class PreparationTest : public QObject {
    Q_OBJECT
private slots:
    void plainRecordsComeOutAsTheyWentIn_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("hold");
        for (const ExcitationKind kind :
             {ExcitationKind::Prbs, ExcitationKind::Multisine, ExcitationKind::Chirp, ExcitationKind::Step}) {
            for (const ForceHold hold : {ForceHold::Zero, ForceHold::First})
                QTest::addRow("%s, %s", qPrintable(toString(kind)), qPrintable(toString(hold)))
                    << int(kind) << int(hold);
        }
    }
    void plainRecordsComeOutAsTheyWentIn()
    {
        QFETCH(int, kind);
        QFETCH(int, hold);
        const Recording recording =
            plainRecording(static_cast<ExcitationKind>(kind), static_cast<ForceHold>(hold));
        const PreparedRecord prepared = prepare(recording);
        QVERIFY2(isUntouched(prepared, recording), qPrintable(ids(prepared)));
    }
    void theOraclesComeOutAsTheyWentIn_data()
    {
        QTest::addColumn<QString>("file");
        for (const char* name :
             {"zoh_prbs_A_fit99", "zoh_clean_A", "zoh_clean_C", "zoh_x0_B", "zoh_multisine_A_fit90",
              "zoh_prbs_C_fit90", "si_can_underdamped", "cd_exact_A"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void theOraclesComeOutAsTheyWentIn()
    {
        QFETCH(QString, file);
        QFile input(QStringLiteral(GRIPSCOPE_TEST_DATA "/oracles/%1.json").arg(file));
        QVERIFY(input.open(QIODevice::ReadOnly));
        const QJsonObject oracle = QJsonDocument::fromJson(input.readAll()).object();
        Recording recording;
        recording.sampleTime_s = oracle[u"Ts"].toDouble();
        recording.force = numbers(oracle[u"u"]);
        recording.position = numbers(oracle[u"y"]);
        for (std::size_t i = 0; i < recording.size(); ++i)
            recording.time_s.push_back(static_cast<double>(i) * recording.sampleTime_s);
        const PreparedRecord prepared = prepare(recording);
        QVERIFY2(isUntouched(prepared, recording), qPrintable(ids(prepared)));
    }
    void aWholeSqueezeIsCutToItsExcitation()
    {
        const SqueezeRecord record;
        const Recording recording = record.make();
        const PreparedRecord prepared = prepare(recording);
        QCOMPARE(ids(prepared), u"contact force_noise"_s);
        QVERIFY(std::abs(prepared.chain.forceNoiseDeviation / record.forceNoise_N - 1) <
                4 * std::sqrt(3.0 / 960));
        QVERIFY(prepared.phases.hasApproach && prepared.phases.hasRelease);
        QVERIFY(prepared.choice.window == prepared.phases.squeeze);
        QCOMPARE(prepared.force.size(), prepared.choice.window.count);
        QCOMPARE(prepared.force.front(), recording.force[prepared.choice.window.first]);
        QCOMPARE(prepared.time_s.front(), recording.time_s[prepared.choice.window.first]);
        PreparationOptions options;
        options.findContact = false;
        QVERIFY(isUntouched(prepare(recording, options), recording));
    }
    void theDevicesWordComesFirst()
    {
        const SqueezeRecord record;
        Recording recording = record.make();
        recording.status.assign(recording.size(), StatusArmed);
        const std::size_t first = record.touch() + 2 * record.ramp;
        for (std::size_t i = first; i < first + record.excited; ++i)
            recording.status[i] |= StatusMoving;
        const PreparedRecord prepared = prepare(recording);
        QVERIFY((prepared.choice.window == Window{first, record.excited}));
        QVERIFY2(prepared.steps.empty(), qPrintable(ids(prepared)));
        // A device that calls all of it movement leaves the phases to be found.
        recording.status.assign(recording.size(), StatusArmed | StatusMoving);
        QVERIFY(prepare(recording).choice.window == prepare(record.make()).choice.window);
    }
    void lostSamplesStayInPlaceAndAreNamed()
    {
        const Recording all = plainRecording(ExcitationKind::Prbs, ForceHold::Zero);
        const auto isLost = [](std::size_t i) { return i == 50 || i == 51 || i == 200; };
        const PreparedRecord prepared = prepare(without(all, isLost));
        QCOMPARE(ids(prepared), u"samples_lost"_s);
        QVERIFY((prepared.lost == std::vector<std::size_t>{50, 51, 200}));
        QCOMPARE(prepared.choice.lostSamples, std::int64_t(3));
        QCOMPARE(prepared.choice.gaps, std::size_t(2));
        QCOMPARE(prepared.choice.eligible, std::size_t(397));
        QCOMPARE(prepared.force.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (isLost(i))
                continue;
            QCOMPARE(prepared.force[i], all.force[i]);
            QCOMPARE(prepared.position[i], all.position[i]);
            QCOMPARE(prepared.time_s[i], all.time_s[i]);
        }
        QVERIFY(std::abs(prepared.time_s[200] - all.time_s[200]) < 1e-9);
    }
    void tooManyLostLeaveTheBestPart()
    {
        const Recording all = plainRecording(ExcitationKind::Prbs, ForceHold::Zero);
        const PreparedRecord prepared =
            prepare(without(all, [](std::size_t i) { return i >= 100 && i < 250; }));
        QCOMPARE(ids(prepared), u"samples_lost window_cut"_s);
        QVERIFY(!prepared.find(u"window_cut"_s)->ok);
        QVERIFY((prepared.choice.window == Window{100, 150}));
        QVERIFY(prepared.lost.empty());
        QCOMPARE(prepared.force.front(), all.force[250]);
    }
    void aDriftingClockIsBelieved()
    {
        Recording recording = plainRecording(ExcitationKind::Prbs, ForceHold::Zero);
        for (double& t : recording.time_s)
            t *= 1.004;
        const PreparedRecord prepared = prepare(recording);
        QCOMPARE(ids(prepared), u"clock_drift"_s);
        QVERIFY(std::abs(prepared.sampleTime_s / 0.0502 - 1) < 1e-9);
        QVERIFY(prepared.force == recording.force);
        QVERIFY(prepared.find(u"clock_drift"_s)->ok);
    }
    void aClockThatWasSetLeavesTheLongerPart()
    {
        Recording recording = plainRecording(ExcitationKind::Prbs, ForceHold::Zero);
        for (std::size_t i = 0; i < recording.size(); ++i)
            recording.sequence.push_back(i);
        for (std::size_t i = 150; i < recording.size(); ++i)
            recording.time_s[i] += 1;
        const PreparedRecord prepared = prepare(recording);
        QCOMPARE(ids(prepared), u"clock_break window_cut"_s);
        QVERIFY((prepared.choice.window == Window{150, 250}));
        QCOMPARE(prepared.choice.lostSamples, std::int64_t(0));
        QVERIFY(prepared.lost.empty());
    }
    void jitteredSamplesAreMovedToTheGrid()
    {
        Recording recording = plainRecording(ExcitationKind::Prbs, ForceHold::Zero);
        GaussianNoise noise(8);
        for (double& t : recording.time_s)
            t += 0.05 * 0.08 * noise();
        const PreparedRecord prepared = prepare(recording);
        QCOMPARE(ids(prepared), u"clock_jitter"_s);
        // The root mean square of 400 scatters by 3.5 %.
        QVERIFY(std::abs(prepared.find(u"clock_jitter"_s)->value - 0.08) < 0.015);
        QCOMPARE(prepared.force.size(), recording.size());
        for (std::size_t i = 1; i < prepared.time_s.size(); ++i)
            QVERIFY(std::abs(prepared.time_s[i] - prepared.time_s[i - 1] - prepared.sampleTime_s) < 1e-12);
        PreparationOptions options;
        options.resample = false;
        QVERIFY(prepare(recording, options).force == recording.force);
        QVERIFY(!prepare(recording, options).find(u"clock_jitter"_s)->ok);
    }
    void lostContactIsLeftOut()
    {
        SqueezeRecord record;
        record.approach = record.opening = record.ramp = record.fall = 0;
        Recording recording = record.make();
        for (std::size_t i = 700; i < 730; ++i) {
            recording.force[i] = 0;
            recording.position[i] -= 0.01;
        }
        const PreparedRecord prepared = prepare(recording);
        QCOMPARE(ids(prepared), u"contact_loss"_s);
        QCOMPARE(prepared.lost.size(), std::size_t(32));
        QCOMPARE(prepared.lost.front(), std::size_t(699));
        QVERIFY(prepared.position == recording.position);
    }
    void saturationIsNoticedByTheDevicesWordAndByItsLook()
    {
        SqueezeRecord record;
        record.approach = record.opening = record.ramp = record.fall = 0;
        Recording recording = record.make();
        for (double& f : recording.force)
            f = std::min(f, 29.99);
        const PreparedRecord clipped = prepare(recording);
        QCOMPARE(ids(clipped), u"saturation"_s);
        QVERIFY(!clipped.find(u"saturation"_s)->ok);
        QVERIFY(clipped.find(u"saturation"_s)->count > 100);
        recording = record.make();
        recording.status.assign(recording.size(), StatusMoving);
        recording.status[5] |= StatusPositionSaturated;
        QCOMPARE(prepare(recording).find(u"saturation"_s)->count, std::size_t(1));
    }
    void coarseStepsOfThePositionAreNoticed()
    {
        Recording recording = plainRecording(ExcitationKind::Prbs, ForceHold::Zero);
        for (double& x : recording.position)
            x = 0.9 * std::round(x / 0.9);
        const PreparedRecord prepared = prepare(recording);
        QCOMPARE(ids(prepared), u"quantization"_s);
        QVERIFY(std::abs(prepared.find(u"quantization"_s)->value - 0.9) < 1e-9);
        // Steps well below the noise do no harm and are not worth a word.
        recording = plainRecording(ExcitationKind::Prbs, ForceHold::Zero);
        for (double& x : recording.position)
            x = 0.05 * std::round(x / 0.05);
        QVERIFY(isUntouched(prepare(recording), recording));
        // Noise that spreads the rounding errors makes them harmless: below two and a half deviations a step.
        GaussianNoise noise(3);
        recording = plainRecording(ExcitationKind::Prbs, ForceHold::Zero);
        for (double& x : recording.position)
            x = 0.9 * std::round((x + 0.5 * noise()) / 0.9);
        QVERIFY(prepare(recording).find(u"quantization"_s) == nullptr);
    }
    void theFramesShareIsTakenAway()
    {
        Recording recording = plainRecording(ExcitationKind::Prbs, ForceHold::Zero);
        const std::vector<double> own = recording.position;
        for (std::size_t i = 0; i < own.size(); ++i)
            recording.position[i] += 0.7 * recording.force[i];
        recording.chain.frameCompliance = 0.7;
        const PreparedRecord prepared = prepare(recording);
        QCOMPARE(ids(prepared), u"frame_compliance"_s);
        for (std::size_t i = 0; i < own.size(); ++i)
            QVERIFY(std::abs(prepared.position[i] - own[i]) < 1e-12);
        QVERIFY(prepared.chain == recording.chain);
    }
    void dataThatCannotBeUsedIsSaidToBe()
    {
        QVERIFY(prepare(Recording()).steps.empty() == false);
        Recording empty;
        empty.sampleTime_s = 1;
        QVERIFY(prepare(empty).force.empty());
        Recording recording = plainRecording(ExcitationKind::Prbs, ForceHold::Zero, 50);
        recording.position[7] = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(ids(prepare(recording)), u"unusable"_s);
        recording = plainRecording(ExcitationKind::Prbs, ForceHold::Zero, 50);
        recording.force.pop_back();
        QCOMPARE(ids(prepare(recording)), u"unusable"_s);
        for (const std::size_t samples : {1, 2, 3}) {
            const Recording few = slice(plainRecording(ExcitationKind::Prbs, ForceHold::Zero), {0, samples});
            QVERIFY(isUntouched(prepare(few), few));
        }
    }
    void anythingComesOutConsistent()
    {
        GaussianNoise random(12);
        const auto pick = [&random](int below) { return static_cast<int>(below * random.uniform()); };
        for (int run = 0; run < 400; ++run) {
            Recording recording;
            recording.sampleTime_s = std::pow(10.0, pick(13) - 9);
            if (pick(2) == 0)
                recording.hold = pick(2) == 0 ? ForceHold::Zero : ForceHold::First;
            const double forceScale = std::pow(10.0, pick(600) - 300);
            const double positionScale = std::pow(10.0, pick(600) - 300);
            const double jitter = pick(3) * 0.2;
            const int samples = pick(80);
            double time = pick(1000) - 500;
            for (int i = 0; i < samples; ++i) {
                time += pick(8) == 0 ? pick(5000) - 50 : 1;
                recording.time_s.push_back((time + jitter * random()) * recording.sampleTime_s);
                recording.force.push_back(forceScale * (pick(3) == 0 ? 0 : pick(3) + random()));
                recording.position.push_back(positionScale * (pick(4) + 0.1 * random()));
                recording.sequence.push_back(static_cast<std::uint64_t>(i + pick(3)));
                recording.status.push_back(
                    static_cast<std::uint16_t>(pick(5) == 0 ? pick(256) : StatusMoving));
            }
            if (pick(2) == 0)
                recording.sequence.clear();
            if (pick(2) == 0)
                recording.status.clear();
            const PreparedRecord prepared = prepare(recording);
            const std::size_t points = prepared.force.size();
            QCOMPARE(prepared.position.size(), points);
            QCOMPARE(prepared.time_s.size(), points);
            QVERIFY(std::isfinite(prepared.sampleTime_s) && prepared.sampleTime_s > 0);
            for (std::size_t n = 0; n < points; ++n)
                QVERIFY(std::isfinite(prepared.force[n]) && std::isfinite(prepared.position[n]) &&
                        std::isfinite(prepared.time_s[n]));
            QVERIFY(std::adjacent_find(prepared.lost.begin(), prepared.lost.end(), std::greater_equal<>()) ==
                    prepared.lost.end());
            QVERIFY(prepared.lost.empty() || prepared.lost.back() < points);
            QVERIFY(prepared.choice.window.first + prepared.choice.window.count <= recording.size());
        }
    }
};

GRIPSCOPE_TEST(PreparationTest)
#include "preparation_test.moc"
