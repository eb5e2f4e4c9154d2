// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_summary.h"

#include "core/signal/units.h"
#include "ui/charts/fit_plots.h"
#include "ui/models/derived_quantities.h"
#include "ui/models/estimate_delegate.h"
#include "ui/models/estimate_table_model.h"
#include "ui/pages/fit_page_checks.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_format.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QResizeEvent>
#include <QTableView>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double quantile975 = 1.959963984540054; // half a 95 % interval in standard errors

constexpr int narrowWidth = 420; // below, the numbers are set smaller

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
    : QScrollArea(parent), m_title(makeLabel({}, "title")), m_facts(makeLabel({}, "second")),
      m_bestName(makeLabel({}, "heading")), m_best(new QGridLayout), m_model(new EstimateTableModel(this)),
      m_table(new QTableView), m_note(makeLabel({}, "second")), m_checks(new CheckList)
{
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* body = new QWidget;
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(2 * metrics::step, 12, 2 * metrics::step, 2 * metrics::step);
    column->setSpacing(metrics::step);
    m_title->setWordWrap(true);
    m_facts->setWordWrap(true);
    m_note->setWordWrap(true);
    m_best->setHorizontalSpacing(2 * metrics::step);
    m_best->setVerticalSpacing(4);
    m_best->setColumnStretch(1, 1);
    buildTable();
    m_note->setText(
        tr("ARX predicts one step ahead from the last two measured positions. With noise that reads high "
           "even when m, b and k are far off: a good ARX prediction fit says nothing about them."));
    column->addWidget(m_title);
    column->addWidget(m_facts);
    column->addWidget(makeRule());
    column->addWidget(m_bestName);
    column->addLayout(m_best);
    column->addWidget(makeRule());
    column->addWidget(makeLabel(tr("Estimators"), "heading"));
    column->addWidget(m_table);
    column->addWidget(m_note);
    column->addWidget(makeRule());
    column->addWidget(m_checks);
    column->addStretch();
    setWidget(body);
    connect(&Theme::instance(), &Theme::changed, this, [this] { showBest(); });
}

void FitSummary::buildTable()
{
    m_table->setModel(m_model);
    m_table->setItemDelegate(new EstimateDelegate(this));
    m_table->setColumnHidden(int(EstimateTableModel::Column::Verdict),
                             true); // the delegate writes it below the name
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setFrameShape(QFrame::NoFrame);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->hide();
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_table->horizontalHeader()->setMinimumSectionSize(40);
    m_table->horizontalHeader()->setStyleSheet(
        u"QHeaderView::section { padding: 4px 5px; }"_s); // as the delegate's
    m_table->setAccessibleName(tr("Estimators against each other"));
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) {
                if (const auto estimator = m_model->estimatorAt(now.row()))
                    emit estimatorChosen(*estimator);
            });
}

void FitSummary::show(const QString& title, const Identification& identification, const QString& forceUnit,
                      const QString& positionUnit)
{
    m_identification = identification;
    m_forceUnit = forceUnit;
    m_positionUnit = positionUnit;
    m_title->setText(title);
    const double seconds = identification.sampleTime_s * double(identification.time_s.size());
    m_facts->setText(tr("%1 samples · %2 · force %3 between samples")
                         .arg(formatCount(qint64(identification.time_s.size())),
                              formatNumber(seconds, std::nullopt, u"s"_s).valueWithUnit(),
                              identification.hold == ForceHold::Zero ? tr("held") : tr("linear")));
    showBest();
    m_model->setIdentification(identification, forceUnit, positionUnit);
    m_note->setVisible(identification.find(Estimator::Arx) || identification.find(Estimator::ArxMeanForce) ||
                       identification.find(Estimator::Arx221));
    m_checks->setValidity(identification.validity);
    fitTable();
    if (const Estimate* best = identification.best())
        m_table->selectRow(m_model->rowOf(best->estimator));
}

void FitSummary::fitTable()
{
    m_table->resizeRowsToContents();
    int height = m_table->horizontalHeader()->sizeHint().height() + 4;
    for (int row = 0; row < m_model->rowCount(); ++row)
        height += m_table->rowHeight(row);
    m_table->setFixedHeight(height);
}

void FitSummary::showBest()
{
    while (QLayoutItem* item = m_best->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const Estimate* best = m_identification.best();
    if (!best || !best->parameters) {
        m_bestName->setText(tr("No estimate"));
        return;
    }
    m_bestName->setText(tr("Recommended: %1").arg(estimatorName(best->estimator)));
    const bool narrow = viewport()->width() < narrowWidth;
    const auto row = [this, narrow](const QString& name, const FormattedNumber& number, bool large) {
        const int at = m_best->rowCount();
        auto* label = makeLabel(name, narrow ? "caption" : "second");
        auto* value = makeLabel(withInterval(number), !large ? "strong" : narrow ? "heading" : "number");
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
    const auto shown = [](const QString& unit) { return unit == u"1" ? QString() : unit; };
    const auto errors = best->standardErrors();
    const auto error = [&](int i) { return errors ? halfWidth((*errors)[i], factor) : std::nullopt; };
    row(tr("Mass m"), formatNumber(best->parameters->m * factor, error(0), shown(units.m)), true);
    row(tr("Damping b"), formatNumber(best->parameters->b * factor, error(1), shown(units.b)), true);
    row(tr("Stiffness k"), formatNumber(best->parameters->k * factor, error(2), shown(units.k)), true);
    if (const auto derived = derivedQuantities(*best)) {
        row(tr("Natural frequency"),
            formatNumber(derived->naturalFrequency_Hz, halfWidth(derived->naturalFrequencyError_Hz), u"Hz"_s),
            false);
        row(tr("Damping ratio"),
            formatNumber(derived->dampingRatio, halfWidth(derived->dampingRatioError), {}), false);
    }
}

void FitSummary::resizeEvent(QResizeEvent* event)
{
    QScrollArea::resizeEvent(event);
    if ((event->oldSize().width() < narrowWidth) != (event->size().width() < narrowWidth))
        showBest();
}

QString FitSummary::toTsv() const
{
    return m_model->toTsv();
}

} // namespace gripscope
