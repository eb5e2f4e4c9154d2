// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/enroll_recipe_form.h"

#include "core/session/enrollment_storage.h"
#include "ui/widgets/controls.h"
#include "ui/workbench.h"

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>

using namespace Qt::StringLiterals;

namespace gripscope {

EnrollRecipeForm::EnrollRecipeForm(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench)
{
    m_bias = makeField(tr("Preload"), u"N"_s, 0, 1000, 1);
    m_peak = makeField(tr("Push and release"), u"N"_s, 0.1, 1000, 1);
    m_bit = makeField(tr("Shortest push"), u"ms"_s, 0.5, 1000, 1);
    m_seconds = makeField(tr("Length"), u"s"_s, 0.1, 60, 2);
    m_maxForce = makeField(tr("Crush limit"), u"N"_s, 0.1, 1000, 1);
    m_maxTravel = makeField(tr("Travel limit"), u"mm"_s, 0.01, 1000, 2);
    m_peak->setPrefix(u"± "_s);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(24);
    grid->setVerticalSpacing(4);
    QDoubleSpinBox* fields[] = {m_bias, m_peak, m_maxForce, m_bit, m_seconds, m_maxTravel};
    for (int i = 0; i < 6; ++i) {
        auto* label = makeLabel(fields[i]->accessibleName(), "strong", this);
        label->setBuddy(fields[i]);
        label->setContentsMargins(0, i < 3 ? 0 : 8, 0, 0);
        grid->addWidget(label, i / 3 * 2, i % 3);
        grid->addWidget(fields[i], i / 3 * 2 + 1, i % 3);
    }
    m_summary = makeLabel({}, "second", this);
    m_summary->setObjectName("recipeSummary");
    m_summary->setWordWrap(true);
    m_summary->setMinimumHeight(40);
    grid->addWidget(m_summary, 4, 0, 1, 3);
    setFocusProxy(m_bias);
    connect(&workbench, &Workbench::connectionChanged, this, &EnrollRecipeForm::validate);
    setRecipe({}, false);
}

QDoubleSpinBox* EnrollRecipeForm::makeField(const QString& name, const QString& unit, double low, double high,
                                            int decimals)
{
    auto* field = new QDoubleSpinBox(this);
    field->setDecimals(decimals);
    field->setRange(low, high);
    field->setSuffix(QChar(0x00A0) + unit);
    field->setAccessibleName(name);
    field->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    connect(field, &QDoubleSpinBox::valueChanged, this, &EnrollRecipeForm::validate);
    return field;
}

void EnrollRecipeForm::setRecipe(const Recipe& recipe, bool readOnly)
{
    m_name = readOnly ? recipe.name : QString();
    const std::pair<QDoubleSpinBox*, double> values[] = {
        {m_bias, recipe.bias_N},         {m_peak, recipe.peak_N},
        {m_bit, recipe.bit_s * 1e3},     {m_seconds, recipe.seconds},
        {m_maxForce, recipe.maxForce_N}, {m_maxTravel, recipe.maxTravel_m * 1e3}};
    for (const auto& [field, value] : values) {
        const QSignalBlocker quiet(field);
        field->setValue(value);
        field->setEnabled(!readOnly);
    }
    validate();
}

Recipe EnrollRecipeForm::recipe() const
{
    Recipe recipe;
    recipe.bias_N = m_bias->value();
    recipe.peak_N = m_peak->value();
    recipe.bit_s = m_bit->value() * 1e-3;
    recipe.seconds = m_seconds->value();
    recipe.maxForce_N = m_maxForce->value();
    recipe.maxTravel_m = m_maxTravel->value() * 1e-3;
    recipe.name = m_name.isEmpty() ? u"squeeze-%1N"_s.arg(recipe.peak_N) : m_name;
    return recipe;
}

QString EnrollRecipeForm::problem(const Recipe& recipe) const
{
    if (const std::optional<Error> error = recipeError(recipe))
        return error->describe();
    if (recipe.bias_N < recipe.peak_N)
        return tr("The push and release is larger than the preload: the gripper would have to pull. Raise "
                  "the preload to at "
                  "least %1 N.")
            .arg(recipe.peak_N);
    ConnectSession& connection = m_workbench->connection();
    if (connection.state() != ConnectSession::State::Connected || !connection.identity().commandable)
        return {};
    const GripperIdentity identity = connection.identity();
    if (recipe.bias_N + recipe.peak_N > identity.limits.maxForce_N)
        return tr("The largest force is %1 N, and this gripper allows %2 N. Choose less.")
            .arg(recipe.bias_N + recipe.peak_N)
            .arg(identity.limits.maxForce_N);
    if (identity.sampleTime_s > 0 &&
        recipe.seconds / identity.sampleTime_s > static_cast<double>(identity.limits.maxSamples))
        return tr("This gripper holds at most %1 s of force. Choose a shorter squeeze.")
            .arg(static_cast<double>(identity.limits.maxSamples) * identity.sampleTime_s);
    return {};
}

void EnrollRecipeForm::validate()
{
    const Recipe wanted = recipe();
    const QString wrong = problem(wanted);
    m_valid = wrong.isEmpty();
    m_summary->setText(
        m_valid ? tr("The force goes from %1 to %2 N for %3 s. The gripper stops by itself at %4 N or %5 mm.")
                      .arg(wanted.bias_N - wanted.peak_N)
                      .arg(wanted.bias_N + wanted.peak_N)
                      .arg(wanted.seconds)
                      .arg(wanted.maxForce_N)
                      .arg(wanted.maxTravel_m * 1e3)
                : wrong);
    setRole(m_summary, m_valid ? "second" : "error");
    emit changed();
}

} // namespace gripscope
