// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/workbench.h"
#include "ui/pages/quality/shift/shift_views.h"
#include "ui/pages/quality/shift/transfer_steps.h"

#include <QStackedWidget>
#include <QVBoxLayout>

namespace gripscope {

namespace {

bool isTransfer(const std::optional<KeptStudy>& study)
{
    return study && study->plan.design.kind == StudyKind::Transfer;
}

} // namespace

TransferView::TransferView(Workbench& workbench, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_watch(workbench.library()),
      m_stack(new QStackedWidget(this)), m_start(new TransferStart(workbench, this)),
      m_lead(new TransferLead(workbench, m_watch, this)),
      m_outcome(new TransferOutcome(workbench, m_watch, this))
{
    m_stack->addWidget(m_start);
    m_stack->addWidget(m_lead);
    m_stack->addWidget(m_outcome);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_stack);
    setFocusPolicy(Qt::StrongFocus);
    m_lead->setFocusPolicy(Qt::StrongFocus);
    connect(m_start, &TransferStart::left, this, &TransferView::left);
    connect(m_start, &TransferStart::submitted, this, &TransferView::submitted);
    connect(m_lead, &TransferLead::paused, this, &TransferView::left);
    connect(m_outcome, &TransferOutcome::left, this, &TransferView::left);
    connect(&workbench, &Workbench::ticked, this, &TransferView::poll);
    connect(&workbench, &Workbench::inspectionChanged, this, [this] {
        if (isVisible() && m_stack->currentWidget() == m_start)
            m_start->refresh();
    });
}

void TransferView::begin()
{
    m_watch.forget();
    m_ended.clear();
    m_stack->setCurrentWidget(m_start);
    m_start->load();
}

void TransferView::refresh()
{
    const std::optional<KeptStudy>& study = m_workbench->study().study();
    if (!isTransfer(study)) {
        m_watch.forget();
        m_ended.clear();
        m_stack->setCurrentWidget(m_start);
        return m_start->refresh();
    }
    m_watch.follow(*study);
    showStep();
}

void TransferView::showStep()
{
    const KeptStudy& study = *m_workbench->study().study();
    if (study.record.state == StudyState::Open) {
        m_ended.clear();
        m_stack->setCurrentWidget(m_lead);
        return m_lead->refresh();
    }
    const bool isNew = m_ended != study.record.id;
    m_ended = study.record.id;
    m_stack->setCurrentWidget(m_outcome);
    isNew ? m_outcome->begin() : m_outcome->refresh();
    if (isNew && isVisible())
        m_outcome->focusFirst();
}

void TransferView::poll()
{
    if (m_watch.poll() && isTransfer(m_workbench->study().study()))
        showStep();
}

void TransferView::focusFirst()
{
    if (m_stack->currentWidget() == m_start)
        m_start->focusFirst();
    else if (m_stack->currentWidget() == m_lead)
        m_lead->focusNext();
    else
        m_outcome->focusFirst();
}

void TransferView::act()
{
    if (m_stack->currentWidget() == m_lead)
        m_lead->act();
}

void TransferView::undo()
{
    if (m_stack->currentWidget() == m_lead)
        m_lead->undo();
}

} // namespace gripscope
