// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/conformity_of_squeeze.h"
#include "core/recognition/verdict/transfer.h"
#include "tests/core/recognition/noisy_types.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const Eigen::Matrix3d checkBetween = covarianceOf(0.03, 0.04, 0.03, 0.2);
const Eigen::Matrix3d checkNoise = covarianceOf(0.01, 0.01, 0.005, 0);

/// Types A, B... enrolled on one gripper, squeezed on another whose logs are `error` off.
struct TwoGrippers {
    TwoGrippers(std::uint64_t seed, int count, Eigen::Vector3d off)
        : source(seed, checkBetween), models(fitTypeModels(source.enrolment(count, 10, checkNoise))),
          types(count), error(std::move(off))
    {
    }
    TypeSqueeze squeeze(int type, const Eigen::Vector3d& more = Eigen::Vector3d::Zero(), int part = -1)
    {
        return NoisyTypes::squeeze(
            QString(QChar(u'A' + type)),
            source.log(NoisyTypes::mean(part < 0 ? type : part) + error + more, checkNoise), checkNoise);
    }
    /// `odd`: this type is another `more` off, as parts that are not the same on both.
    std::vector<TypeSqueeze> squeezes(int each, int odd = -1,
                                      const Eigen::Vector3d& more = Eigen::Vector3d::Zero())
    {
        std::vector<TypeSqueeze> all;
        for (int i = 0; i < each; ++i)
            for (int type = 0; type < types; ++type)
                all.push_back(squeeze(type, type == odd ? more : Eigen::Vector3d::Zero()));
        return all;
    }

    NoisyTypes source;
    TypeModels models;
    int types;
    Eigen::Vector3d error;
};

} // namespace

