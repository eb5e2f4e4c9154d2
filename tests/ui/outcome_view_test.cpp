// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/charts/type_map.h"
#include "ui/format/outcome_words.h"
#include "ui/format/parameter_text.h"
#include "ui/format/yield_text.h"
#include "ui/sound/sound_player.h"
#include "ui/theme/theme.h"
#include "ui/widgets/inspection_widgets.h"
#include "ui/widgets/outcome_view.h"

#include <QPainter>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using namespace gripscope;

namespace {

constexpr InspectionOutcome allOutcomes[] = {
    InspectionOutcome::AsExpected,   InspectionOutcome::OtherType, InspectionOutcome::Unknown,
    InspectionOutcome::Inconclusive, InspectionOutcome::NotValid,  InspectionOutcome::DoesNotConform};

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
    void aLongNameIsStillReadFromAfar();
    void theVerdictFillsItsField();
    void theStripKeepsTwentyAndOpensTheOneThatIsClicked();
    void theYieldLeavesOutWhatWasNotJudged();
    void limitsAreSaidInOneSentence();
    void soundsAreToldApart();
};

void OutcomeViewTest::signsDifferWithoutColour()
{
    for (const InspectionOutcome one : allOutcomes)
        for (const InspectionOutcome other : allOutcomes) {
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
    for (const InspectionOutcome outcome : allOutcomes)
        words << outcomeWord(outcome);
    QCOMPARE(QSet<QString>(words.begin(), words.end()).size(), qsizetype(std::size(allOutcomes)));
}

void OutcomeViewTest::headlinesNameWhatMatters()
{
    QCOMPARE(verdictWords(result(InspectionOutcome::AsExpected)).headline, u"A"_s);
    // What is not in the library is marked, whatever the verdict is.
    for (const auto outcome : {InspectionOutcome::AsExpected, InspectionOutcome::Unknown}) {
        InspectSession::Result kept = result(outcome);
        const QString plain = verdictWords(kept).outcome;
        kept.keeping = InspectSession::Keeping::Stored;
        QCOMPARE(verdictWords(kept).outcome, plain);
        kept.keeping = InspectSession::Keeping::Waiting;
        QVERIFY(verdictWords(kept).outcome.contains(u"not stored yet"_s));
        kept.keeping = InspectSession::Keeping::Refused;
        QVERIFY(verdictWords(kept).outcome.contains(u"NOT STORED"_s));
    }
    QCOMPARE(verdictWords(result(InspectionOutcome::OtherType)).headline, u"B"_s);
    QVERIFY(verdictWords(result(InspectionOutcome::OtherType)).outcome.contains(u"expected A"_s));
    QCOMPARE(verdictWords(result(InspectionOutcome::Unknown)).headline, u"Unknown"_s);
    QCOMPARE(verdictWords(result(InspectionOutcome::Inconclusive)).headline, u"A or B?"_s);
    InspectSession::Result held = result(InspectionOutcome::Inconclusive);
    held.verdict.rival = u"B"_s;
    held.verdict.heldForStranger = true;
    held.verdict.reasons = {u"Too many other parts are like A."_s};
    QCOMPARE(verdictWords(held).headline, u"A?"_s);
    QCOMPARE(verdictWords(held).reason, u"Too many other parts are like A."_s);
    QVERIFY(verdictWords(result(InspectionOutcome::NotValid)).outcome.contains(u"not valid"_s));
    InspectSession::Result refused = result(InspectionOutcome::NotValid);
    refused.refused = true;
    refused.verdict.reasons = {u"Nobody is signed in."_s};
    QCOMPARE(verdictWords(refused).headline, u"Not judged"_s); // to squeeze again would not help
    QCOMPARE(verdictWords(refused).reason, u"Nobody is signed in."_s);
}

void OutcomeViewTest::everyWordReadsOnItsTint()
{
    for (const ThemeKind kind : {ThemeKind::Light, ThemeKind::Dark}) {
        Theme::instance().apply(kind);
        for (const InspectionOutcome outcome : allOutcomes) {
            const QColor color = Theme::instance().outcomeColor(outcome);
            QVERIFY(Theme::contrastRatio(color, outcomeFill(outcome).color()) >= 4.5);
            QVERIFY(Theme::contrastRatio(color, Theme::onColor(color)) >= 4.5); // the field is filled with it
        }
    }
    Theme::instance().apply(ThemeKind::HighContrast);
    QSet<int> patterns;
    for (const InspectionOutcome outcome : allOutcomes)
        patterns << static_cast<int>(outcomeFill(outcome).style());
    QCOMPARE(patterns.size(), qsizetype(std::size(allOutcomes)));
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
    const QColor ink = Theme::onColor(Theme::instance().tokens().otherType);
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

void OutcomeViewTest::aLongNameIsStillReadFromAfar()
{
    VerdictPanel panel;
    panel.showOutcome(InspectionOutcome::AsExpected, u"A"_s, u"as expected"_s);
    QVERIFY(panel.fitted(400, 110).pixels >= metrics::fontVerdict);
    // Two lines as soon as one would be small, broken where the lines are of a length.
    panel.showOutcome(InspectionOutcome::AsExpected, u"Sparkling water with elderflower"_s, u"as expected"_s);
    const VerdictPanel::Headline two = panel.fitted(430, 110);
    QCOMPARE(two.lines, QStringList({u"Sparkling water"_s, u"with elderflower"_s}));
    QVERIFY(two.pixels >= 36);
    // One word that is long gets as large as it can.
    panel.showOutcome(InspectionOutcome::AsExpected, u"Holunderblütensprudel"_s, u"as expected"_s);
    const VerdictPanel::Headline one = panel.fitted(430, 110);
    QCOMPARE(one.lines.size(), 1);
    QVERIFY(one.pixels > metrics::fontNumber);
    QCOMPARE(one.lines[0], u"Holunderblütensprudel"_s);
}

void OutcomeViewTest::theVerdictFillsItsField()
{
    Theme::instance().apply(ThemeKind::Light);
    VerdictPanel panel;
    panel.showOutcome(InspectionOutcome::AsExpected, u"A"_s, u"as expected"_s);
    // Twice the room, twice the letters; a name that is as wide as the field is bound by that.
    const int small = panel.fitted(600, 120).pixels;
    const int large = panel.fitted(1200, 240).pixels;
    QVERIFY2(std::abs(large - 2 * small) <= 8, qPrintable(u"%1, %2"_s.arg(small).arg(large)));
    panel.showOutcome(InspectionOutcome::AsExpected, u"Holunderblütensprudel"_s, u"as expected"_s);
    QVERIFY(panel.fitted(600, 240).pixels < large);
    QVERIFY(panel.fitted(600, 240).pixels > panel.fitted(430, 240).pixels);
    // And the outcome's colour is the field itself, not a tint: more than half of it.
    panel.showOutcome(InspectionOutcome::Unknown, u"Unknown"_s, u"none of the enrolled types"_s);
    panel.resize(700, 260);
    const QImage image = panel.grab().toImage();
    const QColor fill = Theme::instance().outcomeColor(InspectionOutcome::Unknown);
    int filled = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            filled += image.pixelColor(x, y).rgb() == fill.rgb() ? 1 : 0;
    QVERIFY(filled > image.width() * image.height() / 2);
}

void OutcomeViewTest::theStripKeepsTwentyAndOpensTheOneThatIsClicked()
{
    YieldStrip strip;
    std::deque<InspectionLine> lines;
    for (int i = 1; i <= 80; ++i)
        lines.push_back({i, u"g%1"_s.arg(i),
                         i % 8 ? InspectionOutcome::AsExpected : InspectionOutcome::Unknown, u"A"_s, 1});
    strip.setLines(lines);
    strip.resize(272, 64);
    QVERIFY(strip.accessibleName().contains(u"Last 20 inspections: 17"_s));
    qint64 opened = 0;
    QObject::connect(&strip, &YieldStrip::opened, &strip,
                     [&](const QString&, qint64 number) { opened = number; });
    QTest::mouseClick(&strip, Qt::LeftButton, {}, strip.cell(0).center());
    QCOMPARE(opened, 61);
    QTest::mouseClick(&strip, Qt::LeftButton, {}, strip.cell(19).center());
    QCOMPARE(opened, 80);
}

void OutcomeViewTest::theYieldLeavesOutWhatWasNotJudged()
{
    InspectionCounts counts;
    counts.total = 60;
    counts.invalid = 12;
    counts.inconclusive = 8;
    QVERIFY(yieldText(counts).isEmpty()); // nothing was judged
    counts.asExpected = 40;
    // 40 of 40: the exact two-sided lower bound is 0.025^(1/40) = 0.9119.
    QCOMPARE(yieldText(counts), u"100.0\u00A0% as expected (91.2 to 100.0\u00A0%)"_s);
    counts.otherType = 1;
    QVERIFY(!yieldText(counts).startsWith(u"100"_s));
    QVERIFY(yieldExplained(counts).contains(u"40 of 41"_s));
}

void OutcomeViewTest::limitsAreSaidInOneSentence()
{
    const auto said = [](double k, InspectionOutcome outcome) {
        InspectSession::Result r = result(outcome);
        PartLimits limits;
        limits.quantities[2] = ToleranceLimits{11500, 12500};
        r.verdict.conformity =
            *judgeConformity(limits, {std::nullopt, std::nullopt, MeasuredValue{k, 100}}, 1.0);
        return verdictWords(r);
    };
    const VerdictWords beyond = said(12900, InspectionOutcome::DoesNotConform);
    QCOMPARE(beyond.headline, u"A"_s);
    QCOMPARE(beyond.outcome, u"does not conform"_s);
    QCOMPARE(beyond.reason, u"Does not conform: k 12.9 kN/m is above 12.5 kN/m."_s);
    const VerdictWords near = said(12450, InspectionOutcome::Inconclusive);
    QCOMPARE(near.headline, u"A?"_s);
    QCOMPARE(near.outcome, u"too near the limit for this squeeze"_s);
    QVERIFY(near.reason.contains(u"the risk not to conform is 31 %"_s));
    QVERIFY(said(12000, InspectionOutcome::AsExpected).reason.startsWith(u"Conforms."_s));
}

void OutcomeViewTest::soundsAreToldApart()
{
    // By more than pitch: number of tones, length, or direction.
    QSet<QByteArray> allOutcomes;
    for (const Sound sound :
         {Sound::AsExpected, Sound::OtherType, Sound::Unknown, Sound::Inconclusive, Sound::NotValid,
          Sound::BatchWhole, Sound::CodeUnknown, Sound::Countdown, Sound::DoesNotConform}) {
        const std::vector<Tone> tones = tonesOf(sound);
        double seconds = 0;
        for (const Tone& tone : tones)
            seconds += tone.seconds;
        QVERIFY(seconds > 0.05 && seconds <= 0.5);
        QVERIFY((tones.size() == 1) == (sound == Sound::AsExpected || sound == Sound::NotValid));
        const QByteArray samples = samplesOf(tones);
        QVERIFY(std::abs(double(samples.size()) - 2 * seconds * soundRate_Hz) < 10);
        const auto* first = reinterpret_cast<const std::int16_t*>(samples.constData());
        QCOMPARE(int(first[0]), 0); // no click
        QVERIFY(std::abs(int(first[samples.size() / 2 - 1])) < 400);
        allOutcomes << samples;
    }
    QCOMPARE(allOutcomes.size(), 9);
    QVERIFY(tonesOf(Sound::NotValid)[0].seconds > 2 * tonesOf(Sound::AsExpected)[0].seconds);
}

GRIPSCOPE_TEST(OutcomeViewTest)
#include "outcome_view_test.moc"
