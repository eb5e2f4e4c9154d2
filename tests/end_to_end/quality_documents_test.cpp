// SPDX-License-Identifier: GPL-3.0-or-later
// What programs read: the keys of each study's document, and published figures from tables as files.
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QHash>

#include <cmath>

using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// "a.b.0.c": members and places in arrays.
QJsonValue documentValue(const QJsonObject& document, const QString& path)
{
    QJsonValue value = document;
    for (const QString& step : path.split(u'.')) {
        bool isPlace = false;
        const int place = step.toInt(&isPlace);
        value = value.isArray() && isPlace ? value.toArray().at(place) : value.toObject().value(step);
    }
    return value;
}

} // namespace

class QualityDocumentsTest : public QObject {
    Q_OBJECT
private:
    Workplace m_work;
    const QString m_shared = QStringLiteral(GRIPSCOPE_SHARED_DATA "/quality/");

    QHash<QString, QJsonObject> m_documents; // of each command once

    [[nodiscard]] QJsonObject documentOf(const QString& arguments)
    {
        if (m_documents.contains(arguments))
            return m_documents[arguments];
        QStringList words = arguments.split(u' ', Qt::SkipEmptyParts);
        for (QString& word : words)
            if (word.startsWith(u'@'))
                word = m_shared + word.mid(1);
        const ProgramRun run = m_work.cli(QStringList{u"study"_s} + words + QStringList{u"--json"_s});
        if (run.exit != 0)
            qWarning("exit %d: %s", run.exit, run.err.constData());
        return m_documents[arguments] = run.json();
    }

private slots:
    void initTestCase()
    {
        m_work.write(u"gauge.csv"_s, "part,operator,value\nA,1,1.1\nA,1,1.2\nA,2,1.3\nA,2,1.2\nB,1,2.1\n"
                                     "B,1,2.3\nB,2,2.2\nB,2,2.4\nC,1,3.1\nC,1,3.2\nC,2,3.0\nC,2,3.3\n");
        m_work.write(u"one.csv"_s, "k\n10\n10.01\n9.99\n10.02\n9.98\n10\n");
        m_work.write(u"line.csv"_s, "ref,k\n1,1.2\n1,1.1\n2,2.1\n2,2.2\n3,3.0\n3,3.1\n");
        m_work.write(u"verdicts.csv"_s, "part,who,verdict,truth\n1,A,OK,OK\n1,B,OK,OK\n2,A,NotOK,NotOK\n"
                                        "2,B,OK,NotOK\n3,A,OK,OK\n3,B,OK,OK\n");
        QByteArray many = "x,y\n";
        for (int i = 0; i < 40; ++i)
            many += QByteArray::number(i * 7 % 11) + ',' + QByteArray::number(i * 5 % 13) + '\n';
        m_work.write(u"many.csv"_s, many);
    }
    void keysAreThere_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("keys");
        QTest::newRow("gauge")
            << u"gauge gauge.csv --part part --operator operator --value value --tolerance 2 --no-pooling"_s
            << u"design method balanced values.value.anova.0.source values.value.anova.0.df "
               "values.value.anova.0.ss values.value.anova.0.ms values.value.anova.0.f "
               "values.value.anova.0.p values.value.components.repeatability.variance "
               "values.value.components.repeatability.interval.1 "
               "values.value.components.repeatability.percent_contribution "
               "values.value.components.repeatability.percent_study_variation "
               "values.value.components.repeatability.percent_tolerance "
               "values.value.components.operator.variance values.value.components.part_operator.variance "
               "values.value.components.reproducibility.variance values.value.components.gauge.variance "
               "values.value.components.part.variance values.value.components.total.variance "
               "values.value.distinct_categories.value values.value.distinct_categories.interval.0 "
               "values.value.interaction_pooled values.value.messages.0"_s;
        QTest::newRow("type1") << u"type1 one.csv --value k --reference 10 --tolerance 1"_s
                               << u"cg cgk bias bias_interval.1 t p repeatability"_s;
        QTest::newRow("linearity")
            << u"linearity line.csv --reference ref --value k"_s
            << u"intercept slope residual_deviation r_squared t_intercept t_slope p_intercept p_slope "
               "bias.0.reference bias.0.bias bias.0.p percent_linearity"_s;
        QTest::newRow("attributes")
            << u"attributes verdicts.csv --part part --rater who --verdict verdict --reference truth"_s
            << u"raters.A.effectiveness raters.A.interval.1 raters.A.miss_rate raters.A.false_alarm_rate "
               "kappa.pairs.0.value kappa.reference.A kappa.fleiss.value kappa.fleiss.z"_s;
        QTest::newRow("capability")
            << u"capability many.csv --value x --lower -5 --upper 15 --subgroup 5"_s
            << u"within.sigma within.cp within.cp_interval.1 within.cpk within.cpk_interval.1 overall.sigma "
               "overall.pp overall.pp_interval.1 overall.ppk overall.ppk_interval.1 overall.cpm "
               "overall.cpm_interval.1 normality.anderson_darling normality.p expected_ppm"_s;
        for (const char* kind : {"i-mr", "ewma", "cusum"})
            QTest::newRow(kind) << u"chart many.csv --value x --kind %1"_s.arg(QLatin1String(kind))
                                << u"centre sigma points.0.value points.0.lower points.0.upper "
                                   "points.0.rules signals arl.in_control arl.shift_1_sigma"_s;
        for (const char* kind : {"xbar-r", "xbar-s"})
            QTest::newRow(kind) << u"chart many.csv --value x --subgroup 5 --kind %1"_s.arg(
                                       QLatin1String(kind))
                                << u"centre sigma points.0.value points.0.lower points.0.upper "
                                   "points.0.rules signals arl.in_control arl.shift_1_sigma"_s;
        QTest::newRow("hotelling") << u"chart many.csv --value x,y --kind hotelling"_s
                                   << u"centre.1 sigma.1 points.0.value points.0.lower points.0.upper "
                                      "points.0.rules signals arl.in_control arl.shift_1_sigma"_s;
        QTest::newRow("guardband") << u"guardband --lower 1 --upper 2 --process-mean 1.5 --process-sigma 0.3 "
                                      "--measurement-sigma 0.1"_s
                                   << u"consumers_risk producers_risk guard_for_risk.0.01"_s;
    }
    void keysAreThere()
    {
        QFETCH(QString, arguments);
        QFETCH(QString, keys);
        const QJsonObject document = documentOf(arguments);
        QVERIFY(!document.isEmpty());
        for (const QString& key : keys.split(u' ')) {
            if (key == u"guard_for_risk.0.01"_s) {
                QVERIFY(document[u"guard_for_risk"].toObject().contains(u"0.01"_s));
                continue;
            }
            const QJsonValue value = documentValue(document, key);
            QVERIFY2(!value.isUndefined() && !value.isNull(), qPrintable(key));
        }
    }
    void publishedFigures_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("key");
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("lastDigit"); // one of it
        const auto row = [](const QString& arguments, const char* key, double value, double lastDigit) {
            QTest::addRow("%s %s", arguments.section(u' ', 0, 0).toLatin1().constData(), key)
                << arguments << QString::fromLatin1(key) << value << lastDigit;
        };
        const QString crossed =
            u"gauge @crossed_3x3x3.csv --part prototype --operator operator --value time1"_s;
        row(crossed, "values.time1.anova.0.ms", 0.60035926, 1e-8);
        row(crossed, "values.time1.anova.1.ms", 0.02647037, 1e-8);
        row(crossed, "values.time1.anova.2.ms", 0.02084815, 1e-8);
        row(crossed, "values.time1.anova.2.f", 0.974, 1e-3);
        row(crossed, "values.time1.anova.2.p", 0.446, 1e-3);
        row(crossed, "values.time1.anova.3.ms", 0.02141111, 1e-8);
        row(crossed, "values.time1.components.gauge.percent_contribution", 25.379, 1e-3);
        row(crossed, "values.time1.components.gauge.percent_study_variation", 50.378, 1e-3);
        const QString kept = crossed + u" --no-pooling"_s;
        row(kept, "values.time1.components.gauge.percent_contribution", 25.497, 1e-3);
        row(kept, "values.time1.components.gauge.percent_study_variation", 50.494, 1e-3);
        for (const char* design : {" --design nested", " --design auto"}) {
            const QString nested = u"gauge @nested_glucose.csv --part day --operator run --value result"_s +
                                   QLatin1String(design);
            row(nested, "values.result.mean", 244.2, 0.1);
            row(nested, "values.result.anova.0.ms", 21.8842105, 1e-7);
            row(nested, "values.result.anova.1.ms", 14.05, 1e-6);
            row(nested, "values.result.anova.2.ms", 7.9, 1e-6);
            row(nested, "values.result.components.part.variance", 1.958553, 1e-6);
            row(nested, "values.result.components.operator.variance", 3.075, 1e-6);
            row(nested, "values.result.components.repeatability.variance", 7.9, 1e-6);
        }
        const QString line = u"linearity @linearity.csv --reference reference --value value"_s;
        row(line, "intercept", 0.7366667, 1e-7);
        row(line, "slope", -0.1316667, 1e-7);
        row(line, "t_intercept", 10.1575, 1e-4);
        row(line, "t_slope", -12.0426, 1e-4);
        row(line, "residual_deviation", 0.2395398, 1e-7);
        row(line, "r_squared", 0.7143, 1e-4);
        row(line, "bias.0.bias", 0.491667, 1e-6);
        row(line, "bias.1.bias", 0.125, 1e-6);
        row(line, "bias.2.bias", 0.025, 1e-6);
        row(line, "bias.3.bias", -0.291667, 1e-6);
        row(line, "bias.4.bias", -0.616667, 1e-6);
    }
    void publishedFigures()
    {
        if (!QFile::exists(m_shared + u"linearity.csv"_s))
            QSKIP("the published tables are not in ../shared/data/quality");
        QFETCH(QString, arguments);
        QFETCH(QString, key);
        QFETCH(double, value);
        QFETCH(double, lastDigit);
        const double found = documentValue(documentOf(arguments), key).toDouble();
        QVERIFY2(std::abs(found - value) < 0.51 * lastDigit, qPrintable(QString::number(found, 'g', 12)));
    }
    /// The tolerance of a resistor by JCGM 106:2012, and other processes by R's integrate().
    void globalRisksAsByOthers_data()
    {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<double>("consumers");
        QTest::addColumn<double>("producers");
        const QString resistor = u"--lower 1499.8 --upper 1500.2 --process-mean 1500 --process-sigma 0.12 "
                                 "--measurement-sigma 0.04"_s;
        const QString oblique =
            u"--lower 9.5 --upper 10.5 --process-mean 10.1 --process-sigma 0.2 --measurement-sigma 0.05"_s;
        const QString open = u"--upper 1.5 --process-mean 0 --process-sigma 1 --measurement-sigma 0.2"_s;
        QTest::newRow("resistor") << resistor << 0.0189422 << 0.0372078;
        QTest::newRow("oblique") << oblique << 0.00429468770012 << 0.00817186282486;
        QTest::newRow("guarded") << oblique + u" --guard 0.08"_s << 0.000281385164548 << 0.042313537546410;
        QTest::newRow("one limit") << open << 0.00857248334915 << 0.01242828360157;
        QTest::newRow("widened") << open + u" --guard -0.1"_s << 0.01446944957660 << 0.00599448069825;
    }
    void globalRisksAsByOthers()
    {
        QFETCH(QString, arguments);
        QFETCH(double, consumers);
        QFETCH(double, producers);
        const QJsonObject found = documentOf(u"guardband "_s + arguments);
        QVERIFY(std::abs(found[u"consumers_risk"].toDouble() - consumers) < 6e-8);
        QVERIFY(std::abs(found[u"producers_risk"].toDouble() - producers) < 6e-8);
        if (QLatin1String(QTest::currentDataTag()) == QLatin1String("oblique")) {
            QVERIFY(std::abs(found[u"guard_for_risk"][u"0.01"].toDouble() + 0.0475478160881) < 1e-9);
            QVERIFY(std::abs(found[u"guard_for_risk"][u"0.001"].toDouble() - 0.0492821987244) < 1e-9);
        }
    }
    void anAmbiguousDesignIsTold()
    {
        const auto messagesOf = [this](const QString& arguments) {
            return QJsonDocument(documentOf(arguments)[u"values"][u"value"][u"messages"].toArray()).toJson();
        };
        QVERIFY(messagesOf(u"gauge gauge.csv --part part --operator operator --value value"_s)
                    .contains("--design nested"));
        QVERIFY(
            !messagesOf(u"gauge gauge.csv --part part --operator operator --value value --design crossed"_s)
                 .contains("--design"));
        m_work.write(u"runs.csv"_s, "day,Run,value\n1,1,5\n1,1,6\n1,2,4\n1,2,6\n2,1,7\n2,1,9\n2,2,8\n2,2,9\n"
                                    "3,1,3\n3,1,2\n3,2,1\n3,2,3\n");
        const QString runs = u"gauge runs.csv --part day --operator Run --value value"_s;
        QCOMPARE(documentOf(runs)[u"design"].toString(), u"nested"_s);
        QVERIFY(messagesOf(runs).contains("--design crossed"));
        QCOMPARE(documentOf(runs + u" --design crossed"_s)[u"design"].toString(), u"crossed"_s);
    }
};

GRIPSCOPE_TEST(QualityDocumentsTest)
#include "quality_documents_test.moc"
