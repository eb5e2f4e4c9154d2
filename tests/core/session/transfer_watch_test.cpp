// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/gripper_adjustment.h"
#include "core/session/quality/study_session.h"
#include "core/session/shift/drift_look.h"
#include "core/session/shift/transfer_watch.h"
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using TransferStep = StudySession::State;

namespace {

constexpr double otherGain = 1.07; ///< of the second gripper's force sensor

/// One run of the program on the second gripper: squeezes of A and C as the plan asks for them.
struct TransferRun {
    explicit TransferRun(const QString& file)
        : library(file), session(connection.session, library), watch(library)
    {
        connection.gripper().identity.serial = u"F-2"_s;
        connection.gripper().forceGain = otherGain;
        session.setOperator(u"Lea"_s);
    }
    ArmedConnection connection;
    LibraryService library;
    StudySession session;
    TransferWatch watch;

    bool until(const std::function<bool()>& done)
    {
        return pollUntil(
            [this] {
                connection.session.poll();
                session.poll();
                if (session.study())
                    watch.follow(*session.study());
                watch.poll();
            },
            done);
    }
    bool settle()
    {
        return until([this] { return !session.busy(); });
    }
    bool looked()
    {
        return until([this] { return !session.busy() && !watch.busy(); });
    }
    bool begin(int trials = 4)
    {
        StudyRequest request;
        request.name = u"Second line"_s;
        request.design.kind = StudyKind::Transfer;
        request.design.parts = QStringList{u"A"_s, u"C"_s};
        request.design.trials = trials;
        request.design.order = PlanOrder::TrialAfterTrial;
        request.design.blind = false;
        request.recipe.seconds = 0.5;
        return connection.open() && session.begin(request) && settle() &&
               session.state() == TransferStep::Waiting;
    }
    QString next() const { return session.study()->plan.part(*session.nextRow()); }
    /// The part that is asked for, another of its type each time, or another than is asked for.
    bool squeeze(std::optional<MassDampingStiffness> part = {})
    {
        GaussianNoise scatter(9000 + std::uint64_t(session.study()->measurements.size()));
        const auto around = [&scatter](double value) { return value * (1 + 0.03 * scatter()); };
        const MassDampingStiffness type = part.value_or(next() == u"A"_s ? canA : canC);
        connection.gripper().object = {around(type.m), around(type.b), around(type.k)};
        return session.squeeze() && settle() && !session.lastError() && session.refusal().empty();
    }
    std::vector<StudyRecord> unfinished()
    {
        return library.run<std::vector<StudyRecord>>([](Library& kept) { return kept.unfinishedStudies(); })
            .get()
            .value();
    }
};

/// A and C with ten squeezes each, that scatter each on its own.
void enrolApart(const QString& file)
{
    const std::unique_ptr<Library> library = std::move(*Library::open(file));
    for (const auto& [name, part, seeds] : {std::tuple(u"A"_s, canA, 1), std::tuple(u"C"_s, canC, 2001)}) {
        QString typeId;
        for (int i = 0; i < 10; ++i) {
            const Recording recording = scatteredSqueezeOf(part, std::uint64_t(seeds + i));
            const NewGrasp grasp = makeGrasp(recording, identify(recording), u"file.csv"_s, {});
            const auto stored = storeSqueeze(*library, {name, {}, grasp});
            QVERIFY(stored.has_value());
            typeId = stored->type.id;
        }
        QVERIFY(library->approveType(typeId, {}));
    }
}

/// The true error is within so many of its standard uncertainties, in each quantity.
bool covers(const CommonShift& error, double deviations)
{
    const Eigen::Vector3d off = error.value - Eigen::Vector3d::Constant(std::log(otherGain));
    return (off.cwiseAbs().array() < deviations * error.covariance.diagonal().cwiseSqrt().array()).all();
}

} // namespace

