// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/design/excitation_design.h"
#include "core/identification/model/discretization.h"
#include "core/identification/model/response_sensitivities.h"
#include "core/identification/output_error/output_error.h"
#include "core/math/gaussian.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <map>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

const MassDampingStiffness canA{0.0396209, 0.1374754, 0.1022911};
const MassDampingStiffness canB{0.0291124, 0.1268230, 0.1075330};
const MassDampingStiffness canC{0.0300893, 0.1186730, 0.0364721};

DesignOptions fiftySeconds(const std::vector<DesignObject>& objects)
{
    DesignOptions options;
    options.objects = objects;
    options.peak = 1;
    options.bias = 0;
    options.limit = 10;
    options.oneSided = false;
    options.duration_s = 50;
    options.sampleTime_s = 0.05;
    options.noiseDeviation = 0.5;
    return options;
}

std::map<DesignKind, DesignCandidate> byKind(const ExcitationDesign& design)
{
    std::map<DesignKind, DesignCandidate> candidates;
    for (const DesignCandidate& candidate : design.candidates)
        candidates[candidate.kind] = candidate;
    return candidates;
}

} // namespace

class ExcitationDesignTest : public QObject {
    Q_OBJECT
private slots:
    void efficienciesAreThoseKnownForFiftySeconds_data()
    {
        QTest::addColumn<double>("frequency");
        QTest::newRow("A, 1.6 rad/s") << 1.607;
        QTest::newRow("1 rad/s") << 1.0;
        QTest::newRow("2 rad/s") << 2.0;
    }
    void efficienciesAreThoseKnownForFiftySeconds()
    {
        // Equal peak, natural frequencies of 1 to 2 rad/s: step and white noise at most about 0.05, chirp
        // 0.5, multisine less than that (with random phases and a crest factor of 2 to 3), PRBS with bits
        // of 1.5 to 3.5 over the natural frequency 0.73 and more.
        QFETCH(double, frequency);
        const MassDampingStiffness object{0.04, 0.04 * frequency * 2, 0.04 * frequency * frequency};
        const auto design = designExcitation(fiftySeconds({{u"A"_s, object, Eigen::Matrix3d::Zero()}}));
        QVERIFY(design);
        const auto candidates = byKind(*design);
        QVERIFY(candidates.at(DesignKind::Step).dEfficiency < 0.06);
        QVERIFY(candidates.at(DesignKind::WhiteBinary).dEfficiency < 0.08);
        QVERIFY(candidates.at(DesignKind::WhiteBinary).dEfficiency > 0.02);
        QVERIFY(std::abs(candidates.at(DesignKind::Chirp).dEfficiency - 0.45) < 0.15);
        QVERIFY(candidates.at(DesignKind::Multisine).dEfficiency > 0.15);
        QVERIFY(candidates.at(DesignKind::Multisine).dEfficiency < 0.6);
        QVERIFY(candidates.at(DesignKind::Prbs).dEfficiency > 0.73);
        QVERIFY(candidates.at(DesignKind::InverseRepeat).dEfficiency > 0.6);
        QCOMPARE(candidates.at(DesignKind::OptimizedBinary).dEfficiency, 1.0);
        const double bits = candidates.at(DesignKind::Prbs).bit_s * frequency;
        QVERIFY2(bits >= 1.4 && bits <= 4.1, qPrintable(QString::number(bits)));
        for (const auto& [kind, candidate] : candidates)
            QVERIFY2(candidate.dEfficiency <= 1, qPrintable(toString(kind)));
    }
    void aOneSidedGripOfTheSameHighestForceCostsTwiceTheError()
    {
        // Half the amplitude: a quarter of the information, since a bias tells nothing beside a free offset.
        DesignOptions both = fiftySeconds({{u"A"_s, canA, Eigen::Matrix3d::Zero()}});
        both.limit = 1;
        DesignOptions one = both;
        one.oneSided = true;
        one.bias = 0.5;
        const auto pulled = designExcitation(both);
        const auto pushed = designExcitation(one);
        QVERIFY(pulled && pushed);
        QCOMPARE(pulled->amplitude, 1.0);
        QCOMPARE(pushed->amplitude, 0.5);
        const Eigen::Vector3d ratio = pushed->candidates.front().standardErrors[0]->cwiseQuotient(
            *pulled->candidates.front().standardErrors[0]);
        QVERIFY((ratio.array() - 2).abs().maxCoeff() < 1e-6);
    }
    void theCrushLimitIsNeverExceeded()
    {
        GaussianNoise random(11);
        int designed = 0;
        for (int run = 0; run < 60; ++run) {
            DesignOptions options;
            const double frequency = std::pow(10, random.uniform() * 3);
            const double m = std::pow(10, -3 + 3 * random.uniform());
            options.objects = {{u"X"_s,
                                {m, 2 * m * frequency * random.uniform() + 1e-9, m * frequency * frequency},
                                Eigen::Matrix3d::Zero()}};
            if (run % 2 == 0) {
                DesignObject other = options.objects.front();
                other.mean.k *= 1.3;
                options.objects.push_back(other);
            }
            options.limit = std::pow(10, -2 + 5 * random.uniform());
            options.bias = options.limit * (1.4 * random.uniform() - 0.2);
            options.peak = options.limit * 3 * random.uniform();
            options.oneSided = run % 3 != 0;
            options.sampleTime_s = 0.3 * random.uniform() / frequency + 1e-6;
            options.duration_s = options.sampleTime_s * (30 + 300 * random.uniform());
            options.noiseDeviation = 1e-3;
            options.seed = static_cast<std::uint64_t>(run);
            const auto design = designExcitation(options);
            if (!design)
                continue;
            ++designed;
            for (const DesignCandidate& candidate : design->candidates) {
                QCOMPARE(candidate.force.size(), options.samples());
                for (const double force : candidate.force) {
                    QVERIFY(force <= options.limit);
                    QVERIFY(force >= (options.oneSided ? 0 : -options.limit));
                    QVERIFY(std::abs(force - options.bias) <= options.peak * (1 + 1e-12));
                }
                QVERIFY(std::isfinite(candidate.dEfficiency) && std::isfinite(candidate.separation));
            }
        }
        QVERIFY(designed > 25);
    }
    void theErrorsItExpectsAreThoseThatCome()
    {
        const DesignOptions options = fiftySeconds({{u"B"_s, canB, Eigen::Matrix3d::Zero()}});
        const auto design = designExcitation(options);
        QVERIFY(design);
        const DesignCandidate& best = design->candidates.front();
        constexpr int runs = 100;
        Eigen::Vector3d squares = Eigen::Vector3d::Zero();
        for (int run = 0; run < runs; ++run) {
            std::vector<double> position = simulate(canB, best.force, {0.05, ForceHold::Zero});
            GaussianNoise noise(static_cast<std::uint64_t>(run));
            for (double& y : position)
                y += options.noiseDeviation * noise();
            OutputErrorOptions estimation;
            estimation.sampleTime_s = 0.05;
            estimation.hold = ForceHold::Zero;
            const Estimate estimate = estimateOutputError(best.force, position, estimation);
            QVERIFY(estimate.parameters);
            squares += (estimate.parameters->vector() - canB.vector())
                           .cwiseQuotient(*best.standardErrors[0])
                           .cwiseAbs2() /
                       runs;
        }
        // Chi-square over 100 runs: within 0.57 to 1.56 but once in 10,000.
        QVERIFY(squares.minCoeff() > 0.57 && squares.maxCoeff() < 1.56);
    }
    void theNearestPairDecidesWhereThereAreSeveralObjects()
    {
        const std::vector<DesignObject> objects{{u"A"_s, canA, Eigen::Matrix3d::Zero()},
                                                {u"C"_s, canC, Eigen::Matrix3d::Zero()},
                                                {u"B"_s, canB, Eigen::Matrix3d::Zero()}};
        const auto design = designExcitation(fiftySeconds(objects));
        QVERIFY(design);
        const DesignCandidate& best = design->candidates.front();
        QVERIFY(best.kind == DesignKind::OptimizedBinary);
        QCOMPARE(best.nearestFirst, 0); // A and B, whose stiffnesses are 5 % apart
        QCOMPARE(best.nearestSecond, 2);
        for (const DesignCandidate& other : design->candidates)
            QVERIFY(other.separation <= best.separation);
        // Scatter between squeezes can only blur.
        std::vector<DesignObject> scattered = objects;
        for (DesignObject& object : scattered) {
            const Eigen::Vector3d spread = 0.05 * object.mean.vector();
            object.covariance = spread.cwiseAbs2().asDiagonal();
        }
        const auto blurred = designExcitation(fiftySeconds(scattered));
        QVERIFY(blurred);
        QVERIFY(blurred->candidates.front().separation < best.separation);
        QVERIFY(blurred->candidates.front().separation > 0);
    }
    void theSearchKnowsTheInformationOfItsSignals()
    {
        DesignOptions options = fiftySeconds({{u"A"_s, canA, Eigen::Matrix3d::Zero()}});
        options.duration_s = 11.35; // the last run is cut
        const std::size_t run = 10;
        const BinaryExchange exchange(options, run);
        QCOMPARE(exchange.runs(), 23U);
        std::vector<int> signs(23);
        std::vector<double> force(options.samples());
        GaussianNoise random(3);
        for (int& sign : signs)
            sign = random.uniform() < 0.5 ? -1 : 1;
        for (std::size_t i = 0; i < force.size(); ++i)
            force[i] = signs[i / run];
        SensitivityOptions sensitivity;
        sensitivity.sampleTime_s = 0.05;
        const Eigen::Matrix3d direct = fisherInformation(responseSensitivities(canA, force, sensitivity));
        const Eigen::Matrix3d searched = exchange.information(signs).front();
        QVERIFY((direct - searched).cwiseAbs().maxCoeff() < 1e-9 * direct.cwiseAbs().maxCoeff());
        const std::vector<int> better = exchange.improve(signs, DesignCriterion::meanLogDeterminant, 20);
        QVERIFY(DesignCriterion::meanLogDeterminant(exchange.information(better)) >=
                DesignCriterion::meanLogDeterminant({direct}));
    }
    void theSameSeedGivesTheSameDesign()
    {
        const DesignOptions options = fiftySeconds({{u"A"_s, canA, Eigen::Matrix3d::Zero()}});
        QCOMPARE(designExcitation(options)->candidates.front().force,
                 designExcitation(options)->candidates.front().force);
    }
    void whatCannotBeDesignedIsSaid_data()
    {
        QTest::addColumn<int>("which");
        for (int i = 0; i < 9; ++i)
            QTest::addRow("%d", i) << i;
    }
    void whatCannotBeDesignedIsSaid()
    {
        QFETCH(int, which);
        DesignOptions options = fiftySeconds({{u"A"_s, canA, Eigen::Matrix3d::Zero()}});
        QVERIFY(!options.validate());
        const double bad = which % 2 == 0 ? -1 : std::nan("");
        if (which == 0)
            options.objects.clear();
        if (which == 1 || which == 2)
            options.peak = bad;
        if (which == 3)
            options.bias = 10; // at the limit: no room
        if (which == 4)
            options.noiseDeviation = 0;
        if (which == 5)
            options.objects.front().mean.k = bad;
        if (which == 6)
            options.sampleTime_s = 1e-300;
        if (which == 7)
            options.objects.front().mean.m = 1e-9; // far above the sample rate
        if (which == 8)
            options.duration_s = 0.05;
        QVERIFY(!designExcitation(options));
        QVERIFY(!options.validate()->describe().isEmpty());
    }
};

GRIPSCOPE_TEST(ExcitationDesignTest)
#include "excitation_design_test.moc"
