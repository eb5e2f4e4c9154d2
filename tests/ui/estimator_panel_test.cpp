// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/layout_walk.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/theme/elided_text.h"

#include <QScrollArea>
#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;

/// The numbers beside the estimators' names are whole however narrow the panel is: "k −2..." may be 2 or 20.
class EstimatorPanelTest : public QObject {
    Q_OBJECT
private slots:
    void atEveryWidth_data() { test::languageRows(); }
    void atEveryWidth()
    {
        const test::RowLanguage language;
        Theme::instance().apply(ThemeKind::Light);
        auto* panel = new EstimatorPanel;
        panel->setIdentification(test::identifiedCanA(), u"N"_s, u"m"_s);
        QScrollArea area; // its bar comes and goes with the height that the panel takes
        area.setWidgetResizable(true);
        area.setWidget(panel);
        area.show();
        test::LayoutWalk walk(area);
        for (int width = 560; width >= 360; width -= 20) {
            area.resize(width, 360);
            test::settleLayout();
            test::settleLayout(); // the heights of the rows follow, then the bar, then the width again
            walk.look(QString::number(width));
        }
        QVERIFY(walk.sound());
    }

    /// A column is made for the widest of its lines, which is then whole.
    void whatFitsToThePixelIsWhole()
    {
        const QFontMetrics metrics(Theme::font(metrics::fontSmall));
        for (const QString& text : {u"± 0.0010"_s, u"3.5071"_s, u"Stiffness k"_s}) {
            const int room = metrics.horizontalAdvance(text);
            QCOMPARE(elided(metrics, text, room), text);
            QVERIFY(elided(metrics, text, room - 1) != text);
        }
    }
};

GRIPSCOPE_TEST(EstimatorPanelTest)
#include "estimator_panel_test.moc"
