// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/charts/plot_export.h"
#include "ui/charts/trend_plot.h"
#include "ui/pages/fit/fit_page_export.h"
#include "ui/scene/scene_view.h"

#include <QMenu>
#include <QRegularExpression>
#include <QSignalSpy>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

/// By what charts are called: one that cannot be exported has no other sign of being one.
bool isChart(const QWidget* widget)
{
    static const QRegularExpression name(u"(Plot|Plots|Chart|Map|TrendView)$"_s);
    return name.match(QString::fromLatin1(widget->metaObject()->className())).hasMatch();
}

bool holdsCharts(const QWidget* widget)
{
    const QList<QWidget*> inside = widget->findChildren<QWidget*>();
    return std::any_of(inside.begin(), inside.end(), isChart);
}

QStringList textsOf(const QMenu* menu)
{
    QStringList texts;
    for (const QAction* action : menu->actions())
        texts << action->text();
    return texts;
}

} // namespace

/// Every plot of every page can leave it.
class PlotMenuTest : public QObject {
    Q_OBJECT
private slots:
    void everyChartOfAPageHasItsMenu_data()
    {
        QTest::addColumn<int>("atLeast");
        QTest::newRow("live") << 2;
        QTest::newRow("inspect") << 1;
        QTest::newRow("enroll") << 1;
        QTest::newRow("types") << 1;
        QTest::newRow("fit") << 9;
        QTest::newRow("calibrate") << 3;
        QTest::newRow("history") << 1;
    }
    void everyChartOfAPageHasItsMenu()
    {
        QFETCH(int, atLeast);
        const auto id = QString::fromLatin1(QTest::currentDataTag());
        WindowFixture f(true, {});
        f.window->showPage(id);
        int found = 0;
        for (QWidget* widget : f.page(id)->findChildren<QWidget*>()) {
            if (!isChart(widget) || qobject_cast<SceneView*>(widget)) // that has a button for it
                continue;
            const QByteArray which = widget->metaObject()->className();
            if (!dynamic_cast<ExportablePlot*>(widget)) {
                QVERIFY2(holdsCharts(widget), which.constData());
                continue;
            }
            ++found;
            QTest::keyClick(widget, Qt::Key_Menu);
            auto* menu = widget->findChild<QMenu*>(u"plotMenu"_s, Qt::FindDirectChildrenOnly);
            QVERIFY2(menu, which.constData());
            const QStringList texts = textsOf(menu);
            QVERIFY2(texts.contains(u"Save picture as SVG…"_s) && texts.contains(u"Save data as CSV…"_s),
                     which.constData());
            // On Fit the button Export has the width for all of them.
            QVERIFY2(id == u"fit"_s || texts.contains(u"Width of pictures"_s), which.constData());
            menu->close();
        }
        QVERIFY2(found >= atLeast, qPrintable(QString::number(found)));
    }
    void whereNoLineTellsWhatWasSavedTheMessageBarDoes()
    {
        QTemporaryDir folder;
        WindowFixture f(false, {});
        QSignalSpy told(&f.bench->messages(), &Messages::told);
        FitExporter exporter(*f.bench, f.window.get());
        TrendView view;
        view.resize(300, 200);
        const QString file = folder.filePath(u"trend.svg"_s);
        exporter.savePlot(&view, PlotFormat::Svg, file);
        QTRY_COMPARE_WITH_TIMEOUT(told.size(), 1, longEnough_ms);
        QVERIFY2(told[0][0].toString().endsWith(u"trend.svg"_s), qPrintable(told[0][0].toString()));
        QVERIFY(QFile::exists(file));
        // A page with a line of its own says it there, and once.
        QSignalSpy line(&exporter, &FitExporter::told);
        exporter.savePlot(&view, PlotFormat::Csv, folder.filePath(u"trend.csv"_s));
        QTRY_COMPARE_WITH_TIMEOUT(line.size(), 2, longEnough_ms);
        QCOMPARE(line[1][0].toString(), u"saved trend.csv"_s);
        QCOMPARE(told.size(), 1);
    }
};

GRIPSCOPE_TEST(PlotMenuTest)
#include "plot_menu_test.moc"
