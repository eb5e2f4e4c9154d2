// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/reference_words.h"
#include "ui/pages/calibrate/calibrate_parts.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/quantity_box.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr std::pair<double, double> forces_N{0, 1000};
constexpr double leastForce_N = 0.1;

void addField(QGridLayout* grid, int row, int column, int span, const QString& name, QWidget* field)
{
    field->setAccessibleName(name);
    auto* label = makeLabel(name, "strong", field->parentWidget());
    label->setBuddy(field);
    grid->addWidget(label, row, column, 1, span);
    grid->addWidget(field, row + 1, column, 1, span);
}

const RegisteredDialog<ReferenceDialog> referenceDialogRow("reference", [](Workbench&, QWidget* over) {
    return new ReferenceDialog({}, over);
});
} // namespace

ReferenceDialog::ReferenceDialog(const ReferenceObject& reference, QWidget* parent)
    : Dialog(parent), m_known(reference), m_name(new QLineEdit(this)), m_certificate(new QLineEdit(this)),
      m_bias(new QuantityBox(fieldUnit(MechanicalQuantity::Force), forces_N, leastForce_N, this)),
      m_peak(new QuantityBox(fieldUnit(MechanicalQuantity::Force), forces_N, leastForce_N, this)),
      m_squeezes(new QSpinBox(this)), m_interval(new QComboBox(this)), m_words(makeLabel({}, "error", this)),
      m_keep(makeButton(tr("Use this object"), u"dialog-ok-apply"_s, "primary", this))
{
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("referenceDialog");
    setManualPage(u"calibrate"_s);
    setWindowTitle(tr("Reference object"));
    build();
    show(reference);
    for (QLineEdit* field : {m_name, m_certificate})
        connect(field, &QLineEdit::textChanged, this, &ReferenceDialog::validate);
    for (const Quantity& quantity : m_quantities) {
        connect(quantity.stated, &QCheckBox::toggled, this, &ReferenceDialog::validate);
        for (QuantityBox* field : {quantity.value, quantity.uncertainty, quantity.tolerance})
            connect(field, &QDoubleSpinBox::valueChanged, this, &ReferenceDialog::validate);
    }
    for (QuantityBox* field : {m_bias, m_peak})
        connect(field, &QDoubleSpinBox::valueChanged, this, &ReferenceDialog::validate);
    validate();
}

void ReferenceDialog::build()
{
    m_name->setObjectName("referenceName");
    m_name->setPlaceholderText(tr("for instance Spring S-12"));
    m_certificate->setPlaceholderText(tr("number, if it has one"));
    m_peak->setPrefix(u"± "_s);
    m_squeezes->setRange(2, 20);
    m_interval->addItem(tr("4 hours"), 4);
    m_interval->addItem(tr("8 hours (a shift)"), 8);
    m_interval->addItem(tr("24 hours"), 24);
    m_interval->addItem(tr("a week"), 168);
    m_interval->addItem(tr("no check is asked for"), 0);
    m_keep->setObjectName("referenceKeep");
    m_keep->setDefault(true);
    m_words->setWordWrap(true);
    m_words->setMinimumHeight(40);

    auto* top = new QGridLayout;
    top->setHorizontalSpacing(16);
    top->setVerticalSpacing(4);
    addField(top, 0, 0, 1, tr("Object"), m_name);
    addField(top, 0, 1, 1, tr("Its certificate"), m_certificate);
    auto* stated = new QGridLayout;
    stated->setHorizontalSpacing(16);
    stated->setVerticalSpacing(4);
    const QString heads[] = {tr("Stated"), tr("Standard uncertainty"), tr("May differ by")};
    for (int i = 0; i < 3; ++i)
        stated->addWidget(makeLabel(heads[i], "caption", this), 0, i + 1);
    for (int row = 1; row <= 3; ++row)
        addQuantity(stated, row, std::size_t(3 - row)); // k first: the one that is always there
    auto* way = new QGridLayout;
    way->setHorizontalSpacing(16);
    way->setVerticalSpacing(4);
    addField(way, 0, 0, 1, tr("Preload"), m_bias);
    addField(way, 0, 1, 1, tr("Push and release"), m_peak);
    addField(way, 0, 2, 1, tr("Squeezes"), m_squeezes);
    addField(way, 0, 3, 1, tr("A check holds for"), m_interval);

    auto* cancel = makeButton(tr("Cancel"), {}, "", this);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_keep, &QPushButton::clicked, this, &QDialog::accept);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(m_keep);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 16);
    column->addLayout(top);
    column->addLayout(stated);
    column->addLayout(way);
    column->addWidget(m_words, 1);
    column->addLayout(buttons);
    resize(680, 480);
}

