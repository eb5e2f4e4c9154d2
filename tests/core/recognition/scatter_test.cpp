// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/scatter.h"
#include "core/recognition/verdict/verdict.h"
#include "tests/core/recognition/noisy_types.h"
#include "tests/support/test_registry.h"

#include <Eigen/Eigenvalues>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

double difference(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b)
{
    return (a - b).norm() / b.norm();
}

std::vector<TypeSqueeze> withoutCovariances(std::vector<TypeSqueeze> squeezes)
{
    for (TypeSqueeze& squeeze : squeezes)
        squeeze.covariance.reset();
    return squeezes;
}

} // namespace

class ScatterTest : public QObject {
    Q_OBJECT
private slots:
    void withOneCovarianceForAllItIsThePooledDifference()
    {
        const Eigen::Matrix3d c = covarianceOf(0.02, 0.03, 0.01, 0.4);
        NoisyTypes source(1, covarianceOf(0.04, 0.03, 0.05, 0.2));
        const std::vector<TypeSqueeze> squeezes = source.enrolment(3, 8, c);
        const TypeModels known = fitTypeModels(squeezes);
        const TypeModels plain = fitTypeModels(withoutCovariances(squeezes));
        QVERIFY(difference(known.covarianceLog, plain.covarianceLog) < 1e-12);
        QVERIFY(difference(known.scatter.between + c, plain.covarianceLog) < 1e-8);
        QCOMPARE(known.degreesOfFreedom, 21);
        // The squeeze's covariance is not counted twice: distance and gate are those without it.
        const TypeSqueeze next = NoisyTypes::squeeze(u"A"_s, source.log(NoisyTypes::mean(0), c), c);
        const Verdict a = judge(known, next.parameters, {}, next.covariance);
        const Verdict b = judge(plain, next.parameters);
        QVERIFY(std::abs(*a.distance / *b.distance - 1) < 1e-8);
        QVERIFY(std::abs(*a.gate / *b.gate - 1) < 1e-8);
        const std::optional<double> formula = falseRejectGate(8, 21, 0.01);
        QVERIFY(std::abs(*a.gate / *formula - 1) < 1e-8);
    }
    void aNoisierSqueezeIsHeldAgainstAWiderType()
    {
        const Eigen::Matrix3d c = covarianceOf(0.02, 0.02, 0.02, 0);
        NoisyTypes source(2, covarianceOf(0.04, 0.04, 0.04, 0));
        const TypeModels models = fitTypeModels(source.enrolment(4, 10, c));
        const Eigen::Matrix3d wide = covarianceOfSqueeze(models.scatter, 9 * c);
        QVERIFY(difference(wide, models.covarianceLog + 8 * c) < 1e-9);
        // What is known makes up more of it: more degrees of freedom.
        QVERIFY(degreesOfFreedom(models.scatter, wide) > 60);
        QVERIFY(std::abs(degreesOfFreedom(models.scatter, models.covarianceLog) - 36) < 1e-6);
    }
    void scatterIsFoundUnderUnlikeNoise()
    {
        // Every other squeeze has ten times the deviation of the others, more than the scatter.
        const Eigen::Matrix3d truth = covarianceOf(0.04, 0.03, 0.05, 0.5);
        const Eigen::Matrix3d fine = covarianceOf(0.01, 0.01, 0.01, 0.2);
        const Eigen::Matrix3d coarse = 100 * fine;
        constexpr int runs = 300;
        Eigen::Vector3d mean = Eigen::Vector3d::Zero(), square = Eigen::Vector3d::Zero();
        double degrees = 0;
        for (int run = 0; run < runs; ++run) {
            NoisyTypes source(std::uint64_t(run + 10), truth);
            std::vector<TypeSqueeze> squeezes = source.enrolment(4, 5, fine);
            for (const TypeSqueeze& more : source.enrolment(4, 5, coarse))
                squeezes.push_back(more);
            const TypeModels models = fitTypeModels(squeezes);
            const Eigen::Vector3d ratio = models.scatter.between.diagonal().cwiseQuotient(truth.diagonal());
            mean += ratio / runs;
            square += (ratio.array() - 1).square().matrix() / runs;
            degrees += degreesOfFreedom(models.scatter, models.scatter.between + fine) / runs;
        }
        // The 20 fine squeezes alone have 16 degrees of freedom; the coarse ones add a little. The pooled
        // difference would have a variance of half ((0.1^2 / 0.04^2) / 2)^2 2 / 36, ten times as much.
        QVERIFY2(degrees > 13 && degrees < 24, qPrintable(QString::number(degrees)));
        for (int i = 0; i < 3; ++i) {
            const double wanted = 2 / 16.0 * std::pow(1 + fine(i, i) / truth(i, i), 2);
            QVERIFY2(square(i) < 1.4 * wanted, qPrintable(u"%1 %2"_s.arg(square(i)).arg(wanted)));
            // Standard error of the mean of 300: 0.02.
            QVERIFY2(std::abs(mean(i) - 1) < 0.08, qPrintable(QString::number(mean(i))));
        }
    }
    void squeezesThatScatterLessThanTheySayKeepWhatWasSeen()
    {
        const Eigen::Matrix3d c = covarianceOf(0.02, 0.02, 0.02, 0);
        NoisyTypes source(3, covarianceOf(0.01, 0.01, 0.01, 0));
        const std::vector<TypeSqueeze> seen = source.enrolment(4, 10, 1e-6 * c);
        std::vector<TypeSqueeze> claimed = seen;
        for (TypeSqueeze& squeeze : claimed)
            *squeeze.covariance *= 1e6;
        const TypeModels models = fitTypeModels(claimed);
        QVERIFY(difference(models.covarianceLog, fitTypeModels(seen).covarianceLog) < 0.02);
        QVERIFY(models.scatter.between.norm() < 1e-9);
        QVERIFY(difference(covarianceOfSqueeze(models.scatter, c), models.covarianceLog) < 0.02);
    }
    void aFinerSqueezeKeepsEnoughDegreesOfFreedom()
    {
        const Eigen::Matrix3d c = covarianceOf(0.1, 0.1, 0.1, 0);
        NoisyTypes source(4, covarianceOf(0.03, 0.03, 0.03, 0));
        const TypeModels models = fitTypeModels(source.enrolment(4, 10, c));
        const Eigen::Matrix3d fine = covarianceOfSqueeze(models.scatter, 1e-4 * c);
        QVERIFY(degreesOfFreedom(models.scatter, fine) >= 17.9);
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> least(fine - models.scatter.between);
        QVERIFY(least.eigenvalues()(0) > 0);
    }
    void withoutKnownNoiseOnlyAGreaterOneWidens()
    {
        NoisyTypes source(5, covarianceOf(0.04, 0.04, 0.04, 0));
        const TypeModels models =
            fitTypeModels(withoutCovariances(source.enrolment(4, 10, covarianceOf(0.01, 0.01, 0.01, 0))));
        const Eigen::Matrix3d same = covarianceOfSqueeze(models.scatter, covarianceOf(0.01, 0.01, 0.01, 0));
        QVERIFY(difference(same, models.covarianceLog) < 1e-12);
        const Eigen::Matrix3d loud = covarianceOfSqueeze(models.scatter, covarianceOf(0.2, 0.2, 0.2, 0));
        QVERIFY(difference(loud, covarianceOf(0.2, 0.2, 0.2, 0)) < 1e-9);
    }
    void partsAndRegripAreToldApart()
    {
        const Eigen::Matrix3d part = covarianceOf(0.05, 0.04, 0.06, 0.3);
        const Eigen::Matrix3d regrip = covarianceOf(0.02, 0.03, 0.02, 0);
        NoisyTypes parts(6, part);
        NoisyTypes grips(7, regrip);
        std::vector<TypeSqueeze> squeezes;
        for (int type = 0; type < 4; ++type) {
            for (int p = 0; p < 200; ++p) {
                const Eigen::Vector3d mean = parts.log(NoisyTypes::mean(type), 1e-12 * part);
                for (int i = 0; i < 2 + p % 3; ++i) {
                    TypeSqueeze squeeze =
                        NoisyTypes::squeeze(QString(QChar(u'A' + type)), grips.log(mean, 1e-12 * part), part);
                    squeeze.covariance.reset();
                    squeeze.part = QString::number(p);
                    squeezes.push_back(squeeze);
                }
            }
        }
        const TypeModels models = fitTypeModels(squeezes);
        // 796 degrees of freedom between parts, 1600 within: a variance is known to 5 and 3.5 % (1 sd).
        for (int i = 0; i < 3; ++i) {
            QVERIFY(std::abs((*models.scatter.partToPart)(i, i) / part(i, i) - 1) < 0.2);
            QVERIFY(std::abs((*models.scatter.regrip)(i, i) / regrip(i, i) - 1) < 0.12);
            QVERIFY(std::abs(models.covarianceLog(i, i) / (part + regrip)(i, i) - 1) < 0.16);
        }
        QVERIFY(models.degreesOfFreedom > 796 && models.degreesOfFreedom < 1600);
    }
    void aNewPartIsRefusedAtTheStatedRateThoughPartsRepeat()
    {
        const Eigen::Matrix3d part = covarianceOf(0.04, 0.04, 0.04, 0);
        const Eigen::Matrix3d regrip = covarianceOf(0.02, 0.02, 0.02, 0);
        NoisyTypes parts(8, part);
        NoisyTypes grips(9, regrip);
        const Eigen::Matrix3d none = 1e-12 * part;
        constexpr int enrolments = 10'000;
        int rejected = 0, naive = 0;
        for (int run = 0; run < enrolments; ++run) {
            std::vector<TypeSqueeze> squeezes;
            for (int i = 0; i < 48; ++i) { // 4 types of 4 parts, each squeezed 3 times
                static Eigen::Vector3d mean;
                const int type = i / 12;
                if (i % 3 == 0)
                    mean = parts.log(NoisyTypes::mean(type), none);
                squeezes.push_back(
                    NoisyTypes::squeeze(QString(QChar(u'A' + type)), grips.log(mean, none), none));
                squeezes.back().covariance.reset();
                squeezes.back().part = QString::number(i / 3);
            }
            const Eigen::Vector3d p = grips.log(parts.log(NoisyTypes::mean(0), none), none).array().exp();
            const MassDampingStiffness next{p(0), p(1), p(2)};
            rejected += judge(fitTypeModels(squeezes), next).kind == VerdictKind::Unknown;
            for (TypeSqueeze& squeeze : squeezes)
                squeeze.part.clear();
            naive += judge(fitTypeModels(squeezes), next).kind == VerdictKind::Unknown;
        }
        // 1 % of 10,000: 100 +- 10 (1 sd); degrees of freedom are those of Satterthwaite, not exact.
        QVERIFY2(rejected > 65 && rejected < 130, qPrintable(QString::number(rejected)));
        QVERIFY2(naive > 150, qPrintable(QString::number(naive))); // thought to know more than it does
    }
    void aTypeOfItsOwnSpreadIsSeen()
    {
        const Eigen::Matrix3d none = covarianceOf(1e-6, 1e-6, 1e-6, 0);
        NoisyTypes narrow(10, covarianceOf(0.03, 0.03, 0.03, 0));
        NoisyTypes wide(11, covarianceOf(0.12, 0.12, 0.12, 0));
        std::vector<TypeSqueeze> squeezes = narrow.enrolment(3, 15, none);
        QVERIFY(!fitTypeModels(squeezes).likeness);
        for (int i = 0; i < 15; ++i)
            squeezes.push_back(NoisyTypes::squeeze(u"W"_s, wide.log({9, 0, 0}, none), none));
        const TypeModels models = fitTypeModels(squeezes);
        QVERIFY(models.likeness && *models.likeness < 20);
    }
    void hostileNumbersGiveFiniteAnswers()
    {
        const double huge = 1e300, tiny = 1e-300;
        Eigen::Matrix3d bad = Eigen::Matrix3d::Constant(std::nan(""));
        std::vector<TypeSqueeze> squeezes;
        for (int i = 0; i < 12; ++i) {
            const double e = 1 + 0.01 * ((7 * i) % 5);
            squeezes.push_back({i % 2 ? u"A"_s : u"B"_s, {tiny * e, e, huge * e}});
        }
        squeezes[0].covariance = bad;
        squeezes[1].covariance = -Eigen::Matrix3d::Identity();
        squeezes[2].covariance = Eigen::Matrix3d::Identity() * huge;
        squeezes[3].covariance = Eigen::Matrix3d::Zero();
        for (std::size_t count = 0; count <= squeezes.size(); ++count) {
            const TypeModels models = fitTypeModels({squeezes.begin(), squeezes.begin() + long(count)});
            QVERIFY(models.covarianceLog.allFinite());
            for (const Eigen::Matrix3d& c : {bad, Eigen::Matrix3d(Eigen::Matrix3d::Zero()),
                                             Eigen::Matrix3d(huge * Eigen::Matrix3d::Identity())}) {
                for (const bool robust : {false, true}) {
                    VerdictOptions options;
                    options.robust = robust;
                    const Verdict verdict = judge(models, {tiny, 1, huge}, options, c);
                    QVERIFY(!verdict.distance || std::isfinite(*verdict.distance));
                    QVERIFY(!verdict.gate || std::isfinite(*verdict.gate));
                    for (const double probability : verdict.posterior)
                        QVERIFY(probability >= 0 && probability <= 1);
                }
            }
        }
    }
};

GRIPSCOPE_TEST(ScatterTest)
#include "scatter_test.moc"
