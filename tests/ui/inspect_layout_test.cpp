// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/batch.h"
#include "devices/virtual/virtual_load.h"
#include "tests/ui/inspecting.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/layout_walk.h"
#include "ui/settings/values/settings.h"
#include "ui/widgets/fitted_label.h"
#include "ui/widgets/outcome_view.h"

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;
using namespace gripscope::test::inspecting;

/// Inspect beside the state of the tour: what a shift brings, with all that can be asked for shown at once.
class InspectLayoutTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { virtual_load::set(0); }

    void squeezesThatAreNotValid_data() { languageRows(); }
    void squeezesThatAreNotValid()
    {
        const RowLanguage language;
        Armed armed(u"virtual:?object=A&seed=8&fault=loss:0.35&speed=0"_s);
        WindowFixture& f = armed.f;
        LayoutWalk walk(*f.window);
        f.bench->inspection().setEarlyEnd(false); // a short squeeze may by chance have lost little
        f.bench->settings().set(setting::invalidInARow, 2.0);
        squeezeBySpace(f);
        QVERIFY(f.find<VerdictPanel>("verdictPanel")->outcome() == InspectionOutcome::NotValid);
        walk.whereTight(u"not valid"_s);
        squeezeBySpace(f);
        walk.whereTight(u"call the supervisor"_s);
        QVERIFY(walk.sound());
    }

    void aBatchThatIsOverAmongAllThatCanBeShown_data() { languageRows(); }
    void aBatchThatIsOverAmongAllThatCanBeShown()
    {
        const RowLanguage language;
        Armed armed;
        WindowFixture& f = armed.f;
        LayoutWalk walk(*f.window);
        f.bench->settings().set(setting::partNumbers, true);
        expectType(f, u"A"_s);
        walk.whereTight(u"part numbers, ready"_s);
        f.bench->inspection().beginBatch({u"4711"_s, 1, u"A"_s, {}});
        QTRY_VERIFY(f.bench->inspection().batch());
        scan(f, u"SN-0042"_s);
        squeezeBySpace(f);
        QTRY_VERIFY(f.find<FittedLabel>("batchCompleteLabel")->isVisible());
        walk.whereTight(u"batch over, part numbers"_s);
        f.bench->settings().set(setting::automaticSqueeze, true);
        QTRY_VERIFY(f.find<QLabel>("automaticLabel")->isVisible());
        walk.whereTight(u"batch over, part numbers, automatic"_s);
        f.bench->inspection().voidLast(u"squeezed twice"_s);
        QTRY_COMPARE(f.bench->inspection().counts().voided, qint64(1));
        walk.whereTight(u"batch ended, voided"_s);
        QTest::keyClick(f.window.get(), Qt::Key_Escape);
        QTRY_VERIFY(!f.bench->connection().armed());
        walk.whereTight(u"stopped"_s);
        QVERIFY(walk.sound());
    }

    /// Then the yield has its longest words.
    void partsThatNothingIsExpectedOf_data() { languageRows(); }
    void partsThatNothingIsExpectedOf()
    {
        const RowLanguage language;
        Armed armed;
        WindowFixture& f = armed.f;
        LayoutWalk walk(*f.window);
        squeezeBySpace(f);
        QVERIFY(f.find<VerdictPanel>("verdictPanel")->outcome() == InspectionOutcome::AsExpected);
        walk.whereTight(u"nothing expected"_s);
        expectType(f, u"A"_s);
        squeezeBySpace(f);
        walk.whereTight(u"expected, and nothing expected"_s);
        f.bench->inspection().beginBatch({u"4711"_s, 5, {}, {}});
        QTRY_VERIFY(f.bench->inspection().batch());
        squeezeBySpace(f);
        walk.whereTight(u"a batch of any type"_s);
        QVERIFY(walk.sound());
    }

    void theGripperIsGoneAfterAVerdict_data() { languageRows(); }
    void theGripperIsGoneAfterAVerdict()
    {
        const RowLanguage language;
        Armed armed;
        WindowFixture& f = armed.f;
        LayoutWalk walk(*f.window);
        expectType(f, u"B"_s);
        squeezeBySpace(f);
        QVERIFY(f.find<VerdictPanel>("verdictPanel")->outcome() == InspectionOutcome::OtherType);
        walk.whereTight(u"other type"_s);
        f.bench->connection().disconnect();
        QTRY_VERIFY(!f.find<VerdictPanel>("verdictPanel")->outcome());
        walk.whereTight(u"disconnected"_s);
        QVERIFY(walk.sound());
    }

    /// It lasts two seconds: one look, at the least size.
    void aCountdown_data() { languageRows(); }
    void aCountdown()
    {
        const RowLanguage language;
        Armed armed(u"virtual:?object=A&seed=5"_s);
        WindowFixture& f = armed.f;
        LayoutWalk walk(*f.window);
        f.bench->settings().set(setting::automaticSqueeze, true);
        const auto* panel = f.find<VerdictPanel>("verdictPanel");
        constexpr int tries = 10; // beside busy neighbours the gripper's watchdog may disarm it
        for (int i = 0; i < tries && !panel->alerts(); ++i) {
            virtual_load::set(0);
            f.bench->arm();
            QTRY_VERIFY(f.bench->connection().armed());
            QTest::qWait(2500); // the force at rest is learnt
            virtual_load::set(0.5);
            (void)QTest::qWaitFor([&] { return panel->alerts() || !f.bench->connection().armed(); },
                                  longEnough_ms);
        }
        QVERIFY(panel->alerts());
        walk.look(u"countdown, light 1024"_s);
        QVERIFY(walk.sound());
    }
};

GRIPSCOPE_TEST(InspectLayoutTest)
#include "inspect_layout_test.moc"
