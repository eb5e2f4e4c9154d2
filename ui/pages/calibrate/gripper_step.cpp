// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/calibrate/gripper_step.h"

#include "core/base/words.h"
#include "ui/context/workbench.h"
#include "ui/format/fact.h"
#include "ui/format/parameter_text.h"
#include "ui/format/shown_unit.h"
#include "ui/pages/calibrate/gripper_texts.h"
#include "ui/pages/shared/enroll_recipe_form.h"
#include "ui/widgets/controls.h"

#include <QScrollArea>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

GripperStep::GripperStep(Workbench& bench, SeriesSession& session, QWidget* parent)
    : QWidget(parent), m_bench(&bench), m_session(&session)
{
}

EnrollRecipeForm* GripperStep::addForces()
{
    m_forces = new EnrollRecipeForm(*m_bench, EnrollRecipeForm::Gripped::Nothing, this);
    return m_forces;
}

void GripperStep::build(const QString& what, GuidedSqueezes::Script script)
{
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 8);
    auto* told = new QWidget(this);
    auto* inside = new QVBoxLayout(told);
    setSpacing(inside, 0, 8);
    auto* words = makeLabel(what, "second", told);
    words->setWordWrap(true);
    inside->addWidget(words);
    // What was found has the place that it needs; what was asked for is scrolled.
    QScrollArea* const scroll = makeScroll(told, this);
    scroll->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    column->addWidget(scroll);
    if (m_forces) {
        inside->addWidget(m_forces);
        column->addWidget(makeRule(this));
        script.obstacle = [this] {
            return m_forces->isValid() ? QString() : tr("Change the forces above first.");
        };
    }
    inside->addStretch(1);
    m_usable = script.usable;
    m_guide = new GuidedSqueezes(*m_bench, *m_session, std::move(script), this);
    if (m_forces)
        connect(m_forces, &EnrollRecipeForm::changed, m_guide, &GuidedSqueezes::refresh);
    connect(m_guide, &GuidedSqueezes::changed, this, [this] {
        if (m_forces)
            m_forces->setEnabled(!m_session->busy());
        emit changed();
    });
    column->addWidget(m_guide, 1);
}

void GripperStep::act()
{
    if (m_guide->button()->isEnabled())
        m_guide->act();
}

bool GripperStep::underWay() const
{
    return m_session->busy() ||
           (m_session->state() == SeriesSession::State::Measured && m_usable() && isVisible());
}

QString GripperStep::serial() const
{
    return m_bench->connection().identity().serial;
}

QString GripperStep::refused(const QString& problem)
{
    return problem.isEmpty() ? QString() : tr("Not valid, so nothing changes: %1").arg(asSentence(problem));
}

EmptyGripperStep::EmptyGripperStep(Workbench& bench, QWidget* parent)
    : GripperStep(bench, m_session, parent), m_session(bench.connection(), bench.library())
{
    EnrollRecipeForm* const forces = addForces();
    GuidedSqueezes::Script script;
    script.name = u"baseline"_s;
    script.begin = [] { return tr("Squeeze nothing (Space)"); };
    script.again = [] { return tr("Measure again (Space)"); };
    script.start = [this, forces] { return m_session.start(forces->recipe()); };
    script.found = [this] { return found(); };
    script.outcome = [this] { return outcome(); };
    script.use = tr("Take it off from now on");
    script.usable = [this] { return m_session.baseline().has_value(); };
    script.accept = [this] { return m_session.accept(); };
    build(tr("Fingers and drive have m, b, k and friction of their own, which add to the part's. Take "
             "everything "
             "out of the gripper: it squeezes nothing, %n times, with the force of the parts.",
             nullptr, BaselineSession::usualSqueezes),
          std::move(script));
}

QString EmptyGripperStep::found() const
{
    QStringList found;
    const GripperIdentity identity = bench().connection().identity();
    for (const Identification& squeeze : m_session.squeezes())
        found << tr("k %1").arg(parameterTexts(squeeze, identity.forceUnit, identity.positionUnit).k.text());
    return found.join(u"   ·   "_s);
}

