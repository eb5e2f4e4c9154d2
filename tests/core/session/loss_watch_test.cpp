// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/connection/loss_watch.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>

using namespace gripscope;

namespace {

/// A link at 2 kHz that is looked at four times a second, in virtual time.
struct LossyLink {
    LossWatch watch;
    LinkCounters counters;
    LinkCounters::TimePoint now{};
    void run(double seconds, double lostShare)
    {
        for (int i = 0; i < static_cast<int>(4 * seconds); ++i) {
            now += std::chrono::milliseconds(250);
            const auto lost = static_cast<std::uint64_t>(500 * lostShare);
            counters.lostSamples += lost;
            counters.samples += 500 - lost;
            watch.look(counters, now);
        }
    }
};

} // namespace

/// Whether a link loses samples now.
class LossWatchTest : public QObject {
    Q_OBJECT
private slots:
    void aLinkThatLosesNothingIsWell()
    {
        LossyLink link;
        QVERIFY(!link.watch.losing());
        link.run(60, 0);
        QCOMPARE(link.watch.share(), 0.0);
    }
    void theShareIsOfTheLastSeconds()
    {
        LossyLink link;
        link.run(10, 0);
        link.run(1, 0.5); // of five seconds
        QVERIFY(link.watch.losing());
        QVERIFY(std::abs(link.watch.share() - 0.1) < 0.01);
        link.run(20, 0.02);
        QVERIFY(std::abs(link.watch.share() - 0.02) < 1e-9);
    }
    void whatWasLostLongAgoIsNotLostNow()
    {
        LossyLink link;
        link.run(10, 0.08); // hundreds
        QVERIFY(link.counters.lostSamples > 800);
        link.run(6, 0);
        QVERIFY(!link.watch.losing());
    }
    void aFewAreBearable()
    {
        LossyLink link;
        link.run(5, 0);
        link.counters.lostSamples += 8; // one report
        link.run(4, 0);
        QVERIFY(link.watch.share() > 0);
        QVERIFY(!link.watch.losing());
    }
    void whatTheProgramDroppedIsLostToo()
    {
        LossyLink link;
        link.run(5, 0);
        link.counters.droppedSamples += 500;
        link.run(1, 0);
        QVERIFY(link.watch.losing());
    }
    void anotherLinkBeginsAnew()
    {
        LossyLink link;
        link.run(5, 0.5);
        link.counters = {};
        link.run(1, 0);
        QVERIFY(!link.watch.losing());
    }
};

GRIPSCOPE_TEST(LossWatchTest)
#include "loss_watch_test.moc"
