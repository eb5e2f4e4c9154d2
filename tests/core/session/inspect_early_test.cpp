// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QThreadPool>

#include <algorithm>
#include <array>
#include <cmath>
#include <future>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// Each many standard deviations of its scatter from the others.
const std::vector<std::pair<QString, MassDampingStiffness>> fourTypes{
    {u"A"_s, canA}, {u"B"_s, {0.035, 30, 6200}}, {u"C"_s, canC}, {u"D"_s, {0.045, 52, 15000}}};

/// Every thread of the pool waits until this goes away.
class BusyPool {
public:
    BusyPool()
    {
        QThreadPool* pool = QThreadPool::globalInstance();
        for (int i = 0; i < pool->maxThreadCount(); ++i)
            pool->start([released = m_released] { released.wait(); });
    }
    ~BusyPool() { m_release.set_value(); }

private:
    std::promise<void> m_release;
    std::shared_future<void> m_released = m_release.get_future().share();
};

} // namespace

/// Squeezes of known objects that end as soon as they are decided.
class InspectEarlyTest : public QObject {
    Q_OBJECT
private:
    QTemporaryDir m_folder;
    QString m_file;

    /// A squeeze of `object` that waits for each look, so that what is decided does not depend on the
    /// machine.
    static bool squeeze(InspectionRun& run, const MassDampingStiffness& object)
    {
        FakeGripper& gripper = run.connection.gripper();
        gripper.object = object;
        gripper.noise_m = 5e-6;
        gripper.chunk = 40;
        gripper.holdsBack = [&run] { return run.inspection.looking(); };
        // To the session the looks take no time: a slow one is no gripper that has fallen silent.
        run.inspection.setClock([] { return std::chrono::steady_clock::time_point(); });
        return run.inspection.squeeze() && run.ready() && run.inspection.result();
    }

private slots:
    void initTestCase() { enrolTypes(m_folder.filePath(u"enrolled.db"_s), fourTypes, 6); }
    void init()
    {
        static int run = 0;
        m_file = m_folder.filePath(u"run-%1.db"_s.arg(++run));
        QVERIFY(QFile::copy(m_folder.filePath(u"enrolled.db"_s), m_file));
    }

    void knownPartsAreNamedInAFractionOfTheSqueeze()
    {
        InspectionRun run(m_file);
        run.inspection.setStoring(false);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        GaussianNoise scatter(3);
        constexpr int squeezes = 20;
        int right = 0, wrong = 0, early = 0;
        double seconds = 0;
        for (int i = 0; i < squeezes; ++i) {
            const auto& [name, mean] = fourTypes[std::size_t(i) % fourTypes.size()];
            const double m = mean.m * (1 + 0.03 * scatter()), b = mean.b * (1 + 0.03 * scatter()),
                         k = mean.k * (1 + 0.03 * scatter());
            QVERIFY(squeeze(run, {m, b, k}));
            const InspectSession::Result& result = *run.inspection.result();
            right += result.verdict.type == name;
            wrong += result.verdict.kind == VerdictKind::Type && result.verdict.type != name;
            early += result.earlyEnd.has_value();
            seconds += result.seconds;
            QVERIFY(run.connection.session.armed());
        }
        QCOMPARE(wrong, 0);
        // At a false-reject rate of 1 %, three of twenty happen less than once in 900 times.
        QVERIFY2(right >= 18, qPrintable(QString::number(right)));
        QVERIFY2(early >= 18, qPrintable(QString::number(early)));
        // Of 1 s each.
        QVERIFY2(seconds / squeezes < 0.5, qPrintable(QString::number(seconds / squeezes)));
    }

    /// While it goes on a part that yields would be taken for a stranger: what it has besides m, b and k is
    /// not known before its end.
    void whereATypeDeterminesMoreSqueezesGoOnToTheirEnd()
    {
        {
            using enum TypeQuantity;
            std::unique_ptr<Library> library = std::move(*Library::open(m_file));
            for (std::uint64_t seed = 1; seed <= 6; ++seed) {
                const Recording recording = scatteredSqueezeOf({0.06, 60, 2e4}, seed);
                NewGrasp grasp = makeGrasp(recording, identify(recording), u"file.csv"_s, {});
                LogVector log(4);
                log << std::log(0.06), std::log(60), std::log(2e4), std::log(0.05 + 0.001 * double(seed));
                grasp.determined =
                    DeterminedQuantities{{{Mass, Damping, Stiffness, RelaxationTime}}, log, {}};
                const Expected<StoredSqueeze> stored = storeSqueeze(*library, {u"foam"_s, {}, grasp});
                QVERIFY(stored.has_value());
                if (seed == 6)
                    QVERIFY(library->approveType(stored->type.id, {}));
            }
        }
        InspectionRun run(m_file);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        QVERIFY(squeeze(run, canA));
        QVERIFY(!run.inspection.result()->earlyEnd);
        QCOMPARE(run.inspection.result()->verdict.type, u"A"_s);
    }

