// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/shared/enroll_recipe_form.h"

#include "core/base/words.h"
#include "core/session/enroll/enrollment_storage.h"
#include "core/session/squeeze/squeeze_job.h"
#include "ui/context/workbench.h"
#include "ui/format/recipe_words.h"
#include "ui/format/shown_unit.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/narrow_choice.h"
#include "ui/widgets/quantity_box.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

/// Made for all of its time, which what it is made of depends on. Where it looks alike throughout the first
/// second is enough; else all of it, in as many points as a picture has room for.
std::vector<double> worthShowing(std::vector<double> force_N, ExcitationKind kind, double sampleTime_s)
{
    constexpr std::size_t mostPoints = 4000;
    const bool changes = kind == ExcitationKind::PrbsSine || kind == ExcitationKind::PrbsHold ||
                         kind == ExcitationKind::Levels;
    const std::size_t all = force_N.size();
    const std::size_t stride = changes ? all / mostPoints + 1 : 1;
    const auto aSecond = static_cast<std::size_t>(std::ceil(1 / sampleTime_s));
    const std::size_t shown = changes ? all / stride : std::min(all, aSecond);
    for (std::size_t i = 0; i < shown; ++i)
        force_N[i] = force_N[i * stride];
    force_N.resize(shown);
    return force_N;
}

} // namespace

EnrollRecipeForm::EnrollRecipeForm(Workbench& workbench, Gripped gripped, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench)
{
    const ShownUnit force = fieldUnit(MechanicalQuantity::Force);
    constexpr double mostForce_N = 1000, leastForce_N = 0.1;
    m_bias = makeField(tr("Preload"), force, {0, mostForce_N}, leastForce_N);
    m_peak = makeField(tr("Push and release"), force, {leastForce_N, mostForce_N}, leastForce_N);
    m_bit = makeField(tr("Shortest push"), {u"ms"_s, 1e3}, {0.05e-3, 1}, 0.1e-3);
    m_seconds = makeField(tr("Length"), {u"s"_s, 1}, {0.1, 60}, 0.01);
    m_maxForce = makeField(tr("Crush limit"), force, {leastForce_N, mostForce_N}, leastForce_N);
    m_maxTravel = makeField(tr("Travel limit"), fieldUnit(MechanicalQuantity::Length), {1e-5, 1}, 1e-5);
    m_peak->setPrefix(u"± "_s);
    makeKind();
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(24);
    grid->setVerticalSpacing(2);
    QuantityBox* fields[] = {m_bias, m_peak, m_maxForce, m_bit, m_seconds, m_maxTravel};
    for (int i = 0; i < 6; ++i) {
        auto* label = makeLabel(fields[i]->accessibleName(), "strong", this);
        label->setBuddy(fields[i]);
        label->setContentsMargins(0, i < 3 ? 0 : 8, 0, 0);
        grid->addWidget(label, i / 3 * 2, i % 3);
        grid->addWidget(fields[i], i / 3 * 2 + 1, i % 3);
    }
    auto* kindLabel = makeLabel(tr("How the force goes"), "strong", this);
    kindLabel->setBuddy(m_kind);
    kindLabel->setContentsMargins(0, 8, 0, 0);
    grid->addWidget(kindLabel, 4, 0);
    grid->addWidget(m_kind, 5, 0);
    grid->addWidget(m_picture, 4, 1, 2, 2, Qt::AlignBottom);
    makeLevels();
    grid->addWidget(m_levelsRow, 6, 0, 1, 3);
    for (int column = 0; column < 3; ++column)
        grid->setColumnStretch(column, 1);
    m_summary = makeLabel({}, "second", this);
    m_summary->setObjectName("recipeSummary");
    m_summary->setWordWrap(true);
    m_summary->setMinimumHeight(40);
    grid->addWidget(m_summary, 7, 0, 1, 3);
    if (gripped == Gripped::Part) {
        m_expectation = new ExpectationView(workbench, this);
        grid->addWidget(m_expectation, 8, 0, 1, 3);
    }
    setFocusProxy(m_bias);
    connect(&workbench, &Workbench::connectionChanged, this, &EnrollRecipeForm::validate);
    setRecipe(recipeOfNewTypes(), false);
}

QuantityBox* EnrollRecipeForm::makeField(const QString& name, const ShownUnit& unit,
                                         std::pair<double, double> range_si, double resolution_si)
{
    auto* field = new QuantityBox(unit, range_si, resolution_si, this);
    field->setAccessibleName(name);
    connect(field, &QDoubleSpinBox::valueChanged, this, &EnrollRecipeForm::validate);
    return field;
}

