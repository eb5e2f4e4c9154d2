// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/workbench.h"
#include "ui/pages/inspect/inspect_parts.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/form_rows.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QVBoxLayout>

namespace gripscope {

namespace {

constexpr double confidence = 0.95;

QLabel* explanation(const QString& text, QWidget* parent)
{
    QLabel* label = makeLabel(text, "second", parent);
    label->setWordWrap(true);
    return label;
}

const RegisteredDialog<RatesDialog> ratesDialogRow("rates", [](Workbench& bench, QWidget* over) {
    return new RatesDialog(bench.rates().rates, true, over);
});
} // namespace

RatesDialog::RatesDialog(const VerdictOptions& rates, bool earlyEnd, QWidget* parent)
    : Dialog(parent), m_rates(rates)
{
    setObjectName("ratesDialog");
    setWindowTitle(tr("Rates"));
    setFixedWidth(560);
    build();
    fill(rates, earlyEnd);
    setMinimumHeight(layout()->totalHeightForWidth(width())); // what is explained may take two lines
}

QDoubleSpinBox* RatesDialog::addRate(QFormLayout* form, const QString& name, const QString& meaning)
{
    auto* field = new QDoubleSpinBox(this);
    field->setDecimals(3);
    field->setRange(0.001, 20);
    field->setSingleStep(0.1);
    field->setSuffix(tr(" %"));
    field->setAccessibleName(name);
    field->setAccessibleDescription(meaning);
    field->setFixedWidth(128);
    addFormRow(form, makeLabel(name, "strong", this), field);
    form->addRow(explanation(meaning, this));
    return field;
}

void RatesDialog::build()
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 8);
    QFormLayout* form = makeForm();
    m_falseReject = addRate(form, tr("False-reject rate"),
                            tr("Of the squeezes of enrolled types, the share that may be called unknown."));
    m_falseReject->setObjectName("falseRejectField");
    m_wrongType = addRate(form, tr("Wrong-type rate"),
                          tr("Of the squeezes of enrolled types, the share that may be named another type."));
    m_wrongType->setObjectName("wrongTypeField");
    m_strangerAccept = addRate(form, tr("Stranger-accept rate"),
                               tr("Of parts of no enrolled type, spread evenly over all that the gripper may "
                                  "meet, the share that may be named a type."));
    m_strangerAccept->setObjectName("strangerAcceptField");
    column->addLayout(form);
    column->addWidget(makeRule(this));
    column->addWidget(makeLabel(tr("The false-reject rate holds"), "strong", this));
    m_average = new QRadioButton(tr("on average over libraries"), this);
    m_confident = new QRadioButton(tr("for this library, with 95 % confidence (wider gates)"), this);
    m_confident->setObjectName("confidenceButton");
    m_robust = new QCheckBox(tr("Types spread unlike, or have wild squeezes among them (wider gates)"), this);
    m_robust->setObjectName("robustBox");
    m_early = new QCheckBox(tr("End a squeeze as soon as it is decided"), this);
    m_early->setObjectName("earlyEndBox");
    for (QWidget* choice : std::initializer_list<QWidget*>{m_average, m_confident, m_robust})
        column->addWidget(choice);
    column->addWidget(makeRule(this));
    column->addWidget(m_early);
    column->addSpacing(8);
    auto* buttons = new QDialogButtonBox(
        QDialogButtonBox::Ok | QDialogButtonBox::Cancel | QDialogButtonBox::RestoreDefaults, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons->button(QDialogButtonBox::RestoreDefaults), &QPushButton::clicked, this,
            [this] { fill({}, true); });
    column->addWidget(buttons);
}

void RatesDialog::fill(const VerdictOptions& rates, bool earlyEnd)
{
    m_falseReject->setValue(100 * rates.falseReject);
    m_wrongType->setValue(100 * rates.wrongType);
    m_strangerAccept->setValue(100 * rates.strangerAccept);
    (rates.confidence ? m_confident : m_average)->setChecked(true);
    m_robust->setChecked(rates.robust);
    m_early->setChecked(earlyEnd);
}

VerdictOptions RatesDialog::rates() const
{
    VerdictOptions rates = m_rates;
    rates.falseReject = m_falseReject->value() / 100;
    rates.wrongType = m_wrongType->value() / 100;
    rates.strangerAccept = m_strangerAccept->value() / 100;
    if (!m_confident->isChecked())
        rates.confidence.reset();
    else if (!rates.confidence)
        rates.confidence = confidence;
    rates.robust = m_robust->isChecked();
    return rates;
}

bool RatesDialog::earlyEnd() const
{
    return m_early->isChecked();
}

} // namespace gripscope
