// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/hold_history.h"
#include "tests/core/session/session_recordings.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

Recording squeezeWith(const QString& serial, std::uint64_t seed)
{
    Recording recording = squeezeOf(canA, seed);
    recording.provenance.insert(QStringLiteral("serial"), serial);
    return recording;
}

Identification quickly(const Recording& recording, IdentificationOptions options = {})
{
    options.assess = false;
    return identify(recording, options);
}

} // namespace

class HoldHistoryTest : public QObject {
    Q_OBJECT
private slots:
    void addsUpForEachGripperAndDeclaration()
    {
        const Recording one = squeezeWith(QStringLiteral("G-1"), 1);
        const Recording two = squeezeWith(QStringLiteral("G-1"), 2);
        const Recording elsewhere = squeezeWith(QStringLiteral("G-2"), 3);
        IdentificationOptions straight;
        straight.hold = ForceHold::First;
        Recording late = one;
        late.forceLag_s = 1e-4;

        HoldHistory history;
        QCOMPARE(history.before(one, {}).squeezes, 0);
        const Identification first = quickly(one);
        const Identification second = quickly(two);
        history.add(one, first);
        history.add(two, second);
        const Recording next = squeezeWith(QStringLiteral("G-1"), 4);
        QCOMPARE(history.before(next, {}).squeezes, 2);
        QCOMPARE(*history.before(next, {}).gain, *first.holdEvidence.gain + *second.holdEvidence.gain);
        QCOMPARE(history.before(elsewhere, {}).squeezes, 0);
        QCOMPARE(history.before(one, straight).squeezes, 0);
        QCOMPARE(history.before(late, {}).squeezes, 0);

        history.add(one, quickly(one, straight));
        QCOMPARE(history.before(next, straight).squeezes, 1);
        QCOMPARE(history.before(next, {}).squeezes, 2);
        // The same recording again is no more evidence, before or after.
        QCOMPARE(history.before(one, {}).squeezes, 1);
        history.add(one, first);
        QCOMPARE(history.before(next, {}).squeezes, 2);
    }
    void aMeasurementThatIsNoneDoesNotCount()
    {
        HoldHistory history;
        history.add(constantForce(), quickly(constantForce()));
        QCOMPARE(history.before(constantForce(), {}).squeezes, 0);
        Identification invalid = quickly(squeezeOf(canA, 1));
        QVERIFY(invalid.holdEvidence.gain);
        invalid.validity.verdict = ValidityVerdict::Invalid;
        history.add(squeezeOf(canA, 1), invalid);
        QCOMPARE(history.before(squeezeOf(canA, 1), {}).squeezes, 0);
    }
};

GRIPSCOPE_TEST(HoldHistoryTest)
#include "hold_history_test.moc"
