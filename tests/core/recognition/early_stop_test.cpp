// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/identification.h"
#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/recognition/early/early_stop.h"
#include "core/signal/excitation/excitation.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

constexpr double sampleTime_s = 0.0005;
constexpr MassDampingStiffness can{0.0396, 43, 9990};

/// Relative standard errors of m, b, k of an enrolled squeeze, as 5 um of noise gives them.
const Eigen::Vector3d errors(0.004, 0.004, 0.001);

MassDampingStiffness times(const MassDampingStiffness& p, double m, double b, double k)
{
    return {p.m * m, p.b * b, p.k * k};
}

/// Eight squeezes of each of `objects`, 3 % of scatter, named A, B, ...
std::shared_ptr<const TypeModels> modelsOf(const std::vector<MassDampingStiffness>& objects)
{
    GaussianNoise noise(5);
    const auto scattered = [&noise] { return std::exp(0.03 * noise()); };
    std::vector<TypeSqueeze> squeezes;
    for (std::size_t type = 0; type < objects.size(); ++type)
        for (int i = 0; i < 8; ++i) {
            TypeSqueeze squeeze{QString(QChar(char16_t(u'A' + type))), {}};
            const double m = scattered(), b = scattered(), k = scattered();
            squeeze.parameters = times(objects[type], m, b, k);
            const Eigen::Vector3d deviation = errors.cwiseProduct(squeeze.parameters.vector());
            squeeze.covariance = Eigen::Matrix3d(deviation.cwiseAbs2().asDiagonal());
            squeezes.push_back(squeeze);
        }
    return std::make_shared<const TypeModels>(fitTypeModels(squeezes));
}

EarlyStopSetup setupFor(const std::vector<MassDampingStiffness>& objects)
{
    EarlyStopSetup setup;
    setup.models = modelsOf(objects);
    setup.decision.sampleTime_s = sampleTime_s;
    setup.decision.hold = ForceHold::Zero;
    return setup;
}

std::vector<double> usualForce(std::uint64_t seed = 1)
{
    ExcitationOptions excitation;
    excitation.seed = seed;
    excitation.sampleTime_s = sampleTime_s;
    excitation.samples = 2000;
    return *makeExcitation(excitation);
}

/// Force and position are multiplied as other units would do it.
std::optional<EarlyEnd> follow(const EarlyStopSetup& setup, const MassDampingStiffness& object,
                               double forceUnit = 1, double positionUnit = 1, double compliance = 0)
{
    const std::vector<double> force = usualForce();
    const std::vector<double> position =
        simulate(object, force, {sampleTime_s, ForceHold::Zero, 0, 0, 0, 0.01});
    GaussianNoise noise(9);
    EarlyStop stop(setup);
    for (std::size_t t = 0; t < force.size(); ++t) {
        const double y = position[t] + compliance * force[t] + 5e-6 * noise();
        if (!stop.add(force[t] * forceUnit, y * positionUnit))
            continue;
        if (const std::optional<EarlyEnd> end = stop.look())
            return end;
    }
    return {};
}

} // namespace

class EarlyStopTest : public QObject {
    Q_OBJECT
private slots:
    void aKnownPartEndsTheSqueezeEarly()
    {
        const EarlyStopSetup setup = setupFor({can, times(can, 0.8, 0.9, 0.6)});
        const std::optional<EarlyEnd> end = follow(setup, times(can, 1.01, 0.99, 1.02));
        QVERIFY(end && end->kind == VerdictKind::Type);
        QCOMPARE(end->type, u"A"_s);
        QVERIFY(end->posterior > 0.99);
        QVERIFY2(end->samples < 1000, qPrintable(QString::number(end->samples)));
    }

    void aStrangerEndsItAsUnknown()
    {
        const EarlyStopSetup setup = setupFor({can, times(can, 0.8, 0.9, 0.6)});
        const std::optional<EarlyEnd> end = follow(setup, times(can, 2, 1.5, 1.5));
        QVERIFY(end && end->kind == VerdictKind::Unknown);
        QVERIFY(end->type.isEmpty());
        QVERIFY(end->samples < 1000);
    }

    /// Two types that lie within their scatter of each other: the verdict would be inconclusive, so the
    /// squeeze goes on.
    void twinsAreSqueezedToTheEnd()
    {
        const EarlyStopSetup setup = setupFor({can, times(can, 1.02, 1.02, 1.02)});
        QVERIFY(!follow(setup, times(can, 1.01, 1.01, 1.01)));
    }

    void unitsDoNotMatter()
    {
        EarlyStopSetup setup = setupFor({can, times(can, 0.8, 0.9, 0.6)});
        const std::optional<EarlyEnd> metres = follow(setup, can);
        setup.factor = 1e-3 / 1e-6; // mN and um: a stiffness of 1 mN/um is 1000 N/m
        const std::optional<EarlyEnd> micrometres = follow(setup, can, 1e3, 1e6);
        QVERIFY(metres && micrometres);
        QCOMPARE(micrometres->type, metres->type);
        QCOMPARE(micrometres->samples, metres->samples);
    }

    /// What is measured is object and gripper in parallel, behind a frame that gives.
    void gripperAndFrameAreTakenOff()
    {
        EarlyStopSetup setup = setupFor({can, times(can, 0.8, 0.9, 0.6)});
        setup.chain.baseline = GripperBaseline{{0.01, 10, 3000}, {1e-5, 0.01, 1}};
        setup.chain.frameCompliance = 2e-5;
        const std::optional<EarlyEnd> end =
            follow(setup, {can.m + 0.01, can.b + 10, can.k + 3000}, 1, 1, setup.chain.frameCompliance);
        QVERIFY(end);
        QCOMPARE(end->type, u"A"_s);
    }

