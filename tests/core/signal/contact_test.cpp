// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/preparation_parts.h"
#include "tests/core/signal/squeeze_record.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>

using namespace gripscope;
using namespace gripscope::test;

namespace {

ContactPhases phasesOf(const Recording& recording)
{
    return findContact(recording.force, recording.position);
}

bool isWhole(const Recording& recording)
{
    const ContactPhases phases = phasesOf(recording);
    return !phases.hasApproach && !phases.hasRelease && phases.squeeze == Window{0, recording.size()};
}

bool near(std::size_t found, std::size_t truth, std::size_t tolerance)
{
    return found + tolerance >= truth && found <= truth + tolerance;
}

/// An excitation alone on an object, from the first sample to the last.
Recording excited(const ExcitationOptions& options, const MassDampingStiffness& truth, double noise,
                  double x0 = 0, double v0 = 0)
{
    Recording recording;
    recording.sampleTime_s = options.sampleTime_s;
    recording.force = *makeExcitation(options);
    recording.position =
        simulate(truth, recording.force, {options.sampleTime_s, ForceHold::Zero, 0, x0, v0, 3});
    GaussianNoise random(options.seed);
    for (double& x : recording.position)
        x += noise * random();
    return recording;
}

/// The jaws leave the can while the command would pull: `count` samples from `first` on, the force at zero.
void loseContact(Recording& recording, std::size_t first, std::size_t count, double way_m)
{
    for (std::size_t i = 0; i < count; ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(count + 1);
        recording.force[first + i] = 0;
        recording.position[first + i] = 0.02 - way_m * 4 * share * (1 - share);
    }
}

} // namespace

