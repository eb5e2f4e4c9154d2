// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/display_units.h"
#include "tests/support/test_registry.h"
#include "ui/format/number_format.h"
#include "ui/format/parameter_text.h"

#include <QLocale>
#include <QTest>

#include <cmath>
#include <limits>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// m, b, k of a budget in N and mm, with these half widths; damping's interval is askew.
Identification found()
{
    Identification result;
    Estimate estimate;
    estimate.estimator = Estimator::OutputError;
    estimate.status = EstimateStatus::Converged;
    estimate.parameters = MassDampingStiffness{0.0000396, 0.043, 9.99};
    result.estimates = {estimate};
    result.recommended = Estimator::OutputError;
    result.validity.verdict = ValidityVerdict::Suspect;
    UncertaintyBudget& budget = result.budget;
    budget.parameters = estimate.parameters;
    budget.intervals[0] = {0.0000396 - 0.00000032, 0.0000396 + 0.00000032, false, false};
    budget.intervals[1] = {0.040, 0.049, false, false};
    budget.intervals[2] = {9.99 - 0.0513, 9.99 + 0.0513, false, false};
    return result;
}

QString latex()
{
    return resultsAsLatex(found(), u"a.csv"_s, u"N"_s, u"mm"_s);
}

} // namespace

class ResultTextTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup()
    {
        DisplayUnits::choose({});
        QLocale::setDefault(QLocale::c());
    }
    void theUncertaintyHasTwoDigits_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<double>("half");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("number");
        const auto row = [](const char* name, double value, double half, const QString& unit,
                            const QString& number) {
            QTest::newRow(name) << value << half << unit << number;
        };
        row("stiffness in kilo", 9984.2, 51.3, u"N/m"_s, u"9.984 +- 0.051 kN/m"_s);
        row("mass in gram", 0.039612, 0.00042, u"kg"_s, u"39.61 +- 0.42 g"_s);
        row("rounds up to 10", 43.017, 0.0996, u"N s/m"_s, u"43.02 +- 0.10 N s/m"_s);
        row("no prefix", 9984.2, 513, u"N/mm"_s, u"9980 +- 510 N/mm"_s);
        row("wider than the value", 0.2, 31.4, u"N s/m"_s, u"0 +- 31 N s/m"_s);
        row("negative", -1.2342, 0.05, u"1"_s, u"-1.234 +- 0.050 "_s);
        row("no minus zero", -0.001, 0.5, u"1"_s, u"0.00 +- 0.50 "_s);
        row("very narrow", 1.0, 1.2e-9, u"1"_s, u"1.0000000000 +- 0.0000000012 "_s);
    }
    void theUncertaintyHasTwoDigits()
    {
        QFETCH(double, value);
        QFETCH(double, half);
        QFETCH(QString, unit);
        const RoundedNumber rounded = roundedForReport(value, value - half, value + half, unit);
        QTEST(u"%1 +- %2 %3"_s.arg(rounded.value, rounded.half, rounded.unit), "number");
    }
    void withoutAnIntervalThereIsNone()
    {
        QCOMPARE(roundedForReport(1.5, 1.5, 1.5, u"1"_s), (RoundedNumber{u"1.5"_s, {}, {}, {}, {}}));
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(roundedForReport(nan, 1, 2, u"1"_s), RoundedNumber());
        QVERIFY(roundedForReport(1, nan, 2, u"1"_s).half.isEmpty());
    }
    void asText()
    {
        const QStringList lines = resultsAsText(found(), u"a.csv"_s, u"N"_s, u"mm"_s).split(u'\n');
        QVERIFY2(lines[0].startsWith(u"a.csv, "_s) && lines[0].endsWith(u"95 % intervals"_s),
                 qPrintable(lines[0]));
        QCOMPARE(lines[1], u"m = 39.60 ± 0.32\u00A0g"_s);
        QCOMPARE(lines[2], u"b = 43.0\u00A0N s/m (40.0 to 49.0)"_s);
        QCOMPARE(lines[3], u"k = 9.990 ± 0.051\u00A0kN/m"_s);
        QCOMPARE(lines[lines.size() - 2], u"The measurement is suspect."_s);
        QLocale::setDefault(QLocale(QLocale::German));
        QVERIFY(resultsAsText(found(), u"a.csv"_s, u"N"_s, u"mm"_s).contains(u"39,60 ± 0,32\u00A0g"_s));
    }
    void asLatex()
    {
        QLocale::setDefault(QLocale(QLocale::German)); // a document has points in every language
        const QStringList lines = latex().split(u'\n');
        QCOMPARE(lines[0], u"% a.csv, estimator oe, 95 % intervals, measurement suspect"_s);
        QCOMPARE(lines[1], uR"($m = (39.60 \pm 0.32)\,\mathrm{g}$ % mass)"_s);
        QCOMPARE(lines[2], uR"($b = 43.0^{+6.0}_{-3.0}\,\mathrm{N\,s/m}$ % damping)"_s);
        QCOMPARE(lines[3], uR"($k = (9.990 \pm 0.051)\,\mathrm{kN/m}$ % stiffness)"_s);
    }
    void aTitleCannotEndTheComment()
    {
        const QString text = resultsAsLatex(found(), u"a\n\\input{b}\r\u2028c"_s, u"N"_s, u"mm"_s);
        QVERIFY2(text.startsWith(u"% a \\input{b}  c, estimator"_s), qPrintable(text));
    }
    void unitsThatSayNothingToLatex()
    {
        const QString text = resultsAsLatex(found(), u"a"_s, u"$x_{%}&\\N"_s, u"1"_s);
        for (const QString& line : text.split(u'\n', Qt::SkipEmptyParts))
            if (line.startsWith(u'$'))
                QCOMPARE(line.count(u'$'), qsizetype(2));
        QVERIFY2(text.contains(u"\\mathrm{xN}"_s), qPrintable(text));
        QVERIFY(text.contains(u"s^{2}"_s));
    }
    void asCsv()
    {
        const QStringList lines = resultsAsCsv(found(), u"N"_s, u"mm"_s).split(u'\n');
        QCOMPARE(lines[0], u"quantity,value,half_width_95,lower_95,upper_95,unit,validity"_s);
        const QStringList mass = lines[1].split(u',');
        QCOMPARE(mass.size(), qsizetype(7));
        QCOMPARE(mass[0], u"m"_s);
        QCOMPARE(mass[1].toDouble(), 0.0000396 * 1e3);
        QVERIFY(std::abs(mass[2].toDouble() - 0.00032) < 1e-12);
        QCOMPARE(mass[5], u"kg"_s);
        QCOMPARE(mass[6], u"suspect"_s);
        for (qsizetype i = 1; i + 1 < lines.size(); ++i)
            QCOMPARE(lines[i].count(u','), qsizetype(6));
    }
    void numbersAreThoseThatPersonsRead()
    {
        DisplayUnits::choose({DisplayUnits::Force::PoundForce, DisplayUnits::Length::Inch});
        QVERIFY2(latex().contains(u"lbf/in"_s), qPrintable(latex()));
        QVERIFY(resultsAsCsv(found(), u"N"_s, u"mm"_s).contains(u",N/m,"_s)); // a document stays in SI
    }
    void withoutAnEstimateOnlyTheMeasurementIsJudged()
    {
        Identification nothing;
        nothing.validity.verdict = ValidityVerdict::Invalid;
        QCOMPARE(resultsAsText(nothing, u"a"_s, u"N"_s, u"mm"_s), u"The measurement is not valid.\n"_s);
        QVERIFY(reportedResults(nothing, u"N"_s, u"mm"_s).empty());
        QCOMPARE(resultsAsCsv(nothing, u"N"_s, u"mm"_s).count(u'\n'), qsizetype(1));
    }
};

GRIPSCOPE_TEST(ResultTextTest)
#include "result_text_test.moc"
