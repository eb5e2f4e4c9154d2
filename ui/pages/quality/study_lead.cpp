// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/plan/plan_words.h"
#include "ui/context/connection_words.h"
#include "ui/context/workbench.h"
#include "ui/pages/page_state.h"
#include "ui/pages/quality/study_views.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/progress.h"
#include "ui/windows/question.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

using LeadState = StudySession::State;

StudyLead::StudyLead(Workbench& workbench, QWidget* parent) : QWidget(parent), m_workbench(&workbench)
{
    auto* row = new QHBoxLayout(this);
    setSpacing(row, 0, 16);
    row->addWidget(makeTask(), 5);
    row->addWidget(makeSide(), 3);
    connect(m_arm, &QPushButton::clicked, this, [this] { m_workbench->arm(); });
    connect(m_act, &QPushButton::clicked, this, &StudyLead::act);
    connect(m_undo, &QPushButton::clicked, this, &StudyLead::undo);
    connect(m_skip, &QPushButton::clicked, this, &StudyLead::askSkip);
    connect(m_pause, &QPushButton::clicked, this, &StudyLead::paused);
    connect(m_end, &QPushButton::clicked, this, &StudyLead::askEnd);
    connect(m_label, &QLineEdit::returnPressed, this, &StudyLead::takeLabel);
    connect(m_scanFirst, &QCheckBox::toggled, this, [this] {
        refresh();
        focusNext();
    });
    connect(m_word, &QLineEdit::returnPressed, this, [this] { rate(m_word->text()); });
    refresh();
}

QWidget* StudyLead::makeTask()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 24, 8);
    m_name = makeLabel({}, "caption", card);
    m_name->setObjectName("studyLeadName");
    m_who = makeLabel({}, "title", card);
    m_who->setObjectName("studyWho");
    m_part = makeLabel({}, "", card);
    m_part->setObjectName("studyPart");
    m_part->setStyleSheet(u"font-size: 56px; font-weight: 600;"_s); // read from where the parts lie
    m_trial = makeLabel({}, "second", card);
    m_hint = makeLabel({}, "", card);
    m_hint->setObjectName("studyLeadHint");
    m_wrongPart = makeLabel({}, "stopped", card);
    m_wrongPart->setObjectName("wrongPart");
    for (QLabel* label : {m_who, m_part, m_hint, m_wrongPart, m_name})
        label->setWordWrap(true);
    m_arm = makeButton(tr("Arm the gripper"), u"object-unlocked"_s, "primary", card);
    m_arm->setObjectName("studyArm");
    m_act = makeButton({}, {}, "primary", card);
    m_act->setObjectName("studyAct");
    column->addWidget(m_name);
    column->addStretch(1);
    column->addWidget(m_who);
    column->addWidget(m_part);
    column->addWidget(m_trial);
    column->addSpacing(8);
    column->addWidget(m_hint);
    column->addWidget(m_wrongPart);
    column->addStretch(2);
    column->addWidget(m_labelBox = makePart(card));
    column->addWidget(m_ratingBox = makeRating(card));
    column->addWidget(m_arm);
    column->addWidget(m_act);
    return card;
}

QWidget* StudyLead::makePart(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    auto* caption = makeLabel(tr("Label"), "second", box);
    m_label = new QLineEdit(box);
    m_label->setObjectName("studyLabel");
    m_label->setMaxLength(64);
    m_label->setPlaceholderText(tr("typed or scanned, then Enter"));
    m_label->setAccessibleName(tr("Label of the part between the fingers"));
    caption->setBuddy(m_label);
    m_scanFirst = new QCheckBox(tr("Ask for it each time"), box);
    m_scanFirst->setObjectName("studyScanFirst");
    m_scanFirst->setToolTip(tr("No part is squeezed before its label was typed or scanned"));
    rememberChoice(m_scanFirst);
    row->addWidget(caption);
    row->addWidget(m_label, 1);
    row->addWidget(m_scanFirst);
    return box;
}

