// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_uncertainty.h"

#include "ui/models/derived_quantities.h"
#include "ui/models/improvement_advice.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_format.h"

#include <QGridLayout>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double quantile975 = 1.959963984540054; // half a 95 % interval in standard errors

std::optional<double> halfWidth(const std::optional<double>& standardError)
{
    return standardError ? std::optional(*standardError * quantile975) : std::nullopt;
}

} // namespace

UncertaintyPanel::UncertaintyPanel(QWidget* parent)
    : QWidget(parent), m_adviceHead(makeLabel(tr("What would make it better"), "strong")),
      m_advice(makeLabel({})), m_derivedHead(makeLabel(tr("What follows from m, b and k (95 %)"), "strong")),
      m_derived(new QGridLayout)
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, metrics::step);
    m_advice->setWordWrap(true);
    m_advice->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_derived->setHorizontalSpacing(2 * metrics::step);
    m_derived->setVerticalSpacing(metrics::insideControl);
    m_derived->setColumnStretch(1, 1);
    column->addWidget(m_adviceHead);
    column->addWidget(m_advice);
    column->addWidget(m_derivedHead);
    column->addLayout(m_derived);
    column->addStretch();
}

void UncertaintyPanel::setIdentification(const Identification& identification, const QString&, const QString&)
{
    showAdvice(identification);
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

void UncertaintyPanel::showDerived(const Identification& identification)
{
    while (QLayoutItem* item = m_derived->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const Estimate* best = identification.best();
    const auto derived = best ? derivedQuantities(*best) : std::nullopt;
    m_derivedHead->setVisible(derived.has_value());
    if (!derived)
        return;
    const auto row = [this](const QString& name, const FormattedNumber& number) {
        const int at = m_derived->rowCount();
        auto* value = makeLabel(number.text(), "strong");
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        value->setAccessibleName(u"%1: %2"_s.arg(name, number.text()));
        m_derived->addWidget(makeLabel(name, "second"), at, 0, Qt::AlignBaseline);
        m_derived->addWidget(value, at, 1, Qt::AlignBaseline);
    };
    row(tr("Natural frequency"),
        formatNumber(derived->naturalFrequency_Hz, halfWidth(derived->naturalFrequencyError_Hz), u"Hz"_s));
    row(tr("Damping ratio"), formatNumber(derived->dampingRatio, halfWidth(derived->dampingRatioError), {}));
}

} // namespace gripscope