    /// One type of few squeezes has gates so wide that next to nothing decides; what is left of the squeeze
    /// is to be a measurement all the same.
    void whatEndsEarlyIsStillAValidMeasurement()
    {
        EarlyStopSetup setup = setupFor({can});
        std::vector<TypeSqueeze> few;
        for (const double factor : {0.97, 1.0, 1.02, 1.05})
            few.push_back({u"A"_s, times(can, factor, 2 - factor, factor * factor)});
        setup.models = std::make_shared<const TypeModels>(fitTypeModels(few));
        int ended = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            std::vector<double> force = usualForce(seed);
            const SimulationOptions start{sampleTime_s, ForceHold::Zero, 0, 0, 0, 0.01};
            std::vector<double> position = simulate(can, force, start);
            GaussianNoise noise(seed);
            std::vector<double> noises;
            for (std::size_t t = 0; t < force.size(); ++t)
                noises.push_back(5e-6 * noise());
            EarlyStop stop(setup);
            std::optional<EarlyEnd> end;
            for (std::size_t t = 0; t < force.size() && !end; ++t)
                if (stop.add(force[t], position[t] + noises[t]))
                    end = stop.look();
            if (!end)
                continue;
            ++ended;
            // Behind its end the force rests, and is recorded for 20 ms.
            force.resize(end->samples);
            force.resize(end->samples + 40, 20.0);
            position = simulate(can, force, start);
            Recording recording;
            recording.sampleTime_s = sampleTime_s;
            recording.hold = ForceHold::Zero;
            recording.force = force;
            for (std::size_t t = 0; t < force.size(); ++t) {
                recording.time_s.push_back(sampleTime_s * double(t));
                recording.position.push_back(position[t] + noises[t]);
            }
            const Identification found = identify(recording);
            QVERIFY2(found.validity.verdict != ValidityVerdict::Invalid,
                     qPrintable(u"seed %1, %2 samples"_s.arg(seed).arg(end->samples)));
        }
        QVERIFY(ended > 20);
    }

    void tooFewSqueezesDecideNothing()
    {
        EarlyStopSetup setup = setupFor({can});
        setup.models = std::make_shared<const TypeModels>(
            fitTypeModels({{u"A"_s, can, {}, {}}, {u"A"_s, times(can, 1.01, 1, 1), {}, {}}}));
        QVERIFY(!EarlyStop(setup).possible());
        QVERIFY(!EarlyStop({}).possible());
        QVERIFY(!expectedTimes(setup, usualForce()));
    }

    void theTimeStatedIsTheTimeTaken()
    {
        const EarlyStopSetup setup =
            setupFor({can, times(can, 0.8, 0.9, 0.6), times(can, 0.7, 1.2, 0.35), times(can, 1.2, 1.1, 1.5)});
        const std::optional<EarlyTimes> stated = expectedTimes(setup, usualForce());
        QVERIFY(stated);
        QVERIFY(stated->squeezes >= 24);
        QVERIFY(stated->decided >= 22); // four types, each ten standard deviations from the next
        QVERIFY(stated->mean_s > 0.005 && stated->mean_s < 0.5);
        QVERIFY(stated->ninetyPercent_s >= stated->mean_s / 2 && stated->ninetyPercent_s <= 1);
        // Squeezes that the simulation has not seen; their mean spreads by a third or so.
        double sum = 0;
        GaussianNoise noise(77);
        constexpr int squeezes = 12;
        for (int i = 0; i < squeezes; ++i) {
            const double m = std::exp(0.03 * noise()), b = std::exp(0.03 * noise()),
                         k = std::exp(0.03 * noise());
            const std::optional<EarlyEnd> end = follow(setup, times(can, m, b, k));
            sum += end ? sampleTime_s * double(end->samples) : 1.0;
        }
        const double ratio = sum / squeezes / stated->mean_s;
        QVERIFY2(ratio > 0.3 && ratio < 3, qPrintable(QString::number(ratio)));
        QCOMPARE(expectedTimes(setup, usualForce())->mean_s, stated->mean_s);
    }

    void anEndTheRecordAgreesWithStands()
    {
        Verdict verdict;
        verdict.kind = VerdictKind::Type;
        verdict.type = u"A"_s;
        verdict.reasons = {u"Because."_s};
        const Verdict stands = verdictOnEarlyEnd(verdict, {VerdictKind::Type, u"A"_s, 0.9995, 240}, 0.12);
        QVERIFY(stands.kind == VerdictKind::Type);
        QCOMPARE(stands.type, u"A"_s);
        QCOMPARE(described(stands.reasons), QStringList({u"Because."_s, u"Decided after 0.12 s."_s}));
    }

    void anEndTheRecordContradictsIsInconclusive()
    {
        Verdict verdict;
        verdict.kind = VerdictKind::Type;
        verdict.type = u"B"_s;
        const Verdict found = verdictOnEarlyEnd(verdict, {VerdictKind::Type, u"A"_s, 0.9995, 240}, 0.12);
        QVERIFY(found.kind == VerdictKind::Inconclusive);
        QVERIFY(found.type.isEmpty());
        QVERIFY(found.reasons.front().describe().contains(u"A"_s) &&
                found.reasons.front().describe().contains(u"B"_s));
        const Verdict known = verdictOnEarlyEnd(verdict, {VerdictKind::Unknown, {}, 0.9995, 240}, 0.12);
        QVERIFY(known.kind == VerdictKind::Inconclusive);
        verdict.kind = VerdictKind::Invalid;
        QVERIFY(verdictOnEarlyEnd(verdict, {VerdictKind::Type, u"A"_s, 0.9995, 240}, 0.12).kind ==
                VerdictKind::Invalid);
    }
};

GRIPSCOPE_TEST(EarlyStopTest)
#include "early_stop_test.moc"
