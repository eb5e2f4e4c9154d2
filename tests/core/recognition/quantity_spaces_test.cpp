// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/distributions.h"
#include "core/recognition/early/early_stop.h"
#include "core/recognition/enrolment/enrollment_guidance.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/verdict/judgement.h"
#include "core/recognition/verdict/transfer.h"
#include "tests/core/recognition/space_types.h"
#include "tests/support/test_registry.h"

#include <QTest>
#include <boost/math/distributions/students_t.hpp>

#include <cmath>
#include <memory>
#include <numbers>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

constexpr double rate = 0.01;

void everySpace()
{
    QTest::addColumn<int>("p");
    for (const int p : {1, 2, 3, 5, 6})
        QTest::addRow("p = %d", p) << p;
}

bool near(double found, double expected, double share)
{
    return std::abs(found / expected - 1) < share;
}

QString allReasons(const Verdict& verdict)
{
    return described(verdict.reasons).join(u' ');
}

/// Ten squeezes each of A and B, k about 1 and 2.7.
std::vector<TypeSqueeze> squeezesOfStiffness()
{
    return SpaceTypes(1, spaceOfDimensions(1)).enrolment(2, 10);
}

TypeModels stiffnessAlone()
{
    return fitTypeModels(squeezesOfStiffness(), spaceOfDimensions(1));
}

} // namespace

