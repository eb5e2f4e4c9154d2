// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/identification_example.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/layout_walk.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/charts/bode_plots.h"

#include <QPushButton>
#include <QTabWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

/// Fit beside the state of the tour: each tab, the Bode plot, the way back, and while it identifies.
class FitLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void everyTab_data() { languageRows(); }
    void everyTab()
    {
        const RowLanguage language;
        WindowFixture f(true, QString());
        f.window->showPage(u"fit"_s);
        const Recording recording = simulatedSqueeze(canA, 3);
        f.bench->navigator().setFitSubject({u"A, 3"_s, recording, identify(recording), u"history"_s});
        settleLayout();
        LayoutWalk walk(*f.window);
        walk.look(u"identifying, light 1024"_s);
        QTRY_VERIFY(f.page(u"fit"_s)->tourReady());
        auto* tabs = f.page(u"fit"_s)->findChild<QTabWidget*>();
        QVERIFY(tabs->count() > 4);
        for (int tab = 0; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            walk.whereTight(u"tab "_s + tabs->tabText(tab));
        }
        f.click(f.find<QPushButton>("bodeShown"));
        const auto* bode = f.page(u"fit"_s)->findChild<BodePlots*>();
        QTRY_VERIFY(!bode->coherence()->measured().value.empty());
        walk.whereTight(u"Bode"_s);
        QVERIFY(walk.sound());
    }
};

GRIPSCOPE_TEST(FitLayoutTest)
#include "fit_layout_test.moc"
