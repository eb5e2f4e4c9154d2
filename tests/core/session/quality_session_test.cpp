// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/quality/study_session.h"
#include "tests/core/session/session_driver.h"
#include "tests/core/session/study_samples.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

#include <QTemporaryDir>
#include <QTest>
#include <QThreadPool>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using QualityStep = StudySession::State;

namespace {

StudyRequest smallStudy()
{
    StudyRequest request;
    request.name = u"Cans"_s;
    request.design = crossedDesign(2, {u"Ada"_s, u"Bo"_s}, 2);
    request.recipe.seconds = 0.5;
    return request;
}

/// One program run: a library on the disk, a gripper, a study.
struct StudyRun {
    explicit StudyRun(const QString& file) : library(file), session(connection.session, library)
    {
        IdentificationOptions quick;
        quick.assess = false;
        session.setIdentificationOptions(quick);
        session.setOperator(u"Lea"_s);
    }
    ArmedConnection connection;
    LibraryService library;
    StudySession session;

    bool settle()
    {
        return pollUntil(
            [this] {
                connection.session.poll();
                session.poll();
            },
            [this] { return !session.busy(); });
    }
    /// Begins or goes on, armed.
    bool begin(const StudyRequest& request = smallStudy())
    {
        return connection.open() && session.begin(request) && settle() &&
               session.state() == QualityStep::Waiting;
    }
    bool squeeze() { return session.squeeze() && settle(); }
    bool hasResult()
    {
        return pollUntil([this] { session.poll(); }, [this] { return session.result().has_value(); });
    }
    std::vector<StudyRecord> unfinished()
    {
        return library.run<std::vector<StudyRecord>>([](Library& kept) { return kept.unfinishedStudies(); })
            .get()
            .value();
    }
};

} // namespace

