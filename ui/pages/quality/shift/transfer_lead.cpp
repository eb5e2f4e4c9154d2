// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/plan/plan_words.h"
#include "core/session/shift/transfer_watch.h"
#include "ui/charts/interval_plot.h"
#include "ui/context/connection_words.h"
#include "ui/context/workbench.h"
#include "ui/format/number_format.h"
#include "ui/pages/quality/shift/drift_charts.h"
#include "ui/pages/quality/shift/transfer_steps.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/progress.h"
#include "ui/windows/question.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QScrollArea>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

using TransferStep = StudySession::State;

namespace {

QMap<QString, int> placesOf(Workbench& bench)
{
    QMap<QString, int> places;
    for (const TypeRecord& type : bench.inspection().types())
        places.insert(type.name, type.place);
    return places;
}

} // namespace

TransferLead::TransferLead(Workbench& workbench, const TransferWatch& watch, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_watch(&watch)
{
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 16);
    row->addWidget(makeTask(), 5);
    row->addWidget(makeSide(), 3);
    connect(m_arm, &QPushButton::clicked, this, [this] { m_workbench->arm(); });
    connect(m_act, &QPushButton::clicked, this, &TransferLead::act);
    connect(m_finish, &QPushButton::clicked, this, &TransferLead::finish);
    connect(m_undo, &QPushButton::clicked, this, &TransferLead::undo);
    connect(m_skip, &QPushButton::clicked, this, &TransferLead::askSkip);
    connect(m_pause, &QPushButton::clicked, this, &TransferLead::paused);
    connect(m_giveUp, &QPushButton::clicked, this, &TransferLead::askGiveUp);
}

QWidget* TransferLead::makeTask()
{
    QFrame* card = makeCard(this);
    auto* content = new QWidget(card);
    auto* column = new QVBoxLayout(content);
    setSpacing(column, 0, 8);
    m_name = makeLabel({}, "caption", content);
    m_part = makeLabel({}, "", content);
    m_part->setObjectName("transferPart");
    m_part->setStyleSheet(u"font-size: 40px; font-weight: 600;"_s); // read from where the parts lie
    m_trial = makeLabel({}, "second", content);
    m_trial->setObjectName("transferTrial");
    m_why = makeLabel({}, "second", content);
    m_hint = makeLabel({}, "", content);
    m_hint->setObjectName("transferLeadHint");
    m_last = makeLabel({}, "second", content);
    m_last->setObjectName("transferLast");
    m_doubt = makeLabel({}, "error", content);
    m_doubt->setObjectName("transferDoubt");
    m_advice = makeLabel({}, "", content);
    m_advice->setObjectName("transferAdvice");
    m_plot = new IntervalPlot(content);
    m_plot->setObjectName("transferSoFar");
    for (QLabel* label : {m_name, m_part, m_trial, m_why, m_hint, m_last, m_doubt, m_advice}) {
        label->setWordWrap(true);
        column->addWidget(label);
    }
    column->addWidget(m_plot);
    column->addStretch(1);
    m_arm = makeButton(tr("Arm the gripper"), u"object-unlocked"_s, "primary", card);
    m_arm->setObjectName("transferArm");
    m_act = makeButton({}, {}, "primary", card);
    m_act->setObjectName("transferAct");
    auto* outer = new QVBoxLayout(card);
    setSpacing(outer, 16, 8);
    outer->addWidget(makeScroll(content, card), 1);
    outer->addWidget(m_arm);
    outer->addWidget(m_act);
    return card;
}

