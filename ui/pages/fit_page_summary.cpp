// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_summary.h"

#include "core/signal/units.h"
#include "ui/charts/fit_plots.h"
#include "ui/charts/region_plot.h"
#include "ui/models/estimate_table_model.h"
#include "ui/models/shown_unit.h"
#include "ui/pages/fit_page_checks.h"
#include "ui/pages/fit_page_estimators.h"
#include "ui/pages/fit_page_uncertainty.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"
#include "ui/widgets/number_format.h"

#include <QGridLayout>
#include <QResizeEvent>
#include <QScrollArea>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double quantile975 = 1.959963984540054; // half a 95 % interval in standard errors

constexpr int narrowWidth = 420; // below, the numbers are set smaller
constexpr int checksTab = 2;

std::optional<double> halfWidth(const std::optional<double>& standardError, double factor = 1)
{
    return standardError ? std::optional(*standardError * quantile975 * factor) : std::nullopt;
}

/// "9.98 ± 0.05 kN/m (95 %)", the last part small.
QString withInterval(const FormattedNumber& number)
{
    if (number.error.isEmpty())
        return number.text().toHtmlEscaped();
    const ThemeTokens& tokens = Theme::instance().tokens();
    return u"%1 <span style='font-size:%2px; font-weight:400; color:%3'>(95 %)</span>"_s
        .arg(number.text().toHtmlEscaped())
        .arg(metrics::fontSmall)
        .arg(tokens.secondText.name());
}

} // namespace

FitSummary::FitSummary(QWidget* parent)
    : QWidget(parent), m_title(new ElidedLabel), m_verdict(new ValidityLine), m_facts(new ElidedLabel),
      m_best(new QGridLayout), m_tabs(new QTabWidget), m_estimators(new EstimatorPanel),
      m_region(new RegionPlot), m_regionWords(makeLabel({}, "second")), m_checks(new CheckList),
      m_uncertainty(new UncertaintyPanel)
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
    setRole(m_facts, "caption");
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
    m_tabs->tabBar()->setStyleSheet(u"QTabBar::tab { padding: 0 8px; }"_s); // five in a third of the window
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
}

void FitSummary::addTab(QWidget* body, const QString& title)
{
    auto* inside = new QWidget;
    auto* column = new QVBoxLayout(inside);
    column->setContentsMargins(metrics::step, metrics::step, metrics::step, 12);
    column->addWidget(body);
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(inside);
    scroll->setAccessibleName(title);
    m_tabs->addTab(scroll, title);
}

EstimateTableModel* FitSummary::table() const
{
    return m_estimators->model();
}

void FitSummary::show(const QString& title, const Identification& identification, const QString& forceUnit,
                      const QString& positionUnit)
{
    m_identification = identification;
    m_forceUnit = forceUnit;
    m_positionUnit = positionUnit;
    m_title->setFullText(title);
    const double seconds = identification.sampleTime_s * double(identification.time_s.size());
    const QString hold = identification.hold == ForceHold::Zero ? tr("force held") : tr("force linear");
    const QString facts = tr("%1 samples · %2 · %3 between samples")
                              .arg(formatCount(qint64(identification.time_s.size())),
                                   formatNumber(seconds, std::nullopt, u"s"_s).valueWithUnit(), hold);
    m_facts->setFullText(facts);
    m_verdict->setVerdict(identification.validity.verdict);
    showBest();
    m_estimators->setIdentification(identification, forceUnit, positionUnit);
    m_region->setRegion(estimateRegion(identification));
    m_regionWords->setText(m_region->region() ? correlationWords(*m_region->region()) : QString());
    m_regionWords->setVisible(m_region->region().has_value());
    m_checks->setValidity(identification.validity);
    const auto failed =
        std::count_if(identification.validity.checks.begin(), identification.validity.checks.end(),
                      [](const ValidityCheck& check) { return !check.ok; });
    m_tabs->setTabText(checksTab, failed > 0 ? tr("Checks (%1)").arg(failed) : tr("Checks"));
    m_uncertainty->setIdentification(identification, forceUnit, positionUnit);
    if (!identification.best())
        m_tabs->setCurrentIndex(checksTab); // without an estimate they are all there is to read
}

void FitSummary::showBest()
{
    while (QLayoutItem* item = m_best->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const Estimate* best = m_identification.best();
    if (!best || !best->parameters) {
        m_best->addWidget(makeLabel(tr("No estimate"), "heading"), m_best->rowCount(), 0, 1, 2);
        return;
    }
    const bool narrow = width() < narrowWidth;
    const auto row = [this, narrow](const QString& name, const FormattedNumber& number) {
        const int at = m_best->rowCount();
        auto* label = makeLabel(name, "second");
        auto* value = makeLabel(withInterval(number), narrow ? "heading" : "number");
        value->setTextFormat(Qt::RichText);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        value->setAccessibleName(u"%1: %2"_s.arg(name, number.text()));
        m_best->addWidget(label, at, 0, Qt::AlignBaseline);
        m_best->addWidget(value, at, 1, Qt::AlignBaseline);
    };
    const std::optional<double> si = siFactor(m_forceUnit, m_positionUnit);
    const double factor = si.value_or(1);
    const ParameterUnits units =
        si ? parameterUnits(u"N"_s, u"m"_s) : parameterUnits(m_forceUnit, m_positionUnit);
    const auto errors = best->standardErrors();
    const QString names[] = {tr("Mass m"), tr("Damping b"), tr("Stiffness k")};
    const QString unitNames[] = {units.m, units.b, units.k};
    for (int i = 0; i < 3; ++i) {
        const double value = best->parameters->vector()[i] * factor;
        const ShownUnit shown = shownUnit(unitNames[i], std::abs(value));
        row(names[i],
            formatNumber(value * shown.factor,
                         errors ? halfWidth((*errors)[i], factor * shown.factor) : std::nullopt, shown.unit));
    }
}

void FitSummary::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if ((event->oldSize().width() < narrowWidth) != (event->size().width() < narrowWidth))
        showBest();
}

} // namespace gripscope
