// SPDX-License-Identifier: GPL-3.0-or-later
// With pounds and inches chosen, no page, dialog or report says a newton, a millimetre or what follows from
// them. What a gripper itself sends is shown as it is: its profile and the inspector of its reports.
#include "core/base/display_units.h"
#include "tests/support/test_registry.h"
#include "tests/ui/shown_texts.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/format/channel_scale.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"
#include "ui/pages/calibrate/calibrate_parts.h"
#include "ui/reports/reports.h"
#include "ui/widgets/quantity_box.h"
#include "ui/windows/dialog.h"

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

namespace {

constexpr DisplayUnits imperial{DisplayUnits::Force::PoundForce, DisplayUnits::Length::Inch};

QStringList textsOf(const QString& html)
{
    QString plain = html;
    plain.replace(QRegularExpression(u"<[^>]*>"_s), u"\n"_s);
    return plain.replace(u"&nbsp;"_s, u" "_s).split(u'\n', Qt::SkipEmptyParts);
}

bool says(const QStringList& texts, const QString& word)
{
    return std::any_of(texts.begin(), texts.end(),
                       [&word](const QString& text) { return text.contains(word); });
}

/// A calibration with its points, in the unit of the channel.
CalibrationRecord aCalibration(const QString& unit)
{
    CalibrationRecord record;
    record.unit = unit;
    record.degree = 1;
    record.reference.standardUncertainty = 0.002;
    for (int i = 0; i < 6; ++i)
        record.points.push_back({10.0 * i, 10.1 * i + 0.01 * (i % 2)});
    return record;
}

} // namespace

class DisplayUnitsWalkTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { DisplayUnits::choose({}); }

    void metricUnitsAreFound_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("metric");
        for (const char16_t* text :
             {u"9.98 ± 0.05 kN/m", u"30 N", u"m\ng", u"mm", u"Force (N)", u"0 to 60 N for 1 s", u"43 N s/m",
              u"k3 = 3.8 N/mm³", u"0.5 m", u"12\u00A0µm", u"at 120 N or 30 mm."})
            QTest::newRow(QString::fromUtf16(text).toUtf8().constData()) << QString::fromUtf16(text) << true;
        for (const char16_t* text : {u"6.7 lbf", u"press N for the next one", u"squeeze-10N", u"m",
                                     u"57 lbf/in", u"Mass m", u"12 ms", u"3 min", u"Virtual Gripper"})
            QTest::newRow(QString::fromUtf16(text).toUtf8().constData()) << QString::fromUtf16(text) << false;
    }
    void metricUnitsAreFound()
    {
        QFETCH(QString, text);
        QFETCH(bool, metric);
        QCOMPARE(!metricTexts({text}).isEmpty(), metric);
    }
    void everyPage_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("word"); // what it says instead; nothing would prove nothing
        QTest::newRow("live") << u"live"_s << u"lbf"_s;
        QTest::newRow("inspect") << u"inspect"_s << u"lbf/in"_s;
        QTest::newRow("enroll") << u"enroll"_s << u"lbf"_s;
        QTest::newRow("types") << u"types"_s << u"lb"_s;
        QTest::newRow("fit") << u"fit"_s << u"lbf/in"_s;
        QTest::newRow("calibrate") << u"calibrate"_s << u"lbf"_s;
        QTest::newRow("history") << u"history"_s << u"lbf/in"_s;
    }
    void everyPage()
    {
        QFETCH(QString, id);
        QFETCH(QString, word);
        DisplayUnits::choose(imperial);
        WindowFixture f(true, u"virtual:"_s);
        f.window->resize(1440, 900);
        f.window->showPage(id);
        f.page(id)->prepareTour();
        QTRY_VERIFY_WITH_TIMEOUT(f.page(id)->tourReady(), longEnough_ms);
        f.window->showPage(id);
        QTest::qWait(300);
        const QStringList texts = shownTexts(*f.window);
        QVERIFY2(says(texts, word), qPrintable(texts.join(u'\n')));
        const QStringList stray = metricTexts(texts);
        QVERIFY2(stray.isEmpty(), qPrintable(stray.join(u'\n')));
    }
    void thePagesSayMetricUnitsWhereNothingElseWasChosen()
    {
        WindowFixture f(true, u"virtual:"_s);
        f.window->showPage(u"live"_s);
        QTest::qWait(300);
        QVERIFY(!metricTexts(shownTexts(*f.window)).isEmpty()); // else the walk would find nothing anywhere
    }
    void everyDialog()
    {
        DisplayUnits::choose(imperial);
        WindowFixture f(true, u"virtual:"_s);
        for (const DialogRow& row : dialogTable()) {
            const QLatin1String name(row.name);
            if (name == "profile"_L1 || name == "inspector"_L1 || name == "manual"_L1 ||
                name == "foreign table"_L1 || name == "settings"_L1)
                continue; // what a gripper sends, the manual's own examples, what a file is in, the choice
            const std::unique_ptr<QDialog> dialog(row.make(*f.bench, f.window.get()));
            dialog->show();
            QTest::qWait(300);
            const QStringList stray = metricTexts(shownTexts(*dialog));
            QVERIFY2(stray.isEmpty(), qPrintable(name + u": "_s + stray.join(u'\n')));
        }
    }
    void theCertificate()
    {
        DisplayUnits::choose(imperial);
        for (const QString& unit : {u"N"_s, u"mN"_s, u"mm"_s}) {
            const CalibrationRecord record = aCalibration(unit);
            const Expected<CalibrationEvaluation> evaluation = evaluateCalibration(record);
            QVERIFY(evaluation);
            const QStringList texts = textsOf(certificateHtml(record, *evaluation));
            QVERIFY(says(texts, unit == u"mm" ? u"(in)"_s : u"(lbf)"_s));
            QCOMPARE(metricTexts(texts), QStringList());
        }
    }
    void theHistoryReport_data()
    {
        QTest::addColumn<DisplayUnits>("units");
        QTest::addColumn<QStringList>("words");
        using Force = DisplayUnits::Force;
        using Length = DisplayUnits::Length;
        QTest::newRow("N, mm") << DisplayUnits() << QStringList{u" g"_s, u" N s/m"_s, u" kN/m"_s};
        QTest::newRow("lbf, in") << imperial << QStringList{u" lb"_s, u" lbf s/in"_s, u" lbf/in"_s};
        QTest::newRow("kgf, mm") << DisplayUnits{Force::KilogramForce, Length::Metre}
                                 << QStringList{u" g"_s, u" kgf s/mm"_s, u" kgf/mm"_s};
        QTest::newRow("N, in") << DisplayUnits{Force::Newton, Length::Inch}
                               << QStringList{u" g"_s, u" N s/in"_s, u" N/in"_s};
    }
    void theHistoryReport()
    {
        QFETCH(DisplayUnits, units);
        QFETCH(QStringList, words);
        DisplayUnits::choose(units);
        HistoryReport report;
        HistoryEntry entry;
        entry.parameters = MassDampingStiffness{0.04, 40, 10000};
        entry.standardErrors = Eigen::Vector3d(0.001, 1, 50);
        entry.forceUnit = u"N"_s;
        entry.positionUnit = u"m"_s;
        report.rows = {entry};
        report.total = 1;
        const QStringList texts = textsOf(historyReportHtml(report));
        for (const QString& word : words) { // at the end of a cell, behind its number
            const bool said = std::any_of(texts.begin(), texts.end(), [&word](QString text) {
                return text.remove(QChar(0x2060)).replace(QChar(QChar::Nbsp), u' ').trimmed().endsWith(word);
            });
            QVERIFY2(said, qPrintable(word + u": "_s + texts.join(u'\n')));
        }
        QCOMPARE(metricTexts(texts).isEmpty(), units == imperial);
    }
    void numbersAreConvertedOnce()
    {
        DisplayUnits::choose(imperial);
        QCOMPARE(formatNumber(9984, 50, u"N/m"_s).text(), u"57.0 ± 0.3\u00A0lbf/in"_s);
        const ShownUnit shown = shownUnit(u"N/m"_s, 9984);
        QCOMPARE(formatNumber(9984 * shown.factor, 50 * shown.factor, shown.unit).text(),
                 u"57.0 ± 0.3\u00A0lbf/in"_s);
        QCOMPARE(formatNumber(25.4, {}, u"mm"_s).valueWithUnit(), u"1.00\u00A0in"_s);
        QCOMPARE(channelScale(u"mm"_s, 25).unit, u"in"_s);
        QCOMPARE(channelScale(u"mm"_s, 25.4).factor * 25.4, 1.0);
        QCOMPARE(channelScale(u"counts"_s, 25).unit, u"counts"_s);
        QCOMPARE(channelScale(u"counts"_s, 25).factor, 1.0);
        QCOMPARE(formatNumber(25, {}, u"counts"_s).unit, u"counts"_s);
        QCOMPARE(tableScale(u"m"_s, 0.0254).unit, u"mm"_s); // for programs
    }
    void whatNobodyTypedComesOutAsItWentIn()
    {
        DisplayUnits::choose(imperial);
        QuantityBox box(fieldUnit(MechanicalQuantity::Force), {0, 1000}, 0.1);
        box.setSi(30);
        QCOMPARE(box.text(), QLocale().toString(6.74, 'f', 2) + u"\u00A0lbf"_s);
        QCOMPARE(box.si(), 30.0);
        box.setValue(10);
        QCOMPARE(box.si(), 10 * 4.4482216152605);
        box.setSi(5000); // beyond its range
        QCOMPARE(box.si(), 1000.0);
    }
};

GRIPSCOPE_TEST(DisplayUnitsWalkTest)
#include "display_units_walk_test.moc"
