// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/history.h"
#include "tests/core/library/raw_database.h"
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using InspectState = InspectSession::State;

class InspectSessionTest : public QObject {
    Q_OBJECT
private:
    using Run = InspectionRun;
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;

private slots:
    void initTestCase()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        enrolTypes(m_folder->filePath(QStringLiteral("enrolled.db")),
                   {{QStringLiteral("A"), canA}, {QStringLiteral("C"), canC}}, 5);
    }
    void init()
    {
        static int run = 0;
        m_file = m_folder->filePath(QStringLiteral("run-%1.db").arg(++run));
        QVERIFY(QFile::copy(m_folder->filePath(QStringLiteral("enrolled.db")), m_file));
    }
    void whatIsStoredOfASqueezeIsTheObjectAlone()
    {
        Recording recording = scatteredSqueezeOf(canA, 1);
        recording.chain.baseline = GripperBaseline{{0.004, 4, 900}, {1e-5, 0.01, 5}};
        const Identification found = identify(recording);
        const NewGrasp grasp = makeGrasp(recording, found, QStringLiteral("file.csv"), {});
        QCOMPARE(*grasp.estimates.front().parameters, found.object()->parameters);
        QVERIFY(std::abs(grasp.estimates.front().parameters->k - (found.best()->parameters->k - 900)) < 1e-9);
        QCOMPARE(grasp.estimates.size(), found.estimates.size());
    }
    void outcomesNeverShareAWord()
    {
        const QString a = QStringLiteral("A"), c = QStringLiteral("C");
        QVERIFY(inspectionOutcome(VerdictKind::Type, a, a) == InspectionOutcome::AsExpected);
        QVERIFY(inspectionOutcome(VerdictKind::Type, a, {}) == InspectionOutcome::AsExpected);
        QVERIFY(inspectionOutcome(VerdictKind::Type, a, c) == InspectionOutcome::OtherType);
        QVERIFY(inspectionOutcome(VerdictKind::Unknown, {}, a) == InspectionOutcome::Unknown);
        QVERIFY(inspectionOutcome(VerdictKind::Inconclusive, {}, a) == InspectionOutcome::Inconclusive);
        QVERIFY(inspectionOutcome(VerdictKind::Invalid, {}, a) == InspectionOutcome::NotValid);
        const QSet<QString> words{
            toString(InspectionOutcome::AsExpected), toString(InspectionOutcome::OtherType),
            toString(InspectionOutcome::Unknown),    toString(InspectionOutcome::Inconclusive),
            toString(InspectionOutcome::NotValid),   toString(InspectionOutcome::DoesNotConform)};
        QCOMPARE(words.size(), 6);
    }
    void aSqueezeOfTheGripperGetsItsVerdictAndANumber()
    {
        Run run(m_file);
        QCOMPARE(run.inspection.state(), InspectState::Loading);
        QVERIFY(!run.inspection.squeeze()); // not before the library is read
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.types().size(), std::size_t(2));
        run.inspection.setOperator(QStringLiteral("Ada"));
        run.inspection.setExpectedType(QStringLiteral("A"));
        QVERIFY(run.inspection.squeeze());
        QCOMPARE(run.inspection.state(), InspectState::Squeezing);
        QVERIFY(run.ready());
        QVERIFY(!run.inspection.lastError());
        const InspectSession::Result& result = *run.inspection.result();
        QVERIFY(result.verdict.kind == VerdictKind::Type);
        QCOMPARE(result.verdict.type, QStringLiteral("A"));
        QVERIFY(result.outcome == InspectionOutcome::AsExpected);
        QCOMPARE(result.number, qint64(1));
        QCOMPARE(run.inspection.counts().total, qint64(1));
        QCOMPARE(run.inspection.counts().asExpected, qint64(1));
        const auto stored =
            run.library.run<std::vector<InspectionRecord>>([](Library& l) { return l.inspections({}); })
                .get();
        QCOMPARE(stored->at(0).type, QStringLiteral("A"));
        QCOMPARE(stored->at(0).operatorName, QStringLiteral("Ada"));
    }
    void whatWasInForceIsStoredWithIt()
    {
        Run run(m_file);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        VerdictOptions rates;
        rates.strangerAccept = 0.05;
        rates.confidence = 0.95;
        run.inspection.setRates(rates);
        QVERIFY(run.inspection.squeeze());
        QVERIFY(run.ready());
        const auto stored = run.library
                                .run<std::vector<HistoryEntry>>([](Library& l) {
                                    return l.historyEntries({l.inspections({})->at(0).graspId});
                                })
                                .get();
        const auto version = run.library.run<qint64>([](Library& l) { return l.version(); }).get();
        const HistoryEntry& entry = stored->at(0);
        QCOMPARE(entry.libraryVersion, std::optional<qint64>(*version));
        QVERIFY(*version > 0);
        QCOMPARE(entry.program, QStringLiteral(GRIPSCOPE_VERSION));
        QVERIFY(entry.validity && !entry.heldTo.robust.value_or(true));
        QVERIFY(entry.positionCalibration && entry.positionCalibration->isEmpty()); // none was in force
        QVERIFY(entry.heldTo == (HeldTo{0.01, 0.001, 0.05, 0.95, false}));
    }
    void whatAnInspectionSays_data()
    {
        QTest::addColumn<int>("which");
        QTest::addColumn<QString>("expected");
        QTest::addColumn<QString>("outcome");
        QTest::newRow("as expected") << 0 << QStringLiteral("A") << QStringLiteral("as_expected");
        QTest::newRow("another type") << 1 << QStringLiteral("A") << QStringLiteral("other_type");
        QTest::newRow("nothing expected") << 1 << QString() << QStringLiteral("as_expected");
        QTest::newRow("a stranger") << 2 << QStringLiteral("A") << QStringLiteral("unknown");
        QTest::newRow("no measurement") << 3 << QStringLiteral("A") << QStringLiteral("not_valid");
    }
    void whatAnInspectionSays()
    {
        QFETCH(int, which);
        QFETCH(QString, expected);
        QFETCH(QString, outcome);
        Run run(m_file);
        QVERIFY(run.ready());
        run.inspection.setExpectedType(expected);
        const Recording recording = which == 0   ? squeezeOf(canA, 77)
                                    : which == 1 ? squeezeOf(canC, 78)
                                    : which == 2 ? squeezeOf(strangeCan, 79)
                                                 : constantForce();
        QVERIFY(run.inspection.judgeRecording(recording, QStringLiteral("file.csv")));
        QVERIFY(run.ready());
        QVERIFY(!run.inspection.lastError());
        QCOMPARE(toString(run.inspection.result()->outcome), outcome);
        QCOMPARE(run.inspection.result()->number, qint64(1)); // an invalid one is kept, too
        QCOMPARE(run.inspection.result()->expectedType, expected);
    }
    void theOldVerdictIsGoneAsSoonAsANewPartIsMeasured()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        QVERIFY(run.inspection.judgeRecording(squeezeOf(canA, 1), QStringLiteral("1.csv")));
        QVERIFY(run.ready());
        QVERIFY(run.inspection.result());
        QVERIFY(run.inspection.judgeRecording(squeezeOf(canA, 2), QStringLiteral("2.csv")));
        QVERIFY(!run.inspection.result());
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.result()->number, qint64(2));
        QCOMPARE(run.inspection.counts().total, qint64(2));
    }
    void squeezesOfOneGripperTellTheHoldTogether()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        const std::pair<const char*, int> squeezes[] = {{"G-1", 1}, {"G-1", 2}, {"G-2", 1}, {"G-1", 3}};
        std::uint64_t seed = 0;
        for (const auto& squeeze : squeezes) {
            Recording recording = squeezeOf(canA, ++seed);
            recording.provenance.insert(QStringLiteral("serial"), QString::fromLatin1(squeeze.first));
            QVERIFY(run.inspection.judgeRecording(recording, QStringLiteral("file.csv")));
            QVERIFY(run.ready());
            QCOMPARE(run.inspection.result()->identification.summedHold.squeezes, squeeze.second);
        }
    }
    void otherUnitsOfTheSameKindAreConverted()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        Recording recording = squeezeOf(canA, 3);
        recording.forceUnit = QStringLiteral("mN");
        recording.positionUnit = QStringLiteral("mm");
        for (double& force : recording.force)
            force *= 1000;
        for (double& position : recording.position)
            position *= 1000;
        QVERIFY(run.inspection.judgeRecording(recording, QStringLiteral("mm.csv")));
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.result()->verdict.type, QStringLiteral("A"));
    }
    void unitsThatCannotBeComparedGiveNoVerdict()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        Recording recording = squeezeOf(canA, 3);
        recording.forceUnit = recording.positionUnit = QStringLiteral("1");
        QVERIFY(run.inspection.judgeRecording(recording, QStringLiteral("printed.csv")));
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.lastError()->code, ErrorCode::UnitsDiffer);
        QVERIFY(!run.inspection.result());
        QCOMPARE(run.inspection.counts().total, qint64(0));
    }
    void withoutStoringTheLibraryStaysAsItIs()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        run.inspection.setStoring(false);
        QVERIFY(run.inspection.judgeRecording(squeezeOf(canA, 1), QStringLiteral("1.csv")));
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.result()->number, qint64(0));
        const auto counts =
            run.library.run<InspectionCounts>([](Library& l) { return l.inspectionCounts(); }).get();
        QCOMPARE(counts->total, qint64(0));
    }
    void aLostGripperGivesNoVerdict()
    {
        Run run(m_file);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        run.connection.gripper().lostAfterSamples = 300;
        QVERIFY(run.inspection.squeeze());
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.lastError()->code, ErrorCode::DeviceLost);
        QVERIFY(!run.inspection.result());
    }
    void cancellingStopsTheGripperAndIsReadyAgain()
    {
        Run run(m_file);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        run.connection.gripper().neverStarts = true;
        QVERIFY(run.inspection.squeeze());
        run.inspection.poll();
        run.inspection.cancel();
        QCOMPARE(run.inspection.state(), InspectState::Ready);
        QCOMPARE(run.connection.gripper().stops.load(), 1);
        QCOMPARE(run.inspection.lastError()->code, ErrorCode::Cancelled);
    }
    void aLibraryThatCannotBeReadIsAnErrorUntilItCan()
    {
        const QString folder = m_folder->filePath(QStringLiteral("later"));
        Run run(folder + QStringLiteral("/library.db"));
        QVERIFY(run.until([&] { return run.inspection.lastError().has_value(); }));
        QCOMPARE(run.inspection.state(), InspectState::Loading);
        QCOMPARE(run.inspection.lastError()->code, ErrorCode::StorageOpen);
        QVERIFY(QDir().mkpath(folder));
        run.inspection.reload();
        QVERIFY(run.ready());
        QVERIFY(!run.inspection.lastError());
    }
    void reloadingSeesWhatWasEnrolledMeanwhile()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        const Recording recording = squeezeOf(strangeCan, 1);
        const NewGrasp grasp = makeGrasp(recording, identify(recording), QStringLiteral("file.csv"), {});
        const Expected<StoredSqueeze> stored =
            run.library
                .run<StoredSqueeze>([grasp](Library& l) {
                    return storeSqueeze(l, {QStringLiteral("new"), {}, grasp});
                })
                .get();
        QVERIFY(stored.has_value());
        run.inspection.reload();
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.types().size(), std::size_t(3));
        // It waits for approval, and no part is held against it.
        QVERIFY(!run.inspection.models().find(QStringLiteral("new")));
        QCOMPARE(run.inspection.approvedTypes().size(), std::size_t(2));
        QVERIFY(run.library.run<void>([id = stored->type.id](Library& l) { return l.approveType(id, {}); })
                    .get());
        run.inspection.reload();
        QVERIFY(run.ready());
        QVERIFY(run.inspection.models().find(QStringLiteral("new")));
        QCOMPARE(run.inspection.approvedTypes().size(), std::size_t(3));
    }
    void anUnfinishedTypeTakesNoPartInAVerdict()
    {
        // One squeeze of a part just like A, left for later: whether it is A stays as plain as before.
        const Recording part = squeezeOf(canA, 77);
        const auto verdictNow = [&] {
            Run run(m_file);
            run.inspection.setStoring(false);
            if (!run.ready() || !run.inspection.judgeRecording(part, QStringLiteral("part")) || !run.ready())
                return Verdict{};
            return run.inspection.result()->verdict;
        };
        const Verdict before = verdictNow();
        QCOMPARE(before.type, QStringLiteral("A"));
        {
            std::unique_ptr<Library> library = std::move(*Library::open(m_file));
            const Recording recording = scatteredSqueezeOf(canA, 99);
            const NewGrasp grasp = makeGrasp(recording, identify(recording), QStringLiteral("file.csv"), {});
            QVERIFY(storeSqueeze(*library, {QStringLiteral("Long one"), {}, grasp}).has_value());
        }
        const Verdict after = verdictNow();
        QCOMPARE(after.type, QStringLiteral("A"));
        QCOMPARE(after.posterior, before.posterior);
        QCOMPARE(after.gate, before.gate);
    }
    void theExpectedTypesRecipeIsUsed()
    {
        Recipe recipe;
        recipe.seconds = 0.4;
        {
            std::unique_ptr<Library> library = std::move(*Library::open(m_file));
            const Recording recording = squeezeOf(strangeCan, 1);
            QVERIFY(storeSqueeze(
                *library, {QStringLiteral("short"), recipe,
                           makeGrasp(recording, identify(recording), QStringLiteral("file.csv"), {})}));
        }
        Run run(m_file);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        run.inspection.setExpectedType(QStringLiteral("short"));
        QVERIFY(run.inspection.squeeze());
        QCOMPARE(run.connection.gripper().commanded_N.size(), std::size_t(800));
        QVERIFY(run.ready());
    }
    void aBatchEndsByItselfWhenItIsWhole()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        QVERIFY(!run.inspection.batch());
        run.inspection.setOperator(QStringLiteral("Ada"));
        run.inspection.setExpectedType(QStringLiteral("A"));
        run.inspection.beginBatch({QStringLiteral("4711"), 2, QStringLiteral("A"), {}});
        QVERIFY(run.inspection.changingBatch());
        QVERIFY(run.until([&] { return !run.inspection.changingBatch(); }));
        QCOMPARE(run.inspection.batch()->operatorName, QStringLiteral("Ada"));
        const auto inspect = [&](const Recording& recording) {
            QVERIFY(run.inspection.judgeRecording(recording, QStringLiteral("file.csv")));
            QVERIFY(run.ready());
            QVERIFY(!run.inspection.lastError());
        };
        inspect(squeezeOf(canA, 77));
        inspect(squeezeOf(canC, 78)); // another type
        inspect(constantForce());     // no measurement
        inspect(squeezeOf(strangeCan, 79));
        QCOMPARE(run.inspection.batch()->counts.asExpected, qint64(1));
        QCOMPARE(run.inspection.batch()->counts.total, qint64(4));
        QVERIFY(!run.inspection.batch()->ended);
        inspect(squeezeOf(canA, 80));
        QVERIFY(run.inspection.batch()->whole());
        QVERIFY(run.inspection.batch()->ended);
        // Parts after it belong to none, and its end stays in sight.
        inspect(squeezeOf(canA, 81));
        QCOMPARE(run.inspection.batch()->counts.total, qint64(5));
        QCOMPARE(run.inspection.counts().total, qint64(6));
        run.inspection.reload();
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.batch()->name, QStringLiteral("4711"));
    }
    void aBatchGoesOnAfterARestartAndIsEndedByAPerson()
    {
        {
            Run run(m_file);
            QVERIFY(run.ready());
            run.inspection.beginBatch({QStringLiteral("4711"), 10, {}, {}});
            QVERIFY(run.until([&] { return !run.inspection.changingBatch(); }));
            QVERIFY(run.inspection.judgeRecording(squeezeOf(canA, 77), QStringLiteral("file.csv")));
            QVERIFY(run.ready());
        }
        Run run(m_file);
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.batch()->counts.asExpected, qint64(1));
        run.inspection.beginBatch({QStringLiteral("4712"), 10, {}, {}}); // one at a time
        QVERIFY(run.until([&] { return !run.inspection.changingBatch(); }));
        QCOMPARE(run.inspection.lastError()->code, ErrorCode::Usage);
        QCOMPARE(run.inspection.batch()->name, QStringLiteral("4711"));
        run.inspection.endBatch();
        QVERIFY(run.until([&] { return !run.inspection.changingBatch(); }));
        QVERIFY(run.inspection.batch()->ended);
        QVERIFY(!run.inspection.batch()->whole());
    }
    void whatTheLibraryCannotTakeNowIsMarkedAndStoredLater_data()
    {
        QTest::addColumn<bool>("locked");
        QTest::newRow("file away, and back") << false;
        QTest::newRow("locked by another program, and released") << true;
    }
    void whatTheLibraryCannotTakeNowIsMarkedAndStoredLater()
    {
        QFETCH(bool, locked);
        auto now = std::chrono::steady_clock::time_point() + std::chrono::hours(1);
        Run run(m_file);
        run.inspection.setClock([&now] { return now; });
        QVERIFY(run.ready());
        const QString away = m_file + QStringLiteral(".away");
        RawDatabase other(locked ? m_file : away + QStringLiteral(".none"));
        if (locked)
            other.run(QStringLiteral("BEGIN IMMEDIATE"));
        else
            QVERIFY(QFile::rename(m_file, away));
        const auto judged = [&](int seed) {
            QVERIFY(run.inspection.judgeRecording(squeezeOf(canA, seed), QStringLiteral("file.csv")));
            QVERIFY(run.until([&] { return run.inspection.result() && !run.inspection.storing(); }));
        };
        for (const int seed : {1, 2, 3}) {
            judged(seed);
            QVERIFY(run.inspection.result()->keeping == InspectSession::Keeping::Waiting);
            QCOMPARE(run.inspection.result()->number, qint64(0));
            QCOMPARE(run.inspection.lastError()->code, ErrorCode::StorageFailed);
        }
        QCOMPARE(run.inspection.unstored(), std::size_t(3));
        int polls = 0; // tried again some times, in vain
        QVERIFY(run.until([&] {
            now += std::chrono::seconds(1);
            return ++polls > 50;
        }));
        QCOMPARE(run.inspection.unstored(), std::size_t(3));
        if (locked)
            other.run(QStringLiteral("ROLLBACK"));
        else
            QVERIFY(QFile::rename(away, m_file));
        QVERIFY(run.until([&] {
            now += std::chrono::seconds(1);
            return run.inspection.unstored() == 0;
        }));
        QVERIFY(run.inspection.result()->keeping == InspectSession::Keeping::Stored);
        QCOMPARE(run.inspection.result()->number, qint64(3));
        QVERIFY(!run.inspection.lastError());
        QCOMPARE(run.inspection.counts().total, qint64(3));
    }
    void withoutRoomForMoreThereIsNoFurtherSqueeze()
    {
        Run run(m_file);
        QVERIFY(run.ready());
        QVERIFY(QFile::remove(m_file));
        const Recording recording = squeezeOf(canA, 1);
        for (std::size_t i = 0; i < InspectSession::mostUnstored; ++i) {
            QVERIFY(run.inspection.judgeRecording(recording, QStringLiteral("file.csv")));
            QVERIFY(run.until([&] { return run.inspection.result() && !run.inspection.storing(); }));
        }
        const auto refused = run.inspection.squeeze();
        QVERIFY(!refused);
        QVERIFY(refused.error().describe().contains(QStringLiteral("not stored yet")));
        QVERIFY(!run.inspection.judgeRecording(recording, QStringLiteral("file.csv")));
    }
    void anInspectionThatIsAskedForTwiceIsStoredOnce()
    {
        const auto library = std::move(*Library::open(m_file));
        NewInspection inspection;
        inspection.grasp =
            makeGrasp(squeezeOf(canA, 1), identify(squeezeOf(canA, 1)), QStringLiteral("f"), {});
        inspection.grasp.recorded = QDateTime(QDate(2026, 1, 2), QTime(3, 4, 5), Qt::UTC);
        inspection.id = QStringLiteral("0190a5b2-7c3e-7def-8123-456789abcdef");
        const auto once = library->addInspection(inspection);
        const auto twice = library->addInspection(inspection);
        QVERIFY(once && twice);
        QCOMPARE(twice->number, once->number);
        QCOMPARE(once->id, inspection.id);
        QCOMPARE(once->inspected, inspection.grasp.recorded); // when it was, not when it could be stored
        QCOMPARE(library->inspectionCounts()->total, qint64(1));
    }
    void goingAwayWhileWorkRunsDoesNoHarm()
    {
        {
            Run run(m_file);
        } // loading
        {
            Run run(m_file);
            QVERIFY(run.ready());
            QVERIFY(run.inspection.judgeRecording(squeezeOf(canA, 1), QStringLiteral("1.csv")));
        } // judging
        {
            Run run(m_file);
            QVERIFY(run.ready());
            QVERIFY(run.inspection.judgeRecording(squeezeOf(canA, 1), QStringLiteral("1.csv")));
            QVERIFY(run.until([&] { return run.inspection.result().has_value(); }));
        } // storing
        Run run(m_file);
        QVERIFY(run.ready());
        QCOMPARE(run.inspection.counts().total, qint64(1));
    }
};

GRIPSCOPE_TEST(InspectSessionTest)
#include "inspect_session_test.moc"
