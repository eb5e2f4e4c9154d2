// SPDX-License-Identifier: GPL-3.0-or-later
// Which design a table is, and tables that a study can only partly answer or not at all.
#include "tests/core/quality/gauge_tables.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

constexpr std::array<double, 6> usualDeviations{2, 0.5, 0.3, 0.2, 0.1, 0.3};

QString allMessages(const GaugeStudy& study)
{
    return english(study.values.front().messages).join(u'\n');
}

} // namespace

class GaugeLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void labelsTellTheDesign()
    {
        std::vector<GaugeRow> rows = drawnCrossedRows(4, 3, 0, 2, usualDeviations, 1);
        QVERIFY(gaugeLayout(factorsOf(rows))->design == GaugeDesign::Crossed);
        // Labels that repeat: whichever factor has fewer is numbered anew inside the other.
        QVERIFY(gaugeLayout(factorsOf(rows), GaugeDesign::Nested)->operatorsInParts);
        QVERIFY(!gaugeLayout(factorsOf(rows), GaugeDesign::Nested, NestedInside::Parts)->operatorsInParts);
        for (GaugeRow& row : rows)
            row.part += 10 * row.operators; // parts of their own
        const auto own = gaugeLayout(factorsOf(rows));
        QVERIFY(own->design == GaugeDesign::Nested && !own->operatorsInParts && own->balanced);
        QCOMPARE(own->terms.front().cells, 12);
        for (GaugeRow& row : rows)
            std::swap(row.part, row.operators); // runs of their own
        const auto runs = gaugeLayout(factorsOf(rows));
        QVERIFY(runs->design == GaugeDesign::Nested && runs->operatorsInParts);
        QVERIFY(!gaugeLayout(factorsOf(rows), GaugeDesign::Crossed) ||
                gaugeLayout(factorsOf(rows), GaugeDesign::Crossed)->design == GaugeDesign::Crossed);
    }
    /// One operator of three measured part 0: crossed still, as the others are shared.
    void aMissingCellLeavesItCrossed()
    {
        std::vector<GaugeRow> rows = drawnCrossedRows(5, 3, 0, 2, usualDeviations, 1);
        std::erase_if(rows, [](const GaugeRow& row) { return row.part == 0 && row.operators > 0; });
        const GaugeStudy study = studyGauge(measurementsOf(rows)).value();
        QVERIFY(study.design == GaugeDesign::Crossed && !study.balanced);
        QVERIFY(study.method == GaugeMethod::Reml);
        QVERIFY2(allMessages(study).contains(u"2 of 15 combinations"_s), qPrintable(allMessages(study)));
    }
    void withoutReplicatesTheInteractionIsNotSeparable()
    {
        const std::vector<GaugeRow> rows = drawnCrossedRows(8, 3, 0, 1, usualDeviations, 2);
        const GaugeStudy study = studyGauge(measurementsOf(rows)).value();
        const GaugeValue& value = study.values.front();
        QVERIFY(value.find(GaugeComponent::PartOperator) == nullptr);
        QCOMPARE(value.table.back().degreesOfFreedom, 14.0);
        QVERIFY(allMessages(study).contains(u"cannot be told from repeatability"_s));
        // With some cells missing too.
        const auto thin = studyGauge(measurementsOf(thinned(rows, 0.2, 3)));
        QVERIFY(thin && thin->method == GaugeMethod::Reml);
        QVERIFY(thin->values.front().find(GaugeComponent::PartOperator) == nullptr);
    }
    void whatOthersDetermineIsLeftOut()
    {
        std::vector<GaugeRow> rows = drawnCrossedRows(6, 3, 0, 2, usualDeviations, 2);
        for (GaugeRow& row : rows)
            row.station = row.operators; // each operator at a station of their own
        const GaugeStudy study = studyGauge(measurementsOf(rows)).value();
        QVERIFY(study.values.front().find(GaugeComponent::Station) == nullptr);
        QVERIFY(allMessages(study).contains(u"determine them"_s));
        for (GaugeRow& row : rows)
            row.station = 0;
        QVERIFY(allMessages(*studyGauge(measurementsOf(rows))).contains(u"one station only"_s));
        for (GaugeRow& row : rows)
            row.operators = 0;
        QVERIFY(allMessages(*studyGauge(measurementsOf(rows))).contains(u"one operator only"_s));
    }
    void expandedTablesHaveStations()
    {
        const std::vector<GaugeRow> rows = drawnCrossedRows(10, 3, 4, 2, {2, 0.5, 1.5, 0.2, 0.1, 0.3}, 6);
        const GaugeStudy study = studyGauge(measurementsOf(rows)).value();
        const GaugeValue& value = study.values.front();
        QVERIFY(value.find(GaugeComponent::Station) != nullptr && value.find(GaugeComponent::PartStation));
        double sum = 0;
        for (const GaugeComponent one : {GaugeComponent::Operator, GaugeComponent::PartOperator,
                                         GaugeComponent::Station, GaugeComponent::PartStation})
            sum += value.find(one)->taken;
        QVERIFY(isRelativelyNear(value.find(GaugeComponent::Reproducibility)->taken, sum, 1e-12));
        QVERIFY(allMessages(study).contains(u"Stations matter"_s));
    }
    void equalRepeatsAreSaidAndNoNumberIsLost()
    {
        for (const double share : {0.0, 0.3}) {
            std::vector<GaugeRow> rows =
                thinned(drawnCrossedRows(6, 3, 0, 2, {2, 0.5, 0, 0, 0, 0}, 2), share, 4);
            const GaugeStudy study = studyGauge(measurementsOf(rows)).value();
            for (const VarianceComponent& one : study.values.front().components)
                QVERIFY(std::isfinite(one.estimate) && std::isfinite(one.percentStudyVariation) &&
                        std::isfinite(one.interval.lower));
            QCOMPARE(study.values.front().find(GaugeComponent::Repeatability)->taken, 0.0);
        }
    }
    void badTablesAreRefused_data()
    {
        QTest::addColumn<int>("parts");
        QTest::addColumn<int>("operators");
        QTest::addColumn<int>("trials");
        QTest::addColumn<double>("deviation");
        QTest::addColumn<QString>("words");
        QTest::newRow("one part") << 1 << 3 << 3 << 1.0 << u"one part only"_s;
        QTest::newRow("nothing twice") << 8 << 1 << 1 << 1.0 << u"measured once"_s;
        QTest::newRow("all equal") << 5 << 3 << 2 << 0.0 << u"equal"_s;
        QTest::newRow("too large") << 5 << 3 << 2 << 1e160 << u"1e150"_s;
        QTest::newRow("too small") << 5 << 3 << 2 << 1e-160 << u"1e-150"_s;
    }
    void badTablesAreRefused()
    {
        QFETCH(int, parts);
        QFETCH(int, operators);
        QFETCH(int, trials);
        QFETCH(double, deviation);
        QFETCH(QString, words);
        const std::vector<GaugeRow> rows =
            drawnCrossedRows(parts, operators, 0, trials, {deviation, 0, 0, 0, 0, deviation}, 1);
        const auto study = studyGauge(measurementsOf(rows));
        QVERIFY(!study && study.error().code == ErrorCode::BadInput);
        QVERIFY2(study.error().describe().contains(words), qPrintable(study.error().describe()));
    }
    void designsThatCannotBeAreRefused()
    {
        std::vector<GaugeRow> rows = drawnCrossedRows(4, 3, 0, 2, usualDeviations, 1);
        for (GaugeRow& row : rows)
            row.part += 10 * row.operators;
        GaugeOptions options;
        options.design = GaugeDesign::Crossed;
        const auto crossed = studyGauge(measurementsOf(rows), options);
        QVERIFY(!crossed && crossed.error().describe().contains(u"two operators"_s));
        for (GaugeRow& row : rows)
            row.part = row.operators; // one to one
        QVERIFY(!studyGauge(measurementsOf(rows)));
    }
    void hugeUnbalancedTablesAreRefusedInTime()
    {
        std::vector<GaugeRow> rows = drawnCrossedRows(1100, 1, 0, 2, usualDeviations, 1);
        rows.pop_back();
        const auto study = studyGauge(measurementsOf(rows));
        QVERIFY(!study && study.error().describe().contains(u"at most 1000"_s));
    }
};

GRIPSCOPE_TEST(GaugeLayoutTest)
#include "gauge_layout_test.moc"