class ContactTest : public QObject {
    Q_OBJECT
private slots:
    void thePhasesOfAWholeSqueezeAreFound_data()
    {
        QTest::addColumn<double>("forceNoise");
        QTest::addColumn<double>("positionNoise");
        QTest::addColumn<double>("sign");
        QTest::newRow("quiet") << 0.0 << 0.0 << 1.0;
        QTest::newRow("noisy") << 0.02 << 5e-6 << 1.0;
        QTest::newRow("very noisy") << 0.2 << 5e-5 << 1.0;
        QTest::newRow("counted the other way") << 0.02 << 5e-6 << -1.0;
    }
    void thePhasesOfAWholeSqueezeAreFound()
    {
        QFETCH(double, forceNoise);
        QFETCH(double, positionNoise);
        QFETCH(double, sign);
        SqueezeRecord record;
        record.forceNoise_N = forceNoise;
        record.positionNoise_m = positionNoise;
        const Recording recording = record.make(sign);
        const ContactPhases phases = phasesOf(recording);
        QVERIFY(phases.hasApproach && phases.hasRelease);
        // The threshold is 5 % of 30 N, which the ramp of 0.2 N a sample reaches after 8.
        QVERIFY(near(phases.touch, record.touch(), 9));
        QVERIFY(phases.loaded >= phases.touch && phases.squeeze.first >= phases.loaded);
        // The squeeze begins on the ramp (the working range ends 5 N below the 10 N of the low bits) and
        // keeps all of the excitation.
        const std::size_t excitation = record.touch() + 2 * record.ramp;
        const std::size_t end = phases.squeeze.first + phases.squeeze.count;
        QVERIFY(phases.squeeze.first > record.touch() && phases.squeeze.first <= excitation);
        QVERIFY(end >= excitation + record.excited && end < record.contactEnd());
    }
    void anythingInOtherUnitsIsFoundAlike()
    {
        const Recording recording = SqueezeRecord().make();
        const ContactPhases phases = phasesOf(recording);
        for (const double scale : {1e-150, 1e-6, 1e6, 1e150}) {
            Recording scaled = recording;
            for (std::size_t i = 0; i < scaled.size(); ++i) {
                scaled.force[i] *= scale;
                scaled.position[i] /= scale;
            }
            QVERIFY(phasesOf(scaled) == phases);
        }
    }
    void anApproachOrAReleaseMayBeMissing()
    {
        SqueezeRecord record;
        record.approach = 0;
        ContactPhases phases = phasesOf(record.make());
        QVERIFY(!phases.hasApproach && phases.hasRelease);
        QCOMPARE(phases.squeeze.first, std::size_t(0));
        QVERIFY(phases.squeeze.count < record.contactEnd());
        record.approach = 300;
        record.opening = 0;
        record.fall = 0;
        phases = phasesOf(record.make());
        QVERIFY(phases.hasApproach && !phases.hasRelease);
        QCOMPARE(phases.squeeze.first + phases.squeeze.count, record.contactEnd());
    }
    void bouncesAfterTheTouchAreNotTheSqueeze()
    {
        SqueezeRecord record;
        Recording recording = record.make();
        for (std::size_t i = record.touch() + 90; i < record.touch() + 110; ++i)
            recording.force[i] = 0;
        const ContactPhases phases = phasesOf(recording);
        QVERIFY(phases.loaded < record.touch() + 90);
        QCOMPARE(phases.squeeze.first, record.touch() + 110);
    }
    void aPlainExcitationHasNoPhases_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("bias");
        QTest::addColumn<double>("damping");
        for (const ExcitationKind kind :
             {ExcitationKind::Step, ExcitationKind::Prbs, ExcitationKind::Multisine, ExcitationKind::Chirp}) {
            for (const double bias : {0.0, 1.0, 3.0}) {
                for (const double damping : {0.01, 0.1374754})
                    QTest::addRow("%s, bias %g, b %g", qPrintable(toString(kind)), bias, damping)
                        << int(kind) << bias << damping;
            }
        }
    }
    void aPlainExcitationHasNoPhases()
    {
        QFETCH(int, kind);
        QFETCH(double, bias);
        QFETCH(double, damping);
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            ExcitationOptions options;
            options.kind = static_cast<ExcitationKind>(kind);
            options.peak = 1;
            options.bias = bias;
            options.bit_s = 0.5;
            options.sampleTime_s = 0.05;
            options.samples = 400;
            options.seed = seed;
            options.oneSided = seed % 2 == 0;
            const MassDampingStiffness truth{0.0396209, damping, 0.1022911};
            const double noise = seed % 3 == 0 ? 0 : 0.5;
            const Recording recording =
                excited(options, truth, noise, seed % 5 == 0 ? 4 : 0, seed % 7 == 0 ? -5 : 0);
            QVERIFY2(isWhole(recording), qPrintable(QString::number(seed)));
            QVERIFY2(findContactLoss(recording.force, recording.position).empty(),
                     qPrintable(QString::number(seed)));
        }
    }
    void aPulseWithItsDecayIsKept()
    {
        // Rest, a push, and the answer when it ends, in contact all the time.
        Recording recording;
        for (const double force : {0.0, 1.0, 0.0})
            recording.force.insert(recording.force.end(), 200, force);
        recording.position =
            simulate({0.0396209, 0.1374754, 0.1022911}, recording.force, {0.05, ForceHold::Zero, 0, 0, 0, 3});
        QVERIFY(isWhole(recording));
        QVERIFY(findContactLoss(recording.force, recording.position).empty());
    }
    void lostContactIsFound()
    {
        SqueezeRecord record;
        record.approach = record.opening = record.ramp = record.fall = 0;
        Recording recording = record.make();
        loseContact(recording, 400, 25, 0.01);
        loseContact(recording, 900, 12, 0.008);
        std::vector<std::size_t> wanted;
        for (std::size_t i = 399; i < 426; ++i)
            wanted.push_back(i);
        for (std::size_t i = 899; i < 913; ++i)
            wanted.push_back(i);
        QVERIFY(findContactLoss(recording.force, recording.position) == wanted);
    }
    void aRestInContactIsKept()
    {
        SqueezeRecord record;
        record.approach = record.opening = record.ramp = record.fall = 0;
        record.bias_N = record.peak_N = 10; // pushes with 20 N and not at all by turns
        const Recording recording = record.make();
        QVERIFY(isWhole(recording));
        QVERIFY(findContactLoss(recording.force, recording.position).empty());
    }
    void nonsenseIsASqueezeOfItsOwn()
    {
        QVERIFY(findContact({}, {}).squeeze == Window());
        const std::vector<double> constant(100, 2.0), zero(100, 0.0), huge{1e308, -1e308, 1e308, 0};
        QVERIFY((findContact(constant, zero).squeeze == Window{0, 100}));
        QVERIFY((findContact(zero, zero).squeeze == Window{0, 100}));
        QVERIFY((findContact(huge, huge).squeeze == Window{0, 4}));
        QVERIFY(findContactLoss({}, {}).empty());
        QVERIFY(findContactLoss(zero, constant).empty());
        QVERIFY(findContactLoss(huge, huge).empty());
    }
};

GRIPSCOPE_TEST(ContactTest)
#include "contact_test.moc"
