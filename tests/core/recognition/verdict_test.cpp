// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/paper_appendix.h"
#include "core/recognition/verdict/identified_squeeze.h"
#include "core/recognition/verdict/quantity_text.h"
#include "core/recognition/verdict/verdict.h"
#include "tests/core/recognition/gaussian_types.h"
#include "tests/support/test_registry.h"

#include <Eigen/Cholesky>
#include <QTest>

#include <cmath>
#include <numeric>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

double sumOf(const QMap<QString, double>& posterior)
{
    return std::accumulate(posterior.begin(), posterior.end(), 0.0);
}

std::vector<TypeSqueeze> without(std::vector<TypeSqueeze> squeezes, const QString& type)
{
    std::erase_if(squeezes, [&](const TypeSqueeze& squeeze) { return squeeze.type == type; });
    return squeezes;
}

/// One squeeze each side of m = 0.04, b = 40, k = 10,000 in each of the three parameters: scatter of about 1
/// %.
std::vector<TypeSqueeze> cross(const QString& type, double stiffness)
{
    std::vector<TypeSqueeze> squeezes;
    for (double e : {0.99, 1 / 0.99}) {
        squeezes.push_back({type, {0.04 * e, 40, stiffness}});
        squeezes.push_back({type, {0.04, 40 * e, stiffness}});
        squeezes.push_back({type, {0.04, 40, stiffness * e}});
    }
    return squeezes;
}

std::vector<TypeSqueeze> operator+(std::vector<TypeSqueeze> a, const std::vector<TypeSqueeze>& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Identification measured(const MassDampingStiffness& parameters)
{
    Identification identification;
    Estimate estimate;
    estimate.estimator = Estimator::OutputError;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = parameters;
    identification.estimates = {estimate};
    identification.choice.window.count = 400;
    return identification;
}

/// In the units that it has.
std::optional<TypeSqueeze> found(const Identification& identification)
{
    return identifiedSqueeze({}, identification, u"1"_s, u"1"_s);
}

} // namespace

