// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/workbench.h"
#include "ui/format/date_text.h"
#include "ui/pages/enroll/enroll_name_step.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString reached(const EnrollmentDraft& draft)
{
    if (draft.step == EnrollmentDraft::Step::Recipe)
        return EnrollDrafts::tr("Named, and not squeezed yet.");
    if (draft.step == EnrollmentDraft::Step::Review)
        return EnrollDrafts::tr("%n squeeze(s), ready for approval.", nullptr, draft.squeezes);
    const QString words = draft.pendingId.isEmpty()
                              ? EnrollDrafts::tr("Squeezes so far: %1.")
                              : EnrollDrafts::tr("Squeezes so far: %1, and one to decide on.");
    return words.arg(draft.squeezes);
}

} // namespace

QString inWords(const EnrollmentDraft& draft)
{
    const QString when = timeText(draft.changed);
    return draft.operatorName.isEmpty()
               ? EnrollDrafts::tr("%1 Left on %2.").arg(reached(draft), when)
               : EnrollDrafts::tr("%1 Left by %2 on %3.").arg(reached(draft), draft.operatorName, when);
}

EnrollDrafts::EnrollDrafts(Workbench& workbench, QWidget* parent) : QFrame(parent), m_workbench(&workbench)
{
    setRole(this, "card");
    setObjectName("drafts");
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 16, 8);
    column->addWidget(makeLabel(tr("Begun and not finished"), "heading", this));
    m_rows = new QWidget(this);
    auto* rows = new QVBoxLayout(m_rows);
    setSpacing(rows, 0, 8);
    column->addWidget(m_rows);
    m_undone = new QWidget(this);
    auto* row = new QHBoxLayout(m_undone);
    setSpacing(row, 0, 8);
    m_undoneWords = makeLabel({}, "second", m_undone);
    QPushButton* undo = makeButton(tr("Undo"), u"edit-undo"_s, "quiet", m_undone);
    undo->setObjectName("bringDraftBack");
    row->addWidget(m_undoneWords, 1);
    row->addWidget(undo);
    column->addWidget(m_undone);
    m_undone->hide();
    hide();
    connect(undo, &QPushButton::clicked, this, &EnrollDrafts::bringBack);
}

QStringList EnrollDrafts::names() const
{
    QStringList names;
    for (const EnrollmentDraft& draft : m_drafts)
        names << draft.name;
    return names;
}

void EnrollDrafts::load()
{
    using Drafts = std::vector<EnrollmentDraft>;
    m_workbench->background().ask<Drafts>(
        this, [](Library& library) { return library.drafts(); },
        [this](Expected<Drafts> drafts) {
            if (drafts)
                show(std::move(*drafts));
            else
                m_workbench->messages().report(drafts.error().describe());
        });
}

void EnrollDrafts::show(std::vector<EnrollmentDraft> drafts)
{
    m_drafts = std::move(drafts);
    qDeleteAll(m_rows->findChildren<QWidget*>(Qt::FindDirectChildrenOnly));
    for (const EnrollmentDraft& draft : m_drafts)
        m_rows->layout()->addWidget(makeRow(draft));
    if (m_discarded)
        m_undoneWords->setText(tr("“%1” was discarded.").arg(m_discarded->name));
    m_undone->setVisible(m_discarded.has_value());
    setVisible(!m_drafts.empty() || m_discarded);
    emit changed();
}

QWidget* EnrollDrafts::makeRow(const EnrollmentDraft& draft)
{
    auto* box = new QWidget(m_rows);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    auto* name = new ElidedLabel(draft.name, box);
    name->setObjectName("draftName");
    setRole(name, "strong");
    words->addWidget(name);
    auto* state = new ElidedLabel(inWords(draft), box);
    setRole(state, "caption");
    words->addWidget(state);
    QPushButton* goingOn = makeButton(tr("Go on"), {}, "", box);
    goingOn->setObjectName("goOnWithDraft");
    goingOn->setAccessibleName(tr("Go on with %1").arg(draft.name));
    QPushButton* discarding = makeButton(tr("Discard"), {}, "quiet", box);
    discarding->setObjectName("discardDraft");
    discarding->setAccessibleName(tr("Discard the enrolment of %1").arg(draft.name));
    discarding->setToolTip(draft.squeezes > 0
                               ? tr("It is offered no more; accepted squeezes stay, see Enrolled types")
                               : tr("It is offered no more"));
    auto* row = new QHBoxLayout(box);
    setSpacing(row, 0, 8);
    row->addLayout(words, 1);
    row->addWidget(discarding);
    row->addWidget(goingOn);
    connect(goingOn, &QPushButton::clicked, this, [this, name = draft.name] { emit goOn(name); });
    connect(discarding, &QPushButton::clicked, this, [this, draft] { discard(draft); });
    return box;
}

void EnrollDrafts::discard(const EnrollmentDraft& draft)
{
    m_workbench->background().ask<void>(
        this,
        [name = draft.name, who = m_workbench->operatorName()](Library& library) {
            return library.endDraft(name, DraftEnd::Discarded, who);
        },
        [this, draft](const Expected<void>& done) {
            if (!done)
                return m_workbench->messages().report(done.error().describe());
            m_discarded = draft;
            load();
        });
}

void EnrollDrafts::bringBack()
{
    if (!m_discarded)
        return;
    m_workbench->background().ask<void>(
        this, [draft = *m_discarded](Library& library) { return library.saveDraft(draft); },
        [this](const Expected<void>& done) {
            if (!done)
                return m_workbench->messages().report(done.error().describe());
            m_discarded.reset();
            load();
        });
}

} // namespace gripscope