void ReferenceDialog::addQuantity(QGridLayout* grid, int row, std::size_t parameter)
{
    constexpr double most = 1e9;
    constexpr double largestUncertainty = 0.5;
    constexpr double largestTolerance = 1;
    constexpr double leastShare = 1e-4;
    constexpr double resolution[] = {1e-5, 0.01, 0.1};
    const ShownUnit percent{u"%"_s, 100};
    const QString name = ReferenceWords::quantity(parameter);
    Quantity& fields = m_quantities[parameter];
    fields = {
        new QCheckBox(name, this),
        new QuantityBox(displayUnit(ReferenceWords::unit(parameter)), {0, most}, resolution[parameter], this),
        new QuantityBox(percent, {0, largestUncertainty}, leastShare, this),
        new QuantityBox(percent, {0, largestTolerance}, leastShare, this)};
    fields.stated->setObjectName(u"referenceStated%1"_s.arg(parameter));
    fields.value->setObjectName(u"referenceValue%1"_s.arg(parameter));
    fields.tolerance->setObjectName(u"referenceTolerance%1"_s.arg(parameter));
    fields.value->setAccessibleName(name);
    fields.uncertainty->setAccessibleName(tr("%1, standard uncertainty").arg(name));
    fields.tolerance->setAccessibleName(tr("%1, may differ by").arg(name));
    grid->addWidget(fields.stated, row, 0);
    grid->addWidget(fields.value, row, 1);
    grid->addWidget(fields.uncertainty, row, 2);
    grid->addWidget(fields.tolerance, row, 3);
}

void ReferenceDialog::show(const ReferenceObject& reference)
{
    constexpr double usualUncertainty = 0.005;
    constexpr double usualTolerance = 0.05;
    m_name->setText(reference.name);
    m_certificate->setText(reference.certificate);
    for (std::size_t i = 0; i < m_quantities.size(); ++i) {
        const Quantity& fields = m_quantities[i];
        const std::optional<ReferenceQuantity>& stated = reference.stated[i];
        fields.stated->setChecked(stated || i == 2);
        fields.value->setSi(stated ? stated->value : 0);
        fields.uncertainty->setSi(stated ? stated->standardUncertainty / stated->value : usualUncertainty);
        fields.tolerance->setSi(stated ? stated->tolerance / stated->value : usualTolerance);
    }
    m_quantities[2].stated->setEnabled(false); // the stiffness is always stated
    m_bias->setSi(reference.bias_N);
    m_peak->setSi(reference.peak_N);
    m_squeezes->setValue(reference.squeezes);
    m_interval->setCurrentIndex(std::max(0, m_interval->findData(reference.intervalHours)));
}

ReferenceObject ReferenceDialog::reference() const
{
    ReferenceObject reference = m_known;
    reference.name = m_name->text().trimmed();
    reference.certificate = m_certificate->text().trimmed();
    for (std::size_t i = 0; i < m_quantities.size(); ++i) {
        const Quantity& fields = m_quantities[i];
        const double value = fields.value->si();
        reference.stated[i] = fields.stated->isChecked()
                                  ? std::optional(ReferenceQuantity{value, value * fields.uncertainty->si(),
                                                                    value * fields.tolerance->si()})
                                  : std::nullopt;
    }
    reference.bias_N = m_bias->si();
    reference.peak_N = m_peak->si();
    reference.squeezes = m_squeezes->value();
    reference.intervalHours = m_interval->currentData().toInt();
    return reference;
}

void ReferenceDialog::validate()
{
    for (const Quantity& fields : m_quantities)
        for (QuantityBox* field : {fields.value, fields.uncertainty, fields.tolerance})
            field->setEnabled(fields.stated->isChecked());
    const QString wrong = problemOf(reference()).describe();
    m_words->setText(wrong);
    m_keep->setEnabled(wrong.isEmpty());
}

} // namespace gripscope