void EnrollRecipeForm::setRecipe(const Recipe& recipe, bool readOnly)
{
    m_name = readOnly ? recipe.name : QString();
    const std::pair<QuantityBox*, double> values[] = {
        {m_bias, recipe.bias_N},     {m_peak, recipe.peak_N},         {m_bit, recipe.bit_s},
        {m_seconds, recipe.seconds}, {m_maxForce, recipe.maxForce_N}, {m_maxTravel, recipe.maxTravel_m}};
    for (const auto& [field, value] : values) {
        const QSignalBlocker quiet(field);
        field->setSi(value);
        field->setEnabled(!readOnly);
    }
    m_levels = recipe.levels;
    m_levelsRow->setEnabled(!readOnly);
    const QSignalBlocker quiet(m_kind);
    m_kind->setCurrentIndex(m_kind->findData(static_cast<int>(recipe.kind)));
    m_kind->setEnabled(!readOnly);
    if (m_expectation != nullptr) // there is nothing to choose by it
        m_expectation->setVisible(!readOnly);
    validate();
}

void EnrollRecipeForm::makeKind()
{
    constexpr int shortest = 8; // the fields beside it set the width
    m_kind = new NarrowChoice(shortest, this);
    m_kind->setObjectName("recipeKind");
    m_kind->setAccessibleName(tr("How the force goes"));
    for (const ExcitationKind kind : RecipeWords::kinds())
        m_kind->addItem(RecipeWords::name(kind), static_cast<int>(kind));
    m_picture = new ForcePicture(this);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &EnrollRecipeForm::validate);
}

void EnrollRecipeForm::makeLevels()
{
    m_levelsRow = new ForceLevelsRow(*m_workbench, this);
    m_levelsRow->setAllowed([this] { return recipe(); }, [this] { return gripper(); });
    connect(m_levelsRow, &ForceLevelsRow::designed, this, &EnrollRecipeForm::takeLevels);
    connect(m_levelsRow, &ForceLevelsRow::read, this, &EnrollRecipeForm::takeFile);
}

void EnrollRecipeForm::takeLevels(const ForceLevels& force)
{
    m_levels = force.levels;
    const QSignalBlocker quiet(m_bit);
    m_bit->setSi(force.bit_s);
    validate();
}

void EnrollRecipeForm::takeFile(const ForceLevels& force)
{
    for (const auto& [field, value] :
         {std::pair(m_bias, force.bias), {m_peak, force.peak}, {m_seconds, force.seconds()}}) {
        const QSignalBlocker quiet(field);
        field->setSi(value);
    }
    takeLevels(force);
}

ExcitationKind EnrollRecipeForm::kind() const
{
    return static_cast<ExcitationKind>(m_kind->currentData().toInt());
}

GripperIdentity EnrollRecipeForm::gripper() const
{
    constexpr double usual_s = 0.0005;
    GripperIdentity identity;
    if (m_workbench->connection().state() == ConnectSession::State::Connected)
        identity = m_workbench->connection().identity();
    if (!(identity.sampleTime_s > 0))
        identity.sampleTime_s = usual_s;
    return identity;
}

void EnrollRecipeForm::showForce(const Recipe& wanted)
{
    const GripperIdentity identity = gripper();
    std::vector<double> force_N;
    if (!forceProblem(wanted, identity))
        force_N = makeExcitation(excitationOptions(wanted, identity, 1)).value_or(force_N);
    m_picture->show(worthShowing(std::move(force_N), wanted.kind, identity.sampleTime_s), wanted.maxForce_N);
}

Recipe EnrollRecipeForm::recipe() const
{
    Recipe recipe;
    recipe.bias_N = m_bias->si();
    recipe.peak_N = m_peak->si();
    recipe.bit_s = m_bit->si();
    recipe.seconds = m_seconds->si();
    recipe.maxForce_N = m_maxForce->si();
    recipe.maxTravel_m = m_maxTravel->si();
    recipe.kind = kind();
    if (recipe.kind == ExcitationKind::Levels)
        recipe.levels = m_levels;
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
                  "least %1.")
            .arg(forceText(recipe.peak_N));
    ConnectSession& connection = m_workbench->connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    if (connected && !connection.identity().commandable)
        return {}; // nobody will ask it for that force
    if (const std::optional<Error> unfit = forceProblem(recipe, gripper()))
        return unfit->describe();
    if (!connected)
        return {};
    const GripperIdentity identity = connection.identity();
    if (recipe.bias_N + recipe.peak_N > identity.limits.maxForce_N)
        return tr("The largest force is %1, and this gripper allows %2. Choose less.")
            .arg(forceText(recipe.bias_N + recipe.peak_N), forceText(identity.limits.maxForce_N));
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
    const bool ofLevels = wanted.kind == ExcitationKind::Levels;
    m_levelsRow->setVisible(ofLevels);
    m_levelsRow->show(wanted);
    m_valid = wrong.isEmpty();
    m_summary->setText(
        m_valid ? RecipeWords::tells(wanted.kind) + u' ' +
                      tr("The force goes from %1 to %2 for %3 s. The gripper stops by itself at %4 or %5.")
                          .arg(forceText(wanted.bias_N - wanted.peak_N),
                               forceText(wanted.bias_N + wanted.peak_N), Words::number(wanted.seconds),
                               forceText(wanted.maxForce_N), lengthText(wanted.maxTravel_m))
                : wrong);
    setRole(m_summary, m_valid ? "second" : "error");
    showForce(wanted);
    if (m_expectation != nullptr)
        m_expectation->show(wanted, gripper());
    emit changed();
}

} // namespace gripscope