    void theRecordSaysThatItEndedEarlyAndWhy()
    {
        InspectionRun run(m_file);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        QVERIFY(squeeze(run, canA));
        const InspectSession::Result& result = *run.inspection.result();
        QVERIFY(result.earlyEnd);
        QCOMPARE(result.earlyEnd->type, u"A"_s);
        QCOMPARE(result.verdict.type, u"A"_s);
        QVERIFY(result.verdict.reasons.back().describe().startsWith(u"Decided after"_s));
        QVERIFY(result.recording.provenance.value(u"ended_early"_s).startsWith(u"A after"_s));
        const auto stored =
            run.library.run<std::vector<InspectionRecord>>([](Library& l) { return l.inspections({}); })
                .get();
        QVERIFY(stored->at(0).reason.describe().contains(u"Decided after"_s));
        const QString grasp = stored->at(0).graspId;
        const auto recording =
            run.library.run<Recording>([grasp](Library& l) { return l.recording(grasp); }).get();
        QVERIFY(recording->provenance.contains(u"ended_early"_s));
    }

    void aStrangerIsUnknownEarly()
    {
        InspectionRun run(m_file);
        run.inspection.setStoring(false);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        QVERIFY(squeeze(run, {0.08, 90, 22000}));
        QVERIFY(run.inspection.result()->verdict.kind == VerdictKind::Unknown);
        QVERIFY(run.inspection.result()->earlyEnd);
    }

    void switchedOffTheSqueezeIsWhole()
    {
        InspectionRun run(m_file);
        run.inspection.setStoring(false);
        run.inspection.setEarlyEnd(false);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        QVERIFY(squeeze(run, canA));
        QVERIFY(!run.inspection.result()->earlyEnd);
        QVERIFY(run.inspection.result()->seconds >= 1.0);
        QCOMPARE(run.connection.gripper().finished, 0);
    }

    void aDecisionThatNeverComesDelaysNothing()
    {
        InspectionRun run(m_file);
        run.inspection.setStoring(false);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        {
            const BusyPool busy;
            QVERIFY(run.inspection.squeeze());
            QVERIFY(run.until([&] { return run.inspection.state() == InspectSession::State::Judging; }));
        }
        QVERIFY(run.ready());
        QVERIFY(!run.inspection.result()->earlyEnd);
        QCOMPARE(run.inspection.result()->verdict.type, u"A"_s);
        QVERIFY(run.inspection.result()->seconds >= 1.0);
    }

    void theLastTenthIsNotLookedAt()
    {
        InspectionRun run(m_file);
        run.inspection.setStoring(false);
        run.inspection.setClock([] { return std::chrono::steady_clock::time_point(); });
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        FakeGripper& gripper = run.connection.gripper();
        gripper.noise_m = 2e-3; // too much to decide anything
        gripper.chunk = 40;
        std::size_t leftAtLook = 2000;
        gripper.holdsBack = [&] {
            if (run.inspection.looking())
                leftAtLook = std::min(leftAtLook, gripper.pending.size());
            return run.inspection.looking();
        };
        QVERIFY(run.inspection.squeeze());
        QVERIFY(run.ready());
        QVERIFY(!run.inspection.result()->earlyEnd);
        QVERIFY(leftAtLook >= 200 && leftAtLook < 400);
    }

    void aGripperThatGoesOnIsJudgedByTheWholeSqueeze()
    {
        InspectionRun run(m_file);
        run.inspection.setStoring(false);
        QVERIFY(run.connection.open());
        run.connection.gripper().finishesOnRequest = false;
        QVERIFY(run.ready());
        QVERIFY(squeeze(run, canC));
        QCOMPARE(run.connection.gripper().finished, 1);
        QVERIFY(!run.inspection.result()->earlyEnd);
        QCOMPARE(run.inspection.result()->verdict.type, u"C"_s);
    }

    void theTimeIsStatedBeforehand()
    {
        InspectionRun run(m_file);
        run.inspection.setForecasting(true);
        QVERIFY(run.ready());
        QVERIFY(!run.inspection.forecast()); // no gripper, no squeeze
        QVERIFY(run.connection.open());
        QVERIFY(run.until([&] { return run.inspection.forecast().has_value(); }));
        QVERIFY(run.inspection.forecast()->mean_s < run.inspection.nextRecipe().seconds);
        run.inspection.setEarlyEnd(false);
        run.inspection.poll();
        QVERIFY(!run.inspection.forecast()); // nothing to state: each takes its whole time
        QCOMPARE(run.inspection.nextRecipe().seconds, 1.0);
    }
};

GRIPSCOPE_TEST(InspectEarlyTest)
#include "inspect_early_test.moc"
