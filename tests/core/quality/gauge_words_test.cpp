// SPDX-License-Identifier: GPL-3.0-or-later
// What a gauge study says: words, the document, a squeeze's own uncertainty.
#include "core/quality/gauge/gauge_study.h"
#include "core/quality/gauge/gauge_words.h"
#include "tests/core/quality/gauge_tables.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

GaugeMeasurements drawnMeasurements(const std::array<double, 6>& deviations, std::uint64_t seed = 2)
{
    return measurementsOf(drawnCrossedRows(10, 3, 0, 3, deviations, seed));
}

QString saidOf(const GaugeMeasurements& measurements, const GaugeOptions& options = {})
{
    return english(studyGauge(measurements, options)->values.front().messages).join(u'\n');
}

} // namespace

class GaugeWordsTest : public QObject {
    Q_OBJECT
private slots:
    void theVerdictFollowsTheLimits_data()
    {
        QTest::addColumn<double>("repeatability");
        QTest::addColumn<double>("operators");
        QTest::addColumn<QString>("words");
        QTest::newRow("good") << 0.05 << 0.0 << u"is good enough"_s;
        QTest::newRow("usable") << 0.13 << 0.0 << u"may do"_s;
        QTest::newRow("bad") << 1.0 << 0.0 << u"not good enough"_s;
        QTest::newRow("operators") << 0.2 << 1.0 << u"Operators matter"_s;
        QTest::newRow("no operators") << 0.2 << 0.0 << u"Operators are not the trouble"_s;
        QTest::newRow("blame") << 0.2 << 2.0 << u"reduce what comes from the operators"_s;
        QTest::newRow("average") << 0.45 << 0.0 << u"times and take the mean"_s;
        QTest::newRow("hopeless") << 20.0 << 0.0 << u"cannot tell these parts apart"_s;
    }
    void theVerdictFollowsTheLimits()
    {
        QFETCH(double, repeatability);
        QFETCH(double, operators);
        QFETCH(QString, words);
        const QString said = saidOf(drawnMeasurements({1, operators, 0, 0, 0, repeatability}));
        QVERIFY2(said.contains(words), qPrintable(said));
    }
    void theToleranceCounts()
    {
        GaugeOptions options;
        options.tolerances = {0.3};
        const GaugeStudy study = studyGauge(drawnMeasurements({1, 0, 0, 0, 0, 0.05}), options).value();
        QVERIFY(gaugeGrade(study.values.front()) == GaugeGrade::NotGoodEnough);
        QVERIFY(english(study.values.front().messages).first().contains(u"% of the tolerance"_s));
    }
    void pooledInteractionsAreSaid()
    {
        const QString said = saidOf(measurementsOf(prototypeRows()));
        QVERIFY2(said.contains(u"F = 0.974, p = 0.446, above 0.25"_s), qPrintable(said));
        GaugeOptions options;
        options.pooling = false;
        QVERIFY(!saidOf(measurementsOf(prototypeRows()), options).contains(u"Pooled"_s));
    }
    /// The stated uncertainty is a third of, as large as, and three times what repeats scatter by.
    void repeatsAreHeldAgainstTheSqueezesOwnWord()
    {
        GaugeMeasurements measurements = drawnMeasurements({1, 0.1, 0, 0.1, 0, 0.2});
        const std::array<QString, 3> words{u"something that a squeeze does not see"_s,
                                           u"as the squeezes' own uncertainties say"_s,
                                           u"stated too large"_s};
        const std::array<double, 3> stated{0.2 / 3, 0.2, 0.6};
        for (std::size_t i = 0; i < stated.size(); ++i) {
            measurements.standardUncertainties = Eigen::VectorXd::Constant(90, stated[i]);
            const QString said = saidOf(measurements);
            QVERIFY2(said.contains(words[i]), qPrintable(said));
        }
        const GaugeValue value = studyGauge(measurements)->values.front();
        QCOMPARE(value.consistency->degreesOfFreedom, 60.0);
        // With equal uncertainties it is the sum of squares within cells over theirs.
        QVERIFY(
            isRelativelyNear(value.consistency->chiSquared, value.table.back().sumOfSquares / 0.36, 1e-10));
        measurements.standardUncertainties(3, 0) = 0;
        QVERIFY(!studyGauge(measurements));
    }
    void theDocumentHasItsNames()
    {
        const QJsonObject document = gaugeJson(*studyGauge(measurementsOf(prototypeRows())));
        QCOMPARE(document[u"design"].toString(), u"crossed"_s);
        QCOMPARE(document[u"method"].toString(), u"anova"_s);
        QVERIFY(document[u"balanced"].toBool());
        const QJsonObject value = document[u"values"][u"value"].toObject();
        QCOMPARE(value[u"anova"][2][u"source"].toString(), u"part_operator"_s);
        QCOMPARE(value[u"anova"][2][u"df"].toInt(), 4);
        QVERIFY(value[u"interaction_pooled"].toBool() && value[u"messages"].toArray().size() > 4);
        for (const QString& name : {u"repeatability"_s, u"operator"_s, u"part_operator"_s,
                                    u"reproducibility"_s, u"gauge"_s, u"part"_s, u"total"_s}) {
            const QJsonObject one = value[u"components"][name].toObject();
            QVERIFY(one[u"variance"].isDouble() && one[u"interval"].toArray().size() == 2);
            QVERIFY(one[u"percent_contribution"].isDouble() && one[u"percent_study_variation"].isDouble());
            QVERIFY(one.contains(u"percent_tolerance") && one[u"percent_tolerance"].isNull());
        }
        QVERIFY(value[u"distinct_categories"][u"value"].isDouble());
        QCOMPARE(value[u"distinct_categories"][u"interval"].toArray().size(), 2);
    }
    void negativeComponentsAreInTheDocument()
    {
        GaugeOptions options;
        options.pooling = false;
        const QJsonObject document = gaugeJson(*studyGauge(measurementsOf(prototypeRows()), options));
        const QJsonObject one = document[u"values"][u"value"][u"components"][u"part_operator"].toObject();
        QVERIFY(one[u"variance"].toDouble() < 0 && one[u"taken_as"].toDouble(-1) == 0);
        QCOMPARE(one[u"percent_contribution"].toDouble(-1), 0.0);
    }
};

GRIPSCOPE_TEST(GaugeWordsTest)
#include "gauge_words_test.moc"
