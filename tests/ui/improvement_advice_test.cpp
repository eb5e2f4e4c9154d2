// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "ui/models/budget_table_model.h"

#include <QTest>

#include <limits>

using namespace gripscope;

class ImprovementAdviceTest : public QObject {
    Q_OBJECT
private slots:
    void noiseAsksForALongerSqueeze()
    {
        const QStringList advice = improvementAdvice(ImprovementFacts{{0.03, 0.02, 0.01}, 80, {}});
        QCOMPARE(advice,
                 QStringList{QStringLiteral(
                     "Noise dominates the error of m, b and k: squeeze 4 times longer to halve it.")});
    }
    void noiseThatIsMostButNotAllPromisesLess()
    {
        const ImprovementFacts facts{{0.03, 0.02, 0.01},
                                     80,
                                     {{QStringLiteral("position_noise"), {0.4, 0.4, 0.4}},
                                      {QStringLiteral("force_noise"), {0.3, 0.3, 0.3}},
                                      {QStringLiteral("lag"), {0.3, 0.3, 0.3}}}};
        QCOMPARE(improvementAdvice(facts).size(), qsizetype(1)); // both noises are one
        QVERIFY(improvementAdvice(facts).first().contains(QStringLiteral("halve that part")));
    }
    void theEffectThatDominatesIsNamedForItsParameters()
    {
        const ImprovementFacts facts{{0.1, 0.02, 0.01},
                                     80,
                                     {{QStringLiteral("noise"), {0.2, 0.95, 0.1}},
                                      {QStringLiteral("lag"), {0.8, 0.05, 0.1}},
                                      {QStringLiteral("calibration"), {0, 0, 0.8}}}};
        const QStringList advice = improvementAdvice(facts);
        QCOMPARE(advice.size(), qsizetype(3));
        QVERIFY(
            advice[0].startsWith(QStringLiteral("The lag between the channels dominates the error of m: ")));
        QVERIFY(advice[1].startsWith(QStringLiteral("Noise dominates the error of b")));
        QVERIFY(advice[2].startsWith(QStringLiteral("The calibration dominates the error of k")));
    }
    void theWorstParameterAsksForItsBand()
    {
        QVERIFY(
            improvementAdvice(ImprovementFacts{{0.12, 0.02, 0.01}, 80, {}})
                .last()
                .contains(QStringLiteral("m is known 12 times worse than k: a force that changes faster")));
        QVERIFY(improvementAdvice(ImprovementFacts{{0.02, 0.12, 0.01}, 80, {}})
                    .last()
                    .contains(QStringLiteral("around 80 Hz")));
        QVERIFY(improvementAdvice(ImprovementFacts{{0.02, 0.01, 0.12}, 80, {}})
                    .last()
                    .contains(QStringLiteral("more slowly")));
    }
    void theBandIsNoMatterWhenNoiseIsNone()
    {
        const ImprovementFacts facts{{0.12, 0.02, 0.01}, 80, {{QStringLiteral("lag"), {1, 1, 1}}}};
        QCOMPARE(improvementAdvice(facts).size(), qsizetype(1));
    }
    void goodEnoughIsSaid()
    {
        const QStringList advice = improvementAdvice(ImprovementFacts{{0.004, 0.003, 0.002}, 80, {}});
        QVERIFY(advice.first().startsWith(QStringLiteral("Little is left to gain")));
    }
    void whenNothingDominatesItSaysSo()
    {
        const ImprovementFacts facts{{0.03, 0.03, 0.03},
                                     80,
                                     {{QStringLiteral("noise"), {0.34, 0.34, 0.34}},
                                      {QStringLiteral("lag"), {0.33, 0.33, 0.33}},
                                      {QStringLiteral("hold"), {0.33, 0.33, 0.33}}}};
        QCOMPARE(improvementAdvice(facts).size(), qsizetype(1));
        QVERIFY(improvementAdvice(facts).first().startsWith(QStringLiteral("No single effect dominates")));
    }
    void numbersThatDoNotExistGetNoAdvice()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(improvementAdvice(ImprovementFacts{{nan, 0.1, 0.1}, 80, {}}).isEmpty());
    }
    void anIdentificationIsAdvisedAndAnInvalidOneIsNot()
    {
        Identification identification = test::identifiedCanA();
        identification.validity.verdict = ValidityVerdict::Valid;
        QVERIFY(!improvementAdvice(identification).isEmpty());
        identification.validity.verdict = ValidityVerdict::Suspect;
        ValidityCheck notWhite;
        notWhite.id = QStringLiteral("residual_whiteness");
        notWhite.ok = false;
        identification.validity.checks.push_back(notWhite);
        QVERIFY(
            improvementAdvice(identification).first().contains(QStringLiteral("longer squeeze will not")));
        identification.validity.verdict = ValidityVerdict::Invalid;
        QVERIFY(improvementAdvice(identification).isEmpty());
        QVERIFY(improvementAdvice(Identification{}).isEmpty());
    }
};

GRIPSCOPE_TEST(ImprovementAdviceTest)
#include "improvement_advice_test.moc"