QWidget* StudyLead::makeRating(QWidget* parent)
{
    auto* box = new QWidget(parent);
    auto* column = new QVBoxLayout(box);
    setSpacing(column, 0, 8);
    m_ratings = new QHBoxLayout;
    m_ratings->setSpacing(8);
    m_word = new QLineEdit(box);
    m_word->setObjectName("studyWord");
    m_word->setMaxLength(64);
    m_word->setPlaceholderText(tr("or another word, then Enter"));
    m_word->setAccessibleName(tr("What the part is called"));
    column->addLayout(m_ratings);
    column->addWidget(m_word);
    return box;
}

QWidget* StudyLead::makeSide()
{
    QFrame* card = makeCard(this);
    auto* column = new QVBoxLayout(card);
    setSpacing(column, 16, 8);
    m_ring = new ProgressRing(card);
    m_ring->setObjectName("studyRing");
    m_words = makeLabel({}, "second", card);
    m_words->setObjectName("studyProgress");
    m_words->setWordWrap(true);
    m_words->setAlignment(Qt::AlignCenter);
    m_last = makeLabel({}, "", card);
    m_last->setObjectName("studyLast");
    m_last->setWordWrap(true);
    m_undo = makeButton(tr("Take the last one back (Ctrl+Z)"), u"edit-undo"_s, "", card);
    m_undo->setObjectName("studyUndo");
    m_skip = makeButton(tr("Leave this one out…"), {}, "", card);
    m_skip->setObjectName("studySkip");
    m_pause = makeButton(tr("Pause"), u"media-playback-pause"_s, "", card);
    m_pause->setObjectName("studyPause");
    m_pause->setToolTip(tr("Goes back to the list; the study is kept and can be gone on with"));
    m_end = makeButton(tr("End it here…"), {}, "quiet", card);
    m_end->setObjectName("studyEnd");
    column->addWidget(m_ring, 1);
    column->addWidget(m_words);
    column->addWidget(makeRule(card));
    column->addWidget(m_last);
    column->addStretch(1);
    for (QPushButton* button : {m_undo, m_skip, m_pause, m_end})
        column->addWidget(button);
    return card;
}

bool StudyLead::rated() const
{
    const std::optional<KeptStudy>& study = m_workbench->study().study();
    return study && study->plan.design.kind == StudyKind::Attributes;
}

bool StudyLead::through() const
{
    return !m_workbench->study().nextRow();
}

bool StudyLead::mayGoOn() const
{
    return !m_wrong && (!m_scanFirst->isChecked() || m_labelled == m_workbench->study().nextRow());
}

void StudyLead::refresh()
{
    const StudySession& session = m_workbench->study();
    if (!session.study())
        return;
    const std::optional<std::size_t> next = session.nextRow();
    if (next != m_row) {
        m_row = next;
        m_labelled.reset();
        m_wrong = false;
        m_label->clear();
        m_word->clear();
        fillRatings();
    }
    refreshTask();
    refreshButtons();
    refreshLast();
    const StudyProgress progress = session.progress();
    m_ring->setCount(int(progress.done + progress.skipped), int(progress.rows.size()));
    m_ring->setRunning(session.state() == LeadState::Squeezing ? session.squeezeProgress() : -1);
    m_words->setText(progressWords(progress).describe());
    const int shown = 2 * int(session.state()) + (m_act->isEnabled() ? 1 : 0);
    if (shown != m_shown) {
        m_shown = shown;
        if (isVisible())
            focusNext();
    }
}

