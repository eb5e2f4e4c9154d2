// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/choosing.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/charts/bode_plots.h"
#include "ui/imports/foreign_table_dialog.h"
#include "ui/pages/fit/fit_page_export.h"

#include <QAbstractButton>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMap>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test::choosing;
using gripscope::test::longEnough_ms;
using gripscope::test::WindowFixture;

namespace {

QByteArray withComma(double value)
{
    return QByteArray::number(value, 'e', 17).replace('.', ',');
}

/// A squeeze of can A as a German measuring program would write it: semicolons, decimal commas, units below.
QByteArray measuredElsewhere()
{
    const Recording recording = simulatedSqueeze(test::canA, 4);
    QByteArray text("Zeit;Kraft;Weg\nms;N;mm\n");
    for (std::size_t i = 0; i < recording.size(); ++i)
        text += withComma(1e3 * recording.time_s[i]) + ';' + withComma(recording.force[i]) + ';' +
                withComma(1e3 * recording.position[i]) + '\n';
    return text;
}

struct Reported {
    QString value, half;
    double factor = 0; ///< to SI
    [[nodiscard]] bool holds(double truth) const
    {
        // Twice a 95 % interval: fails once in ten thousand squeezes, and this one is always the same.
        return factor > 0 && std::abs(value.toDouble() * factor - truth) <= 2 * half.toDouble() * factor;
    }
};

/// "k = 9.98 ± 0.05 kN/m" in a text of such lines.
Reported reported(const QString& text, const QString& symbol)
{
    const QRegularExpression line(u"^%1 = ([0-9.]+) ± ([0-9.]+) (.+)$"_s.arg(symbol),
                                  QRegularExpression::MultilineOption);
    const QRegularExpressionMatch match = line.match(QString(text).replace(QChar(QChar::Nbsp), u' '));
    const QMap<QString, double> units{
        {u"g"_s, 1e-3}, {u"kg"_s, 1}, {u"N s/m"_s, 1}, {u"N/m"_s, 1}, {u"kN/m"_s, 1e3}};
    return {match.captured(1), match.captured(2), units.value(match.captured(3).trimmed())};
}

} // namespace

/// Own data to a figure and a table for a paper: all by clicks and keys.
class ResearcherJourneyTest : public QObject {
    Q_OBJECT

    template <typename Window>
    static Window* shown(WindowFixture& f)
    {
        Window* found = nullptr;
        const auto look = [&] {
            for (auto* one : f.window->findChildren<Window*>())
                if (one->isVisible())
                    found = one;
            return found != nullptr;
        };
        return QTest::qWaitFor(look, longEnough_ms) ? found : nullptr;
    }
    static QPushButton* button(WindowFixture& f, const QString& name)
    {
        for (auto* one : f.page(u"fit"_s)->findChildren<QPushButton*>())
            if (one->accessibleName() == name || one->text() == name)
                return one;
        return nullptr;
    }
    /// What the clipboard holds after this entry of "Copy numbers" was clicked.
    static QString copied(WindowFixture& f, const QString& words)
    {
        QGuiApplication::clipboard()->clear();
        chooseInMenu(button(f, u"Copy numbers"_s), button(f, u"Copy numbers"_s)->menu(), {words});
        return QGuiApplication::clipboard()->text();
    }

private slots:
    void ownTableToFigureAndNumbers()
    {
        const QTemporaryDir folder;
        const QString table = folder.filePath(u"versuch.csv"_s);
        QFile out(table);
        QVERIFY(out.open(QIODevice::WriteOnly) && out.write(measuredElsewhere()) > 0);
        out.close();
        WindowFixture f(false, QString());
        WindowFixture::clickWhenEnabled(f.find<QAbstractButton>("rail-fit"));

        WindowFixture::click(button(f, u"Open…"_s));
        chooseFile(f.window.get(), table);
        auto* import = shown<ForeignTableDialog>(f);
        QVERIFY(import);
        QCOMPARE(import->findChild<QComboBox*>(u"importForce"_s)->currentText(), u"Kraft"_s);
        QTest::keyClick(import->findChild<QComboBox*>(u"importHold"_s), Qt::Key_Down); // held
        WindowFixture::click(import->findChild<QPushButton*>(u"importTable"_s));
        QTRY_VERIFY_WITH_TIMEOUT(f.bench->navigator().fitSubject().has_value(), longEnough_ms);
        QVERIFY(f.bench->navigator().fitSubject()->recording.hold == ForceHold::Zero);
        QTRY_VERIFY_WITH_TIMEOUT(f.page(u"fit"_s)->tourReady(), longEnough_ms);

        WindowFixture::clickWhenEnabled(button(f, u"Bode plot"_s));
        const auto* bode = f.window->findChild<BodePlots*>();
        QVERIFY(bode->isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!bode->magnitude()->measured().value.empty(), longEnough_ms);

        QPushButton* exports = button(f, u"Export"_s);
        chooseInMenu(exports, exports->menu(), {u"Width of pictures"_s, u"One journal column (85 mm)"_s});
        chooseInMenu(exports, exports->menu(), {u"Bode plot"_s, u"Save picture as SVG…"_s});
        const QString figure = folder.filePath(u"figure.svg"_s);
        chooseFile(f.window.get(), figure);
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(figure), longEnough_ms);
        QTRY_COMPARE_WITH_TIMEOUT(f.page(u"fit"_s)->findChild<FitExporter*>()->pending(), 0, longEnough_ms);
        QFile saved(figure);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        const QString svg = QString::fromUtf8(saved.readAll());
        static const QRegularExpression width(u"width=\"([0-9.]+)mm\""_s);
        QVERIFY(std::abs(width.match(svg).captured(1).toDouble() - 85) < 0.3);
        for (const QString& words : {u"Magnitude (mm/N)"_s, u"Phase (°)"_s, u"Coherence"_s, u"measured"_s})
            QVERIFY2(svg.contains(words), qPrintable(words));

        const QString text = copied(f, u"Results, rounded (± 95 %)"_s);
        const QString latex = copied(f, u"Results for LaTeX (± 95 %)"_s);
        const std::pair<QString, double> truths[] = {
            {u"m"_s, test::canA.m}, {u"b"_s, test::canA.b}, {u"k"_s, test::canA.k}};
        for (const auto& [symbol, truth] : truths) {
            const Reported number = reported(text, symbol);
            QVERIFY2(number.holds(truth), qPrintable(text));
            // The same digits in both.
            const QString formula =
                u"$%1 = (%2 \\pm %3)\\,\\mathrm{"_s.arg(symbol, number.value, number.half);
            QVERIFY2(latex.contains(formula), qPrintable(formula + u'\n' + latex));
        }
    }
};

GRIPSCOPE_TEST(ResearcherJourneyTest)
#include "researcher_journey_test.moc"
