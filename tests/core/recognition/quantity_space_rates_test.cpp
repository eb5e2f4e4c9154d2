// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel_runs.h"
#include "core/research/recognition_study.h"
#include "tests/core/recognition/space_types.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

constexpr double statedRate = 0.01;

void everySpaceAndNumber()
{
    QTest::addColumn<int>("p");
    QTest::addColumn<int>("squeezes");
    for (const int p : {1, 2, 3, 5, 6})
        for (const int squeezes : {5, 10})
            QTest::addRow("p = %d, %d squeezes", p, squeezes) << p << squeezes;
}

/// 400 enrolments of four types of m, b and k, 200 of others; three rates of 1 %.
ClusteredShare shareIn(ScenarioKind kind, int p, int squeezes, const QString& name)
{
    RecognitionScenario scenario;
    scenario.kind = kind;
    scenario.squeezes = squeezes;
    scenario.space = spaceOfDimensions(p);
    scenario.options.siUnits = false;
    scenario.options.falseReject = scenario.options.wrongType = scenario.options.strangerAccept = statedRate;
    std::vector<EnrolmentTally> tallies;
    for (int run = 0; run < (p == 3 ? 400 : 200); ++run)
        tallies.push_back(
            runScenario(scenario, runSeed(1, scenario.name(), static_cast<std::uint64_t>(run))));
    return pooled(tallies).shares[name];
}

/// The test says something only where the rate itself is known well enough.
double largestError(int p)
{
    return p == 3 ? 0.0025 : 0.0036;
}

QString text(const ClusteredShare& share)
{
    return u"%1 +- %2"_s.arg(share.share).arg(share.standardError);
}

} // namespace

class QuantitySpaceRatesTest : public QObject {
    Q_OBJECT
private slots:
    void squeezesAreRefusedAtTheStatedRate_data() { everySpaceAndNumber(); }
    void squeezesAreRefusedAtTheStatedRate()
    {
        QFETCH(int, p);
        QFETCH(int, squeezes);
        // Of m, b and k 400 of 40,000; binomial it would be +- 20, clustered by enrolment it is up to six
        // times that. Four standard errors, which a right statedRate exceeds once in 16,000 times.
        const ClusteredShare unknown = shareIn(ScenarioKind::KnownParts, p, squeezes, u"unknown"_s);
        QVERIFY2(std::abs(unknown.share - statedRate) < 4 * unknown.standardError, qPrintable(text(unknown)));
        QVERIFY2(unknown.standardError < largestError(p), qPrintable(text(unknown)));
    }
    void neighboursAreMistakenAtMostAtTheStatedRate_data() { everySpaceAndNumber(); }
    void neighboursAreMistakenAtMostAtTheStatedRate()
    {
        QFETCH(int, p);
        QFETCH(int, squeezes);
        // As the study holds it, 1.2 times, and three standard errors.
        const ClusteredShare wrong = shareIn(ScenarioKind::Neighbours, p, squeezes, u"wrong_type"_s);
        QVERIFY2(wrong.share < 1.2 * statedRate + 3 * wrong.standardError, qPrintable(text(wrong)));
        QVERIFY2(wrong.standardError < largestError(p), qPrintable(text(wrong)));
    }
    void strangersAreAcceptedAtMostAtTheStatedRate_data() { everySpaceAndNumber(); }
    void strangersAreAcceptedAtMostAtTheStatedRate()
    {
        QFETCH(int, p);
        QFETCH(int, squeezes);
        const ClusteredShare accepted = shareIn(ScenarioKind::StrangersInRange, p, squeezes, u"accepted"_s);
        QVERIFY2(accepted.share < statedRate + 4 * accepted.standardError, qPrintable(text(accepted)));
        QVERIFY2(accepted.share > 0.8 * statedRate - 4 * accepted.standardError, qPrintable(text(accepted)));
    }
    void gatesWithConfidenceKeepTheirPromise_data()
    {
        QTest::addColumn<int>("p");
        for (const int p : {1, 5})
            QTest::addRow("p = %d", p) << p;
    }
    void gatesWithConfidenceKeepTheirPromise()
    {
        QFETCH(int, p);
        RecognitionScenario scenario;
        scenario.kind = ScenarioKind::Promise;
        scenario.space = spaceOfDimensions(p);
        scenario.options.siUnits = false;
        scenario.options.confidence = 0.95;
        std::vector<EnrolmentTally> tallies;
        for (int run = 0; run < 200; ++run)
            tallies.push_back(
                runScenario(scenario, runSeed(1, scenario.name(), static_cast<std::uint64_t>(run))));
        // 190 of 200 +- 3.1 (binomial); 4 sd. It may be kept more often, where scatter is alike or shrunk.
        QVERIFY(pooled(tallies).shares[u"kept"_s].count >= 178);
    }
};

GRIPSCOPE_TEST(QuantitySpaceRatesTest)
#include "quantity_space_rates_test.moc"
