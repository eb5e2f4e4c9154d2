// SPDX-License-Identifier: GPL-3.0-or-later
// Analyses of variance whose sums of squares are certified (NIST, Statistical Reference Datasets) or by R,
// from tables as they are written.
#include "core/quality/gauge/gauge_study.h"
#include "core/quality/table/study_table.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <array>
#include <cmath>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

QByteArray groupsAsTable(const std::vector<const char*>& groups)
{
    QByteArray text = "part,value\n";
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (const QByteArray& value : QByteArray(groups[g]).split(' '))
            text += QByteArray::number(int(g)) + ',' + value + '\n';
    return text;
}

/// SmLs: nine treatments about `constant` + 0.4, eight of them off by 0.1, each value off by 0.1 in turn.
QByteArray simonLesageTable(const QByteArray& constant, int replicates)
{
    QByteArray text = "part,value\n";
    for (int treatment = 0; treatment < 9; ++treatment)
        for (int i = 0; i < replicates; ++i) {
            const int centre = treatment == 0 ? 4 : treatment % 2 == 1 ? 3 : 5;
            const int tenths = centre + (i == 0 ? 0 : i % 2 == 1 ? -1 : 1);
            text += QByteArray::number(treatment) + ',' + constant + '.' + QByteArray::number(tenths) + '\n';
        }
    return text;
}

GaugeStudy studyOf(const QByteArray& text, GaugeDesign design)
{
    const StudyTable table = StudyTable::parse(text, u"t.csv"_s).value();
    GaugeMeasurements measurements;
    measurements.factors.part = table.labels(u"part"_s).value();
    if (table.columns().contains(u"operator"_s))
        measurements.factors.operators = table.labels(u"operator"_s).value();
    measurements.factors.operatorsAre = OperatorsAre::Persons;
    measurements.names = QStringList{u"value"_s};
    const OffsetColumn column = table.offsets(u"value"_s).value();
    measurements.origins = Eigen::VectorXd::Constant(1, column.origin);
    measurements.values =
        Eigen::Map<const Eigen::VectorXd>(column.offsets.data(), Eigen::Index(column.offsets.size()));
    GaugeOptions options;
    options.design = design;
    options.pooling = false;
    return studyGauge(measurements, options).value();
}

bool isCertified(double found, double expected, double relative)
{
    return std::abs(found - expected) <= relative * std::abs(expected);
}

/// Parts 0 to 4, operators 0 to 2, twice each; R: anova(lm(v ~ p * o)).
QByteArray crossedByR()
{
    const QByteArray values =
        "14.7 14.5 17.3 17.0 16.9 16.9 17.8 17.0 16.4 16.6 18.1 17.2 21.2 22.4 21.1 21.5 "
        "22.9 23.5 11.6 11.0 13.3 12.8 13.9 14.2 19.3 19.3 19.3 19.9 22.0 21.4";
    QByteArray text = "part,operator,value\n";
    int i = 0;
    for (const QByteArray& value : values.split(' ')) {
        text += QByteArray::number(i / 6) + ',' + QByteArray::number(i / 2 % 3) + ',' + value + '\n';
        ++i;
    }
    return text;
}

/// Operators 0 to 2 with four parts of their own, called alike, twice each; R: anova(lm(v ~ o / p)), lmer().
QByteArray nestedByR()
{
    const QByteArray values =
        "51.3 50.3 49.4 48.6 49.0 48.9 48.2 50.8 49.1 48.7 51.0 51.8 52.4 52.8 47.8 48.7 "
        "48.7 48.5 48.1 51.1 49.9 49.7 43.9 44.0";
    QByteArray text = "part,operator,value\n";
    int i = 0;
    for (const QByteArray& value : values.split(' ')) {
        text += QByteArray::number(i / 2 % 4) + ',' + QByteArray::number(i / 8) + ',' + value + '\n';
        ++i;
    }
    return text;
}

} // namespace