/// Types of one gripper on another, from the first squeeze to the adjustment; and what has moved.
class TransferWatchTest : public QObject {
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;

private slots:
    void initTestCase()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        enrolApart(m_folder->filePath(u"enrolled.db"_s));
    }
    void init()
    {
        static int run = 0;
        m_file = m_folder->filePath(u"run-%1.db"_s.arg(++run));
        QVERIFY(QFile::copy(m_folder->filePath(u"enrolled.db"_s), m_file));
    }
    void aTransferIsLedToAnAdjustmentThatCoversTheTruth()
    {
        TransferRun run(m_file);
        QVERIFY(run.begin());
        QVERIFY(run.looked());
        QVERIFY(run.watch.look() && !run.watch.look()->report.error && !run.watch.look()->acceptable());
        QCOMPARE(run.watch.look()->missing, (QStringList{u"A"_s, u"C"_s}));
        QVERIFY(described(run.watch.look()->advice).join(u' ').contains(u"No adjustment yet"_s));
        for (int i = 0; i < 4; ++i)
            QVERIFY(run.squeeze());
        QVERIFY(run.looked());
        QCOMPARE(run.watch.look()->squeezes, 4);
        QVERIFY(run.watch.look()->report.error && !run.watch.look()->acceptable()); // two of each are too few
        QVERIFY(described(run.watch.look()->advice).join(u' ').contains(u"Too few squeezes of A, C"_s));
        for (int i = 0; i < 4; ++i)
            QVERIFY(run.squeeze());
        QVERIFY(run.looked());
        const TransferLook& look = *run.watch.look();
        QVERIFY(look.acceptable() && look.misfits().isEmpty());
        QVERIFY(covers(*look.report.error, 4));
        QVERIFY(look.report.error->degreesOfFreedom > 10);
        QVERIFY(run.session.finish() && run.looked());
        QVERIFY(run.session.state() == TransferStep::Ended);
        QVERIFY(run.watch.look()->acceptable()); // of an ended study, too
    }
    void killedInTheMiddleItGoesOnWithWhatIsStored()
    {
        std::optional<LogVector> before;
        {
            TransferRun run(m_file);
            QVERIFY(run.begin());
            for (int i = 0; i < 6; ++i)
                QVERIFY(run.squeeze());
            QVERIFY(run.looked());
            before = run.watch.look()->report.error->value;
            QVERIFY(run.session.squeeze()); // under way when the program ends
        }
        TransferRun run(m_file);
        QVERIFY(run.connection.open());
        QCOMPARE(run.unfinished().size(), std::size_t(1));
        QVERIFY(run.session.resume(run.unfinished()[0].id) && run.looked());
        QCOMPARE(run.watch.look()->squeezes, 6);
        QVERIFY(run.watch.look()->report.error->value == *before); // the same recordings, the same numbers
        QVERIFY(run.squeeze() && run.squeeze() && run.looked());
        QVERIFY(!run.session.nextRow() && run.watch.look()->acceptable());
    }
    void aWrongPartIsDoubtedAndTakenBack()
    {
        TransferRun run(m_file);
        QVERIFY(run.begin());
        for (int i = 0; i < 5; ++i)
            QVERIFY(run.squeeze());
        QVERIFY(run.looked() && !run.watch.look()->doubt);
        QVERIFY(run.squeeze(run.next() == u"A"_s ? canC : canA));
        QVERIFY(run.looked());
        QVERIFY(run.watch.look()->doubt);
        QVERIFY(run.watch.look()->doubt->describe().contains(u"Take it back"_s));
        QVERIFY(run.session.undo(u"the wrong part"_s) && run.looked());
        QCOMPARE(run.watch.look()->squeezes, 5);
        QVERIFY(run.squeeze() && run.looked());
        QVERIFY(!run.watch.look()->doubt && run.watch.look()->acceptable());
    }
    void aTypeThatIsNotCommonStandsAgainstIt()
    {
        TransferRun run(m_file);
        QVERIFY(run.begin());
        const MassDampingStiffness notC{canC.m * 1.3, canC.b * 1.3, canC.k * 0.75};
        while (run.session.nextRow())
            QVERIFY(run.squeeze(run.next() == u"A"_s ? canA : notC));
        QVERIFY(run.looked());
        QCOMPARE(run.watch.look()->misfits(), (QStringList{u"A"_s, u"C"_s}));
        QVERIFY(!run.watch.look()->acceptable());
        QVERIFY(described(run.watch.look()->advice).join(u' ').contains(u"A third type tells which"_s));
    }
    void eachTypeIsSqueezedByItsOwnRecipe()
    {
        TransferRun run(m_file);
        QVERIFY(run.begin());
        Recipe soft, hard;
        soft.seconds = hard.seconds = 0.5;
        soft.maxForce_N = 31;
        hard.maxForce_N = 47;
        run.session.setPartRecipes({{u"A"_s, soft}, {u"C"_s, hard}});
        for (int i = 0; i < 2; ++i) {
            const double limit = run.next() == u"A"_s ? 31 : 47;
            QVERIFY(run.squeeze());
            QCOMPARE(run.connection.gripper().admittedMaxForce_N, limit);
        }
    }
    void whatMovedIsDated()
    {
        InspectionRun run(m_file);
        QVERIFY(run.ready());
        constexpr int before = 8, after = 10;
        for (int i = 0; i < before + after; ++i) {
            const double gain = i < before ? 1 : 1.15;
            for (const auto& [name, part] : {std::pair(u"A"_s, canA), std::pair(u"C"_s, canC)}) {
                run.inspection.setExpectedType(name);
                Recording recording = scatteredSqueezeOf(part, 400 + std::uint64_t(i));
                for (double& force : recording.force)
                    force *= gain;
                recording.provenance[u"serial"_s] = i % 2 == 0 ? u"F-1"_s : u"F-7"_s;
                QVERIFY(run.inspection.judgeRecording(recording, u"file"_s) && run.ready());
            }
        }
        const DriftMaterial material =
            run.library.run<DriftMaterial>([](Library& kept) { return readDriftMaterial(kept, {400}); })
                .get()
                .value();
        DriftOptions options;
        options.recent = after;
        const DriftLook look = lookForDrift(material, options).value();
        QVERIFY2(look.report.cause == DriftCause::Sensor || look.report.cause == DriftCause::Gripper,
                 qPrintable(toString(look.report.cause)));
        QVERIFY(look.change);
        QVERIFY(look.change->earliest <= 2 * before && 2 * before <= look.change->latest);
        QVERIFY(std::abs(look.change->before - 2 * before) <= 2);
        QVERIFY(std::abs(look.change->shift(2) - std::log(1.15)) <
                4 * std::sqrt(look.change->covariance(2, 2)));
        QVERIFY(described(look.since).join(u' ').contains(u"Since inspection 1"_s));
        QCOMPARE(look.inspected.grippers, (QStringList{u"F-1"_s, u"F-7"_s}));
        QCOMPARE(look.inspected.stations.size(), 1);
        const auto ofOne = run.library
                               .run<DriftMaterial>([](Library& kept) {
                                   return readDriftMaterial(kept, {10, false, u"F-7"_s, {}});
                               })
                               .get()
                               .value();
        QCOMPARE(ofOne.inspected.squeezes.size(), std::size_t(6)); // of the newest ten
        QCOMPARE(ofOne.inspected.origins.back().gripperSerial, u"F-7"_s);
        QVERIFY(!lookForDrift({}, {}).value().change); // nothing there
    }
};

GRIPSCOPE_TEST(TransferWatchTest)
#include "transfer_watch_test.moc"
