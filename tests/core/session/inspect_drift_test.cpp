// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// So many squeezes are seen to have moved, and not fewer (DriftOptions::recent looks at the last).
constexpr int enoughToTell = 16;

} // namespace

/// What moves while parts are inspected is told while they are inspected.
class InspectDriftTest : public QObject {
    Q_OBJECT
private:
    using Run = InspectionRun;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;

    static void inspect(Run& run, const MassDampingStiffness& part, std::uint64_t seed)
    {
        run.inspection.setExpectedType(QStringLiteral("A"));
        QVERIFY(run.inspection.judgeRecording(scatteredSqueezeOf(part, seed), QStringLiteral("file.csv")));
        QVERIFY(run.ready());
        QVERIFY(!run.inspection.lastError());
    }
    /// The report has looked at so many squeezes of the one type.
    static bool hasSeen(Run& run, int squeezes)
    {
        return run.until([&] {
            const std::optional<DriftReport>& report = run.inspection.drift();
            const int seen = report && !report->types.empty() ? report->types.front().squeezes : 0;
            return report && seen == squeezes;
        });
    }

    static bool isTold(Run& run)
    {
        return run.until(
            [&] { return run.inspection.drift() && run.inspection.drift()->moved.contains(u"A"); });
    }

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        m_file = m_folder->filePath(QStringLiteral("test.db"));
        enrolTypes(m_file, {{QStringLiteral("A"), canA}}, 8);
    }
    void aStifferPartIsToldAndStaysToldAfterARestart()
    {
        MassDampingStiffness stiffer = canA;
        for (double* const value : {&stiffer.m, &stiffer.b, &stiffer.k})
            *value *= 1.05; // less than two deviations each: still recognised
        {
            Run run(m_file);
            QVERIFY(run.ready());
            QVERIFY(hasSeen(run, 0));
            QVERIFY(!driftSignal(*run.inspection.drift()));
            for (int i = 0; i < enoughToTell; ++i)
                inspect(run, stiffer, 100 + std::uint64_t(i));
            QVERIFY(isTold(run));
            const std::optional<Finding> signal = driftSignal(*run.inspection.drift());
            QVERIFY(signal);
            QVERIFY2(signal->describe().contains(QLatin1String("A has moved")),
                     qPrintable(signal->describe()));
        }
        Run again(m_file);
        QVERIFY(again.ready());
        QVERIFY(isTold(again));
    }
    void anotherPartIsNoNewsOfTheExpectedOne()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        for (int i = 0; i < enoughToTell; ++i)
            inspect(run, strangeCan, 500 + std::uint64_t(i));
        inspect(run, canA, 600);
        QVERIFY(hasSeen(run, 1));
        QVERIFY(!driftSignal(*run.inspection.drift()));
    }
    void partsAsEnrolledAreNoNews()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        for (int i = 0; i < enoughToTell; ++i)
            inspect(run, canA, 200 + std::uint64_t(i));
        QVERIFY(run.until([&] { return run.inspection.drift() && !run.inspection.drift()->types.empty(); }));
        const std::optional<Finding> signal = driftSignal(*run.inspection.drift());
        QVERIFY2(!signal, signal ? qPrintable(signal->describe()) : "");
    }
    void whatIsVoidedCountsNoLonger()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        inspect(run, canA, 300);
        inspect(run, canA, 301);
        QVERIFY(hasSeen(run, 2));
        run.inspection.voidLast(QStringLiteral("squeezed twice"));
        QVERIFY(hasSeen(run, 1));
    }
    void aSqueezeThatIsNotKeptIsNotCounted()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        QVERIFY(hasSeen(run, 0));
        run.inspection.setStoring(false);
        inspect(run, canA, 400);
        QVERIFY(hasSeen(run, 0));
    }
};

GRIPSCOPE_TEST(InspectDriftTest)
#include "inspect_drift_test.moc"