class VerdictTest : public QObject {
    Q_OBJECT
private slots:
    void leaveOneOutOnTheAppendixIsAllCorrect()
    {
        QCOMPARE(leaveOneOutCorrect(paperSqueezesAsPrinted()), 40);
        QCOMPARE(leaveOneOutCorrect(paperSqueezesInSi()), 40);
    }
    void everyTypeOfTheAppendixThatIsLeftOutIsUnknown()
    {
        const std::vector<TypeSqueeze> all = paperSqueezesInSi();
        for (const TypeSqueeze& squeeze : all) {
            const Verdict verdict = judge(fitTypeModels(without(all, squeeze.type)), squeeze.parameters);
            QVERIFY(verdict.kind == VerdictKind::Unknown);
            QVERIFY(*verdict.distance > 2.5 * *verdict.gate); // far outside, not just so
            QVERIFY(verdict.type.isEmpty());
            QVERIFY(!verdict.nearest.isEmpty() && verdict.nearest != squeeze.type);
        }
    }
    void posteriorIsTheStudentTRatio()
    {
        const TypeModels models = fitTypeModels(cross(u"A"_s, 10000) + cross(u"B"_s, 10500));
        const MassDampingStiffness p{0.04, 40, 10200};
        const Verdict verdict = judge(models, p);
        const double v = models.degreesOfFreedom;
        const double spread = 1 + 1.0 / 6;
        const auto density = [&](std::size_t type) {
            return std::pow(1 + *squaredDistance(models, models.types[type], p) / (v * spread), -(v + 1) / 2);
        };
        const double wanted = density(0) / (density(0) + density(1));
        QVERIFY(std::abs(verdict.posterior[u"A"_s] - wanted) < 1e-12);
        QVERIFY(std::abs(sumOf(verdict.posterior) - 1) < 1e-15);
    }
    void posteriorIsCalibrated()
    {
        // Two types two deviations apart: among squeezes given about p, a share of about p is right.
        GaussianTypes source(11, 0.3, 0.5);
        double expected = 0;
        double right = 0;
        constexpr int squeezes = 4000;
        for (int i = 0; i < squeezes; ++i) {
            const TypeModels models = fitTypeModels(source.enrolment(2, 5));
            const Verdict verdict = judge(models, source.squeeze(i % 2));
            const double a = verdict.posterior[u"A"_s];
            expected += std::max(a, 1 - a);
            right += (a > 0.5) == (i % 2 == 0);
        }
        // Three sd of a binomial share near 0.95: 0.01. The means' own uncertainty is in the (1 + 1/n).
        QVERIFY2(std::abs(expected - right) / squeezes < 0.01,
                 qPrintable(u"%1 %2"_s.arg(expected).arg(right)));
    }
    void farAwayNothingUnderflows()
    {
        const TypeModels models = fitTypeModels(paperSqueezesInSi());
        for (double factor : {1e-200, 1e-6, 1e6, 1e200}) {
            const Verdict verdict = judge(models, {0.04 * factor, 43 * factor, 9990 * factor});
            QVERIFY(verdict.kind == VerdictKind::Unknown);
            QVERIFY(std::abs(sumOf(verdict.posterior) - 1) < 1e-12);
            QVERIFY(std::isfinite(*verdict.distance));
        }
    }
    void aNamedTypeSaysWhichParameterTellsAndHowFarTheNextIs()
    {
        const TypeModels models = fitTypeModels(cross(u"A"_s, 10000) + cross(u"B"_s, 11000));
        const Verdict verdict = judge(models, {0.04, 40, 9980});
        QVERIFY(verdict.kind == VerdictKind::Type);
        QCOMPARE(verdict.type, u"A"_s);
        QCOMPARE(verdict.reasons.size(), 1);
        QVERIFY2(verdict.reasons[0].describe().startsWith(
                     u"Stiffness 9.98 kN/m is where A sits; the next type, B, is "_s),
                 qPrintable(verdict.reasons[0].describe()));
        // Logs differ by log(11000/9980) = 0.0973; the sd of log k is 0.01005 sqrt(4 / 10).
        const double deviations = std::log(11000.0 / 9980) / (-std::log(0.99) * std::sqrt(0.4));
        QVERIFY2(verdict.reasons[0].describe().contains(shortNumber(deviations).describe() + u" sd"_s),
                 qPrintable(verdict.reasons[0].describe()));
    }
    void withoutUnitsReasonsNameNone()
    {
        const TypeModels models = fitTypeModels(cross(u"A"_s, 10000) + cross(u"B"_s, 11000));
        VerdictOptions options;
        options.siUnits = false;
        QVERIFY(judge(models, {0.04, 40, 9980}, options)
                    .reasons[0]
                    .describe()
                    .startsWith(u"Stiffness is where A sits"_s));
        QVERIFY(judge(models, {0.04, 40, 5000}, options)
                    .reasons[0]
                    .describe()
                    .startsWith(u"Stiffness is 50 % below"_s));
    }
    void anUnknownSaysWhatIsOffAndByHowMuch()
    {
        const TypeModels models = fitTypeModels(cross(u"A"_s, 10000) + cross(u"B"_s, 11000));
        const Verdict stiff = judge(models, {0.04, 40, 14300});
        QVERIFY(stiff.kind == VerdictKind::Unknown);
        QCOMPARE(stiff.reasons[0].describe(),
                 u"Stiffness 14.3 kN/m is 30 % above that of B, the nearest type."_s);
        QCOMPARE(judge(models, {0.04, 8, 10000}).reasons[0].describe(),
                 u"Damping 8 N s/m is 80 % below that of A, the nearest type."_s);
        QCOMPARE(judge(models, {0.12, 40, 10000}).reasons[0].describe(),
                 u"Mass 120 g is 3 times that of A, the nearest type."_s);
        QVERIFY(stiff.reasons[1].describe().contains(u"stay within"_s));
    }
    void anUnknownCombinationSaysThatItIsTheCombination()
    {
        GaussianTypes source(3, 0.99);
        const TypeModels models = fitTypeModels(source.enrolment(1, 30));
        // 1.5 sd up in m and as much down in k, where both always go together.
        const Verdict verdict = judge(models, {std::exp(0.06), 1, std::exp(-0.06)});
        QVERIFY(verdict.kind == VerdictKind::Unknown);
        QVERIFY(verdict.reasons.back().describe().contains(u"not the three together"_s));
    }
    void betweenTwoTypesItIsInconclusive()
    {
        const TypeModels models = fitTypeModels(cross(u"A"_s, 10000) + cross(u"B"_s, 10200));
        const Verdict verdict = judge(models, {0.04, 40, 10090});
        QVERIFY(verdict.kind == VerdictKind::Inconclusive);
        QVERIFY(verdict.type.isEmpty());
        QVERIFY(verdict.reasons[0].describe().startsWith(u"The squeeze could be A ("_s));
        VerdictOptions bold;
        bold.wrongType = 0.5;
        QVERIFY(judge(models, {0.04, 40, 10090}, bold).kind == VerdictKind::Type);
    }
    void withoutAGateItSaysHowManySqueezesAreMissing()
    {
        GaussianTypes source(1, 0);
        const Verdict one = judge(fitTypeModels(source.enrolment(1, 1)), source.squeeze(0));
        QVERIFY(one.kind == VerdictKind::Inconclusive);
        QVERIFY(one.reasons[0].describe().contains(u"3 more are needed"_s));
        QVERIFY(!one.gate && !one.distance);
        QCOMPARE(one.nearest, u"A"_s);
        const Verdict two = judge(fitTypeModels(source.enrolment(2, 1)), source.squeeze(1));
        QCOMPARE(two.nearest, u"B"_s);
        QCOMPARE(two.posterior[u"A"_s], 0.5);
        const Verdict three = judge(fitTypeModels(source.enrolment(1, 3)), source.squeeze(0));
        QVERIFY(three.kind == VerdictKind::Inconclusive);
        QVERIFY(three.reasons[0].describe().contains(u"1 more is needed"_s));
        QVERIFY(judge(fitTypeModels(source.enrolment(1, 4)), source.squeeze(0)).gate);
    }
    void withNoTypeItIsInconclusive()
    {
        const Verdict verdict = judge(TypeModels{}, MassDampingStiffness{0.04, 43, 9990});
        QVERIFY(verdict.kind == VerdictKind::Inconclusive);
        QVERIFY(verdict.nearest.isEmpty());
        QVERIFY(verdict.posterior.isEmpty());
        QCOMPARE(described(verdict.reasons), QStringList({u"No type is enrolled and approved yet."_s}));
    }
    void oneTypeIsNamedOrRefused()
    {
        const TypeModels models = fitTypeModels(cross(u"A"_s, 10000));
        QVERIFY(judge(models, {0.04, 40, 10000}).kind == VerdictKind::Type);
        QVERIFY(judge(models, {0.04, 40, 15000}).kind == VerdictKind::Unknown);
    }
    void gateIntervalsAreTheBoxAboutTheGate_data()
    {
        QTest::addColumn<bool>("robust");
        QTest::newRow("on average") << false;
        QTest::newRow("with a confidence, robust") << true;
    }
    void gateIntervalsAreTheBoxAboutTheGate()
    {
        QFETCH(bool, robust);
        VerdictOptions options;
        options.robust = robust;
        if (robust)
            options.confidence = 0.95;
        std::vector<TypeSqueeze> ofA = paperSqueezesInSi();
        std::erase_if(ofA, [](const TypeSqueeze& squeeze) { return squeeze.type != u"A"_s; });
        const TypeModels models = fitTypeModels(ofA);
        const Eigen::Vector3d mean = models.types[0].meanLog;
        const Eigen::Matrix3d factor = models.covarianceLog.llt().matrixL();
        // Out from the mean, in many directions, to where judge() has its gate.
        Eigen::Vector3d reached = Eigen::Vector3d::Zero();
        constexpr int directions = 2000;
        for (int i = 0; i < directions; ++i) {
            const double up = 1 - (2 * i + 1.0) / directions, turn = i * 2.399963229728653; // golden angle
            const double out = std::sqrt(1 - up * up);
            const Eigen::Vector3d step =
                0.1 * factor * Eigen::Vector3d(out * std::cos(turn), out * std::sin(turn), up);
            const Eigen::Vector3d p = (mean + step).array().exp();
            const Verdict verdict = judge(models, {p[0], p[1], p[2]}, options);
            reached = reached.cwiseMax(std::sqrt(*verdict.gate / *verdict.distance) * step);
        }
        const std::vector<GateIntervals> gates = gateIntervals(models, options);
        QCOMPARE(gates.size(), std::size_t(1));
        for (int i = 0; i < 3; ++i) {
            const TypeInterval& gate = gates[0][std::size_t(i)];
            const double reach = std::log(gate.high / gate.mean);
            QVERIFY(std::abs(std::log(gate.mean) - mean[i]) < 1e-12);
            QVERIFY(std::abs(std::log(gate.mean / gate.low) - reach) < 1e-12);
            // 2,000 directions come within 0.05 rad of any: cos of it is 0.9988.
            QVERIFY2(reached[i] < reach * (1 + 1e-9) && reached[i] > 0.998 * reach,
                     qPrintable(u"%1, %2"_s.arg(reached[i]).arg(reach)));
        }
        QVERIFY(gateIntervals({}, options).empty());
        ofA.resize(2); // too few for a gate
        QVERIFY(gateIntervals(fitTypeModels(ofA), options).empty());
    }
    void parametersThatCannotBeAreInvalid()
    {
        const TypeModels models = fitTypeModels(paperSqueezesInSi());
        for (const MassDampingStiffness& p :
             {MassDampingStiffness{0, 43, 9990}, MassDampingStiffness{0.04, -1, 9990},
              MassDampingStiffness{0.04, 43, std::nan("")}}) {
            const Verdict verdict = judge(models, p);
            QVERIFY(verdict.kind == VerdictKind::Invalid);
            QVERIFY(!verdict.reasons.empty());
        }
    }
    void aMeasurementIsScaledToTheModelsUnits()
    {
        const TypeModels models = fitTypeModels(cross(u"A"_s, 10000));
        const Identification inMillimetres = measured({4e-5, 0.04, 10});
        const Verdict verdict =
            judge(models, inMillimetres, identifiedSqueeze({}, inMillimetres, u"N"_s, u"mm"_s));
        QVERIFY(verdict.kind == VerdictKind::Type);
        QCOMPARE(verdict.samplesUsed, std::size_t(400));
    }
    void aBadMeasurementIsInvalidWithTheChecksWords()
    {
        const TypeModels models = fitTypeModels(cross(u"A"_s, 10000));
        Identification identification = measured({0.04, 40, 10000});
        identification.validity.verdict = ValidityVerdict::Invalid;
        identification.validity.checks = {
            {u"samples_lost"_s, false, true, {}, {}, u"12 samples were lost."_s},
            {u"fit"_s, false, false, {}, {}, u"The fit is poor."_s},
            {u"hold"_s, true, true, {}, {}, u"The hold is known."_s}};
        const Verdict verdict = judge(models, identification, found(identification));
        QVERIFY(verdict.kind == VerdictKind::Invalid);
        QCOMPARE(described(verdict.reasons), QStringList({u"12 samples were lost."_s}));
        QCOMPARE(verdict.samplesUsed, std::size_t(400));
        identification.validity.verdict = ValidityVerdict::Suspect;
        QVERIFY(judge(models, identification, found(identification)).kind == VerdictKind::Type);
    }
    void aMeasurementWithoutParametersIsInvalidWithTheEstimatesWords()
    {
        const TypeModels models = fitTypeModels(cross(u"A"_s, 10000));
        Identification identification = measured({});
        identification.estimates[0].parameters.reset();
        identification.estimates[0].status = EstimateStatus::NotIdentifiable;
        identification.estimates[0].message = u"The force is constant."_s;
        QCOMPARE(described(judge(models, identification, found(identification)).reasons),
                 QStringList({u"The force is constant."_s}));
        const Verdict empty = judge(models, Identification{}, found({}));
        QVERIFY(empty.kind == VerdictKind::Invalid);
        QCOMPARE(empty.reasons.size(), 1);
    }
    void ratesOutOfRangeAreErrors()
    {
        QVERIFY(!VerdictOptions{}.validate());
        for (double rate : {0.0, -1.0, 1.0, 1e-9, std::nan("")}) {
            QVERIFY((VerdictOptions{rate, 0.001}.validate()));
            QVERIFY((VerdictOptions{0.01, rate}.validate()));
        }
    }
    void namesReadBack()
    {
        for (VerdictKind kind :
             {VerdictKind::Type, VerdictKind::Unknown, VerdictKind::Inconclusive, VerdictKind::Invalid})
            QVERIFY(verdictKindFromString(toString(kind)) == kind);
        QVERIFY(!verdictKindFromString(u"maybe"_s));
    }
    void quantitiesHaveThreeDigitsAndAPrefix()
    {
        using Q = MechanicalQuantity;
        QCOMPARE(Finding::quantity(Q::Mass, 0.0396).describe(), u"39.6 g"_s);
        QCOMPARE(Finding::quantity(Q::Mass, 1.5).describe(), u"1.5 kg"_s);
        QCOMPARE(Finding::quantity(Q::Stiffness, 9984).describe(), u"9.98 kN/m"_s);
        QCOMPARE(Finding::quantity(Q::Stiffness, 999.6).describe(), u"1 kN/m"_s);
        QCOMPARE(Finding::quantity(Q::Stiffness, 1e12).describe(), u"1000 GN/m"_s);
        QCOMPARE(Finding::quantity(Q::Damping, 43).describe(), u"43 N s/m"_s);
        QCOMPARE(Finding::quantity(Q::Damping, 0.0021).describe(), u"2.1 mN s/m"_s);
        QCOMPARE(Finding::quantity(Q::Mass, 4.2e-6).describe(), u"4.2 mg"_s);
        QCOMPARE(Finding::quantity(Q::Mass, 4.2e-9).describe(), u"4.2 µg"_s);
        QCOMPARE(Finding::quantity(Q::Mass, 0).describe(), u"0 g"_s);
    }
};

GRIPSCOPE_TEST(VerdictTest)
#include "verdict_test.moc"
