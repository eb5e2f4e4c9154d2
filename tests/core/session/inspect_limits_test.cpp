// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/history.h"
#include "core/quality/conformity/conformity_json.h"
#include "core/recognition/verdict/conformity_of_squeeze.h"
#include "tests/core/session/inspection_run.h"
#include "tests/support/test_registry.h"

#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using D = ConformityDecision;

namespace {

PartLimits kBetween(double lower, double upper)
{
    PartLimits limits;
    limits.quantities[2] = ToleranceLimits{lower, upper};
    return limits;
}

} // namespace

/// A part of a type with limits, squeezed by the gripper, judged by the squeeze's own uncertainty and kept.
class InspectLimitsTest : public QObject {
    Q_OBJECT
private:
    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_file;

    /// Squeezes the part A (k 9990) once, held to these limits.
    void squeezed(InspectionRun& run, const PartLimits& limits)
    {
        const auto set = run.library
                             .run<TypeRecord>([limits](Library& library) -> Expected<TypeRecord> {
                                 ASSIGN_OR_RETURN(const auto type, library.findType(u"A"_s));
                                 return library.setTypeLimits(type->id, limits, {u"Ada"_s, u"drawing"_s});
                             })
                             .get();
        QVERIFY(set);
        run.inspection.setExpectedType(u"A"_s);
        run.inspection.reload();
        QVERIFY(run.connection.open());
        QVERIFY(run.ready());
        QVERIFY(run.inspection.squeeze());
        QVERIFY(run.ready());
        QVERIFY(run.inspection.result());
        QVERIFY(limits.isEmpty() || !run.inspection.result()->earlyEnd); // it takes the whole squeeze
        QVERIFY(run.inspection.result()->verdict.kind == VerdictKind::Type);
    }
    static HistoryEntry stored(InspectionRun& run)
    {
        return *run.library
                    .run<HistoryEntry>([](Library& library) -> Expected<HistoryEntry> {
                        ASSIGN_OR_RETURN(const auto keys,
                                         library.historyKeys({.kind = SqueezeKind::Inspection}));
                        ASSIGN_OR_RETURN(const auto entries, library.historyEntries(keys.part(0, 1)));
                        return entries.at(0);
                    })
                    .get();
    }

private slots:
    void initTestCase()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        enrolTypes(m_folder->filePath(u"enrolled.db"_s), {{u"A"_s, canA}, {u"C"_s, canC}}, 5);
    }
    void init()
    {
        static int run = 0;
        m_file = m_folder->filePath(u"run-%1.db"_s.arg(++run));
        QVERIFY(QFile::copy(m_folder->filePath(u"enrolled.db"_s), m_file));
    }
    void aPartIsHeldToTheLimitsOfItsType_data()
    {
        QTest::addColumn<double>("lower");
        QTest::addColumn<double>("upper");
        QTest::addColumn<int>("decision");
        QTest::addColumn<int>("outcome");
        using O = InspectionOutcome;
        QTest::newRow("within") << 9000. << 11000. << int(D::Conforms) << int(O::AsExpected);
        QTest::newRow("beyond") << 5000. << 9000. << int(D::DoesNotConform) << int(O::DoesNotConform);
        // Narrower than any squeeze can tell: the guard bands meet.
        QTest::newRow("too near") << 9989.999 << 9990.001 << int(D::TooNearTheLimit) << int(O::Inconclusive);
    }
    void aPartIsHeldToTheLimitsOfItsType()
    {
        QFETCH(double, lower);
        QFETCH(double, upper);
        QFETCH(int, decision);
        QFETCH(int, outcome);
        InspectionRun run(m_file);
        squeezed(run, kBetween(lower, upper));
        const InspectSession::Result& result = *run.inspection.result();
        QVERIFY(result.verdict.conformity);
        const Conformity& conformity = *result.verdict.conformity;
        // A value this near may by chance be proven to be beyond so narrow limits only with a far smaller u.
        QCOMPARE(int(conformity.decision), decision);
        QCOMPARE(int(result.outcome), outcome);
        const QuantityConformity& k = *conformity.quantities[2];
        QCOMPARE(*k.standardUncertainty, result.identification.budget.combined[2].standardUncertainty);
        QVERIFY(*k.guard > 1.644 * *k.standardUncertainty);
        const HistoryEntry entry = stored(run);
        QVERIFY(entry.conformityValues == conformity);
        QCOMPARE(int(*entry.outcome()), outcome);
        const InspectionCounts counts = run.inspection.counts();
        QCOMPARE(counts.doesNotConform, outcome == int(InspectionOutcome::DoesNotConform) ? 1 : 0);
        QCOMPARE(counts.inconclusive, outcome == int(InspectionOutcome::Inconclusive) ? 1 : 0);
        QCOMPARE(counts.asExpected, outcome == int(InspectionOutcome::AsExpected) ? 1 : 0);
    }
    void withoutLimitsNothingIsSaid()
    {
        InspectionRun run(m_file);
        squeezed(run, {});
        QVERIFY(!run.inspection.result()->verdict.conformity);
        QVERIFY(run.inspection.result()->outcome == InspectionOutcome::AsExpected);
        QVERIFY(!stored(run).conformity);
    }
    void aRecordInMillimetresIsHeldToLimitsInMetres()
    {
        Recording recording = scatteredSqueezeOf(canA, 1);
        const MeasuredValues inMetres = measuredValues(identify(recording));
        recording.positionUnit = u"mm"_s;
        for (double& x : recording.position)
            x *= 1000;
        const MeasuredValues inMillimetres = measuredValues(identify(recording), 1000);
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(std::abs(inMillimetres[i]->value / inMetres[i]->value - 1) < 1e-6);
            QVERIFY(std::abs(*inMillimetres[i]->standardUncertainty / *inMetres[i]->standardUncertainty - 1) <
                    1e-3);
        }
        const auto decided = conformityOf(kBetween(9000, 11000), identify(recording), 1000, 1.0);
        QVERIFY(decided->decision == D::Conforms);
    }
    void whatIsNotDeterminedIsNotDecided()
    {
        const Identification nothing = identify(constantForce());
        const auto decided = conformityOf(kBetween(9000, 11000), nothing, 1, 1.0);
        QVERIFY(decided->decision == D::NotDecidable);
        QVERIFY(!conformityOf({}, nothing, 1, 1.0));
    }
};

GRIPSCOPE_TEST(InspectLimitsTest)
#include "inspect_limits_test.moc"
