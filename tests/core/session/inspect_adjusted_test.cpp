// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/gripper_adjustment.h"
#include "core/library/records/measuring_chain_record.h"
#include "core/session/inspect/squeeze_judged.h"
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

constexpr double adjustedGain = 1.2; ///< of the second gripper's force sensor

NewAdjustment adjustmentBy(double gain, double uncertainty = 0.005)
{
    NewAdjustment adjustment;
    adjustment.gripperSerial = u"F-2"_s;
    adjustment.error.value = Eigen::Vector3d::Constant(std::log(gain));
    adjustment.error.covariance = Eigen::Matrix3d::Identity() * uncertainty * uncertainty;
    adjustment.error.degreesOfFreedom = 20;
    adjustment.reason = u"second line"_s;
    return adjustment;
}

template <typename T>
T answerOf(InspectionRun& run, std::function<Expected<T>(Library&)> work)
{
    Expected<T> answer = run.library.run<T>(std::move(work)).get();
    if (!answer)
        qFatal("%s", qPrintable(answer.error().describe()));
    if constexpr (!std::is_void_v<T>)
        return std::move(*answer);
}

} // namespace

/// Inspections on a gripper whose force sensor says a fifth too much, of types that were enrolled on another.
class InspectAdjustedTest : public QObject {
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;

