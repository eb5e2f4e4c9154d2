// SPDX-License-Identifier: GPL-3.0-or-later
// What identify() makes of the hold's evidence: alone, with earlier squeezes, and in the intervals of m, b,
// k.
#include "core/identification/identification.h"
#include "core/identification/result/identification_json.h"
#include "tests/core/identification/synthetic.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <boost/math/distributions/binomial.hpp>

#include <array>

using namespace gripscope;
using namespace Qt::StringLiterals;
using test::Synthetic;

namespace {

/// wn T = 0.1: one squeeze of 75 % tells the holds apart by about 2, one of 94 % by about 30.
Recording squeezeOf(double fitPercent, ForceHold hold, std::uint64_t seed)
{
    Synthetic synthetic;
    synthetic.truth = {0.04, 2 * 0.5 * 2 * 0.04, 4 * 0.04};
    synthetic.hold = hold;
    synthetic.fitPercent = fitPercent;
    synthetic.seed = seed;
    return synthetic.make();
}

Identification identifyAs(const Recording& recording, ForceHold declared, const HoldEvidence& earlier = {},
                          bool assess = false)
{
    IdentificationOptions options;
    options.estimators = {Estimator::OutputError};
    options.hold = declared;
    options.earlierHold = earlier;
    options.assess = assess;
    return identify(recording, options);
}

const ValidityCheck& holdCheck(const Identification& identification)
{
    const auto& checks = identification.validity.checks;
    return *std::find_if(checks.begin(), checks.end(),
                         [](const auto& check) { return check.id == u"hold"_s; });
}

/// Squeezes with a held force, declared as `declared`, each with what the ones before said.
std::vector<Identification> series(ForceHold declared, double fitPercent, std::uint64_t squeezes)
{
    std::vector<Identification> all;
    HoldEvidence sum;
    for (std::uint64_t seed = 1; seed <= squeezes; ++seed) {
        Recording recording = squeezeOf(fitPercent, ForceHold::Zero, seed);
        recording.provenance.insert(u"serial"_s, u"G-7"_s);
        all.push_back(identifyAs(recording, declared, sum));
        sum = all.back().summedHold;
    }
    return all;
}

} // namespace

