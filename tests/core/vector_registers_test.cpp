// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel_runs.h"
#include "core/base/vector_registers.h"
#include "core/session/tasks/pool.h"
#include "tests/support/test_registry.h"

#include <atomic>

#ifdef __x86_64__
#include <cpuid.h>
#endif

using namespace gripscope;

namespace {

#ifdef __x86_64__
constexpr unsigned upperHalves = 1U << 2U; // of what the processor keeps track of

/// Tells with XGETBV what is in use (Intel's manual, volume 1, 13.6).
bool tellsWhatIsInUse()
{
    unsigned a = 0, b = 0, c = 0, d = 0;
    constexpr unsigned osxsave = 1U << 27U, told = 1U << 2U;
    const bool saves = __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & osxsave) != 0;
    return saves && __get_cpuid_count(0xd, 1, &a, &b, &c, &d) != 0 && (a & told) != 0 &&
           __builtin_cpu_supports("avx2");
}

bool upperHalvesInUse()
{
    unsigned low = 0, high = 0;
    asm volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(1));
    return (low & upperHalves) != 0;
}

/// As Qt's hash leaves them.
void useUpperHalves()
{
    asm volatile("vpcmpeqd %%ymm1, %%ymm1, %%ymm1" ::: "xmm1");
}
#else
bool tellsWhatIsInUse()
{
    return false;
}
bool upperHalvesInUse()
{
    return false;
}
void useUpperHalves() {}
#endif

/// Some processors do not tell, others call them in use from the first use on.
bool tellsThatTheyAreReleased()
{
    if (!tellsWhatIsInUse())
        return false;
    useUpperHalves();
    const bool used = upperHalvesInUse();
    releaseVectorRegisters();
    return used && !upperHalvesInUse();
}

} // namespace

/// What Qt leaves in the registers does not slow down what is computed. Where a processor does not tell what
/// is in use, there is nothing to see.
class VectorRegistersTest : public QObject {
    Q_OBJECT
private slots:
    void workInAPoolBeginsWithoutWhatItsThreadWasHanded()
    {
        if (!tellsThatTheyAreReleased())
            return;
        QThreadPool pool;
        pool.setMaxThreadCount(1);
        useUpperHalves();
        // The second follows one that left them in use.
        for (int i = 0; i < 2; ++i) {
            Pending<bool> work = inPool(
                [] {
                    const bool inUse = upperHalvesInUse();
                    useUpperHalves();
                    return inUse;
                },
                pool);
            pool.waitForDone();
            QCOMPARE(work.take(), std::optional(false));
        }
        releaseVectorRegisters();
    }
    void soDoesWorkThatThreadsShare()
    {
        if (!tellsThatTheyAreReleased())
            return;
        std::atomic<int> inUse = 0;
        useUpperHalves();
        shareAmongThreads(4, 4, [&inUse](std::int64_t) { inUse += upperHalvesInUse() ? 1 : 0; });
        QCOMPARE(inUse.load(), 0);
    }
};

GRIPSCOPE_TEST(VectorRegistersTest)
#include "vector_registers_test.moc"