/// Whether one adjustment explains all common types, and how well it is known.
class TransferCheckTest : public QObject {
    Q_OBJECT
private slots:
    void theIntervalCoversTheTrueError()
    {
        constexpr int runs = 300;
        Eigen::Vector3i covered = Eigen::Vector3i::Zero();
        for (int run = 0; run < runs; ++run) {
            TwoGrippers two(std::uint64_t(run + 1), 4, {0.08, -0.06, 0.05});
            const CommonShift error = *measureTransfer(two.models, two.squeezes(3)).error;
            for (int i = 0; i < 3; ++i)
                covered(i) +=
                    std::abs(error.value(i) - two.error(i)) < 1.96 * std::sqrt(error.covariance(i, i));
        }
        // 95 % of 300 are 285 with a standard deviation of 3.8; the scatter behind it has 36 degrees of
        // freedom, for which 1.96 holds 94.2 %: 282.6.
        for (int i = 0; i < 3; ++i)
            QVERIFY2(covered(i) > 270 && covered(i) < 298, qPrintable(QString::number(covered(i))));
    }
    void aCommonScaleIsSaidToFitAtTheStatedRate()
    {
        constexpr int runs = 200;
        int misfits = 0;
        for (int run = 0; run < runs; ++run) {
            TwoGrippers two(std::uint64_t(run + 1000), 4, {0.1, 0.1, 0.1});
            bool anyOdd = false;
            for (const TransferResidual& left :
                 transferResiduals(measureTransfer(two.models, two.squeezes(3))))
                anyOdd = anyOdd || !left.fits;
            misfits += anyOdd;
        }
        // 1 % of 200 looks at four types: 2, standard deviation 1.4.
        QVERIFY2(misfits <= 7, qPrintable(QString::number(misfits)));
    }
    void theTypeThatIsNotCommonIsNamed()
    {
        TwoGrippers two(7, 4, {0.05, 0.05, 0.05});
        const TransferReport report = measureTransfer(two.models, two.squeezes(5, 2, {0.2, 0.1, -0.2}));
        const std::vector<TransferResidual> residuals = transferResiduals(report);
        QCOMPARE(residuals.size(), std::size_t(4));
        const auto worst = std::ranges::min_element(residuals, {}, &TransferResidual::pValue);
        QCOMPARE(worst->type, u"C"_s);
        QVERIFY(!worst->fits && worst->pValue < 1e-6);
        QVERIFY(report.error->agreement < 0.01);
    }
    void ofTwoTypesNeitherIsBlamedAlone()
    {
        TwoGrippers two(8, 2, {0.05, 0.05, 0.05});
        const std::vector<TransferResidual> residuals =
            transferResiduals(measureTransfer(two.models, two.squeezes(5, 1, {0.3, 0.3, -0.3})));
        QVERIFY(residuals.size() == 2 && !residuals[0].fits && !residuals[1].fits);
        TwoGrippers one(8, 1, {0.05, 0.05, 0.05});
        QVERIFY(transferResiduals(measureTransfer(one.models, one.squeezes(5))).empty());
    }
    void moreSqueezesBringWhatIsForetold()
    {
        TwoGrippers two(9, 4, {0.05, 0, 0});
        const TransferReport few = measureTransfer(two.models, two.squeezes(3));
        const LogVector foretold = *uncertaintyWith(two.models, few, 9);
        const CommonShift many = *measureTransfer(two.models, two.squeezes(12)).error;
        for (int i = 0; i < 3; ++i) {
            QVERIFY(std::abs(foretold(i) / std::sqrt(many.covariance(i, i)) - 1) < 0.02);
            QVERIFY(
                std::abs((*uncertaintyWith(two.models, few, 0))(i) / std::sqrt(few.error->covariance(i, i)) -
                         1) < 1e-9);
        }
        const LogVector wanted = wantedUncertainty(two.models);
        const int needed = *squeezesNeeded(two.models, few, wanted);
        QVERIFY((uncertaintyWith(two.models, few, needed)->array() <= wanted.array()).all());
        QVERIFY(needed == 0 ||
                !(uncertaintyWith(two.models, few, needed - 1)->array() <= wanted.array()).all());
        // Better than the enrolment itself is known: never.
        QVERIFY(!squeezesNeeded(two.models, few, 1e-4 * wanted));
        QVERIFY(!uncertaintyWith(two.models, {}, 0));
    }
    void aWrongPartIsDoubted()
    {
        TwoGrippers two(10, 4, {0.1, 0.1, 0.1});
        const std::vector<TypeSqueeze> others = two.squeezes(3);
        QVERIFY(!transferDoubt(two.models, two.squeeze(0), others));
        const auto mistaken = transferDoubt(two.models, two.squeeze(0, Eigen::Vector3d::Zero(), 1), others);
        QVERIFY(mistaken && mistaken->describe().contains(u"part of B, not of A"_s));
        const auto strange = transferDoubt(two.models, two.squeeze(0, {1, -1, 1}), others);
        QVERIFY(strange && strange->describe().contains(u"no part of A"_s));
        QVERIFY(!transferDoubt(two.models, two.squeeze(0), {}));
    }
    void valuesHeldToLimitsAreAdjustedWithTheUncertainty()
    {
        CommonShift error;
        error.value = Eigen::Vector3d(0, 0, std::log(1.1));
        error.covariance = Eigen::Vector3d(1e-4, 1e-4, 4e-4).asDiagonal();
        error.degreesOfFreedom = 20;
        const MeasuredValues measured{std::nullopt, MeasuredValue{40}, MeasuredValue{11000, 110, 50.}};
        const MeasuredValues moved = adjusted(measured, error);
        QVERIFY(!moved[0] && !moved[1]->standardUncertainty);
        QCOMPARE(moved[1]->value, 40.0);
        QVERIFY(std::abs(moved[2]->value - 10000) < 1e-6);
        // 100 of the squeeze and 2 % of 10000 of the adjustment.
        QVERIFY(std::abs(*moved[2]->standardUncertainty - std::hypot(100, 200)) < 1e-6);
        // u^4 / (100^4 / 50 + 200^4 / 20) of JCGM 100, G.2b
        QVERIFY(std::abs(*moved[2]->degreesOfFreedom - 2.5e9 / (1e8 / 50 + 1.6e9 / 20)) < 1e-6);
        error.space = {{TypeQuantity::Stiffness}};
        error.value = LogVector::Zero(1);
        error.covariance = LogMatrix::Zero(1, 1);
        QVERIFY(!adjusted(measured, error)[1] && adjusted(measured, error)[2]->value == 11000);
    }
};

GRIPSCOPE_TEST(TransferCheckTest)
#include "transfer_check_test.moc"