class QualitySessionTest : public QObject {
    Q_OBJECT
private slots:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }
    void aStudyIsLedFromTheFirstSqueezeToItsResult()
    {
        StudyRun run(file());
        QVERIFY(run.begin());
        QCOMPARE(run.session.progress().left(), std::size_t(8));
        for (int i = 0; i < 8; ++i) {
            const std::size_t row = *run.session.nextRow();
            QCOMPARE(row, std::size_t(i));
            QVERIFY(run.session.instruction().describe().contains(u"part "_s +
                                                                  run.session.study()->plan.part(row)));
            const bool second = run.session.study()->plan.rows[row].part == 1;
            run.connection.gripper().object =
                second ? MassDampingStiffness{0.03, 37, 3562} : MassDampingStiffness{0.0396, 43, 9990};
            QVERIFY(run.squeeze());
            QVERIFY2(!run.session.lastError() && run.session.refusal().empty(),
                     qPrintable(described(run.session.refusal()).join(u' ')));
        }
        QVERIFY(!run.session.nextRow() && run.session.instruction().isEmpty());
        QVERIFY(!run.session.squeeze());
        QVERIFY(run.session.shownMeasurements().empty()); // blind
        QVERIFY(run.session.finish() && run.settle());
        QCOMPARE(run.session.state(), QualityStep::Ended);
        QVERIFY(run.hasResult());
        QVERIFY2(*run.session.result(), qPrintable(whyNot(*run.session.result())));
        const StudyResult& result = **run.session.result();
        const std::vector<QuantitySummary>& quantities = result.gauge()->quantities;
        QCOMPARE(quantities.size(), std::size_t(3));
        QVERIFY(std::abs(quantities[2].parts[0].mean - 9990) < 20);
        QVERIFY(std::abs(quantities[2].parts[1].mean - 3562) < 10);
        QVERIFY(*result.gauge()->study.values[2].distinctCategories > 100);
        QCOMPARE(run.session.shownMeasurements().size(), std::size_t(8));
        const StudyMeasurementRecord first = run.session.shownMeasurements().front();
        QCOMPARE(first.measured.operatorName, u"Ada"_s); // the plan's, not who leads
        QCOMPARE(first.measured.units[2], u"N/m"_s);
        QVERIFY(first.measured.values[2]->standardUncertainty > 0);
        const auto recording = run.library.run<DraftSqueeze>(
            [id = first.squeezeId](Library& kept) { return kept.draftSqueeze(id); });
        QVERIFY(Pending(recording).get()->recording.force.size() > 900);
    }
    void whatIsStoredIsGoneOnWithAfterACrash()
    {
        QString id;
        {
            StudyRun run(file());
            QVERIFY(run.begin());
            QVERIFY(run.squeeze() && run.squeeze() && run.squeeze());
            id = run.session.study()->record.id;
            QVERIFY(run.session.squeeze()); // under way when the program ends
        }
        StudyRun run(file());
        QVERIFY(run.connection.open());
        QCOMPARE(run.unfinished().size(), std::size_t(1));
        QCOMPARE(run.unfinished()[0].measurements, 3);
        QVERIFY(run.session.resume(run.unfinished()[0].id) && run.settle());
        QCOMPARE(run.session.study()->record.id, id);
        QCOMPARE(*run.session.nextRow(), std::size_t(3));
        QVERIFY(run.session.study()->plan == makePlan(smallStudy().design).value());
        QVERIFY(run.squeeze());
        QCOMPARE(*run.session.nextRow(), std::size_t(4));
    }
    void anInvalidSqueezeIsToldKeptAndRepeated()
    {
        StudyRun run(file());
        QVERIFY(run.begin());
        run.connection.gripper().moves = [](const std::vector<double>& force) {
            return std::vector<double>(force.size(), 0.002); // nothing in the jaws moves
        };
        run.connection.gripper().noise_m = 0;
        QVERIFY(run.squeeze());
        QVERIFY(!run.session.refusal().empty());
        QCOMPARE(*run.session.nextRow(), std::size_t(0));
        QVERIFY(run.session.progress().rows[0] == RowState::Repeat);
        QCOMPARE(run.session.study()->measurements.size(), std::size_t(1));
        QVERIFY(!run.session.study()->measurements[0].squeezeId.isEmpty());
        run.connection.gripper().moves = nullptr;
        run.connection.gripper().noise_m = 1e-6;
        QVERIFY(run.squeeze());
        QVERIFY(run.session.refusal().empty());
        QCOMPARE(*run.session.nextRow(), std::size_t(1));
        QCOMPARE(run.session.progress().repeated, std::size_t(1));
    }
    void whatWasMeasuredOrLeftOutCanBeTakenBack()
    {
        StudyRun run(file());
        QVERIFY(run.begin());
        QVERIFY(!run.session.undo());
        QVERIFY(run.squeeze());
        QVERIFY(run.session.skip(u"the part broke"_s) && run.settle());
        QCOMPARE(*run.session.nextRow(), std::size_t(2));
        QVERIFY(run.session.undo() && run.settle());
        QCOMPARE(*run.session.nextRow(), std::size_t(1));
        QVERIFY(run.session.undo(u"the wrong part"_s) && run.settle());
        QCOMPARE(*run.session.nextRow(), std::size_t(0));
        QCOMPARE(run.session.study()->measurements.size(), std::size_t(2)); // both are on record
        QVERIFY(!run.session.undo());
    }
    void aStudyEndsEarlyWithAReasonOnly()
    {
        StudyRun run(file());
        QVERIFY(run.begin());
        for (int i = 0; i < 3; ++i)
            QVERIFY(run.squeeze());
        QVERIFY(!run.session.finish());
        QVERIFY(!run.session.begin(smallStudy())); // one at a time
        QVERIFY(run.session.abandon(u"no time"_s) && run.settle());
        QCOMPARE(run.session.state(), QualityStep::Ended);
        QVERIFY(run.unfinished().empty());
        QVERIFY(run.session.begin(smallStudy()) && run.settle());
        QVERIFY(run.squeeze());
        QVERIFY(run.session.finish(u"a fire"_s) && run.settle());
        QVERIFY(run.hasResult());
        QVERIFY(!*run.session.result()); // one squeeze is no study
    }
    void theResultOfTheStudyBeforeIsNotTheNextOnes()
    {
        StudyRun run(file());
        QVERIFY(run.begin());
        QVERIFY(run.squeeze());
        QVERIFY(run.session.finish(u"a fire"_s) && run.settle());
        if (run.session.result()) // it was quick
            QVERIFY(run.session.study()->record.ended);
        QVERIFY(run.session.begin(smallStudy()) && run.settle());
        QThreadPool::globalInstance()->waitForDone();
        run.session.poll();
        QVERIFY(!run.session.result());
        QCOMPARE(run.session.state(), QualityStep::Waiting);
    }
    void nothingMovesButThroughTheGate()
    {
        StudyRun run(file());
        QVERIFY(run.connection.open(false));
        QVERIFY(run.session.begin(smallStudy()) && run.settle());
        QVERIFY(!run.session.squeeze()); // not armed
        QCOMPARE(run.connection.gripper().started, 0);
        QCOMPARE(run.session.state(), QualityStep::Waiting);
    }
    void aSqueezeThatIsStoppedIsNoMeasurement()
    {
        StudyRun run(file());
        QVERIFY(run.begin());
        QVERIFY(run.session.squeeze());
        run.session.cancel();
        QVERIFY(run.connection.gripper().stops > 0);
        QCOMPARE(run.session.lastError()->code, ErrorCode::Cancelled);
        QVERIFY(run.session.study()->measurements.empty());
        QCOMPARE(run.session.state(), QualityStep::Waiting);
    }
    void anotherGripperIsAnotherStudy()
    {
        StudyRun run(file());
        QVERIFY(run.begin());
        const QString id = run.session.study()->record.id;
        StudyRun other(file());
        other.connection.gripper().identity.serial = u"F-2"_s;
        QVERIFY(other.connection.open());
        QVERIFY(other.session.resume(id) && other.settle());
        const auto refused = other.session.squeeze();
        QVERIFY(!refused && refused.error().describe().contains(u"F-1"_s));
    }
    void ratersNeedNoGripper()
    {
        StudyRun run(file());
        StudyRequest request = smallStudy();
        request.design.kind = StudyKind::Attributes;
        QVERIFY(run.begin(request));
        QVERIFY(!run.session.rate(u" "_s));
        QVERIFY(run.session.rate(u"good"_s) && run.settle());
        QCOMPARE(run.session.study()->measurements[0].measured.rating, u"good"_s);
        QCOMPARE(*run.session.nextRow(), std::size_t(1));
        while (run.session.nextRow())
            QVERIFY(run.session.rate(u"good"_s) && run.settle());
        QVERIFY(run.session.finish() && run.settle() && run.hasResult());
        QVERIFY(*run.session.result() && (*run.session.result())->as<AttributeAgreement>());
        StudyRun another(file());
        QVERIFY(!another.session.rate(u"good"_s)); // no study
    }
    void aStudyThatIsNotThereIsAnError()
    {
        StudyRun run(file());
        QVERIFY(run.session.resume(u"none"_s) && run.settle());
        QCOMPARE(run.session.lastError()->code, ErrorCode::NotFound);
        QCOMPARE(run.session.state(), QualityStep::Idle);
    }

private:
    QString file() const { return m_folder->filePath(u"library.db"_s); }
    std::unique_ptr<QTemporaryDir> m_folder;
};
GRIPSCOPE_TEST(QualitySessionTest)
#include "quality_session_test.moc"
