// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/validation/validation.h"
#include "core/session/enroll/enrollment_storage.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/core/identification/controlled_gripper.h"
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/science_pages.h"
#include "ui/charts/fit_plots.h"
#include "ui/format/validation_words.h"
#include "ui/pages/fit/fit_page.h"
#include "ui/pages/fit/fit_page_validation.h"

#include <QLabel>
#include <QMenu>
#include <QTabWidget>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

struct Shown {
    test::PageFixture fixture;
    FitPage page{fixture.bench};
    Recording recording = simulatedSqueeze(test::canA, 3);

    Shown()
    {
        page.resize(1200, 800);
        page.show();
        fixture.bench.navigator().setFitSubject({u"A, squeeze 3"_s, recording, identify(recording)});
    }
    [[nodiscard]] bool ready()
    {
        return QTest::qWaitFor([this] { return page.tourReady(); }, test::longEnough_ms);
    }
    [[nodiscard]] ValidationPanel* panel() const { return page.findChild<ValidationPanel*>(); }
    [[nodiscard]] QString words() const
    {
        QStringList texts;
        for (const QLabel* label : panel()->findChildren<QLabel*>())
            texts << label->text();
        return texts.join(u'\n');
    }
    [[nodiscard]] bool saysSoon(const QString& text)
    {
        return QTest::qWaitFor([&] { return words().contains(text); }, test::longEnough_ms);
    }
};

QAction* actionNamed(const QMenu* menu, const QString& text)
{
    for (QAction* action : menu->actions())
        if (action->text().startsWith(text))
            return action;
    return nullptr;
}

QString valueOf(const std::vector<Fact>& facts, const QString& name)
{
    for (const Fact& fact : facts)
        if (fact.name == name)
            return fact.text;
    return {};
}

} // namespace

class FitValidationTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void theRestOfTheRecordIsTheFirstJudge()
    {
        Shown shown;
        QVERIFY(shown.ready());
        QVERIFY2(shown.saysSoon(u"the last 800 samples"_s), qPrintable(shown.words()));
        QVERIFY(shown.words().contains(u"The misfit is no larger than noise"_s));
        QCOMPARE(shown.panel()->plot()->curves().size(), std::size_t(2));
    }
    void aFileIsHeldAgainst()
    {
        Shown shown;
        QVERIFY(shown.ready());
        const QString file = shown.fixture.folder.filePath(u"stiffer.csv"_s);
        QVERIFY(writeRecordingCsv(simulatedSqueeze({0.0396, 43.0, 12000}, 9), file));
        shown.page.findChild<ValidationChooser*>()->useFile(file);
        QVERIFY2(shown.saysSoon(u"stiffer.csv"_s), qPrintable(shown.words()));
        QVERIFY2(shown.words().contains(u"The model misses by more"_s), qPrintable(shown.words()));
        QVERIFY(shown.fixture.reports.isEmpty());
    }
    void aFileThatIsNotThereIsReported()
    {
        Shown shown;
        QVERIFY(shown.ready());
        const QString before = shown.words();
        shown.page.findChild<ValidationChooser*>()->useFile(u"/absent/squeeze.csv"_s);
        QTRY_COMPARE_WITH_TIMEOUT(shown.fixture.reports.size(), 1, test::longEnough_ms);
        QCOMPARE(shown.words(), before);
    }
    void aStoredSqueezeIsChosenFromTheMenu()
    {
        Shown shown;
        QVERIFY(shown.ready());
        bool stored = false;
        shown.fixture.bench.background().ask<StoredSqueeze>(
            &shown.page,
            [](Library& library) {
                const Recording recording = simulatedSqueeze(test::canA, 7);
                return storeSqueeze(library,
                                    {u"Cola"_s, {}, makeGrasp(recording, identify(recording), {}, {})});
            },
            [&](const Expected<StoredSqueeze>& answer) { stored = answer.has_value(); });
        QTRY_VERIFY_WITH_TIMEOUT(stored, test::longEnough_ms);
        shown.page.findChild<QTabWidget*>()->setCurrentIndex(4);
        QMenu* const menu = shown.panel()->choices();
        menu->popup(shown.page.mapToGlobal(QPoint(600, 100)));
        QTRY_VERIFY_WITH_TIMEOUT(actionNamed(menu, u"Cola"_s), test::longEnough_ms);
        QMenu* const type = actionNamed(menu, u"Cola"_s)->menu();
        QAction* const squeeze = actionNamed(type, u"Squeeze 1"_s);
        QVERIFY(squeeze);
        QTest::mouseClick(menu, Qt::LeftButton, {},
                          menu->actionGeometry(actionNamed(menu, u"Cola"_s)).center());
        QTRY_VERIFY_WITH_TIMEOUT(type->isVisible(), test::longEnough_ms);
        QTest::mouseClick(type, Qt::LeftButton, {}, type->actionGeometry(squeeze).center());
        QVERIFY2(shown.saysSoon(u"Cola, squeeze 1"_s), qPrintable(shown.words()));
        QVERIFY(shown.words().contains(u"The misfit is no larger than noise"_s));
    }
    void thePeriodsAreShownWhereTheForceRepeats()
    {
        const Recording recording = test::ControlledGripper().make();
        IdentificationOptions options;
        options.estimators = {Estimator::Periodic};
        const Identification found = identify(recording, options);
        QVERIFY(found.repetition);
        const std::vector<Fact> facts = periodFacts(*found.repetition, u"N"_s, u"m"_s);
        QVERIFY(valueOf(facts, u"Periods"_s).contains(u"of 248 samples"_s));
        QVERIFY(valueOf(facts, u"Force noise"_s).endsWith(u"N"_s));
        // Drift that a servo answers to: the two noises have much in common.
        QVERIFY2(periodSentence(*found.repetition).contains(u"The force answers to disturbances"_s),
                 qPrintable(periodSentence(*found.repetition)));
    }
    void whatWasNotSimulatedHasNoFacts()
    {
        QVERIFY(validationFacts({}).empty());
        ValidationPanel panel;
        panel.setValidation({}, u"m"_s);
        QVERIFY(!panel.plot()->isVisibleTo(&panel));
    }
};

GRIPSCOPE_TEST(FitValidationTest)
#include "fit_validation_test.moc"