QString EmptyGripperStep::outcome() const
{
    if (!m_session.baseline())
        return refused(m_session.problem());
    const GripperIdentity identity = bench().connection().identity();
    const ParameterTexts texts = GripperTexts::baseline(*m_session.baseline(), identity);
    QString numbers = tr("m %1, b %2, k %3 (95 %)").arg(texts.m.text(), texts.b.text(), texts.k.text());
    if (m_session.friction())
        numbers += tr(", friction %1").arg(GripperTexts::friction(*m_session.friction(), identity));
    return m_session.state() == SeriesSession::State::Stored
               ? tr("In use for gripper %1: %2.").arg(serial(), numbers)
               : tr("The empty gripper: %1.").arg(numbers);
}

FrameStep::FrameStep(Workbench& bench, QWidget* parent)
    : GripperStep(bench, m_session, parent), m_session(bench.connection(), bench.library())
{
    EnrollRecipeForm* const forces = addForces();
    GuidedSqueezes::Script script;
    script.name = u"frame"_s;
    script.begin = [] { return tr("Squeeze the block (Space)"); };
    script.again = [] { return tr("Measure again (Space)"); };
    script.start = [this, forces] { return m_session.start(forces->recipe()); };
    script.found = [this] { return found(); };
    script.outcome = [this] { return outcome(); };
    script.use = tr("Take it off from now on");
    script.usable = [this] { return m_session.compliance().has_value(); };
    script.accept = [this] { return m_session.accept(); };
    build(
        tr("Frame and fingers give way, which the position counts as the part's. Put in a steel block, which "
           "does not: it is squeezed %n times, with the force of the parts.",
           nullptr, FrameSession::usualSqueezes),
        std::move(script));
}

QString FrameStep::found() const
{
    QStringList found;
    for (const Identification& squeeze : m_session.squeezes())
        if (const QString text = GripperTexts::stiffness(squeeze, bench().connection().identity());
            !text.isEmpty())
            found << tr("k %1").arg(text);
    return found.join(u"   ·   "_s);
}

QString FrameStep::outcome() const
{
    if (!m_session.compliance())
        return refused(m_session.problem());
    const QString frame =
        GripperTexts::frame(m_session.compliance()->value, m_session.compliance()->standardError,
                            bench().connection().identity());
    return m_session.state() == SeriesSession::State::Stored
               ? tr("In use for gripper %1: the frame has %2.").arg(serial(), frame)
               : tr("The frame has %1 (95 %).").arg(frame);
}

LagStep::LagStep(Workbench& bench, QWidget* parent)
    : GripperStep(bench, m_session, parent), m_session(bench.connection(), bench.library())
{
    GuidedSqueezes::Script script;
    script.name = u"lag"_s;
    script.begin = [] { return tr("Squeeze %1 times").arg(LagSession::usualSqueezes); };
    script.again = [] { return tr("Measure again"); };
    script.start = [this] { return m_session.start(m_recipe); };
    script.found = [this] { return found(); };
    script.outcome = [this] { return outcome(); };
    script.use = tr("Use this lag");
    script.usable = [this] { return m_session.result().status == LagStatus::Measured; };
    script.accept = [this] { return m_session.accept(); };
    build(
        tr("A gripper samples the position a little later than the force. A lag of 100 µs that nobody knows "
           "of changes the mass of a can by a tenth. Grip something firm, a spring or a can of any type, and "
           "leave it there: the gripper squeezes it %1 times, with %2 for %3 s.")
            .arg(QString::number(LagSession::usualSqueezes), pushText(m_recipe.bias_N, m_recipe.peak_N),
                 Words::number(m_recipe.seconds)),
        std::move(script));
}

QString LagStep::found() const
{
    QStringList found;
    for (const LagEstimate& squeeze : m_session.squeezes())
        found << GripperTexts::lag(squeeze);
    return found.join(u"   ·   "_s);
}

QString LagStep::outcome() const
{
    const LagEstimate& result = m_session.result();
    if (m_session.state() == LagSession::State::Stored)
        return tr("In use: %1. It is kept for gripper %2, and its uncertainty goes into every error bar.")
            .arg(GripperTexts::lag(result), serial());
    return result.status == LagStatus::Measured
               ? tr("The position is sampled %1 (95 %) later than the force.").arg(GripperTexts::lag(result))
               : result.message.describe();
}

} // namespace gripscope
