// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"
#include "ui/widgets/outcome_view.h"
#include "ui/widgets/parameter_text.h"
#include "ui/widgets/type_map.h"
#include "ui/widgets/verdict_panel.h"
#include "ui/widgets/yield_strip.h"

#include <QPainter>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace gripscope;

namespace {

constexpr InspectionOutcome all[] = {InspectionOutcome::AsExpected, InspectionOutcome::OtherType,
                                     InspectionOutcome::Unknown, InspectionOutcome::Inconclusive,
                                     InspectionOutcome::NotValid};

QImage sign(InspectionOutcome outcome)
{
    QImage image(48, 48, QImage::Format_Grayscale8);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintOutcomeSign(painter, image.rect(), outcome, Qt::black);
    return image;
}

InspectSession::Result result(InspectionOutcome outcome)
{
    InspectSession::Result r;
    r.outcome = outcome;
    r.expectedType = u"A"_s;
    r.verdict.type = outcome == InspectionOutcome::OtherType ? u"B"_s : u"A"_s;
    r.verdict.nearest = u"A"_s;
    r.verdict.posterior = {{u"A"_s, 0.55}, {u"B"_s, 0.44}, {u"C"_s, 0.01}};
    return r;
}

} // namespace

/// What an inspection says on the screen.
class OutcomeViewTest : public QObject {
    Q_OBJECT
private slots:
    void signsDifferWithoutColour();
    void wordsDiffer();
    void headlinesNameWhatMatters();
    void everyWordReadsOnItsTint();
    void aLongNameStaysInsideThePanel();
    void parametersAreShownInSi();
    void anEllipseHoldsItsTypesSpread();
    void theStripKeepsFifty();
};

void OutcomeViewTest::signsDifferWithoutColour()
{
    for (const InspectionOutcome one : all)
        for (const InspectionOutcome other : all) {
            if (one == other)
                continue;
            const QImage a = sign(one);
            const QImage b = sign(other);
            int different = 0;
            for (int y = 0; y < 48; ++y)
                for (int x = 0; x < 48; ++x)
                    different += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 128;
            QVERIFY(different > 100); // of 2,304: well over what antialiasing alone could make
        }
}

void OutcomeViewTest::wordsDiffer()
{
    QStringList words;
    for (const InspectionOutcome outcome : all)
        words << outcomeWord(outcome);
    QCOMPARE(QSet<QString>(words.begin(), words.end()).size(), 5);
}

void OutcomeViewTest::headlinesNameWhatMatters()
{
    QCOMPARE(verdictWords(result(InspectionOutcome::AsExpected)).headline, u"A"_s);
    QCOMPARE(verdictWords(result(InspectionOutcome::OtherType)).headline, u"B"_s);
    QVERIFY(verdictWords(result(InspectionOutcome::OtherType)).outcome.contains(u"expected A"_s));
    QCOMPARE(verdictWords(result(InspectionOutcome::Unknown)).headline, u"Unknown"_s);
    QCOMPARE(verdictWords(result(InspectionOutcome::Inconclusive)).headline, u"A or B?"_s);
    QVERIFY(verdictWords(result(InspectionOutcome::NotValid)).outcome.contains(u"not valid"_s));
}

void OutcomeViewTest::everyWordReadsOnItsTint()
{
    for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark}) {
        Theme::instance().apply(kind);
        for (const InspectionOutcome outcome : all)
            QVERIFY(Theme::contrastRatio(Theme::instance().outcomeColor(outcome),
                                         outcomeFill(outcome).color()) >= 4.5);
    }
    Theme::instance().apply(ThemeKind::HighContrast);
    QSet<int> patterns;
    for (const InspectionOutcome outcome : all)
        patterns << static_cast<int>(outcomeFill(outcome).style());
    QCOMPARE(patterns.size(), 5);
    Theme::instance().apply(ThemeKind::Light);
}

void OutcomeViewTest::aLongNameStaysInsideThePanel()
{
    Theme::instance().apply(ThemeKind::Light);
    VerdictPanel panel;
    panel.resize(480, 140);
    panel.showOutcome(InspectionOutcome::OtherType, u"Sparkling water with elderflower, 500 ml, returnable"_s,
                      u"other type; expected A"_s);
    const QImage image = panel.grab().toImage();
    const QColor ink = Theme::instance().tokens().otherType;
    for (int y = 8; y < image.height() - 8; ++y)
        for (int x = image.width() - 20; x < image.width() - 4; ++x)
            QVERIFY(image.pixelColor(x, y) != ink);
}

void OutcomeViewTest::parametersAreShownInSi()
{
    // N and mm: 9.99 N/mm is 9.99 kN/m. Half widths: 1.96 standard errors.
    const ParameterTexts texts =
        parameterTexts({3.96e-5, 0.043, 9.99}, Eigen::Vector3d(2e-7, 1e-4, 0.025), u"N"_s, u"mm"_s);
    QCOMPARE(texts.k.text(), u"9.99 ± 0.05\u00A0kN/m"_s);
    QCOMPARE(texts.m.text(), u"39.6 ± 0.4\u00A0g"_s);
    QVERIFY(texts.b.text().startsWith(u"43.0 ± 0.2"_s));
    const ParameterTexts printed = parameterTexts({0.5, 0.9, 0.98}, std::nullopt, u"1"_s, u"1"_s);
    QCOMPARE(printed.k.text(), u"0.980"_s);
}

void OutcomeViewTest::anEllipseHoldsItsTypesSpread()
{
    TypeModels models;
    models.covarianceLog = Eigen::Vector3d(1e-4, 4e-4, 9e-4).asDiagonal(); // 1, 2, 3 % in m, b, k
    const TypeModel type{u"A"_s, 10, Eigen::Vector3d(std::log(0.04), std::log(43), std::log(10000))};
    const std::vector<QPointF> edge = TypeMap::ellipse(models, type);
    double widest = 0;
    double tallest = 0;
    for (const QPointF& p : edge) {
        widest = std::max(widest, std::abs(std::log(p.x() / 10000)));
        tallest = std::max(tallest, std::abs(std::log(p.y() / 43)));
    }
    // sqrt of the chi-square quantile, 2 degrees of freedom, 0.95: 2.4477. 64 corners miss the tip by 0.1 %.
    QVERIFY(std::abs(widest / (0.03 * 2.4477) - 1) < 2e-3);
    QVERIFY(std::abs(tallest / (0.02 * 2.4477) - 1) < 2e-3);
}

void OutcomeViewTest::theStripKeepsFifty()
{
    YieldStrip strip;
    strip.setOutcomes(std::deque<InspectionOutcome>(80, InspectionOutcome::AsExpected));
    QVERIFY(strip.accessibleName().contains(u"50"_s));
}

GRIPSCOPE_TEST(OutcomeViewTest)
#include "outcome_view_test.moc"
