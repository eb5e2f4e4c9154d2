// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/format/number_format.h"

#include <QTest>

#include <limits>

using namespace Qt::StringLiterals;
using namespace gripscope;

class NumberFormatTest : public QObject {
    Q_OBJECT
private slots:
    void onlyDigitsTheUncertaintyAllows_data();
    void onlyDigitsTheUncertaintyAllows();
    void withoutAnErrorThreeDigits_data();
    void withoutAnErrorThreeDigits();
    void neverShowsWhatIsNotANumber();
    void percentSaysHundredOnlyOfTheWhole();
    void probabilitiesNearTheEndsAreBounded();
    void countsAreGrouped();
    void aNumberInASentenceIsNotBroken();
};

void NumberFormatTest::onlyDigitsTheUncertaintyAllows_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("error");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("text");
    const auto row = [](const char* name, double value, double error, const QString& unit,
                        const QString& text) { QTest::newRow(name) << value << error << unit << text; };
    row("stiffness in kilo", 9984.2, 51.3, u"N/m"_s, u"9.98 ± 0.05\u00A0kN/m"_s);
    row("mass in gram", 0.039612, 0.00042, u"kg"_s, u"39.6 ± 0.4\u00A0g"_s);
    row("error starting with 1 keeps two digits", 43.017, 0.123, u"N s/m"_s, u"43.02 ± 0.12\u00A0N s/m"_s);
    row("error that rounds up to 10", 43.017, 0.0998, u"N s/m"_s, u"43.02 ± 0.10\u00A0N s/m"_s);
    row("error that rounds up to 2", 43.017, 0.196, u"N s/m"_s, u"43.0 ± 0.2\u00A0N s/m"_s);
    row("error larger than the value", 0.2, 31.0, u"N s/m"_s, u"0 ± 30\u00A0N s/m"_s);
    row("negative value, real minus sign", -1.234, 0.05, u"N"_s, u"\u22121.23 ± 0.05\u00A0N"_s);
    row("unknown unit is left alone", 9984.2, 51.3, u"N/mm"_s, u"9980 ± 50\u00A0N/mm"_s);
    row("units as printed", 0.5123, 0.004, u"1"_s, u"0.512 ± 0.004"_s);
    row("a tiny error leaves six digits", 9984.2, 1e-6, u"N/m"_s, u"9.98420 ± 0.00001\u00A0kN/m"_s);
    row("metres in micro", 20e-6, 2e-6, u"m"_s, u"20 ± 2\u00A0µm"_s);
}

void NumberFormatTest::onlyDigitsTheUncertaintyAllows()
{
    QFETCH(double, value);
    QFETCH(double, error);
    QFETCH(QString, unit);
    QTEST(formatNumber(value, error, unit).text(), "text");
}

void NumberFormatTest::withoutAnErrorThreeDigits_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("text");
    QTest::newRow("stiffness") << 9984.2 << u"N/m"_s << u"9.98\u00A0kN/m"_s;
    QTest::newRow("zero") << 0.0 << u"N"_s << u"0\u00A0N"_s;
    QTest::newRow("milligrams") << 4.5678e-5 << u"kg"_s << u"45.7\u00A0mg"_s;
    QTest::newRow("no unit") << 0.99804 << u""_s << u"0.998"_s;
    QTest::newRow("rounds into the next decade") << 999.7 << u"N/m"_s << u"1.00\u00A0kN/m"_s;
}

void NumberFormatTest::withoutAnErrorThreeDigits()
{
    QFETCH(double, value);
    QFETCH(QString, unit);
    QTEST(formatNumber(value, std::nullopt, unit).text(), "text");
}

void NumberFormatTest::neverShowsWhatIsNotANumber()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    QCOMPARE(formatNumber(nan, 1.0, u"N"_s).value, u"–"_s);
    QCOMPARE(formatNumber(infinity, std::nullopt, u"N"_s).value, u"–"_s);
    QCOMPARE(formatNumber(5.0, nan, u"N"_s).text(), u"5.00\u00A0N"_s);
    QCOMPARE(formatPercent(nan), u"–"_s);
    QCOMPARE(formatProbability(nan), u"–"_s);
}

void NumberFormatTest::percentSaysHundredOnlyOfTheWhole()
{
    QCOMPARE(formatPercent(97.84), u"97.8\u00A0%"_s);
    QCOMPARE(formatPercent(99.97), u"99.9\u00A0%"_s);
    QCOMPARE(formatPercent(100), u"100.0\u00A0%"_s);
}

void NumberFormatTest::probabilitiesNearTheEndsAreBounded()
{
    QCOMPARE(formatProbability(0.9998), u"0.9998"_s);
    QCOMPARE(formatProbability(0.99999), u"> 0.9999"_s);
    QCOMPARE(formatProbability(1e-9), u"< 0.0001"_s);
    QCOMPARE(formatProbability(0), u"< 0.0001"_s);
    QCOMPARE(formatProbability(1), u"> 0.9999"_s);
}

void NumberFormatTest::countsAreGrouped()
{
    QCOMPARE(formatCount(412), u"412"_s);
    QCOMPARE(formatCount(1234567), u"1\u202F234\u202F567"_s);
    QCOMPARE(formatCount(-1234), u"-1\u202F234"_s);
}

void NumberFormatTest::aNumberInASentenceIsNotBroken()
{
    QCOMPARE(keptTogether(u"mass +23.3 ± 1.9 %, 6 of 7, a ± b"_s),
             u"mass +23.3\u00A0±\u00A01.9\u00A0%, 6 of 7, a ± b"_s);
}

GRIPSCOPE_TEST(NumberFormatTest)
#include "number_format_test.moc"
