// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/conformity/conformity.h"
#include "core/quality/conformity/conformity_json.h"
#include "core/quality/conformity/limit_risks.h"
#include "tests/support/test_registry.h"

#include <QJsonDocument>
#include <QTest>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

using D = ConformityDecision;
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

PartLimits stiffnessLimits(std::optional<double> lower, std::optional<double> upper,
                           ConformityRule rule = ConformityRule::Iso14253)
{
    PartLimits limits;
    limits.quantities[2] = ToleranceLimits{lower, upper};
    limits.rule = rule;
    return limits;
}

MeasuredValues stiffness(double k, std::optional<double> u, std::optional<double> v = {})
{
    return {std::nullopt, std::nullopt, MeasuredValue{k, u, v}};
}

/// Student's density with v degrees of freedom; the normal one without.
double densityAt(double t, std::optional<double> v)
{
    if (!v)
        return std::exp(-t * t / 2) / std::sqrt(2 * std::numbers::pi);
    return std::exp(std::lgamma((*v + 1) / 2) - std::lgamma(*v / 2)) / std::sqrt(*v * std::numbers::pi) *
           std::pow(1 + t * t / *v, -(*v + 1) / 2);
}

/// The probability that the part is between the limits, by midpoints in asinh(t), for the long tails.
double conformingByMidpoints(const ToleranceLimits& limits, double value, double u, std::optional<double> v)
{
    const double reach = v ? 4000 : 12; // what is beyond is below 1e-7 with 3 degrees of freedom
    const double low = std::asinh(limits.lower ? std::max(-reach, (*limits.lower - value) / u) : -reach);
    const double high = std::asinh(limits.upper ? std::min(reach, (*limits.upper - value) / u) : reach);
    constexpr int steps = 20'000;
    double sum = 0;
    for (int i = 0; i < steps && low < high; ++i) {
        const double x = low + (i + 0.5) * (high - low) / steps;
        sum += densityAt(std::sinh(x), v) * std::cosh(x) * (high - low) / steps;
    }
    return sum;
}

D decisionOn(const PartLimits& limits, const MeasuredValues& measured)
{
    const auto found = judgeConformity(limits, measured);
    return found ? found->decision : D::NotDecidable;
}

} // namespace