void StudyLead::refreshTask()
{
    const StudySession& session = m_workbench->study();
    const KeptStudy& study = *session.study();
    m_name->setText(study.record.study.name);
    const bool anyLeft = m_row.has_value();
    const QString person = anyLeft ? study.plan.operatorName(*m_row) : QString();
    const QString station = anyLeft ? study.plan.station(*m_row) : QString();
    m_who->setText(!anyLeft           ? tr("All squeezes are through")
                   : person.isEmpty() ? tr("Next")
                                      : tr("Operator %1").arg(person));
    m_part->setText(anyLeft ? tr("Part %1").arg(study.plan.part(*m_row)) : QString());
    m_part->setVisible(anyLeft);
    m_trial->setVisible(anyLeft);
    if (anyLeft) {
        const QString trial =
            tr("Trial %1 of %2").arg(study.plan.rows[*m_row].trial + 1).arg(study.plan.design.trials);
        m_trial->setText(station.isEmpty() ? trial : tr("%1, at station %2").arg(trial, station));
    }
    m_hint->setText(hint());
    m_labelBox->setVisible(anyLeft);
    m_ratingBox->setVisible(anyLeft && rated());
    m_wrongPart->setVisible(!m_wrongPart->text().isEmpty() && m_wrong);
}

QString StudyLead::hint() const
{
    const StudySession& session = m_workbench->study();
    const ConnectSession& connection = m_workbench->connection();
    switch (session.state()) {
    case LeadState::Squeezing:
        return tr("Squeezing…");
    case LeadState::Identifying:
        return tr("Finding m, b and k…");
    case LeadState::Storing:
        return tr("Being stored…");
    default:
        break;
    }
    if (!m_row)
        return tr("Nothing can be taken back once the result is shown.");
    const QString part = session.study()->plan.part(*m_row);
    if (rated())
        return tr("Look at part %1 and say what it is.").arg(part);
    if (connection.state() != ConnectSession::State::Connected)
        return u"%1. %2."_s.arg(missingWords(connection).headline, missingWords(connection).detail);
    if (connection.identity().commandable && !connection.armed())
        return tr("Put part %1 between the fingers, hands clear, then arm.").arg(part);
    if (!mayGoOn())
        return tr("Put part %1 between the fingers, then type or scan its label.").arg(part);
    return tr("Put part %1 between the fingers, hands clear, then press Space.").arg(part);
}

void StudyLead::refreshButtons()
{
    const StudySession& session = m_workbench->study();
    const ConnectSession& connection = m_workbench->connection();
    const bool waiting = session.state() == LeadState::Waiting;
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const bool ready = connected && (connection.armed() || !connection.identity().commandable);
    const bool squeezes = !rated() && m_row;
    const bool moving = session.state() == LeadState::Squeezing;
    m_arm->setVisible(squeezes && !ready && !moving);
    m_arm->setEnabled(connected);
    m_act->setVisible(!m_row || (squeezes && (ready || moving)));
    m_act->setText(!m_row   ? tr("Finish and show the result")
                   : moving ? tr("Squeezing…")
                            : tr("Squeeze (Space)"));
    m_act->setEnabled(waiting && (!m_row || (ready && mayGoOn())));
    m_ratingBox->setEnabled(waiting && mayGoOn());
    m_label->setEnabled(waiting);
    m_undo->setEnabled(waiting && session.progress().undoable.has_value());
    m_skip->setEnabled(waiting && m_row.has_value());
    m_pause->setEnabled(waiting);
    m_end->setVisible(m_row.has_value());
    m_end->setEnabled(waiting);
}

void StudyLead::refreshLast()
{
    const StudySession& session = m_workbench->study();
    const KeptStudy& study = *session.study();
    if (!session.refusal().empty()) {
        m_last->setText(tr("That squeeze does not count: %1 Squeeze the same part again.")
                            .arg(described(session.refusal()).join(u' ')));
        return setRole(m_last, "error");
    }
    setRole(m_last, "second");
    if (study.measurements.empty())
        return m_last->setText(tr("What is measured is stored at once, and shown when the study is "
                                  "finished."));
    const StudyMeasurementRecord& newest = study.measurements.back();
    const QString part = study.plan.part(std::size_t(newest.measured.row));
    m_last->setText(newest.undone ? tr("Part %1 was taken back and comes again.").arg(part)
                    : newest.measured.outcome == toString(AttemptOutcome::Skipped)
                        ? tr("Part %1 was left out.").arg(part)
                        : tr("Part %1 is stored.").arg(part));
}

