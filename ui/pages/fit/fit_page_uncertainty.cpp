// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/uncertainty/derived_quantities.h"
#include "core/math/normal_interval.h"
#include "ui/format/derived_quantities.h"
#include "ui/format/interval_text.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_budget.h"
#include "ui/models/budget_table_model.h"
#include "ui/pages/fit/fit_page_summary.h"
#include "ui/pages/fit/fit_page_table.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QTableView>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

BudgetPanel::BudgetPanel(QWidget* parent)
    : QWidget(parent), m_model(new BudgetTableModel(this)), m_table(makePanelTable(m_model)),
      m_words(makeLabel({}, "second")), m_message(makeLabel({}, "second"))
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::insideControl);
    m_table->setItemDelegate(new BudgetDelegate(this));
    m_table->setAccessibleName(tr("Uncertainty budget"));
    addCopyAction(m_table, [this] { return m_model->toTsv(); });
    m_words->setWordWrap(true);
    m_message->setWordWrap(true);
    column->addWidget(m_table);
    column->addWidget(m_words);
    column->addWidget(m_message);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { showWords(now.row()); });
}

void BudgetPanel::setBudget(const UncertaintyBudget& budget, const QString& forceUnit,
                            const QString& positionUnit)
{
    m_model->setBudget(budget, forceUnit, positionUnit);
    m_table->setVisible(m_model->rowCount() > 0);
    fitPanelTable(m_table);
    m_message->setText(budget.message.describe());
    m_message->setVisible(!budget.message.isEmpty());
    m_table->selectRow(0);
    showWords(0);
}

void BudgetPanel::showWords(int row)
{
    const QModelIndex index = m_model->index(row, 0);
    const QString words = index.data(BudgetTableModel::WordsRole).toString();
    m_words->setText(words.isEmpty() ? QString() : tr("%1: %2").arg(index.data().toString(), words));
    m_words->setVisible(!words.isEmpty());
}

namespace {

std::vector<Fact> rowsOf(const std::vector<DerivedQuantity>& quantities)
{
    std::vector<Fact> rows;
    for (const DerivedQuantity& one : quantities) {
        QString name = one.name.describe();
        if (!name.isEmpty())
            name[0] = name[0].toUpper();
        const QString unit = one.unit == u"1" ? QString() : one.unit;
        rows.push_back({name, one.value ? intervalText(*one.value, one.interval, unit) : one.words.describe(),
                        one.value.has_value()});
    }
    return rows;
}

/// From noise alone, without a budget.
std::vector<Fact> rowsOf(const Estimate& estimate)
{
    const auto derived = derivedQuantities(estimate);
    if (!derived)
        return {};
    const auto text = [](double value, const std::optional<double>& error, const QString& unit) {
        return formatNumber(value, error ? std::optional(*error * normal95) : std::nullopt, unit).text();
    };
    return {
        {UncertaintyPanel::tr("Natural frequency"),
         text(derived->naturalFrequency_Hz, derived->naturalFrequencyError_Hz, u"Hz"_s)},
        {UncertaintyPanel::tr("Damping ratio"), text(derived->dampingRatio, derived->dampingRatioError, {})}};
}

} // namespace

UncertaintyPanel::UncertaintyPanel(QWidget* parent)
    : QWidget(parent), m_adviceHead(makeLabel(tr("What would make it better"), "strong")),
      m_advice(makeLabel({})), m_budgetHead(makeLabel(tr("What the error bars are made of"), "strong")),
      m_budget(new BudgetPanel),
      m_derivedHead(makeLabel(tr("What follows from m, b and k (95 %)"), "strong")), m_derived(makeFactGrid())
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    m_advice->setWordWrap(true);
    m_advice->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(m_adviceHead);
    column->addWidget(m_advice);
    column->addWidget(m_budgetHead);
    column->addWidget(m_budget);
    column->addWidget(m_derivedHead);
    column->addLayout(m_derived);
    column->addStretch();
}

void UncertaintyPanel::setIdentification(const Identification& identification, const QString& forceUnit,
                                         const QString& positionUnit)
{
    showAdvice(identification);
    showBudget(identification, forceUnit, positionUnit);
    showDerived(identification);
}

void UncertaintyPanel::showAdvice(const Identification& identification)
{
    QString advice = improvementAdvice(identification).join(u'\n');
    if (advice.isEmpty())
        advice = identification.validity.verdict == ValidityVerdict::Invalid
                     ? tr("The measurement is not valid. The failed checks say what to do first.")
                     : tr("Without error bars there is nothing to improve on. Squeeze again.");
    m_advice->setText(advice);
}

void UncertaintyPanel::showBudget(const Identification& identification, const QString& forceUnit,
                                  const QString& positionUnit)
{
    const UncertaintyBudget& budget = identification.budget;
    const bool any = budget.parameters || !budget.message.isEmpty();
    m_budgetHead->setVisible(any);
    m_budget->setVisible(any);
    m_budget->setBudget(budget, forceUnit, positionUnit);
}

void UncertaintyPanel::showDerived(const Identification& identification)
{
    std::vector<Fact> rows;
    if (const UncertaintyBudget* budget = shownBudget(identification))
        rows = rowsOf(derivedFrom(*budget));
    else if (const Estimate* best = identification.best())
        rows = rowsOf(*best);
    m_derivedHead->setVisible(!rows.empty());
    fillFacts(m_derived, rows);
}

} // namespace gripscope
