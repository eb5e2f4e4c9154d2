// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/charting.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/layout_walk.h"
#include "tests/ui/shifting.h"
#include "tests/ui/studying.h"
#include "ui/pages/quality/shift/shift_views.h"

#include <QTabBar>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

/// The Quality page beside its list: what is asked for a study, its squeezes and its result, the charts, what
/// moved, and types on another gripper; in every theme, at every size, in both languages.
class QualityLayoutTest : public QObject {
    Q_OBJECT
    static inline const std::vector<QSize> sizes{{1440, 900}, leastSize};

private slots:
    void forms_data() { languageRows(); }
    void forms()
    {
        const RowLanguage language;
        WindowFixture f(true, u"virtual:"_s);
        LayoutWalk walk(*f.window);
        for (const char* kind : {"type1", "gauge", "linearity", "attributes"}) {
            f.window->showPage(u"quality"_s);
            f.clickWhenEnabled(f.find<QPushButton>(QByteArray("begin-").append(kind).constData()));
            QTRY_VERIFY(f.find<QLineEdit>("studyNameField")->isVisible());
            walk.whereTight(u"form %1"_s.arg(QLatin1StringView(kind)));
            f.click(f.find<QPushButton>("studyFormBack"));
        }
        QVERIFY(walk.sound());
    }

    void study_data() { languageRows(); }
    void study()
    {
        const RowLanguage language;
        WindowFixture f(false, unhurriedA);
        LayoutWalk walk(*f.window);
        studying::beginStudy(f, 3, u"Anna, Ben"_s, 2);
        walk.whereTight(u"gauge, asked"_s);
        while (studying::study(f).nextRow() && !QTest::currentTestFailed())
            studying::squeezeNext(f);
        walk.whereTight(u"gauge, all squeezed"_s);
        studying::pressSpaceOn(f, "studyAct");
        (void)studying::shownVerdict(f);
        walk.inAll(u"gauge, result"_s, sizes);
        QVERIFY(walk.sound());
    }

    void charts_data() { languageRows(); }
    void charts()
    {
        const RowLanguage language;
        WindowFixture f(true, {});
        LayoutWalk walk(*f.window);
        charting::openProcess(f);
        QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("processEmpty")->isVisible(), longEnough_ms);
        walk.whereTight(u"charts, nothing inspected"_s);
        charting::storeParts(f, 60, 10);
        charting::waitFor(f, 60);
        walk.inAll(u"charts"_s, sizes);
        auto* kinds = f.find<QComboBox>("processKind");
        for (int i = 1; i < kinds->count(); ++i) {
            charting::choose(f, "processKind", kinds->itemText(i));
            QTRY_VERIFY_WITH_TIMEOUT(charting::view(f).session().state() == ProcessSession::State::Shown &&
                                         int(charting::view(f).session().picture()->options.kind) == i,
                                     longEnough_ms);
            walk.whereTight(u"charts, "_s + kinds->itemText(i));
        }
        charting::choose(f, "processKind", kinds->itemText(0));
        charting::waitFor(f, 60);
        f.clickWhenEnabled(f.find<QPushButton>("processFilters"));
        QTRY_VERIFY(f.find<QComboBox>("processOperator")->isVisible());
        walk.whereTight(u"charts, filters"_s);
        f.click(f.find<QPushButton>("processFilters"));
        f.find<QLineEdit>("processLower")->setText(QLocale().toString(9.9, 'f', 1));
        f.find<QLineEdit>("processUpper")->setText(QLocale().toString(10.1, 'f', 1));
        QTest::keyClick(f.find<QLineEdit>("processUpper"), Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(charting::view(f).session().state() == ProcessSession::State::Shown,
                                 longEnough_ms);
        walk.whereTight(u"charts, tolerance"_s);
        QVERIFY(walk.sound());
    }

    void drift_data() { languageRows(); }
    void drift()
    {
        const RowLanguage language;
        WindowFixture f(true, unhurriedA);
        LayoutWalk walk(*f.window);
        shifting::openView(f, "openDrift");
        QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("driftCause")->isVisible(), longEnough_ms);
        walk.whereTight(u"what moved, nothing inspected"_s);
        f.click(f.find<QPushButton>("driftBack"));
        shifting::judgeMovedParts(f, 22);
        shifting::openView(f, "openDrift");
        const auto* view = f.window->findChild<DriftView*>();
        QTRY_VERIFY_WITH_TIMEOUT(view->look() && view->look()->change, longEnough_ms);
        walk.inAll(u"what moved"_s, sizes);
        auto* tabs = f.find<QTabBar>("driftTabs");
        for (int tab = 1; tab < tabs->count(); ++tab) {
            tabs->setCurrentIndex(tab);
            walk.whereTight(u"what moved, "_s + tabs->tabText(tab));
        }
        QVERIFY(walk.sound());
    }

    void transfer_data() { languageRows(); }
    void transfer()
    {
        const RowLanguage language;
        WindowFixture f(true, unhurriedA);
        LayoutWalk walk(*f.window);
        shifting::openView(f, "beginTransfer");
        QTRY_VERIFY_WITH_TIMEOUT(f.window->findChild<QCheckBox*>(u"transferType-A"_s), longEnough_ms);
        walk.whereTight(u"another gripper, form"_s);
        f.click(f.find<QPushButton>("transferBack"));
        shifting::beginTransfer(f, 3);
        walk.whereTight(u"another gripper, asked"_s);
        while (shifting::transferStudy(f).nextRow() && !QTest::currentTestFailed())
            shifting::squeezeOne(f);
        QVERIFY(shifting::isLookedAt(f, 6));
        walk.whereTight(u"another gripper, all squeezed"_s);
        f.clickWhenEnabled(f.find<QPushButton>("transferFinish"));
        QTRY_VERIFY_WITH_TIMEOUT(f.find<QLabel>("transferVerdict")->isVisible(), longEnough_ms);
        walk.inAll(u"another gripper, result"_s, sizes);
        QVERIFY(walk.sound());
    }
};

GRIPSCOPE_TEST(QualityLayoutTest)
#include "quality_layout_test.moc"