class CertifiedVarianceTest : public QObject {
    Q_OBJECT
private slots:
    void sumsOfSquaresAreCertified_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<double>("between");
        QTest::addColumn<double>("within");
        QTest::addColumn<double>("f");
        QTest::newRow("AtmWtAg") << groupsAsTable({"107.8681568 107.8681465 107.8681572 107.8681785 "
                                                   "107.8681446 107.8681903 107.8681526 107.8681494 "
                                                   "107.8681616 107.8681587 107.8681519 107.8681486 "
                                                   "107.8681419 107.8681569 107.8681508 107.8681672 "
                                                   "107.8681385 107.8681518 107.8681662 107.8681424 "
                                                   "107.8681360 107.8681333 107.8681610 107.8681477",
                                                   "107.8681079 107.8681344 107.8681513 107.8681197 "
                                                   "107.8681604 107.8681385 107.8681642 107.8681365 "
                                                   "107.8681151 107.8681082 107.8681517 107.8681448 "
                                                   "107.8681198 107.8681482 107.8681334 107.8681609 "
                                                   "107.8681101 107.8681512 107.8681469 107.8681360 "
                                                   "107.8681254 107.8681261 107.8681450 107.8681368"})
                                 << 3.63834187500000e-09 << 1.04951729166667e-08 << 15.9467335677930;
        QTest::newRow("SiRstv") << groupsAsTable({"196.3052 196.1240 196.1890 196.2569 196.3403",
                                                  "196.3042 196.3825 196.1669 196.3257 196.0422",
                                                  "196.1303 196.2005 196.2889 196.0343 196.1811",
                                                  "196.2795 196.1748 196.1494 196.1485 195.9885",
                                                  "196.2119 196.1051 196.1850 196.0052 196.2090"})
                                << 5.11462616000000e-02 << 2.16636560000000e-01 << 1.18046237440255;
        const std::array<QByteArray, 3> constants{"1", "1000000", "1000000000000"};
        for (std::size_t c = 0; c < constants.size(); ++c) {
            QTest::addRow("SmLs, 21, %s", constants[c].constData())
                << simonLesageTable(constants[c], 21) << 1.68 << 1.80 << 21.0;
            QTest::addRow("SmLs, 201, %s", constants[c].constData())
                << simonLesageTable(constants[c], 201) << 16.08 << 18.0 << 201.0;
            QTest::addRow("SmLs, 2001, %s", constants[c].constData())
                << simonLesageTable(constants[c], 2001) << 160.08 << 180.0 << 2001.0;
        }
    }
    void sumsOfSquaresAreCertified()
    {
        QFETCH(QByteArray, text);
        QFETCH(double, between);
        QFETCH(double, within);
        QFETCH(double, f);
        const GaugeStudy study = studyOf(text, GaugeDesign::Auto);
        const std::vector<VarianceRow>& rows = study.values.front().table;
        QCOMPARE(rows.size(), std::size_t(2));
        QVERIFY2(isCertified(rows[0].sumOfSquares, between, 1e-12),
                 qPrintable(QString::number(rows[0].sumOfSquares, 'g', 17)));
        QVERIFY2(isCertified(rows[1].sumOfSquares, within, 1e-12),
                 qPrintable(QString::number(rows[1].sumOfSquares, 'g', 17)));
        QVERIFY(isCertified(*rows[0].f, f, 1e-12));
    }
    void theMeanIsThatOfTheTable()
    {
        const GaugeStudy study = studyOf(simonLesageTable("1000000", 21), GaugeDesign::Auto);
        QVERIFY(isCertified(study.values.front().mean, 1000000.4, 1e-15));
    }
    void aCrossedTableAsByR()
    {
        const GaugeStudy study = studyOf(crossedByR(), GaugeDesign::Auto);
        QVERIFY(study.design == GaugeDesign::Crossed && study.method == GaugeMethod::Anova);
        const GaugeValue& value = study.values.front();
        const std::array<double, 4> squares{312.52333333, 17.048, 10.78866667, 2.5}, degrees{4, 2, 8, 15};
        for (std::size_t i = 0; i < 4; ++i) {
            QVERIFY(isCertified(value.table[i].sumOfSquares, squares[i], 1e-9));
            QCOMPARE(value.table[i].degreesOfFreedom, degrees[i]);
        }
        QVERIFY(isCertified(*value.table[2].p, 0.00029707, 1e-4));
        const auto variance = [&](GaugeComponent component) { return value.find(component)->estimate; };
        QVERIFY(isCertified(variance(GaugeComponent::PartOperator), (1.34858333 - 0.16666667) / 2, 1e-7));
        QVERIFY(isCertified(variance(GaugeComponent::Operator), (8.524 - 1.34858333) / 10, 1e-7));
        QVERIFY(isCertified(variance(GaugeComponent::Part), (78.13083333 - 1.34858333) / 6, 1e-7));
    }
    void aNestedTableAsByR()
    {
        const GaugeValue value = studyOf(nestedByR(), GaugeDesign::Nested).values.front();
        const auto row = [&](GaugeSource source) {
            for (const VarianceRow& one : value.table)
                if (one.source == source)
                    return one;
            return VarianceRow{};
        };
        QVERIFY(isCertified(row(GaugeSource::Operator).meanSquare, 11.061666667, 1e-9));
        QVERIFY(isCertified(row(GaugeSource::Part).meanSquare, 8.322361111, 1e-9));
        QVERIFY(isCertified(row(GaugeSource::Repeatability).meanSquare, 0.802916667, 1e-9));
        const auto variance = [&](GaugeComponent component) { return value.find(component)->estimate; };
        // lmer() stops its search about 2e-5 from the maximum.
        QVERIFY(isCertified(variance(GaugeComponent::Operator), 0.342419092, 5e-5));
        QVERIFY(isCertified(variance(GaugeComponent::Part), 3.759717704, 5e-5));
        QVERIFY(isCertified(variance(GaugeComponent::Repeatability), 0.802916844, 5e-5));
    }
    void decimalsAreSubtractedAsTheyAreWritten()
    {
        QCOMPARE(decimalDifference("1000000000000.4", "1000000000000.3"), std::optional(0.1));
        QCOMPARE(decimalDifference("-0.1", "0.2"), std::optional(-0.3));
        QCOMPARE(decimalDifference("+5", "5.000"), std::optional(0.0));
        QCOMPARE(decimalDifference(".5", "1."), std::optional(-0.5));
        QCOMPARE(decimalDifference("999999999999999999", "-999999999999999999"), std::optional(2e18));
        for (const char* text : {"", "-", ".", "1e3", "1 2", "nan", "1.2.3", "1000000000000000000"})
            QVERIFY(!decimalDifference(text, "1"));
        QVERIFY(!decimalDifference("1000000000000000", "0.0001")); // 20 digits with the other's decimals
    }
    void offsetsOfNumbersWithExponentsAreThoseOfDoubles()
    {
        const StudyTable table = StudyTable::parse("v\n1e3\n 1.5e3\n-2\n", u"t.csv"_s).value();
        const OffsetColumn column = table.offsets(u"v"_s).value();
        QCOMPARE(column.origin, 1000.0);
        QCOMPARE(column.offsets, (std::vector<double>{0, 500, -1002}));
        QVERIFY(!table.offsets(u"w"_s));
    }
};

GRIPSCOPE_TEST(CertifiedVarianceTest)
#include "certified_variance_test.moc"