QWidget* TransferLead::makeSide()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    m_ring = new ProgressRing(card);
    m_words = makeLabel({}, "second", card);
    m_words->setObjectName("transferProgress");
    m_words->setWordWrap(true);
    m_words->setAlignment(Qt::AlignCenter);
    m_finish = makeButton(tr("Work out the adjustment"), {}, "", card);
    m_finish->setObjectName("transferFinish");
    m_undo = makeButton(tr("Take the last one back (Ctrl+Z)"), u"edit-undo"_s, "", card);
    m_undo->setObjectName("transferUndo");
    m_skip = makeButton(tr("Leave this one out…"), {}, "", card);
    m_skip->setObjectName("transferSkip");
    m_pause = makeButton(tr("Pause"), u"media-playback-pause"_s, "", card);
    m_pause->setObjectName("transferPause");
    m_pause->setToolTip(tr("Goes back to the list; the squeezes are kept and can be gone on with"));
    m_giveUp = makeButton(tr("Give up…"), {}, "quiet", card);
    m_giveUp->setObjectName("transferGiveUp");
    column->addWidget(m_ring, 1);
    column->addWidget(m_words);
    column->addStretch(1);
    for (QPushButton* button : {m_finish, m_undo, m_skip, m_pause, m_giveUp})
        column->addWidget(button);
    return card;
}

void TransferLead::refresh()
{
    const StudySession& session = m_workbench->study();
    if (!session.study())
        return;
    m_row = session.nextRow();
    refreshTask();
    refreshLook();
    refreshButtons();
    const StudyProgress progress = session.progress();
    m_ring->setCount(int(progress.done + progress.skipped), int(progress.rows.size()));
    m_ring->setRunning(session.state() == TransferStep::Squeezing ? session.squeezeProgress() : -1);
    m_words->setText(progressWords(progress).describe());
    const int shown = 4 * int(session.state()) + 2 * int(m_act->isEnabled()) + int(m_finish->isEnabled());
    if (shown != m_shown) {
        m_shown = shown;
        if (isVisible())
            focusNext();
    }
}

void TransferLead::refreshTask()
{
    const StudySession& session = m_workbench->study();
    const KeptStudy& study = *session.study();
    m_name->setText(study.record.study.name);
    m_part->setText(m_row ? tr("A part of %1").arg(study.plan.part(*m_row)) : tr("All squeezes are through"));
    m_trial->setVisible(m_row.has_value());
    m_why->setVisible(m_row.has_value());
    if (m_row) {
        m_trial->setText(tr("Squeeze %1 of %2 of this type")
                             .arg(study.plan.rows[*m_row].trial + 1)
                             .arg(study.plan.design.trials));
        m_why->setText(
            tr("Any good part of that type will do, another one each time if you have some: what two "
               "grippers differ by is held against how parts differ."));
    }
    m_hint->setText(hint());
    if (!session.refusal().empty()) {
        m_last->setText(tr("That squeeze does not count: %1 Squeeze a part of the same type again.")
                            .arg(described(session.refusal()).join(u' ')));
        return setRole(m_last, "error");
    }
    setRole(m_last, "second");
    m_last->setText(study.measurements.empty() ? tr("Each squeeze is stored at once.")
                    : study.measurements.back().undone
                        ? tr("The last squeeze was taken back; a part of its type comes again.")
                        : tr("The last squeeze is stored."));
}

QString TransferLead::hint() const
{
    const StudySession& session = m_workbench->study();
    const ConnectSession& connection = m_workbench->connection();
    switch (session.state()) {
    case TransferStep::Squeezing:
        return tr("Squeezing…");
    case TransferStep::Identifying:
        return tr("Finding m, b and k…");
    case TransferStep::Storing:
        return tr("Being stored…");
    default:
        break;
    }
    if (!m_row)
        return tr("Nothing can be taken back once the adjustment is worked out.");
    if (connection.state() != ConnectSession::State::Connected)
        return u"%1. %2."_s.arg(missingWords(connection).headline, missingWords(connection).detail);
    if (connection.identity().commandable && !connection.armed())
        return tr("Put the part between the fingers, hands clear, then arm.");
    return tr("Put the part between the fingers, hands clear, then press Space.");
}

void TransferLead::refreshLook()
{
    const std::optional<TransferLook>& look = m_watch->look();
    const std::optional<Error>& error = m_watch->error();
    m_doubt->setVisible(error || (look && look->doubt));
    if (error)
        m_doubt->setText(error->describe());
    else if (look && look->doubt)
        m_doubt->setText(keptTogether(look->doubt->describe()));
    const QString advice = look ? keptTogether(described(look->advice).join(u' ')) : QString();
    m_advice->setText(m_watch->busy() ? tr("%1 Being worked out…").arg(advice).trimmed() : advice);
    m_plot->setVisible(look && !look->report.types.empty());
    if (look)
        m_plot->setChart(DriftCharts::adjustment(*look, placesOf(*m_workbench)));
}

