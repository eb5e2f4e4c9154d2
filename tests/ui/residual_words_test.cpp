// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "tests/ui/identification_example.h"
#include "ui/charts/fit_plots.h"
#include "ui/format/residual_words.h"
#include "ui/theme/theme.h"

#include <QTest>

using namespace gripscope;

class ResidualWordsTest : public QObject {
    Q_OBJECT

    static Identification withResiduals(double whitenessP, double independenceP)
    {
        Identification identification = test::identifiedCanA();
        for (Estimate& estimate : identification.estimates) {
            estimate.residuals.whitenessP = whitenessP;
            estimate.residuals.inputIndependenceP = independenceP;
        }
        identification.validity.checks.clear();
        return identification;
    }

private slots:
    void initTestCase() { Theme::instance().apply(ThemeKind::Light); }
    void pValuesHaveTheDigitsTheyCanCarry()
    {
        QCOMPARE(pValueText(0.3141), QStringLiteral("p = 0.31"));
        QCOMPARE(pValueText(0.0314), QStringLiteral("p = 0.031"));
        QCOMPARE(pValueText(0.00099), QStringLiteral("p < 0.001"));
        QCOMPARE(pValueText(0), QStringLiteral("p < 0.001"));
        QCOMPARE(pValueText(1), QStringLiteral("p = 1.00"));
    }
    void wordsFollowTheLevelOfTheChecks()
    {
        Identification identification = withResiduals(0.02, 0.0001);
        const Estimate* best = identification.best();
        const ResidualFindings usual = residualFindings(identification, best);
        QCOMPARE(usual.whiteness.words, QStringLiteral("white, p = 0.020"));
        QVERIFY(!usual.whiteness.doubtful);
        QCOMPARE(usual.inputIndependence.words, QStringLiteral("dependent, p < 0.001"));
        QVERIFY(usual.inputIndependence.doubtful);
        ValidityCheck strict;
        strict.id = QStringLiteral("residual_whiteness");
        strict.limit = 0.05;
        strict.ok = false;
        identification.validity.checks.push_back(strict);
        QCOMPARE(residualFindings(identification, best).whiteness.words,
                 QStringLiteral("not white, p = 0.020"));
        QVERIFY(residualFindings(identification, best).whiteness.doubtful);
    }
    void whatTheChecksLetPassIsNamedButNotMarked()
    {
        Identification identification = withResiduals(0.0001, 0.5);
        ValidityCheck passed;
        passed.id = QStringLiteral("residual_whiteness");
        passed.limit = 0.005;
        identification.validity.checks.push_back(passed);
        const Estimate* best = identification.best();
        QCOMPARE(residualFindings(identification, best).whiteness.words,
                 QStringLiteral("not white, p < 0.001"));
        QVERIFY(!residualFindings(identification, best).whiteness.doubtful);
        // The checks are about the recommended estimate only.
        QVERIFY(residualFindings(identification, identification.find(Estimator::Arx)).whiteness.doubtful);
    }
    void withoutAModelNothingIsClaimed()
    {
        const Identification identification = withResiduals(0.5, 0.5);
        QVERIFY(residualFindings(identification, nullptr).whiteness.words.isEmpty());
    }
    void thePlotsSayTheFindingInTheirTitle()
    {
        FitPlots plots;
        plots.show(withResiduals(0.31, 0.0001), Estimator::OutputError, QStringLiteral("N"),
                   QStringLiteral("m"));
        QCOMPARE(plots.autocorrelations()->accessibleName(),
                 QStringLiteral("Residual autocorrelation: white, p = 0.31"));
        QVERIFY(!plots.autocorrelations()->findingDoubtful());
        QCOMPARE(plots.crossCorrelations()->accessibleName(),
                 QStringLiteral("Residuals against force: dependent, p < 0.001"));
        QVERIFY(plots.crossCorrelations()->findingDoubtful());
        plots.clear();
        QCOMPARE(plots.autocorrelations()->accessibleName(), QStringLiteral("Residual autocorrelation"));
    }
};

GRIPSCOPE_TEST(ResidualWordsTest)
#include "residual_words_test.moc"
