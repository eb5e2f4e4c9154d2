// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/enroll_steps.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/layout_walk.h"
#include "tests/ui/workbench_fixture.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;
using Step = EnrollSession::Step;

/// Each step of an enrolment, one after another.
class EnrollLayoutTest : public QObject {
    Q_OBJECT

    static void squeeze(WindowFixture& f)
    {
        f.clickWhenEnabled(f.find<QPushButton>("enrollSqueezeButton"));
        QTRY_VERIFY(f.find<QPushButton>("acceptButton")->isVisible());
    }

private slots:
    void everyStep_data() { languageRows(); }
    void everyStep()
    {
        const RowLanguage language;
        WindowFixture f(true, u"virtual:?object=0.031,52,13500&seed=3&speed=0"_s);
        LayoutWalk walk(*f.window);
        enterTypeName(f, u"Cola 330 ml"_s);
        walk.whereTight(u"recipe"_s);
        f.click(f.find<QPushButton>("leaveForLater"));
        QTRY_VERIFY(f.window->findChild<QPushButton*>(u"goOnWithDraft"_s));
        walk.whereTight(u"name, one begun before"_s);
        f.click(f.find<QPushButton>("goOnWithDraft"));
        QTRY_COMPARE(f.bench->enrollment().step(), Step::Recipe);
        f.click(f.find<QPushButton>("recipeNext"));
        QTRY_COMPARE(f.bench->enrollment().step(), Step::Squeeze);
        walk.whereTight(u"squeeze, not armed"_s);
        f.find<QCheckBox>("acceptByItself")->setChecked(false);
        f.click(f.find<QPushButton>("enrollArmButton"));
        for (int i = 1; i <= EnrollSession::leastSqueezes; ++i) {
            squeeze(f);
            f.clickWhenEnabled(f.find<QPushButton>("acceptButton"));
            QTRY_COMPARE(f.bench->enrollment().acceptedCount(), i);
            if (i == 1)
                walk.whereTight(u"one squeeze"_s);
        }
        f.clickWhenEnabled(f.find<QPushButton>("reviewButton"));
        QTRY_COMPARE(f.bench->enrollment().step(), Step::Review);
        QTRY_COMPARE(f.find<QTableWidget>("heldOutTable")->rowCount(), 5);
        QTRY_VERIFY(!f.find<QLabel>("distanceLabel")->text().isEmpty());
        walk.whereTight(u"review"_s);
        f.click(f.find<QPushButton>("approveButton"));
        QTRY_COMPARE(f.bench->enrollment().step(), Step::Approved);
        QTRY_VERIFY(f.find<QLabel>("doneLabel")->isVisible());
        walk.whereTight(u"approved"_s);
        QVERIFY(walk.sound());
    }
};

GRIPSCOPE_TEST(EnrollLayoutTest)
#include "enroll_layout_test.moc"
