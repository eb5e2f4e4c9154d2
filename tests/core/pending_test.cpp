// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/pending.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <thread>

using namespace gripscope;

class PendingTest : public QObject {
    Q_OBJECT
private slots:
    void theValueIsGivenOnce()
    {
        const Promise<int> work;
        Pending<int> pending = work.pending();
        QVERIFY(pending.waiting());
        QVERIFY(!pending.ready());
        QCOMPARE(pending.take(), std::nullopt);
        QVERIFY(pending.waiting()); // asking too early takes nothing away
        work.give(7);
        QVERIFY(pending.ready());
        QCOMPARE(pending.take(), std::optional(7));
        QVERIFY(!pending.waiting() && !pending.ready());
        QCOMPARE(pending.take(), std::nullopt);
    }
    void nothingIsPendingAtFirst()
    {
        Pending<int> none;
        QVERIFY(!none.waiting() && !none.ready());
        QCOMPARE(none.take(), std::nullopt);
        PendingCall call;
        QVERIFY(!call.waiting() && !call.ready() && !call.poll());
    }
    void whoGoesAwayIsNotWaitedFor()
    {
        const Promise<int> work;
        {
            const Pending<int> dropped = work.pending();
        }
        Pending<int> forgotten;
        forgotten.forget();
        work.give(7); // nobody is there, and nothing happens
        QVERIFY(!forgotten.waiting());
    }
    void whoPollsIsWokenOnce()
    {
        const Promise<int> work;
        Pending<int> pending = work.pending();
        int woken = 0;
        pending.whenReady([&] { ++woken; });
        QCOMPARE(woken, 0);
        work.give(7);
        QCOMPARE(woken, 1);
        QVERIFY(pending.ready()); // before the call, so that who is woken finds it
        pending.whenReady([&] { ++woken; });
        QCOMPARE(woken, 2); // too late to be told later
    }
    void aValueIsWaitedForAcrossThreads()
    {
        const Promise<int> work;
        std::thread other([work] { work.give(7); });
        QCOMPARE(work.pending().get(), 7);
        other.join();
    }
    void aCallIsToldOnceAndMayAskAgain()
    {
        const Promise<int> first, second;
        std::vector<int> told;
        PendingCall call;
        call = PendingCall(first.pending(), [&](int value) {
            told.push_back(value);
            call = PendingCall(second.pending(), [&](int next) { told.push_back(next); });
        });
        QVERIFY(!call.poll());
        first.give(1);
        QVERIFY(call.poll());
        QVERIFY(call.waiting()); // for the second, asked for while the first was told
        QVERIFY(!call.poll());
        second.give(2);
        QVERIFY(call.poll());
        QVERIFY(!call.poll());
        QCOMPARE(told, (std::vector<int>{1, 2}));
    }
    void aCallThatIsReplacedIsNotTold()
    {
        const Promise<int> work;
        int told = 0;
        PendingCall call(work.pending(), [&](int value) { told = value; });
        call = {};
        work.give(3);
        QVERIFY(!call.poll());
        QCOMPARE(told, 0);
    }
};

GRIPSCOPE_TEST(PendingTest)
#include "pending_test.moc"