class PartConformityTest : public QObject {
    Q_OBJECT

private slots:
    void theSpecificRiskIsTheIntegral_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("uncertainty");
        QTest::addColumn<double>("freedom");
        for (const double k : {11.2, 11.5, 12.0, 12.4, 12.9})
            for (const double u : {0.05, 0.3, 2.0})
                for (const double v : {0.0, 3.0, 30.0})
                    QTest::addRow("%g %g %g", k, u, v) << k << u << v;
    }
    void theSpecificRiskIsTheIntegral()
    {
        QFETCH(double, value);
        QFETCH(double, uncertainty);
        QFETCH(double, freedom);
        const std::optional<double> v = freedom > 0 ? std::optional(freedom) : std::nullopt;
        for (const ToleranceLimits& own :
             {ToleranceLimits{11.5, 12.5}, ToleranceLimits{11.5, {}}, ToleranceLimits{{}, 12.5}}) {
            PartLimits limits;
            limits.quantities[2] = own;
            const auto found = judgeConformity(limits, stiffness(value, uncertainty, v));
            QVERIFY(found);
            const double wanted = 1 - conformingByMidpoints(own, value, uncertainty, v);
            QVERIFY2(std::abs(found->quantities[2]->risk.value() - wanted) < 2e-6,
                     qPrintable(u"%1 against %2"_s.arg(*found->quantities[2]->risk).arg(wanted)));
        }
    }

    void theGuardBandLeavesFivePercentAtOneLimit()
    {
        // 1.645 and Student's 2.353 (3 degrees of freedom), one-sided 95 %: tables.
        const auto normal = judgeConformity(stiffnessLimits({}, 12.5), stiffness(12, 0.1));
        QVERIFY(std::abs(*normal->quantities[2]->guard - 0.1644854) < 1e-6);
        const auto student = judgeConformity(stiffnessLimits({}, 12.5), stiffness(12, 0.1, 3));
        QVERIFY(std::abs(*student->quantities[2]->guard - 0.2353363) < 1e-6);
        const auto atItsEnd = judgeConformity(stiffnessLimits({}, 12.5), stiffness(12.5 - 0.1644854, 0.1));
        QVERIFY(std::abs(*atItsEnd->quantities[2]->risk - 0.05) < 1e-6);
    }

    void decides_data()
    {
        QTest::addColumn<int>("rule");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("uncertainty");
        QTest::addColumn<int>("decision");
        const auto row = [](const char* name, ConformityRule rule, double value, double u, D decision) {
            QTest::newRow(name) << int(rule) << value << u << int(decision);
        };
        using R = ConformityRule;
        row("iso, middle", R::Iso14253, 12, 0.1, D::Conforms);
        row("iso, just inside the guard band", R::Iso14253, 12.34, 0.1, D::TooNearTheLimit);
        row("iso, just clear of it", R::Iso14253, 12.33, 0.1, D::Conforms);
        row("iso, beyond, not proven", R::Iso14253, 12.66, 0.1, D::TooNearTheLimit);
        row("iso, beyond, proven", R::Iso14253, 12.67, 0.1, D::DoesNotConform);
        row("iso, below, proven", R::Iso14253, 11.33, 0.1, D::DoesNotConform);
        row("iso, more uncertain than the tolerance", R::Iso14253, 12, 1, D::TooNearTheLimit);
        row("iso, no uncertainty", R::Iso14253, 12, notANumber, D::NotDecidable);
        row("iso, an uncertainty of zero", R::Iso14253, 12, 0, D::NotDecidable);
        row("iso, no value", R::Iso14253, notANumber, 0.1, D::NotDecidable);
        row("simple, inside", R::Simple, 12.49, 1, D::Conforms);
        row("simple, on the limit", R::Simple, 12.5, 1, D::Conforms);
        row("simple, beyond", R::Simple, 12.51, 1, D::DoesNotConform);
        row("simple, no uncertainty", R::Simple, 12, notANumber, D::Conforms);
        row("risk, clear", R::ConsumersRisk, 12.33, 0.1, D::Conforms);
        row("risk, near", R::ConsumersRisk, 12.34, 0.1, D::TooNearTheLimit);
        row("risk, proven", R::ConsumersRisk, 12.67, 0.1, D::DoesNotConform);
        // 0.5 is 1.67 u away on either side: each tail is below 5 %, both together are not.
        row("iso, two limits close together", R::Iso14253, 12, 0.3, D::Conforms);
        row("risk, two limits close together", R::ConsumersRisk, 12, 0.3, D::TooNearTheLimit);
    }
    void decides()
    {
        QFETCH(int, rule);
        QFETCH(double, value);
        QFETCH(double, uncertainty);
        QFETCH(int, decision);
        const auto limits = stiffnessLimits(11.5, 12.5, ConformityRule(rule));
        const auto found = judgeConformity(limits, stiffness(value, uncertainty));
        QVERIFY(found);
        QCOMPARE(int(found->decision), decision);
        for (const auto& number : {found->quantities[2]->value, found->quantities[2]->risk,
                                   found->quantities[2]->guard, found->quantities[2]->standardUncertainty})
            QVERIFY(!number || std::isfinite(*number));
    }

    void oneQuantityThatDoesNotConformDecides()
    {
        PartLimits limits = stiffnessLimits(11.5, 12.5);
        limits.quantities[0] = ToleranceLimits{{}, 0.05};
        const auto both = [](double m, double k) {
            return MeasuredValues{MeasuredValue{m, 0.001}, {}, MeasuredValue{k, 0.1}};
        };
        QVERIFY(decisionOn(limits, both(0.04, 12)) == D::Conforms);
        QVERIFY(decisionOn(limits, both(0.06, 12)) == D::DoesNotConform);
        QVERIFY(decisionOn(limits, both(0.06, 12.45)) == D::DoesNotConform);
        QVERIFY(decisionOn(limits, both(0.04, 12.45)) == D::TooNearTheLimit);
        // Without the mass nothing is said against the part, nor for it.
        QVERIFY(decisionOn(limits, stiffness(12, 0.1)) == D::NotDecidable);
        QVERIFY(decisionOn(limits, stiffness(12.45, 0.1)) == D::TooNearTheLimit);
        QVERIFY(decisionOn(limits, stiffness(13, 0.1)) == D::DoesNotConform);
    }

    /// Of parts just at the limit, the rule accepts as many as it says.
    void ofPartsAtTheLimitOneInTwentyIsAccepted()
    {
        std::mt19937_64 random(7);
        std::normal_distribution<double> error(0, 0.1);
        int accepted = 0;
        constexpr int parts = 40'000;
        for (int i = 0; i < parts; ++i)
            accepted +=
                decisionOn(stiffnessLimits({}, 12.5), stiffness(12.5 + error(random), 0.1)) == D::Conforms;
        // A binomial deviation of 0.11 %; four of them.
        QVERIFY(std::abs(double(accepted) / parts - 0.05) < 0.0045);
    }

    void saysWhatDecides()
    {
        const auto words = [](double value, double u, std::optional<double> si = 1000.0) {
            return inWords(*judgeConformity(stiffnessLimits(11.5, 12.5), stiffness(value, u), si)).english();
        };
        QCOMPARE(words(12, 0.1), u"Conforms."_s);
        QCOMPARE(words(12.9, 0.1), u"Does not conform: k 12.9 kN/m is above 12.5 kN/m."_s);
        QCOMPARE(words(11, 0.1), u"Does not conform: k 11 kN/m is below 11.5 kN/m."_s);
        QCOMPARE(words(12.9, 0.1, std::nullopt), u"Does not conform: k 12.9 is above 12.5."_s);
        QCOMPARE(words(12.54, 0.001), u"Does not conform: k is 0.32 % above 12.5 kN/m."_s);
        QCOMPARE(words(12.4, 0.1), u"Too near the limit for this squeeze: k 12.4 kN/m against 12.5 kN/m, the "
                                   "risk not to conform is 16 %."_s);
        const auto without = judgeConformity(stiffnessLimits(11.5, 12.5), {});
        QCOMPARE(inWords(*without).english(), u"Not decidable by this squeeze: it does not determine k."_s);
    }

    void refusesWhatAreNoLimits_data()
    {
        QTest::addColumn<double>("lower");
        QTest::addColumn<double>("upper");
        QTest::newRow("none") << notANumber << notANumber;
        QTest::newRow("the wrong way round") << 12.5 << 11.5;
        QTest::newRow("equal") << 12. << 12.;
        QTest::newRow("not above zero") << 0. << 12.;
        QTest::newRow("infinite") << 1. << double(INFINITY);
    }
    void refusesWhatAreNoLimits()
    {
        QFETCH(double, lower);
        QFETCH(double, upper);
        const auto side = [](double limit) {
            return std::isnan(limit) ? std::nullopt : std::optional(limit);
        };
        const auto found = judgeConformity(stiffnessLimits(side(lower), side(upper)), stiffness(12, 0.1));
        QVERIFY(!found);
        QVERIFY(found.error().code == ErrorCode::Usage);
    }
    void refusesARiskOutOfRange()
    {
        for (const double risk : {0.0, 0.5, -1.0, notANumber}) {
            PartLimits limits = stiffnessLimits(11.5, 12.5, ConformityRule::ConsumersRisk);
            limits.risk = risk;
            QVERIFY(limits.validate());
        }
    }

    void limitsReadBackAsTheyWere()
    {
        PartLimits limits = stiffnessLimits(0.1 + 0.2, {}, ConformityRule::ConsumersRisk);
        limits.quantities[0] = ToleranceLimits{{}, 1. / 3};
        limits.quantities[1] = ToleranceLimits{1e-300, 1e300};
        limits.risk = 0.01;
        QVERIFY(partLimitsFromText(toText(limits)) == limits);
        QVERIFY(partLimitsFromText(QString())->isEmpty());
        QCOMPARE(toText(stiffnessLimits(11.5, 12.5)), u"k=11.5:12.5 rule=iso14253"_s);
        for (const QString& text :
             {u"k"_s, u"k=1"_s, u"k=1:2:3"_s, u"k=2:1"_s, u"q=1:2"_s, u"k=a:2"_s, u"k=1:2 rule=none"_s,
              u"k=1:2 rule=risk risk=2"_s, u"k=:"_s, u"k=nan:1"_s})
            QVERIFY2(!partLimitsFromText(text), qPrintable(text));
    }

    void aDecisionReadsBackAsItWas()
    {
        PartLimits limits = stiffnessLimits(11.5, 12.5, ConformityRule::ConsumersRisk);
        limits.quantities[0] = ToleranceLimits{{}, 0.05};
        limits.risk = 0.02;
        for (const MeasuredValues& measured : {stiffness(12, 0.1), stiffness(12.4, 0.1, 5), {}}) {
            const auto found = judgeConformity(limits, measured, 1000.0);
            const QByteArray text = QJsonDocument(conformityJson(*found)).toJson();
            QVERIFY(conformityFromJson(QJsonDocument::fromJson(text).object()) == *found);
        }
        QVERIFY(!conformityFromJson({}));
        QVERIFY(!conformityFromJson({{u"decision"_s, u"perhaps"_s}, {u"rule"_s, u"simple"_s}}));
    }

    /// A million parts of that process, each measured once, against what limitRisks() says of squeezes that
    /// show this process.
    void theRisksAreThoseOfSimulatedParts()
    {
        std::mt19937_64 random(11);
        std::normal_distribution<double> normal(0, 1);
        constexpr double mean = 12.1, deviation = 0.2, u = 0.1;
        std::vector<MeasuredValues> squeezes;
        for (int i = 0; i < 20'000; ++i)
            squeezes.push_back(stiffness(mean + deviation * normal(random) + u * normal(random), u));
        const PartLimits limits = stiffnessLimits(11.5, 12.5);
        const auto risks = limitRisks(limits, squeezes);
        QVERIFY(risks && (*risks)[2] && !(*risks)[0]);
        const QuantityRisks& found = *(*risks)[2];
        QVERIFY(std::abs(found.mean - mean) < 0.01);
        QVERIFY(std::abs(found.deviation - deviation) < 0.006); // 0.005 relative of 0.224, four deviations
        QVERIFY(!found.deviationIsOfSqueezes);
        QVERIFY(std::abs(found.uncertainty - u) < 1e-12);
        int wronglyAccepted = 0, wronglyRejected = 0;
        constexpr int parts = 1'000'000;
        for (int i = 0; i < parts; ++i) {
            const double part = found.mean + found.deviation * normal(random);
            const double value = part + u * normal(random);
            const bool accepted = value >= 11.5 + found.guard && value <= 12.5 - found.guard;
            const bool conforms = part >= 11.5 && part <= 12.5;
            wronglyAccepted += accepted && !conforms;
            wronglyRejected += !accepted && conforms;
        }
        // Four binomial deviations.
        const auto agrees = [](double simulated, double risk) {
            return std::abs(simulated - risk) < 4 * std::sqrt(risk * (1 - risk) / parts) + 1e-6;
        };
        QVERIFY(agrees(double(wronglyAccepted) / parts, found.risks.consumers));
        QVERIFY(agrees(double(wronglyRejected) / parts, found.risks.producers));
    }

    void risksNeedSqueezes()
    {
        const PartLimits limits = stiffnessLimits(11.5, 12.5);
        QVERIFY(!(*limitRisks(limits, {stiffness(12, 0.1), stiffness(12.1, 0.1)}))[2]);
        QVERIFY(!(*limitRisks(limits, std::vector<MeasuredValues>(5, stiffness(12, 0.1))))[2]);
        QVERIFY(!(*limitRisks(limits, std::vector<MeasuredValues>(5, stiffness(12, {}))))[2]);
        QVERIFY(!limitRisks(PartLimits{}, {}));
        const auto alike =
            limitRisks(limits, {stiffness(12, 0.1), stiffness(12.01, 0.1), stiffness(12.02, 0.1)});
        QVERIFY((*alike)[2]->deviationIsOfSqueezes);
        QVERIFY(std::abs((*alike)[2]->deviation - 0.01) < 1e-9);
    }
};

GRIPSCOPE_TEST(PartConformityTest)
#include "part_conformity_test.moc"