void StudyLead::takeLabel()
{
    const QString told = m_label->text().trimmed();
    if (!m_row || told.isEmpty())
        return;
    const QString wanted = m_workbench->study().study()->plan.part(*m_row);
    m_wrong = told.compare(wanted, Qt::CaseInsensitive) != 0;
    if (m_wrong) {
        m_labelled.reset();
        m_wrongPart->setText(tr("That is part %1. Take it out and put in part %2.").arg(told, wanted));
        m_label->selectAll();
    } else {
        m_labelled = m_row;
    }
    refresh();
    focusNext();
}

void StudyLead::fillRatings()
{
    while (QLayoutItem* item = m_ratings->takeAt(0)) {
        item->widget()->deleteLater();
        delete item;
    }
    if (!m_row || !rated())
        return;
    QStringList words = m_workbench->study().study()->plan.design.references;
    words.removeDuplicates();
    if (words.size() < 2)
        words = QStringList{tr("good"), tr("bad")};
    words.sort();
    for (const QString& word : words) {
        QPushButton* button = makeButton(word, {}, "primary", m_ratingBox);
        button->setObjectName(u"rate-"_s + word);
        connect(button, &QPushButton::clicked, this, [this, word] { rate(word); });
        m_ratings->addWidget(button, 1);
    }
}

void StudyLead::rate(const QString& word)
{
    if (!word.trimmed().isEmpty() && mayGoOn())
        tell(m_workbench->study().rate(word));
}

void StudyLead::act()
{
    StudySession& session = m_workbench->study();
    if (session.state() != LeadState::Waiting)
        return;
    if (through())
        tell(session.finish());
    else if (!rated())
        squeeze();
}

void StudyLead::squeeze()
{
    if (!mayGoOn() || m_workbench->busyWithSqueeze())
        return;
    tell(m_workbench->study().squeeze());
}

void StudyLead::undo()
{
    if (m_undo->isEnabled())
        tell(m_workbench->study().undo());
}

void StudyLead::askSkip()
{
    if (!m_row)
        return;
    auto* question =
        new TextQuestion(tr("Leave part %1 out").arg(m_workbench->study().study()->plan.part(*m_row)),
                         tr("Why is it not squeezed? The reason is kept."), {}, tr("Leave out"), this);
    question->setObjectName("skipQuestion");
    question->requireText();
    connect(question, &TextQuestion::answered, this,
            [this](const QString& reason) { tell(m_workbench->study().skip(reason)); });
    question->open();
}

void StudyLead::askEnd()
{
    auto* question =
        new TextQuestion(tr("End the study here"),
                         tr("Squeezes are left. Why does it end without them? The reason is kept, and the "
                            "result rests on what was measured."),
                         {}, tr("End"), this);
    question->setObjectName("endStudyQuestion");
    question->requireText();
    connect(question, &TextQuestion::answered, this,
            [this](const QString& reason) { tell(m_workbench->study().finish(reason)); });
    question->open();
}

void StudyLead::tell(const Expected<void>& done)
{
    if (!done)
        m_workbench->messages().report(done.error().describe());
    refresh();
}

void StudyLead::focusNext()
{
    if (m_workbench->study().state() != LeadState::Waiting) {
        if (parentWidget())
            parentWidget()->setFocus(); // a Space that was meant here presses nothing else
        return;
    }
    if (m_row && (m_wrong || (m_scanFirst->isChecked() && !mayGoOn())))
        m_label->setFocus();
    else if (m_act->isVisible())
        m_act->setFocus();
    else if (m_arm->isVisible())
        m_arm->setFocus();
}

} // namespace gripscope
