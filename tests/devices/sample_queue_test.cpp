// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/sample_queue.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <thread>

using namespace gripscope;

namespace {
std::vector<Sample> numbered(std::uint64_t first, std::size_t count)
{
    std::vector<Sample> samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples[i].sequence = first + i;
    return samples;
}
} // namespace

class SampleQueueTest : public QObject {
    Q_OBJECT
private slots:
    void dropsTheNewestWhenFull()
    {
        SampleQueue queue(10);
        QCOMPARE(queue.push(numbered(0, 8)), std::size_t(8));
        QCOMPARE(queue.push(numbered(8, 8)), std::size_t(2));
        std::vector<Sample> out;
        QCOMPARE(queue.pop(out, 4), std::size_t(4));
        QCOMPARE(queue.push(numbered(100, 8)), std::size_t(4));
        QCOMPARE(queue.pop(out, 100), std::size_t(10));
        QCOMPARE(out[9].sequence, std::uint64_t(9));
        QCOMPARE(out[10].sequence, std::uint64_t(100));
        QCOMPARE(queue.pop(out, 100), std::size_t(0));
        QCOMPARE(queue.pushed(), queue.popped());
    }

    void keepsOrderBetweenTwoThreads()
    {
        constexpr std::uint64_t all = 200000;
        SampleQueue queue(1000);
        std::thread producer([&] {
            for (std::uint64_t next = 0; next < all;)
                next += queue.push(numbered(next, std::min<std::size_t>(7, all - next)));
        });
        std::vector<Sample> out;
        while (out.size() < all)
            if (queue.pop(out, 64) == 0)
                std::this_thread::yield();
        producer.join();
        for (std::uint64_t i = 0; i < all; ++i)
            if (out[i].sequence != i)
                QFAIL("out of order");
    }
};

GRIPSCOPE_TEST(SampleQueueTest)
#include "sample_queue_test.moc"
