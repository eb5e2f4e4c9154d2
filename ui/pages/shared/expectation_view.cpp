// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "ui/context/workbench.h"
#include "ui/format/parameter_text.h"
#include "ui/format/shown_unit.h"
#include "ui/pages/shared/enroll_recipe_form.h"
#include "ui/widgets/controls.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

using P = MotionParameter;

/// "k ±0.2 %"; nothing where the squeeze does not tell.
QString told(const ModelExpectation& model, P parameter)
{
    const std::optional<double> half = model.of(parameter);
    return half ? u"%1\u00A0±%2\u00A0%"_s.arg(toString(parameter), Words::number(100 * *half, 'g', 2))
                : QString();
}

/// What it holds for, in the units that are shown.
QString conditions()
{
    const ExpectedPart part;
    const GripperIdentity si;
    const ParameterTexts texts =
        parameterTexts(MassDampingStiffness{part.m_kg, part.b_Ns_per_m, part.k_N_per_m}, std::nullopt,
                       si.forceUnit, si.positionUnit);
    return ExpectationView::tr(
               "Half-widths of 95 % intervals, at best, for %1, %2 and %3 with noise of %4; friction "
               "of %5 % of the push and release, and %6 % of k that goes on yielding over %7 % of the "
               "length.")
        .arg(texts.m.valueWithUnit(), texts.b.valueWithUnit(), texts.k.valueWithUnit(),
             lengthText(part.noise_m), Words::number(100 * part.frictionShare),
             Words::number(100 * part.relaxingShare), Words::number(100 * part.relaxationShare));
}

const ModelExpectation* modelWith(const std::vector<ModelExpectation>& models, const MotionTerms& terms)
{
    const auto found = std::ranges::find(models, terms, &ModelExpectation::terms);
    return found != models.end() && !found->relative.empty() ? &*found : nullptr;
}

} // namespace

ExpectationView::ExpectationView(Workbench& workbench, QWidget* parent)
    : QLabel(parent), m_workbench(&workbench)
{
    setObjectName("recipeExpectation");
    setWordWrap(true);
    setTextFormat(Qt::PlainText);
    setRole(this, "second");
}

void ExpectationView::show(const Recipe& recipe, const GripperIdentity& identity)
{
    m_recipe = recipe;
    m_identity = identity;
    m_changed = true;
    if (!m_busy)
        begin();
}

void ExpectationView::begin()
{
    m_busy = true;
    m_changed = false;
    m_workbench->background().compute<std::vector<ModelExpectation>>(
        this, [recipe = m_recipe, identity = m_identity] { return expectationOf(recipe, identity); },
        [this](const std::vector<ModelExpectation>& models) {
            m_busy = false;
            if (m_changed) {
                begin();
                return;
            }
            tell(models);
            emit shown();
        });
}

void ExpectationView::tell(const std::vector<ModelExpectation>& models)
{
    const ModelExpectation* const linear = modelWith(models, {});
    const ModelExpectation* const rubs = modelWith(models, {.friction = true});
    const ModelExpectation* const yields = modelWith(models, {.relaxation = true});
    setToolTip(conditions());
    if (linear == nullptr) {
        setText({});
        return;
    }
    // A further term lets k be less certain; what hides it makes it useless.
    QStringList parts{told(*linear, P::Mass), told(*linear, P::Damping), told(*linear, P::Stiffness)};
    if (rubs != nullptr)
        parts << tr("with friction %1").arg(told(*rubs, P::Stiffness));
    if (yields != nullptr)
        parts << tr("with yielding %1").arg(told(*yields, P::Stiffness));
    setText(tr("At best: %1.").arg(parts.join(u", "_s)));
}

} // namespace gripscope