class QuantitySpacesTest : public QObject {
    Q_OBJECT
private slots:
    void gatesOfOneQuantityAreStudents()
    {
        for (const double v : {1.0, 4.5, 30.0}) {
            const double t = studentQuantileAbove(rate / 2, v);
            QVERIFY(near(*predictiveGate(v, rate, 1), t * t, 1e-10));
            QVERIFY(near(chanceBeyond(t * t, v, 1), rate, 1e-10));
        }
        const double z = normalQuantileAbove(rate / 2);
        QVERIFY(near(chiSquaredGate(rate, 1), z * z, 1e-10));
        const double t = studentQuantileAbove(rate / 2, 5); // of unit variance, 5/3 taken out
        QVERIFY(near(heavyTailFactor(rate, 1), 0.6 * t * t / (z * z), 1e-10));
    }
    void gatesOfTwoQuantitiesHaveClosedForms()
    {
        // F of 2 and n degrees of freedom exceeds x with (1 + 2 x / n)^(-n / 2).
        for (const double v : {2.0, 7.0, 40.0})
            QVERIFY(near(*predictiveGate(v, rate, 2), v * (std::pow(rate, -2 / (v - 1)) - 1), 1e-9));
        QVERIFY(near(chiSquaredGate(rate, 2), -2 * std::log(rate), 1e-10));
    }
    void gatesOfAnySpace_data() { everySpace(); }
    void gatesOfAnySpace()
    {
        QFETCH(int, p);
        QVERIFY(!predictiveGate(p - 0.01, rate, p));
        QVERIFY(!toleranceGate(5, p - 0.01, rate, 0.95, p));
        QVERIFY(predictiveGate(p, rate, p).has_value());
        const double known = chiSquaredGate(rate, p);
        QVERIFY(near(*predictiveGate(1e7, rate, p), known, 1e-5));
        QVERIFY(near(*toleranceGate(1'000'000, 1e5, rate, 0.95, p), known, 0.02));
        for (const double v : {p + 0.5, 20.0})
            QVERIFY(near(chanceBeyond(*predictiveGate(v, rate, p), v, p), rate, 1e-8));
        QVERIFY(*toleranceGate(10, 20, rate, 0.95, p) > 1.1 * *predictiveGate(20, rate, p));
    }
    void toleranceGateOfOneQuantityIsThatOfTables()
    {
        // Two-sided factors for 99 % of a normal population with 95 % confidence: 4.433 from 10, 3.615 from
        // 20 (Odeh and Owen). 10,000 draws know the confidence to 0.2 %, that is the factor to about 0.5 %.
        QVERIFY(near(std::sqrt(*toleranceGate(10, 9, rate, 0.95, 1)), 4.433, 0.015));
        QVERIFY(near(std::sqrt(*toleranceGate(20, 19, rate, 0.95, 1)), 3.615, 0.015));
    }
    void densityOfOneQuantityIsStudents()
    {
        const TypeModels models = stiffnessAlone();
        const LogVector log = LogVector::Constant(1, 0.07);
        const TypePrediction found = predictType(models, models.types[0], log, {}, {});
        // The variance about the mean that is known from 10 squeezes, over 18 degrees of freedom.
        QCOMPARE(found.degreesOfFreedom, 18.0);
        const double scale = std::sqrt(1.1 * models.covarianceLog(0, 0));
        const boost::math::students_t student(18);
        const double density =
            boost::math::pdf(student, (log(0) - models.types[0].meanLog(0)) / scale) / scale;
        QVERIFY(std::abs(found.logDensity - std::log(density)) < 1e-10);
    }
    void densitiesIntegrateToOne_data() { everySpace(); }
    void densitiesIntegrateToOne()
    {
        QFETCH(int, p);
        SpaceTypes source(2, spaceOfDimensions(p));
        const TypeModels models = fitTypeModels(source.enrolment(2, 10), spaceOfDimensions(p));
        for (const bool robust : {false, true}) {
            // Over spheres of d' V^-1 d = r^2: 2 pi^(p/2) / G(p/2) r^(p-1) |V|^(1/2), with r = tan(angle).
            constexpr int steps = 4000;
            double sum = 0;
            for (int i = 0; i < steps; ++i) {
                const double angle = (i + 0.5) / steps * std::numbers::pi / 2, r = std::tan(angle);
                LogVector log = models.types[0].meanLog;
                log(0) += 0.04 * r;
                const TypePrediction seen = predictType(models, models.types[0], log, {}, {robust});
                const double ratio = std::sqrt(seen.squaredDistance) / r; // of this r to that of 4 %
                const double surface = std::log(2.0) + p / 2.0 * std::log(std::numbers::pi) -
                                       logGamma(p / 2.0) + (p - 1) * std::log(ratio * r) +
                                       seen.logDeterminant / 2;
                sum += std::exp(seen.logDensity + surface) * ratio * (1 + r * r);
            }
            QVERIFY2(std::abs(sum * std::numbers::pi / 2 / steps - 1) < 1e-3,
                     qPrintable(QString::number(sum)));
        }
    }
    void scatterLikeTheEnrolledHasTheirDegreesOfFreedom_data() { everySpace(); }
    void scatterLikeTheEnrolledHasTheirDegreesOfFreedom()
    {
        QFETCH(int, p);
        SpaceTypes source(3, spaceOfDimensions(p));
        const TypeModels models = fitTypeModels(source.enrolment(4, 30), spaceOfDimensions(p));
        QCOMPARE(models.degreesOfFreedom, 4 * 29);
        QVERIFY(std::abs(degreesOfFreedom(models.scatter, models.covarianceLog) - 4 * 29) < 1e-6);
        QCOMPARE(models.covarianceLog.rows(), Eigen::Index(p));
        // Each entry of a covariance over 116 degrees of freedom to 13 % of the diagonal's; 4 sd.
        QVERIFY((models.covarianceLog - source.covariance()).cwiseAbs().maxCoeff() < 0.53 * 0.0016);
        // Scatter may be alike only where quantities can be compared.
        QVERIFY(p <= 2 || !models.scatter.alikeVariance);
    }
    void squeezesOfUnlikeNoiseLeaveWhatIsBetween_data() { everySpace(); }
    void squeezesOfUnlikeNoiseLeaveWhatIsBetween()
    {
        QFETCH(int, p);
        const QuantitySpace space = spaceOfDimensions(p);
        SpaceTypes source(4, space);
        std::vector<TypeSqueeze> squeezes = source.enrolment(4, 40);
        for (std::size_t i = 0; i < squeezes.size(); ++i) {
            const double deviation = i % 2 == 0 ? 0.01 : 0.05;
            DeterminedQuantities& known = *squeezes[i].determined;
            known.log += deviation * source.normals();
            known.covariance = deviation * deviation * LogMatrix::Identity(p, p);
        }
        const TypeModels models = fitTypeModels(squeezes, space);
        QVERIFY(models.scatter.noiseKnown);
        // 80 squeezes of little noise know a variance to 16 %, with the others a little better; 3.5 sd.
        QVERIFY((models.scatter.between - source.covariance()).cwiseAbs().maxCoeff() < 0.55 * 0.0016);
    }
    void strangersOfOneQuantityFillIntervals()
    {
        const TypeModels models = stiffnessAlone();
        VerdictOptions options;
        options.range = InstrumentRange{{1e-3, 1e-1, 1e-2}, {1e1, 1e3, 1e2}};
        options.strangerAccept = 0.5; // more than what is inside the gates: nothing is cut off
        double share = 0;
        for (const GateIntervals& gate : gateIntervals(models, options)) {
            QCOMPARE(gate.size(), std::size_t(1));
            share += std::log(gate[0].high / gate[0].low) / std::log(1e4);
        }
        const Verdict verdict = judge(models, squeezeAt({}, models.space, models.types[0].meanLog), options);
        QVERIFY(near(*verdict.strangerAccept, share, 1e-9));
        options.strangerAccept = share / 3;
        const Verdict cut = judge(models, squeezeAt({}, models.space, models.types[0].meanLog), options);
        QVERIFY(near(*cut.strangerAccept, share / 3, 1e-6));
    }
    /// Where strangers forbid a name, that is what is said: not that it could be another type.
    void whatIsHeldForAStrangerSaysWhy()
    {
        const TypeModels models = stiffnessAlone();
        const TypeModel& type = models.types[0];
        const double sd = std::sqrt(models.covarianceLog(0, 0));
        VerdictOptions options;
        options.range = InstrumentRange{{1e-3, 1e-1, 1e-2}, {1e1, 1e3, 1e2}};
        const auto at = [&](double deviations) {
            return judge(models, squeezeAt({}, models.space, type.meanLog.array() + deviations * sd),
                         options);
        };
        options.strangerAccept = 0.5;
        const double gate = std::sqrt(*at(0).gate); // 2.9 or so, 5.8 sd wide, of which a third is left:
        options.strangerAccept = *at(0).strangerAccept / 3;
        QVERIFY(at(0).kind == VerdictKind::Type && !at(0).heldForStranger);
        const Verdict within = at(0.45 * gate), outer = at(0.9 * gate);
        for (const Verdict& held : {within, outer}) {
            QVERIFY(held.kind == VerdictKind::Inconclusive && held.heldForStranger);
            QVERIFY(!allReasons(held).contains(u"or B"_s));
        }
        QVERIFY2(
            allReasons(within).startsWith(
                u"The squeeze is where A sits, but so would be too many other parts: by stiffness alone, more than "_s),
            qPrintable(allReasons(within)));
        QVERIFY2(allReasons(outer).contains(u"lies so far out"_s), qPrintable(allReasons(outer)));
        const auto expected = expectedVerdicts(ModelsBySpace(squeezesOfStiffness()), u"A"_s, options);
        QVERIFY(expected && expected->undecided.isEmpty() && expected->undecidedAlone > 0.2);
    }
    void neighboursOfOneQuantityAreToldApartByStudent()
    {
        const TypeModels models = stiffnessAlone();
        const LogVector log = models.types[0].meanLog;
        const auto predictions = predictTypes(models, log, {}, {});
        for (const bool alike : {true, false}) { // one quantity is alike to itself
            auto as = predictions;
            if (!alike)
                for (TypePrediction& prediction : as)
                    prediction.alikeCovariance.reset();
            const auto found = separation(as, 0, 1, log, rate, false);
            QVERIFY(near(found->needed, std::sqrt(1.1) * studentQuantileAbove(rate, 18), 1e-6));
            QVERIFY(near(found->reached, found->distance, 1e-9));
        }
    }
    void stiffnessAloneNamesTypesAndStrangers()
    {
        const TypeModels models = stiffnessAlone();
        const auto stiff = [](double k) {
            return squeezeAt({}, spaceOfDimensions(1), LogVector::Constant(1, k));
        };
        const Verdict a = judge(models, stiff(0.02)), b = judge(models, stiff(0.97)),
                      none = judge(models, stiff(0.5));
        QCOMPARE(a.type, u"A"_s);
        QCOMPARE(b.type, u"B"_s);
        QVERIFY(none.kind == VerdictKind::Unknown);
        QVERIFY2(allReasons(none).startsWith(u"Stiffness "_s), qPrintable(allReasons(none)));
        QVERIFY2(allReasons(none).endsWith(
                     u"Judged by stiffness alone: the squeezes enrolled determine no more."_s),
                 qPrintable(allReasons(none)));
        // m, b and k determine k too.
        QCOMPARE(judge(models, MassDampingStiffness{5, 7, std::exp(0.97)}).type, u"B"_s);
        QCOMPARE(*squaredDistance(models, models.types[0], {5, 7, std::exp(models.types[0].meanLog(0))}),
                 0.0);
        const Verdict only =
            judge(fitTypeModels(SpaceTypes(1, models.space).enrolment(1, 9), models.space), stiff(0));
        QVERIFY2(allReasons(only).startsWith(u"Stiffness is where A sits; it is the only type enrolled."_s),
                 qPrintable(allReasons(only)));
    }
    void aSqueezeThatLacksAQuantityIsRefusedInWords()
    {
        using enum TypeQuantity;
        const QuantitySpace relaxing = spaceOfDimensions(3);
        const TypeModels models = fitTypeModels(SpaceTypes(5, relaxing).enrolment(2, 10), relaxing);
        const Verdict verdict = judge(models, MassDampingStiffness{1, 1, 1});
        QVERIFY(verdict.kind == VerdictKind::Invalid);
        QCOMPARE(
            allReasons(verdict),
            u"The squeeze does not determine relaxing share and relaxation time, by which the types are told apart."_s);
        const Verdict tooFew = judge(models, squeezeAt({}, {{Mass, Stiffness}}, LogVector::Zero(2)));
        QVERIFY(tooFew.kind == VerdictKind::Invalid);
        TypeSqueeze lost = squeezeAt({}, relaxing, LogVector::Zero(3));
        lost.determined->log(1) = std::nan("");
        QCOMPARE(allReasons(judge(models, lost)),
                 u"The squeeze does not determine relaxing share, by which the types are told apart."_s);
        QVERIFY(judge(fitTypeModels({}), lost).kind == VerdictKind::Invalid);
    }
    void theSpaceIsWhatMostOfEveryTypeDetermine()
    {
        using enum TypeQuantity;
        std::vector<TypeSqueeze> squeezes{{u"A"_s, {1, 2, 3}}, {u"B"_s, {2, 3, 4}}};
        QVERIFY(spaceOf({}) == QuantitySpace{});
        QVERIFY(spaceOf(squeezes) == QuantitySpace{});
        squeezes.push_back({u"A"_s, {}}); // nothing usable: it does not count
        QVERIFY(spaceOf(squeezes) == QuantitySpace{});
        squeezes.push_back(squeezeAt(u"B"_s, {{RelaxationTime, Stiffness}}, LogVector::Zero(2)));
        QVERIFY(spaceOf(squeezes) == QuantitySpace{{Stiffness}});
        QCOMPARE(fitTypeModels(squeezes, spaceOf(squeezes)).find(u"B"_s)->squeezes, 2);
        QCOMPARE(fitTypeModels(squeezes).find(u"B"_s)->squeezes, 1);
        squeezes.push_back(squeezeAt(u"B"_s, {{Friction}}, LogVector::Zero(1)));
        QVERIFY(spaceOf(squeezes) == QuantitySpace{{Stiffness}}); // one poor squeeze takes nothing away
        QCOMPARE(fitTypeModels(squeezes, spaceOf(squeezes)).find(u"B"_s)->squeezes, 2);
        squeezes.push_back(squeezeAt(u"B"_s, {{Friction}}, LogVector::Zero(1)));
        QVERIFY(spaceOf(squeezes).quantities.empty());
        QVERIFY(fitTypeModels(squeezes, spaceOf(squeezes)).types.empty());
        QCOMPARE(allReasons(judge(fitTypeModels(squeezes, spaceOf(squeezes)), squeezes[0])),
                 u"The squeezes enrolled have no quantity in common to judge by."_s);
        // The larger of two that it determines; m, b and k are not mixed with what else is determined.
        TypeSqueeze both = squeezeAt(u"A"_s, spaceOfDimensions(5), LogVector::Zero(5));
        both.parameters = {1, 2, 3};
        QVERIFY(spaceOf({both}) == spaceOfDimensions(5));
        both.determined->space = {{Stiffness, RelaxingShare, RelaxationTime}};
        both.determined->log = LogVector::Zero(3);
        QVERIFY(spaceOf({both}) == QuantitySpace{});
        QCOMPARE(toString(spaceOfDimensions(3)), u"k+k1/k+tau"_s);
    }
    void logarithmsComeInTheOrderOfTheSpace()
    {
        using enum TypeQuantity;
        TypeSqueeze squeeze =
            squeezeAt(u"A"_s, {{RelaxationTime, Mass, Stiffness}}, Eigen::Vector3d(1, 2, 3));
        squeeze.determined->covariance = LogMatrix(Eigen::Vector3d(0.1, 0.2, 0.3).asDiagonal());
        const QuantitySpace turned{{Stiffness, RelaxationTime}};
        QVERIFY(*coordinatesOf(squeeze, turned) == LogVector(Eigen::Vector2d(3, 1)));
        QVERIFY((*noiseOf(squeeze, turned) - LogMatrix(Eigen::Vector2d(0.3, 0.1).asDiagonal())).norm() <
                1e-8);
        QVERIFY(!coordinatesOf(squeeze, {{Friction}}));
        squeeze.determined->covariance = LogMatrix(LogMatrix::Constant(3, 3, -1));
        QVERIFY(!noiseOf(squeeze, turned)); // no covariance
        const TypeSqueeze motion{u"A"_s, {std::exp(1), std::exp(2), std::exp(3)}};
        QVERIFY((*coordinatesOf(motion, {{Stiffness, Mass}}) - LogVector(Eigen::Vector2d(3, 1))).norm() <
                1e-12);
    }
    void rangesOfSpacesMultiply()
    {
        const InstrumentRange range;
        QVERIFY(near(*range.logVolume(), std::pow(std::log(1e4), 3), 1e-12));
        QVERIFY(
            near(*range.logVolume(spaceOfDimensions(3)), std::pow(std::log(1e4), 2) * std::log(1e6), 1e-12));
        QVERIFY(!range.logVolume(QuantitySpace{{}}));
        VerdictOptions options;
        options.range = InstrumentRange{};
        options.range->friction.lowest = 0;
        QVERIFY(options.validate());
    }
    void otherSpacesAreSaidInFindings()
    {
        const QuantitySpace space = spaceOfDimensions(3);
        SpaceTypes source(6, space);
        std::vector<TypeSqueeze> squeezes = source.enrolment(3, 12);
        const HeldOutConfusion confusion = heldOutConfusion(squeezes);
        QCOMPARE(confusion.squeezes, 36);
        QCOMPARE(confusion.counts.topLeftCorner(3, 3).trace() + confusion.counts.col(3).sum(), 36);
        QVERIFY(leaveOneOutCorrect(squeezes) >= 34); // 1 % are unknown; three of 36 in 6,000
        const TypeModels models = fitTypeModels(squeezes, space);
        const EnrollmentProgress progress = enrollmentProgress(models, u"A"_s, {});
        QVERIFY(progress.gate && progress.stiffnessUncertainty);
        QVERIFY(near(progress.gateLimit, std::sqrt(chiSquaredGate(rate, 3)), 1e-12));
        QVERIFY(expectedVerdicts(ModelsBySpace(squeezes), u"A"_s, {})->named > 0.97);
        squeezes[4].determined->log(2) += 1;
        const auto outliers = findOutliers(squeezes, u"A"_s);
        QCOMPARE(outliers.size(), std::size_t(1));
        QCOMPARE(outliers[0].parameter, int(TypeQuantity::RelaxationTime));
        QVERIFY2(outliers[0].reason.describe().startsWith(u"Relaxation time is 3"_s),
                 qPrintable(outliers[0].reason.describe()));
    }
    void anotherGrippersErrorIsFoundAndTakenOff()
    {
        const QuantitySpace space = spaceOfDimensions(2);
        SpaceTypes source(7, space);
        const TypeModels models = fitTypeModels(source.enrolment(3, 20), space);
        std::vector<TypeSqueeze> there = source.enrolment(3, 20);
        const Eigen::Vector2d error(0.2, -0.1);
        for (TypeSqueeze& squeeze : there)
            squeeze.determined->log += error;
        const TransferReport report = measureTransfer(models, there);
        QVERIFY(report.adjust);
        QVERIFY((report.error->value - error).norm() < 4 * std::sqrt(report.error->covariance.trace()));
        QVERIFY2(report.words[0].describe().contains(u"damping +2"_s) &&
                     report.words[0].describe().contains(u", stiffness -"_s),
                 qPrintable(report.words[0].describe()));
        const TypeSqueeze back = adjusted(there[0], *report.error);
        QVERIFY((back.determined->log + report.error->value - there[0].determined->log).norm() < 1e-12);
    }
    void nothingIsDecidedEarlyInOtherSpaces()
    {
        EarlyStopSetup setup;
        setup.models = std::make_shared<TypeModels>(stiffnessAlone());
        setup.decision.sampleTime_s = 0.01;
        QVERIFY(candidateTypes(setup).empty());
        QVERIFY(!EarlyStop(setup).possible());
    }
};

GRIPSCOPE_TEST(QuantitySpacesTest)
#include "quantity_spaces_test.moc"
