// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/preparation/held_position.h"
#include "core/signal/preparation/preparation.h"
#include "tests/core/identification/held_squeeze.h"
#include "tests/core/signal/squeeze_record.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

std::optional<HeldPosition> heldIn(const Recording& recording)
{
    return heldPosition(recording.time_s, recording.force, recording.position);
}

} // namespace

class HeldPositionTest : public QObject {
    Q_OBJECT
private slots:
    void aHeldPositionIsFoundWithItsInterval()
    {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            const HeldSqueeze squeeze = HeldSqueeze::random(seed % 2 == 0 ? 600 : 1e7, seed);
            const std::optional<HeldPosition> held = heldIn(squeeze.make());
            QVERIFY2(held, qPrintable(QString::number(seed)));
            QVERIFY(std::abs(held->interval_s - squeeze.interval_s) < squeeze.sampleTime_s);
            QVERIFY(held->opening);
            QCOMPARE(held->spikes, std::size_t(5));
            QVERIFY(std::abs(held->largestSpike - squeeze.spike_N) < 6 * squeeze.forceNoise_N);
            // 5 % of the force is passed after 5 % of the loading.
            const double touch_s = held->time_s[held->contact.first];
            QVERIFY(touch_s > squeeze.touch_s() &&
                    touch_s < squeeze.touch_s() + 0.05 * squeeze.loading_s() + 0.04);
            QVERIFY(held->position[held->contact.first + held->contact.count / 2] > held->position.front());
        }
    }
    void anySignAndUnitIsRead()
    {
        const Recording recording = HeldSqueeze().make();
        for (const double force : {1.0, -1e3}) {
            for (const double position : {-1.0, 1e3}) {
                Recording other = recording;
                for (double& f : other.force)
                    f *= force;
                for (double& x : other.position)
                    x *= position;
                const std::optional<HeldPosition> held = heldIn(other);
                QVERIFY(held);
                QCOMPARE(held->opening, force * position > 0);
                QVERIFY(held->contact == heldIn(recording)->contact);
            }
        }
    }
    void whatIsRenewedWithEveryRowIsNotHeld_data()
    {
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("lattice");
        QTest::addColumn<double>("stiffness");
        for (const double speed : {0.002, 0.018})
            for (const double lattice : {0.0, 1e-6, 3e-4, 2e-3})
                for (const double stiffness : {600.0, 1e7})
                    QTest::addRow("%g m/s, steps of %g m, %g N/m", speed, lattice, stiffness)
                        << speed << lattice << stiffness;
    }
    void whatIsRenewedWithEveryRowIsNotHeld()
    {
        HeldSqueeze squeeze;
        squeeze.held = false;
        QFETCH(double, speed);
        QFETCH(double, lattice);
        QFETCH(double, stiffness);
        squeeze.speed_mPerS = speed;
        squeeze.lattice_m = lattice;
        squeeze.k_NPerM = stiffness;
        for (const double noise : {0.0, 0.02, 1.0}) {
            squeeze.forceNoise_N = noise;
            QVERIFY(!heldIn(squeeze.make()));
        }
    }
    void aGripperThatMovesInStepsIsNotHeld()
    {
        // The force stands while the fingers do.
        HeldSqueeze squeeze;
        squeeze.spike_N = 0;
        Recording recording = squeeze.make();
        for (std::size_t i = 0; i < recording.size(); ++i) {
            const double t = squeeze.interval_s * std::floor(recording.time_s[i] / squeeze.interval_s);
            recording.force[i] = squeeze.force(t);
            recording.position[i] = squeeze.opening(t);
        }
        QVERIFY(!heldIn(recording));
    }
    void aStuckOrMissingPositionIsNotHeld()
    {
        HeldSqueeze squeeze;
        squeeze.held = false;
        Recording recording = squeeze.make();
        for (std::size_t i = recording.size() / 3; i < recording.size(); ++i)
            recording.position[i] = recording.position[recording.size() / 3];
        QVERIFY(!heldIn(recording));
        std::ranges::fill(recording.position, 0.08);
        QVERIFY(!heldIn(recording));
        QVERIFY(!heldPosition({}, {}, {}));
    }
    void withoutAnApproachNothingIsHeld()
    {
        const HeldSqueeze squeeze;
        const Recording recording = squeeze.make();
        const auto touch = std::size_t(squeeze.touch_s() / squeeze.sampleTime_s) + 10;
        QVERIFY(!heldIn(slice(recording, {touch, recording.size() - touch})));
    }
    void anOrdinaryApproachComesOutAsItWas()
    {
        for (const bool quiet : {true, false}) {
            SqueezeRecord squeeze;
            if (quiet)
                squeeze.forceNoise_N = squeeze.positionNoise_m = 0;
            const Recording recording = squeeze.make();
            const PreparedRecord record = prepare(recording);
            QVERIFY(!record.held && record.phases.hasApproach);
            QVERIFY(record.find(u"opening"_s) == nullptr);
            const Window used = record.choice.window;
            QVERIFY(std::equal(record.position.begin(), record.position.end(),
                               recording.position.begin() + std::ptrdiff_t(used.first)));
        }
    }
    void anOpeningIsTurned()
    {
        const Recording closing = SqueezeRecord().make();
        Recording opening = closing;
        for (double& x : opening.position)
            x = 0.08 - x;
        const PreparedRecord usual = prepare(closing), turned = prepare(opening);
        QVERIFY(turned.find(u"opening"_s) != nullptr && !turned.held);
        QVERIFY(turned.phases == usual.phases);
        QCOMPARE(turned.position.size(), usual.position.size());
        for (std::size_t i = 0; i < turned.position.size(); ++i)
            QVERIFY(std::abs(turned.position[i] + 0.08 - usual.position[i]) < 1e-15);
    }
    void aPositionThatGoesAgainstTheForceWithoutAnApproachIsLeftAlone()
    {
        SqueezeRecord squeeze;
        squeeze.approach = squeeze.opening = squeeze.fall = 0;
        Recording recording = squeeze.make();
        for (double& x : recording.position)
            x = 0.08 - x;
        const PreparedRecord record = prepare(recording);
        QVERIFY(record.find(u"opening"_s) == nullptr);
        QVERIFY(record.position == recording.position);
    }
};

GRIPSCOPE_TEST(HeldPositionTest)
#include "held_position_test.moc"
