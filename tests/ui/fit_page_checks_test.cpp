// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/format/estimate_words.h"
#include "ui/format/fact.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/theme/theme.h"

#include <QLabel>
#include <QTest>

using namespace gripscope;

namespace {

ValidityCheck check(const char* id, bool ok, const char* message)
{
    ValidityCheck result;
    result.id = QLatin1String(id);
    result.ok = ok;
    result.message = QString::fromUtf8(message);
    return result;
}

QStringList textsOf(const QWidget& widget)
{
    QStringList texts;
    for (const QLabel* label : widget.findChildren<QLabel*>())
        texts << label->text();
    return texts;
}

} // namespace

class FitPageChecksTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void whatFailedComesFirst()
    {
        CheckList list;
        Validity validity;
        validity.checks = {check("fit", true, "the model follows the position"),
                           check("saturation", false, "3 samples are at the end")};
        list.setFindings(validity, {});
        const QStringList texts = textsOf(list);
        QCOMPARE(texts.size(), qsizetype(2));
        QCOMPARE(texts[0], QStringLiteral("<b>Saturation.</b> 3 samples are at the end."));
        QCOMPARE(texts[1], QStringLiteral("<b>Fit.</b> The model follows the position."));
    }
    void whatWasDoneBeforeStandsBelow()
    {
        CheckList list;
        Validity validity;
        validity.checks = {check("fit", true, "good")};
        PreparationStep step;
        step.id = QStringLiteral("clock_jitter");
        step.message = QStringLiteral("samples were moved to <a regular grid>");
        list.setFindings(validity, {step});
        const QStringList texts = textsOf(list);
        QCOMPARE(texts.size(), qsizetype(3));
        QCOMPARE(texts[1], QStringLiteral("Before the estimate"));
        QCOMPARE(texts[2],
                 QStringLiteral("<b>Clock jitter.</b> Samples were moved to &lt;a regular grid&gt;."));
        list.setFindings(validity, {});
        QCOMPARE(textsOf(list).size(), qsizetype(1));
    }
    void whatWasNotJudgedHasNoTick()
    {
        CheckList list;
        Validity validity;
        validity.checks = {check("fit", true, "the model follows the position"),
                           check("calibration", true, "not judged")};
        validity.checks[1].noted = true;
        list.setFindings(validity, {});
        const auto signs = list.findChildren<CheckSignLabel*>();
        QCOMPARE(signs.size(), qsizetype(2));
        QCOMPARE(signs[0]->accessibleName(), QStringLiteral("passed"));
        QCOMPARE(signs[1]->accessibleName(), QStringLiteral("noted"));
        QVERIFY(signs[0]->grab().toImage() != signs[1]->grab().toImage());
    }
    void aSymbolStaysAsItIs()
    {
        QCOMPARE(asSentence(QStringLiteral("m, b and k are above zero")),
                 QStringLiteral("m, b and k are above zero."));
        QCOMPARE(asSentence(QStringLiteral("a channel is stuck")), QStringLiteral("A channel is stuck."));
        QCOMPARE(asSentence(QStringLiteral("k")), QStringLiteral("k."));
    }
    void theVerdictIsNamedForAScreenReader()
    {
        ValidityLine line;
        line.setVerdict(ValidityVerdict::Suspect);
        QCOMPARE(line.accessibleName(), QStringLiteral("Measurement suspect"));
        line.setVerdict(ValidityVerdict::Invalid);
        QCOMPARE(line.accessibleName(), QStringLiteral("Measurement not valid"));
    }
};

GRIPSCOPE_TEST(FitPageChecksTest)
#include "fit_page_checks_test.moc"