    /// A run on that gripper, its types read.
    static void begin(InspectionRun& run)
    {
        run.connection.gripper().identity.serial = u"F-2"_s;
        run.connection.gripper().forceGain = adjustedGain;
        run.inspection.setExpectedType(u"A"_s);
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
    }
    static void squeeze(InspectionRun& run)
    {
        QVERIFY(run.inspection.squeeze());
        QVERIFY(run.ready());
        QVERIFY(run.inspection.result());
        QVERIFY2(!run.inspection.lastError(), qPrintable(whyNot(run.inspection.lastError())));
    }
    static QString accept(InspectionRun& run, const NewAdjustment& adjustment)
    {
        const AdjustmentRecord record = answerOf<AdjustmentRecord>(
            run, [adjustment](Library& library) { return library.acceptAdjustment(adjustment); });
        run.inspection.reload();
        return run.ready() ? record.id : QString();
    }

private slots:
    void initTestCase()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        enrolTypes(m_folder->filePath(u"enrolled.db"_s), {{u"A"_s, canA}, {u"C"_s, canC}}, 6);
    }
    void init()
    {
        static int run = 0;
        m_file = m_folder->filePath(u"run-%1.db"_s.arg(++run));
        QVERIFY(QFile::copy(m_folder->filePath(u"enrolled.db"_s), m_file));
    }
    void wrongBeforeRightAfterAndAfterARestart()
    {
        {
            InspectionRun run(m_file);
            begin(run);
            squeeze(run);
            QVERIFY(run.inspection.result()->verdict.kind != VerdictKind::Type);
            QVERIFY(!run.inspection.adjustment());
            const QString id = accept(run, adjustmentBy(adjustedGain));
            QVERIFY(run.inspection.adjustment() && run.inspection.adjustment()->record.id == id);
            squeeze(run);
            QVERIFY(run.inspection.result()->verdict.kind == VerdictKind::Type);
            QCOMPARE(run.inspection.result()->verdict.type, u"A"_s);
            QVERIFY(!run.inspection.result()->earlyEnd);
            QCOMPARE(run.inspection.result()->adjustmentId, id);
        }
        InspectionRun again(m_file);
        begin(again);
        squeeze(again);
        QCOMPARE(again.inspection.result()->verdict.type, u"A"_s);
        const auto records = answerOf<std::vector<InspectionRecord>>(
            again, [](Library& library) { return library.inspections({}); });
        QCOMPARE(records.size(), std::size_t(3));
        QVERIFY(records[2].adjustmentId.isEmpty() && !records[1].adjustmentId.isEmpty());
        QCOMPARE(records[0].adjustmentId, records[1].adjustmentId);
        // What was measured is kept as it was measured.
        QVERIFY(std::abs(records[0].parameters->k / (adjustedGain * canA.k) - 1) < 0.01);
    }
    void theDecisionOfTheSqueezeBeforeEndsNone()
    {
        InspectionRun run(m_file);
        begin(run);
        for (int i = 0; i < 10 && !(run.inspection.result() && run.inspection.result()->earlyEnd); ++i)
            squeeze(run);
        QVERIFY(!accept(run, adjustmentBy(adjustedGain)).isEmpty()); // the next is not to end early
        squeeze(run);
        QVERIFY(!run.inspection.result()->earlyEnd);
        QVERIFY(run.inspection.result()->seconds > 0.9 * run.inspection.nextRecipe().seconds);
    }
    void anotherGripperIsNotAdjusted()
    {
        InspectionRun run(m_file);
        begin(run);
        QVERIFY(!accept(run, adjustmentBy(adjustedGain)).isEmpty());
        // A recording of the first gripper beside it: as it is.
        Recording own = scatteredSqueezeOf(canA, 77);
        own.provenance[u"serial"_s] = u"F-1"_s;
        QVERIFY(run.inspection.judgeRecording(own, u"file"_s) && run.ready());
        QCOMPARE(run.inspection.result()->verdict.type, u"A"_s);
        QVERIFY(run.inspection.result()->adjustmentId.isEmpty());
        // Whoever states an adjustment, or that there is none, means all.
        run.inspection.setTransfer({});
        squeeze(run);
        QVERIFY(run.inspection.result()->verdict.kind != VerdictKind::Type);
        QVERIFY(run.inspection.result()->adjustmentId.isEmpty() && !run.inspection.adjustment());
        run.inspection.setTransferOfLibrary();
        squeeze(run);
        QCOMPARE(run.inspection.result()->verdict.type, u"A"_s);
    }
    void withdrawnItIsAsBefore()
    {
        InspectionRun run(m_file);
        begin(run);
        const QString id = accept(run, adjustmentBy(adjustedGain));
        answerOf<void>(run,
                       [id](Library& library) { return library.withdrawAdjustment(id, u"moved"_s, {}); });
        run.inspection.reload();
        QVERIFY(run.ready());
        squeeze(run);
        QVERIFY(run.inspection.result()->verdict.kind != VerdictKind::Type);
    }
    void valuesHeldToLimitsAreAdjusted_data()
    {
        QTest::addColumn<bool>("stated");
        QTest::newRow("of the library") << false;
        QTest::newRow("stated, as by --transfer") << true;
    }
    void valuesHeldToLimitsAreAdjusted()
    {
        QFETCH(bool, stated);
        InspectionRun run(m_file);
        answerOf<TypeRecord>(run, [](Library& library) -> Expected<TypeRecord> {
            ASSIGN_OR_RETURN(const auto type, library.findType(u"A"_s));
            PartLimits limits;
            limits.quantities[2] = ToleranceLimits{9000, 11000}; // as measured it is 11988
            return library.setTypeLimits(type->id, limits, {u"Ada"_s, u"drawing"_s});
        });
        run.inspection.reload();
        begin(run);
        const NewAdjustment adjustment = adjustmentBy(adjustedGain, 0.02);
        if (stated)
            run.inspection.setTransfer(adjustment.error);
        else
            QVERIFY(!accept(run, adjustment).isEmpty());
        squeeze(run);
        const auto& conformity = run.inspection.result()->verdict.conformity;
        QVERIFY(conformity && conformity->decision == ConformityDecision::Conforms);
        QVERIFY(std::abs(*conformity->quantities[2]->value / canA.k - 1) < 0.01);
        QVERIFY(*conformity->quantities[2]->standardUncertainty >= 0.0199 * canA.k); // that of the adjustment
        QVERIFY(run.inspection.result()->outcome == InspectionOutcome::AsExpected);
    }
    void theUncertaintyOfTheAdjustmentCounts()
    {
        // An adjustment that nobody knows better than to 30 % leaves A and C apart, yet says less surely
        // which.
        InspectionRun sure(m_file);
        QVERIFY(QFile::copy(m_folder->filePath(u"enrolled.db"_s), m_file + u"3"_s));
        begin(sure);
        QVERIFY(!accept(sure, adjustmentBy(adjustedGain, 0.005)).isEmpty());
        squeeze(sure);
        InspectionRun loose(m_file + u"3"_s);
        begin(loose);
        QVERIFY(!accept(loose, adjustmentBy(adjustedGain, 0.3)).isEmpty());
        squeeze(loose);
        QVERIFY(sure.inspection.result()->verdict.distance && loose.inspection.result()->verdict.distance);
        QVERIFY(*loose.inspection.result()->verdict.distance < *sure.inspection.result()->verdict.distance);
    }
    void anAdjustedGripperHasNotDrifted()
    {
        InspectionRun run(m_file);
        begin(run);
        QVERIFY(!accept(run, adjustmentBy(adjustedGain)).isEmpty());
        for (int i = 0; i < 4; ++i)
            squeeze(run);
        QVERIFY(run.until([&] {
            const auto& report = run.inspection.drift();
            return report && !report->types.empty() && report->types[0].squeezes == 4;
        }));
        QVERIFY(!run.inspection.drift()->moved.contains(u"A"_s));
        // Nor has it for whoever reads the library later.
        InspectionRun again(m_file);
        QVERIFY(again.ready());
        QVERIFY(again.until([&] {
            const auto& report = again.inspection.drift();
            return report && !report->types.empty() && report->types[0].squeezes == 4;
        }));
        QVERIFY(!again.inspection.drift()->moved.contains(u"A"_s));
    }
    void aCalibrationAfterItIsTold()
    {
        InspectionRun run(m_file);
        begin(run);
        QVERIFY(!accept(run, adjustmentBy(adjustedGain)).isEmpty());
        QVERIFY(adjustmentSignals(*run.inspection.adjustment()).empty());
        QTest::qWait(2); // later by the clock's milliseconds
        answerOf<void>(run, [](Library& library) {
            return library.addMeasuringChain({u"F-2"_s, 0, {}, u"Ada"_s, u"measured"_s});
        });
        run.inspection.reload();
        QVERIFY(run.ready());
        QVERIFY(!adjustmentSignals(*run.inspection.adjustment()).empty());
    }
    void whoReplaysASqueezeKnowsTheAdjustment()
    {
        SqueezeJudged judged;
        judged.transfer = adjustmentBy(adjustedGain).error;
        const auto read = squeezeJudged(toNote(judged));
        QVERIFY(read && read->transfer);
        QVERIFY(read->transfer->value == judged.transfer->value);
        QVERIFY(read->transfer->covariance == judged.transfer->covariance);
        QCOMPARE(read->transfer->degreesOfFreedom, 20.0);
        QVERIFY(!squeezeJudged(toNote(SqueezeJudged()))->transfer);
    }
};

GRIPSCOPE_TEST(InspectAdjustedTest)
#include "inspect_adjusted_test.moc"
