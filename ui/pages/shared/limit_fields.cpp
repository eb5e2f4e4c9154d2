// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/display_units.h"
#include "core/signal/recording/units.h"
#include "ui/format/reference_words.h"
#include "ui/pages/shared/type_limits_dialog.h"
#include "ui/widgets/controls.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// As a person reads the unit of a quantity of this type.
ShownUnit unitOfLimits(const TypeRecord& type, std::size_t place)
{
    if (const std::optional<double> si = siFactor(type.forceUnit, type.positionUnit)) {
        const ShownUnit shown = fieldUnit(MechanicalQuantity(place));
        return {shown.unit, shown.factor * *si};
    }
    const ParameterUnits units = parameterUnits(type.forceUnit, type.positionUnit);
    const QString unit = std::array{units.m, units.b, units.k}[place];
    return {unit == u"1"_s ? QString() : unit, 1};
}

} // namespace

LimitFields::LimitFields(QWidget* parent) : QWidget(parent)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(8);
    grid->setVerticalSpacing(8);
    grid->addWidget(makeLabel(tr("At least"), "caption"), 0, 1);
    grid->addWidget(makeLabel(tr("At most"), "caption"), 0, 2);
    const char* const names[3][2] = {
        {"lowerMass", "upperMass"}, {"lowerDamping", "upperDamping"}, {"lowerStiffness", "upperStiffness"}};
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        Row& row = m_rows[i];
        const QString quantity = ReferenceWords::quantity(i);
        row.lower = makeField(tr("%1, at least").arg(quantity), names[i][0]);
        row.upper = makeField(tr("%1, at most").arg(quantity), names[i][1]);
        row.unit = makeLabel({}, "caption");
        const int line = int(i) + 1;
        grid->addWidget(makeLabel(quantity), line, 0);
        grid->addWidget(row.lower.edit, line, 1);
        grid->addWidget(row.upper.edit, line, 2);
        grid->addWidget(row.unit, line, 3);
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
}

LimitFields::Field LimitFields::makeField(const QString& name, const char* objectName)
{
    Field field;
    field.edit = new QLineEdit(this);
    field.edit->setObjectName(QString::fromLatin1(objectName));
    field.edit->setAccessibleName(name);
    field.edit->setPlaceholderText(tr("open"));
    field.edit->setMaxLength(24);
    connect(field.edit, &QLineEdit::textChanged, this, &LimitFields::changed);
    return field;
}

void LimitFields::fill(Field& field, std::optional<double> value, double factor)
{
    field.was = value;
    QLocale plain;
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    field.text = value ? plain.toString(*value * factor, 'g', 7) : QString();
    field.edit->setText(field.text);
}

bool LimitFields::read(const Field& field, double factor, std::optional<double>& value)
{
    const QString text = field.edit->text().trimmed();
    value = field.was;
    if (text == field.text)
        return true;
    value.reset();
    bool isNumber = text.isEmpty();
    if (!isNumber) {
        const double number = QLocale().toDouble(text, &isNumber);
        isNumber = isNumber && std::isfinite(number);
        value = number / factor;
    }
    return isNumber;
}

void LimitFields::showType(const TypeRecord& type)
{
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        Row& row = m_rows[i];
        const ShownUnit unit = unitOfLimits(type, i);
        row.factor = unit.factor;
        row.unit->setText(unit.unit);
        const ToleranceLimits own = type.limits.quantities[i].value_or(ToleranceLimits{});
        fill(row.lower, own.lower, row.factor);
        fill(row.upper, own.upper, row.factor);
    }
}

std::optional<PartLimits> LimitFields::limits() const
{
    PartLimits limits;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        ToleranceLimits own;
        const Row& row = m_rows[i];
        if (!read(row.lower, row.factor, own.lower) || !read(row.upper, row.factor, own.upper))
            return {};
        if (own.lower || own.upper)
            limits.quantities[i] = own;
    }
    return limits;
}

} // namespace gripscope