class SummedHoldTest : public QObject {
    Q_OBJECT
private slots:
    void squeezesTogetherSettleWhatOneCannotTell()
    {
        const std::vector<Identification> wrong = series(ForceHold::First, 75, 20);
        const ValidityCheck& first = holdCheck(wrong.front());
        QVERIFY(first.ok);
        QVERIFY(first.message.describe().contains(u"this record cannot tell it from zoh"_s));
        const ValidityCheck& last = holdCheck(wrong.back());
        QVERIFY(!last.ok);
        QCOMPARE(*last.value, *wrong.back().summedHold.gain);
        QCOMPARE(wrong.back().summedHold.squeezes, 20);
        for (const QString& words : {u"over 20 squeezes with gripper G-7"_s, u"zoh"_s, u"foh"_s, u"lag"_s})
            QVERIFY2(last.message.describe().contains(words), qPrintable(last.message.describe()));
        // One squeeze by itself is as it was.
        QVERIFY(wrong.back().holdEvidence.verdict() == HoldVerdict::Ambiguous);

        const ValidityCheck right = holdCheck(series(ForceHold::Zero, 75, 20).back());
        QVERIFY(right.ok);
        QVERIFY2(
            right.message.describe().contains(u"over 20 squeezes with gripper G-7 the position agrees"_s),
            qPrintable(right.message.describe()));
    }
    void theIntervalNarrowsAsTheHoldIsSettled()
    {
        const Recording recording = squeezeOf(75, ForceHold::Zero, 21);
        const HoldEvidence settled = series(ForceHold::Zero, 75, 20).back().summedHold;
        const UncertaintyBudget alone = identifyAs(recording, ForceHold::Zero, {}, true).budget;
        const UncertaintyBudget together = identifyAs(recording, ForceHold::Zero, settled, true).budget;
        QVERIFY(alone.find(u"hold"_s) != nullptr);
        QVERIFY(together.find(u"hold"_s) == nullptr);
        QVERIFY(together.combined[0].standardUncertainty < alone.combined[0].standardUncertainty);
    }
    void manyRightSqueezesDoNotHideAWrongOne()
    {
        const HoldEvidence earlier = series(ForceHold::Zero, 94, 10).back().summedHold;
        const Identification changed =
            identifyAs(squeezeOf(94, ForceHold::First, 11), ForceHold::Zero, earlier);
        QVERIFY(*changed.summedHold.gain < 0);
        QVERIFY(!holdCheck(changed).ok);
        QCOMPARE(*holdCheck(changed).value, *changed.holdEvidence.gain);
    }
    void aSqueezeThatIsRightAfterWrongOnesIsToldSo()
    {
        const HoldEvidence earlier = series(ForceHold::First, 94, 10).back().summedHold;
        const Identification changed =
            identifyAs(squeezeOf(94, ForceHold::First, 11), ForceHold::First, earlier);
        QVERIFY(!holdCheck(changed).ok);
        QVERIFY(holdCheck(changed).message.describe().contains(u"This squeeze alone agrees with foh"_s));
    }
    void whatEarlierSqueezesDeclaredOtherwiseDoesNotCount()
    {
        const Recording recording = squeezeOf(85, ForceHold::Zero, 5);
        const HoldEvidence other = series(ForceHold::First, 85, 3).back().summedHold;
        const Identification found = identifyAs(recording, ForceHold::Zero, other);
        QCOMPARE(found.summedHold.squeezes, 1);
        QCOMPARE(*found.summedHold.gain, *found.holdEvidence.gain);
    }
    void theDocumentHasBothThisSqueezeAndTheSum()
    {
        const Identification last = series(ForceHold::Zero, 85, 3).back();
        const QJsonObject hold =
            toJson(last, squeezeOf(85, ForceHold::Zero, 3), u"3.csv"_s)[u"hold"].toObject();
        QCOMPARE(hold[u"gain"].toDouble(), *last.holdEvidence.gain);
        QCOMPARE(hold[u"expected_gain"].toDouble(), last.holdEvidence.expectedGain);
        QCOMPARE(hold[u"summed"][u"gain"].toDouble(), *last.summedHold.gain);
        QCOMPARE(hold[u"summed"][u"expected_gain"].toDouble(), last.summedHold.expectedGain);
        QCOMPARE(hold[u"summed"][u"squeezes"].toInt(), 3);
        const Identification none = identifyAs(Recording(), ForceHold::Zero);
        const QJsonObject empty = toJson(none, Recording(), u"none.csv"_s)[u"hold"].toObject();
        QVERIFY(empty[u"gain"].isNull() && empty[u"summed"][u"gain"].isNull());
        QCOMPARE(empty[u"summed"][u"squeezes"].toInt(-1), 0);
    }
    void theIntervalsCoverUnderEitherDeclaration_data()
    {
        QTest::addColumn<bool>("held");
        QTest::newRow("held") << true;
        QTest::newRow("straight") << false;
    }
    void theIntervalsCoverUnderEitherDeclaration()
    {
        QFETCH(bool, held);
        const ForceHold truth = held ? ForceHold::Zero : ForceHold::First;
        constexpr int runs = 100;
        const Eigen::Vector3d true3(0.04, 0.08, 0.16);
        for (const ForceHold declared : {ForceHold::Zero, ForceHold::First}) {
            std::array<int, 3> covered{};
            for (int run = 0; run < runs; ++run) {
                const Recording recording = squeezeOf(88, truth, static_cast<std::uint64_t>(run) + 1);
                const UncertaintyBudget budget = identifyAs(recording, declared, {}, true).budget;
                for (std::size_t i = 0; i < 3; ++i) {
                    const double value = true3(static_cast<Eigen::Index>(i));
                    covered[i] += budget.intervals[i].lower <= value && value <= budget.intervals[i].upper;
                }
            }
            // At least 93 %: the binomial law's 99.9 % point. Half-way intervals (a rectangle to the other
            // hold's m) cover 80 %.
            const boost::math::binomial law(runs, 0.93);
            for (const int count : covered)
                QVERIFY2(count >= boost::math::quantile(law, 1e-3), qPrintable(QString::number(count)));
        }
    }
};

GRIPSCOPE_TEST(SummedHoldTest)
#include "summed_hold_test.moc"
