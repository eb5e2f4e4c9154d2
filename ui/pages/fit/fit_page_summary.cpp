// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit/fit_page_summary.h"

#include "ui/charts/region_plot.h"
#include "ui/format/determined_text.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_budget.h"
#include "ui/models/estimate_table_model.h"
#include "ui/pages/fit/fit_page_validation.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/plain_text.h"

#include <QGridLayout>
#include <QResizeEvent>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr int narrowWidth = 420; // below, the numbers are set smaller
constexpr int checksTab = 2;

/// "9.98 ± 0.05 kN/m (95 %)", the last part small.
QString withCoverage(const QString& number)
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    return u"%1 <span style='font-size:%2px; font-weight:400; color:%3'>(95 %)</span>"_s
        .arg(number.toHtmlEscaped())
        .arg(metrics::fontSmall)
        .arg(tokens.secondText.name());
}

} // namespace

FitSummary::FitSummary(QWidget* parent)
    : QWidget(parent), m_title(new ElidedLabel), m_verdict(new ValidityLine), m_facts(new ElidedLabel),
      m_best(new QGridLayout), m_tabs(new QTabWidget), m_estimators(new EstimatorPanel),
      m_region(new RegionPlot), m_regionWords(makeLabel({}, "second")), m_checks(new CheckList),
      m_uncertainty(new UncertaintyPanel), m_models(new ModelPanel)
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 0);
    column->addWidget(buildHead());
    buildTabs();
    column->addWidget(m_tabs, 1);
    connect(m_estimators, &EstimatorPanel::estimatorChosen, this, &FitSummary::estimatorChosen);
    connect(&Theme::instance(), &Theme::changed, this, [this] { showBest(); });
}

QWidget* FitSummary::buildHead()
{
    auto* head = new QWidget;
    auto* column = new QVBoxLayout(head);
    column->setContentsMargins(2 * metrics::step, 12, 2 * metrics::step, metrics::insideControl);
    column->setSpacing(metrics::insideControl);
    setRole(m_title, "heading");
    m_title->setObjectName("fitTitle");
    setRole(m_facts, "caption");
    m_facts->setObjectName("fitFacts");
    auto* line = new QHBoxLayout;
    line->setSpacing(metrics::step);
    line->addWidget(m_title, 1);
    line->addWidget(m_verdict);
    m_best->setHorizontalSpacing(2 * metrics::step);
    m_best->setVerticalSpacing(2);
    m_best->setColumnStretch(1, 1);
    column->addLayout(line);
    column->addWidget(m_facts);
    column->addWidget(makeRule());
    column->addLayout(m_best);
    return head;
}

void FitSummary::buildTabs()
{
    m_tabs->setDocumentMode(true);
    m_tabs->setStyleSheet(u"QTabWidget > QStackedWidget { background: transparent; }"_s); // the card's
    m_tabs->tabBar()->setDrawBase(false);
    m_tabs->tabBar()->setExpanding(true);
    m_tabs->tabBar()->setAccessibleName(tr("Details of the fit"));
    m_tabs->tabBar()->setStyleSheet(u"QTabBar::tab { padding: 0 4px; }"_s); // five in a third of the window
    auto* region = new QWidget;
    auto* column = new QVBoxLayout(region);
    setSpacing(column, metrics::step, metrics::insideControl);
    m_regionWords->setWordWrap(true);
    column->addWidget(m_region, 1);
    column->addWidget(m_regionWords);
    addTab(m_estimators, tr("Estimators"));
    m_tabs->addTab(region, tr("Region")); // a picture takes the room there is, it does not scroll
    addTab(m_checks, tr("Checks"));
    addTab(m_uncertainty, tr("Uncertainty"));
    addTab(m_models, tr("Models"));
}

void FitSummary::addTab(QWidget* body, const QString& title)
{
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(metrics::step, metrics::step, metrics::step, 12);
    column->addWidget(body);
    QScrollArea* scroll = makeScroll(inside);
    scroll->setAccessibleName(title);
    m_tabs->addTab(scroll, title);
}

EstimateTableModel* FitSummary::table() const
{
    return m_estimators->model();
}

ValidationPanel* FitSummary::validation() const
{
    return m_models->validation();
}

void FitSummary::showValidation(const Validation& validation)
{
    m_identification.validation = validation;
    m_models->validation()->setValidation(validation, m_positionUnit);
}

void FitSummary::show(const QString& title, const Identification& identification, double length_s,
                      const QString& forceUnit, const QString& positionUnit)
{
    m_identification = identification;
    m_forceUnit = forceUnit;
    m_positionUnit = positionUnit;
    m_title->setFullText(title);
    const QString hold = identification.hold == ForceHold::Zero ? tr("force held") : tr("force linear");
    const QString facts =
        tr("length %1 · %2 samples · %3 between samples")
            .arg(formatLength(length_s), formatCount(qint64(identification.time_s.size())), hold);
    m_facts->setFullText(facts);
    m_verdict->setVerdict(identification.validity.verdict);
    showBest();
    m_estimators->setIdentification(identification, forceUnit, positionUnit);
    const UncertaintyBudget* budget = shownBudget(identification);
    m_region->setRegion(budget ? estimateRegion(identification, *budget) : estimateRegion(identification));
    m_regionWords->setText(m_region->region() ? correlationWords(*m_region->region()) : QString());
    m_regionWords->setVisible(m_region->region().has_value());
    m_checks->setFindings(identification.validity, identification.preparation);
    const auto failed =
        std::count_if(identification.validity.checks.begin(), identification.validity.checks.end(),
                      [](const ValidityCheck& check) { return !check.ok; });
    m_tabs->setTabText(checksTab, failed > 0 ? tr("Checks (%1)").arg(failed) : tr("Checks"));
    m_uncertainty->setIdentification(identification, forceUnit, positionUnit);
    m_models->setIdentification(identification, forceUnit, positionUnit);
    if (determinedParameters(identification, forceUnit, positionUnit).empty())
        m_tabs->setCurrentIndex(checksTab); // without an estimate they are all there is to read
}

void FitSummary::showBest()
{
    while (QLayoutItem* item = m_best->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const std::vector<DeterminedParameter> all =
        determinedParameters(m_identification, m_forceUnit, m_positionUnit);
    if (all.empty()) {
        m_best->addWidget(makeLabel(tr("No estimate"), "heading"), m_best->rowCount(), 0, 1, 2);
        return;
    }
    // Six numbers of the large ones would leave the tabs no room.
    constexpr std::size_t mostLarge = 3;
    const char* look = width() < narrowWidth || all.size() > mostLarge ? "heading" : "number";
    for (const DeterminedParameter& one : all) {
        const QString name = parameterName(one.parameter);
        const QString text = determinedText(one);
        const int at = m_best->rowCount();
        auto* value = makeMarkedLabel(one.interval ? withCoverage(text) : text.toHtmlEscaped(), look);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        value->setAccessibleName(u"%1: %2"_s.arg(name, text));
        QLabel* called = makeLabel(name, "second");
        called->setWordWrap(true); // a number never breaks
        m_best->addWidget(called, at, 0, Qt::AlignBaseline);
        m_best->addWidget(value, at, 1, Qt::AlignBaseline);
    }
}

void FitSummary::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if ((event->oldSize().width() < narrowWidth) != (event->size().width() < narrowWidth))
        showBest();
}

} // namespace gripscope