void TransferLead::refreshButtons()
{
    const StudySession& session = m_workbench->study();
    const ConnectSession& connection = m_workbench->connection();
    const bool waiting = session.state() == TransferStep::Waiting;
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const bool ready = connected && (connection.armed() || !connection.identity().commandable);
    const bool moving = session.state() == TransferStep::Squeezing;
    const std::optional<TransferLook>& look = m_watch->look();
    m_arm->setVisible(m_row && !ready && !moving);
    m_arm->setEnabled(connected);
    m_act->setVisible(m_row && (ready || moving));
    m_act->setText(moving ? tr("Squeezing…") : tr("Squeeze (Space)"));
    m_act->setEnabled(waiting && m_row && ready);
    const bool isKnown = look && look->report.error && !m_watch->busy();
    const bool isEnough = isKnown && look->acceptable();
    m_finish->setEnabled(waiting && isEnough);
    m_finish->setToolTip(isEnough
                             ? QString()
                             : tr("From three squeezes of each type on that fit one another; what is missing "
                                  "is said beside"));
    setRole(m_finish, isEnough && (!m_row || (look->more && *look->more == 0)) ? "primary" : "");
    m_undo->setEnabled(waiting && session.progress().undoable.has_value());
    m_skip->setEnabled(waiting && m_row.has_value());
    m_pause->setEnabled(waiting);
    m_giveUp->setEnabled(waiting);
}

void TransferLead::act()
{
    StudySession& session = m_workbench->study();
    if (session.state() != TransferStep::Waiting || !m_row || m_workbench->busyWithSqueeze())
        return;
    QMap<QString, Recipe> recipes;
    for (const TypeRecord& type : m_workbench->inspection().types())
        recipes.insert(type.name, type.recipe);
    session.setPartRecipes(recipes);
    tell(session.squeeze());
}

void TransferLead::finish()
{
    // That squeezes of the plan are left is no flaw where those that were made are enough.
    tell(m_workbench->study().finish(m_row ? tr("enough for the adjustment") : QString()));
}

void TransferLead::undo()
{
    if (m_undo->isEnabled())
        tell(m_workbench->study().undo());
}

void TransferLead::askSkip()
{
    if (!m_row)
        return;
    auto* question = new TextQuestion(
        tr("Leave this squeeze of %1 out").arg(m_workbench->study().study()->plan.part(*m_row)),
        tr("Why is it not squeezed? The reason is kept."), {}, tr("Leave out"), this);
    question->setObjectName("skipQuestion");
    question->requireText();
    connect(question, &TextQuestion::answered, this,
            [this](const QString& reason) { tell(m_workbench->study().skip(reason)); });
    question->open();
}

void TransferLead::askGiveUp()
{
    auto* question =
        new TextQuestion(tr("Give up"),
                         tr("No adjustment comes of these squeezes then; they stay on record. Why? "
                            "The reason is kept."),
                         {}, tr("Give up"), this);
    question->setObjectName("giveUpQuestion");
    question->requireText();
    connect(question, &TextQuestion::answered, this,
            [this](const QString& reason) { tell(m_workbench->study().abandon(reason)); });
    question->open();
}

void TransferLead::tell(const Expected<void>& done)
{
    if (!done)
        m_workbench->messages().report(done.error().describe());
    refresh();
}

void TransferLead::focusNext()
{
    if (m_workbench->study().state() != TransferStep::Waiting) {
        if (parentWidget())
            parentWidget()->setFocus(); // a Space that was meant here presses nothing else
        return;
    }
    if (m_act->isVisible())
        m_act->setFocus();
    else if (m_arm->isVisible())
        m_arm->setFocus();
    else if (m_finish->isEnabled())
        m_finish->setFocus();
}

} // namespace gripscope
