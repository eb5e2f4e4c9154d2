// SPDX-License-Identifier: GPL-3.0-or-later
// What a squeeze tells besides m, b and k, or in place of them, is shown where m, b and k are.
#include "core/identification/identification.h"
#include "core/math/gaussian.h"
#include "devices/virtual/virtual_part.h"
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "tests/ui/layout_languages.h"
#include "tests/ui/layout_walk.h"
#include "ui/format/parameter_text.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QFrame>
#include <QLabel>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>
#include <QVBoxLayout>

#include <random>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// Four levels about 20 N, as the default recipe has them.
Recording fourLevelSqueeze(const VirtualTerms& terms)
{
    Recording recording = simulatedSqueeze(test::canA, 1);
    VirtualPart part(test::canA, terms, 0.0005);
    std::mt19937_64 bits(5);
    GaussianNoise noise(6);
    double force = 20;
    for (int i = 0; i < 2000; ++i) // at rest under the preload
        part.advance(force);
    for (std::size_t i = 0; i < recording.size(); ++i) {
        if (i % 10 == 0)
            force = 10 + 20.0 / 3 * double(bits() % 4);
        recording.force[i] = force;
        recording.position[i] = part.position_m() + 5e-6 * noise();
        part.advance(force);
    }
    return recording;
}

QStringList shownNumbers(const Identification& identification)
{
    FitSummary summary;
    summary.resize(500, 800);
    summary.show(u"a squeeze"_s, identification, 1, u"N"_s, u"m"_s);
    summary.show();
    QStringList texts;
    for (const QLabel* label : summary.findChildren<QLabel*>())
        if (label->textInteractionFlags() == (Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard) &&
            label->accessibleName().contains(u": "_s))
            texts << label->accessibleName();
    return texts;
}

Identification held(const StiffnessBounds& bounds)
{
    Identification identification;
    Estimate& estimate = identification.estimates.emplace_back();
    estimate.estimator = Estimator::Static;
    estimate.status = EstimateStatus::NotIdentifiable;
    estimate.stiffnessBounds = bounds;
    identification.recommended = Estimator::Static;
    identification.validity.verdict = ValidityVerdict::Invalid;
    return identification;
}

} // namespace

class FitRealPartsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void mBAndKAloneStayThree()
    {
        const QStringList shown = shownNumbers(identify(fourLevelSqueeze({})));
        QCOMPARE(shown.size(), 3);
        QVERIFY(shown[0].startsWith(u"Mass m: "_s) && shown[2].startsWith(u"Stiffness k: "_s));
    }
    void aPartThatRubsShowsItsFriction()
    {
        VirtualTerms terms;
        terms.friction_N = 0.5;
        const Identification found = identify(fourLevelSqueeze(terms));
        QVERIFY(found.recommended == Estimator::Friction);
        const QStringList shown = shownNumbers(found);
        QCOMPARE(shown.size(), 4);
        QVERIFY2(shown[3].startsWith(u"Friction Fc: 50"_s) || shown[3].startsWith(u"Friction Fc: 49"_s),
                 qPrintable(shown[3])); // mN
        const QString text = resultsAsText(found, u"a"_s, u"N"_s, u"m"_s);
        QVERIFY2(text.contains(u"\nFc = "_s), qPrintable(text));
        QVERIFY(resultsAsLatex(found, u"a"_s, u"N"_s, u"m"_s).contains(u"$F_\\mathrm{c} = "_s));
        QVERIFY(resultsAsCsv(found, u"N"_s, u"m"_s).contains(u"\nFc,"_s));
    }
    void aPartThatYieldsShowsByWhatAndWithin()
    {
        VirtualTerms terms;
        terms.relaxingShare = 0.2;
        terms.relaxationTime_s = 0.03;
        const QStringList shown = shownNumbers(identify(fourLevelSqueeze(terms)));
        QCOMPARE(shown.size(), 5);
        QVERIFY2(shown[3].startsWith(u"Yielding stiffness k1: "_s), qPrintable(shown[3]));
        QVERIFY2(shown[4].startsWith(u"Yields within τ: 3"_s) || shown[4].startsWith(u"Yields within τ: 2"_s),
                 qPrintable(shown[4])); // ms
    }
    /// Five numbers in a third of the least window; a long name goes on in a second line.
    void aNumberIsNeverCut_data() { test::languageRows(); }
    void aNumberIsNeverCut()
    {
        const test::RowLanguage language;
        VirtualTerms terms;
        terms.relaxingShare = 0.2;
        terms.relaxationTime_s = 0.03;
        const Identification found = identify(fourLevelSqueeze(terms));
        auto* summary = new FitSummary;
        summary->show(u"a squeeze"_s, found, 1, u"N"_s, u"m"_s);
        QScrollArea area; // takes any width, as the page's splitter does
        area.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        area.setWidgetResizable(true);
        QFrame* card = makeCard(); // the ground that it stands on
        setSpacing(new QVBoxLayout(card), 0, 0);
        card->layout()->addWidget(summary);
        area.setWidget(card);
        area.show();
        test::LayoutWalk walk(area);
        for (const int width : {560, 480, 420, 390}) {
            area.resize(width, 700);
            test::settleLayout();
            QCOMPARE(card->width(), area.viewport()->width());
            walk.look(QString::number(width));
        }
        QVERIFY(walk.sound());
    }
    void aStiffnessKnownFromBelowIsSaidAsThat()
    {
        const Identification found = held({1500, {}});
        QCOMPARE(shownNumbers(found), QStringList{u"Stiffness k: at least 1.5\u00A0kN/m"_s});
        QVERIFY(resultsAsText(found, u"a"_s, u"N"_s, u"m"_s).contains(u"k: at least 1.5"_s));
        QVERIFY(resultsAsLatex(found, u"a"_s, u"N"_s, u"m"_s).contains(u"$k \\ge 1.5"_s));
        QVERIFY(resultsAsCsv(found, u"N"_s, u"m"_s).contains(u"\nk,,,1500,,N/m,invalid\n"_s));
    }
    void whatWasNotFoundIsNotShown()
    {
        Identification nothing = held({1, {}});
        nothing.estimates.front().stiffnessBounds.reset();
        QVERIFY(shownNumbers(nothing).isEmpty());
    }
};

GRIPSCOPE_TEST(FitRealPartsTest)
#include "fit_real_parts_test.moc"
