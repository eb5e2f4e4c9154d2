// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/csv.h"
#include "core/identification/uncertainty/derived_quantities.h"
#include "core/math/normal_interval.h"
#include "ui/context/navigator.h"
#include "ui/format/derived_quantities.h"
#include "ui/format/parameter_text.h"
#include "ui/format/shown_budget.h"
#include "ui/format/validation_words.h"
#include "ui/models/budget_table_model.h"
#include "ui/models/comparison_table_model.h"
#include "ui/models/estimate_table_model.h"
#include "ui/pages/fit/fit_page.h"
#include "ui/pages/fit/fit_page_export.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <QStringList>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString line(const QStringList& cells)
{
    return cells.join(u'\t') + u'\n';
}

QString derivedBlock(const Estimate& estimate)
{
    const auto derived = derivedQuantities(estimate);
    if (!derived)
        return {};
    const auto half = [](std::optional<double> error) {
        return error ? exactText(normal95 * *error) : QString();
    };
    return u'\n' + line({u"quantity"_s, u"value"_s, u"95 % half width"_s, u"unit"_s}) +
           line({u"natural frequency"_s, exactText(derived->naturalFrequency_Hz),
                 half(derived->naturalFrequencyError_Hz), u"Hz"_s}) +
           line({u"damping ratio"_s, exactText(derived->dampingRatio), half(derived->dampingRatioError), {}});
}

QString derivedBlock(const UncertaintyBudget& budget)
{
    QString text = u'\n' + line({u"quantity"_s, u"value"_s, u"95 % from"_s, u"95 % to"_s, u"unit"_s});
    for (const DerivedQuantity& one : derivedFrom(budget))
        text += line({one.name.english(), exactText(one.value), exactText(one.interval.lower),
                      exactText(one.interval.upper), one.unit});
    return text;
}

QString correlationBlock(const Estimate& estimate)
{
    const std::optional<Eigen::Vector3d> errors = estimate.standardErrors();
    if (!errors || !(errors->minCoeff() > 0))
        return {};
    QString text = u'\n' + line({u"correlation"_s, u"m"_s, u"b"_s, u"k"_s});
    for (int i = 0; i < 3; ++i) {
        QStringList cells{QString(u"mbk"_s[i])};
        for (int j = 0; j < 3; ++j)
            cells << exactText(i == j ? 1.0 : (*estimate.covariance)(i, j) / (*errors)[i] / (*errors)[j]);
        text += line(cells);
    }
    return text;
}

QString residualBlock(const Estimate& estimate)
{
    const ResidualSummary& residuals = estimate.residuals;
    return u'\n' + line({u"residual test"_s, u"p"_s}) +
           line({u"whiteness (Ljung-Box)"_s, exactText(residuals.whitenessP)}) +
           line({u"independence of the force (F)"_s, exactText(residuals.inputIndependenceP)});
}

QString checkBlock(const Validity& validity)
{
    QString text = u'\n' + line({u"check"_s, u"ok"_s, u"value"_s, u"limit"_s, u"message"_s});
    for (const ValidityCheck& check : validity.checks)
        text += line({check.id, check.ok ? u"yes"_s : u"no"_s, exactText(check.value), exactText(check.limit),
                      check.message.describe().simplified()});
    return text + line({u"verdict"_s, toString(validity.verdict)});
}

QString budgetBlock(const UncertaintyBudget& budget, const QString& forceUnit, const QString& positionUnit)
{
    BudgetTableModel table;
    table.setBudget(budget, forceUnit, positionUnit);
    return u'\n' + table.toTsv();
}

QString factBlock(const QString& head, const std::vector<Fact>& facts)
{
    if (facts.empty())
        return {};
    QString text = u'\n' + line({head});
    for (const Fact& fact : facts)
        text += line({fact.name, fact.text});
    return text;
}

} // namespace

QString fitNumbers(const Identification& identification, const QString& forceUnit,
                   const QString& positionUnit)
{
    EstimateTableModel estimates;
    estimates.setIdentification(identification, forceUnit, positionUnit);
    QString text = estimates.toTsv();
    const UncertaintyBudget* budget = shownBudget(identification);
    if (const Estimate* best = identification.best())
        text += (budget ? derivedBlock(*budget) : derivedBlock(*best)) + correlationBlock(*best) +
                residualBlock(*best);
    if (budget)
        text += budgetBlock(*budget, forceUnit, positionUnit);
    if (!identification.comparison.ranked.empty()) {
        ComparisonTableModel models;
        models.setComparison(identification.comparison);
        text += u'\n' + models.toTsv();
    }
    text += factBlock(u"validation"_s, validationFacts(identification.validation));
    if (identification.repetition)
        text += factBlock(u"periods"_s, periodFacts(*identification.repetition, forceUnit, positionUnit));
    return text + checkBlock(identification.validity);
}

QMenu* FitPage::makeCopyMenu(QWidget* parent, std::function<const FitSubject&()> subject,
                             std::function<void()> copied)
{
    using Wording = std::function<QString(const FitSubject&)>;
    auto* menu = new QMenu(parent);
    menu->setObjectName("copyMenu");
    const auto add = [menu, subject, copied](const QString& name, const QString& words, Wording wording) {
        QAction* action = menu->addAction(words, menu, [subject, copied, wording = std::move(wording)] {
            QGuiApplication::clipboard()->setText(wording(subject()));
            copied();
        });
        action->setObjectName(name);
    };
    add(u"copyText"_s, tr("Results, rounded (± 95 %)"), [](const FitSubject& one) {
        return resultsAsText(one.identification, one.title, one.recording.forceUnit,
                             one.recording.positionUnit);
    });
    add(u"copyLatex"_s, tr("Results for LaTeX (± 95 %)"), [](const FitSubject& one) {
        return resultsAsLatex(one.identification, one.title, one.recording.forceUnit,
                              one.recording.positionUnit);
    });
    add(u"copyCsv"_s, tr("Results as CSV, all digits"), [](const FitSubject& one) {
        return resultsAsCsv(one.identification, one.recording.forceUnit, one.recording.positionUnit);
    });
    menu->addSeparator();
    add(u"copyAll"_s, tr("Every number, all digits"), [](const FitSubject& one) {
        return fitNumbers(one.identification, one.recording.forceUnit, one.recording.positionUnit);
    });
    return menu;
}

} // namespace gripscope
