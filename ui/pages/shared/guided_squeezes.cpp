// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/shared/guided_squeezes.h"

#include "core/session/squeeze/series_session.h"
#include "ui/context/workbench.h"
#include "ui/people/authorize.h"
#include "ui/widgets/controls.h"

#include <QHBoxLayout>
#include <QProgressBar>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

using SeriesState = SeriesSession::State;

GuidedSqueezes::GuidedSqueezes(Workbench& workbench, SeriesSession& session, Script script, QWidget* parent)
    : QWidget(parent), m_workbench(&workbench), m_session(&session), m_script(std::move(script)),
      m_progress(new QProgressBar(this)), m_found(makeLabel({}, "second", this)),
      m_outcome(makeLabel({}, "strong", this)), m_act(makeButton({}, {}, "primary", this)),
      m_buttons(new QHBoxLayout)
{
    build();
    connect(&workbench, &Workbench::ticked, this, [this] {
        const bool moved = m_session->poll();
        if (moved || m_session->busy())
            refresh();
        if (moved)
            emit changed();
    });
    connect(&workbench, &Workbench::connectionChanged, this, &GuidedSqueezes::refresh);
    connect(&workbench, &Workbench::stopped, this, [this] {
        m_session->cancel();
        refresh(); // the window must not think that the squeeze goes on
    });
    connect(m_act, &QPushButton::clicked, this, &GuidedSqueezes::act);
    refresh();
}

GuidedSqueezes::~GuidedSqueezes() = default;

void GuidedSqueezes::build()
{
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Squeezes"));
    m_found->setWordWrap(true);
    m_outcome->setObjectName(m_script.name + u"Outcome"_s);
    m_outcome->setWordWrap(true);
    m_act->setObjectName(m_script.name + u"Act"_s);
    m_buttons->addStretch(1);
    m_buttons->addWidget(m_act);
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 0, 8);
    column->addWidget(m_progress);
    column->addWidget(m_found);
    column->addWidget(m_outcome);
    column->addStretch(1);
    column->addLayout(m_buttons);
}

void GuidedSqueezes::addButton(QPushButton* button)
{
    m_buttons->insertWidget(m_buttons->count() - 1, button);
}

void GuidedSqueezes::claim(bool on)
{
    if (m_claimed != on)
        m_workbench->setTrialRunning(on);
    m_claimed = on;
}

bool GuidedSqueezes::mayUse() const
{
    return m_session->state() == SeriesState::Measured && m_script.usable && m_script.usable();
}

void GuidedSqueezes::act()
{
    Expected<void> answer;
    if (m_session->busy()) {
        m_session->cancel();
    } else if (mayUse()) {
        askWhy(this, m_script.use, [this](const QString& reason) {
            authorize(*m_workbench, this, Permission::AcceptCalibrations, [this, reason] {
                m_session->setReason(reason);
                if (const Expected<void> accepted = m_script.accept(); !accepted)
                    m_workbench->messages().report(accepted.error().describe());
                refresh();
                emit changed();
            });
        });
    } else if (!m_workbench->connection().armed()) {
        m_workbench->arm();
    } else if (!m_workbench->busyWithSqueeze()) {
        m_session->setOperator(m_workbench->operatorName());
        answer = m_script.start();
        claim(answer.has_value());
    }
    if (!answer)
        m_workbench->messages().report(answer.error().describe());
    refresh();
    emit changed();
}

QString GuidedSqueezes::outcome() const
{
    switch (m_session->state()) {
    case SeriesState::Measured:
    case SeriesState::Storing:
    case SeriesState::Stored:
        return m_script.outcome();
    case SeriesState::Failed:
        return m_session->error()->describe();
    default:
        break;
    }
    const ConnectSession& connection = m_workbench->connection();
    if (connection.state() != ConnectSession::State::Connected)
        return tr("No gripper is connected. Choose one at the top.");
    if (!connection.identity().commandable)
        return tr("This gripper only streams, so that it cannot be measured from here.");
    if (const QString obstacle = m_script.obstacle ? m_script.obstacle() : QString(); !obstacle.isEmpty())
        return obstacle;
    return connection.armed() ? QString() : tr("Hands clear, then arm.");
}

QString GuidedSqueezes::buttonText() const
{
    if (m_session->busy())
        return tr("Cancel");
    if (mayUse())
        return m_script.use;
    if (!m_workbench->connection().armed())
        return tr("Arm");
    return m_session->state() == SeriesState::Idle ? m_script.begin() : m_script.again();
}

void GuidedSqueezes::refresh()
{
    const ConnectSession& connection = m_workbench->connection();
    const bool ready =
        connection.state() == ConnectSession::State::Connected && connection.identity().commandable;
    const bool hindered = m_script.obstacle && !m_script.obstacle().isEmpty();
    if (!m_session->busy())
        claim(false);
    m_progress->setVisible(m_session->busy());
    m_progress->setValue(static_cast<int>(100 * m_session->progress()));
    m_found->setText(m_script.found());
    m_found->setVisible(!m_found->text().isEmpty());
    m_outcome->setText(outcome());
    m_outcome->setVisible(!m_outcome->text().isEmpty());
    m_act->setText(buttonText());
    enableAct(m_session->busy() ? m_session->state() != SeriesState::Storing
                                : mayUse() || (ready && !hindered));
}

/// Disabling the focused button hands the focus on, to anything: a Space that was meant here would press
/// that.
void GuidedSqueezes::enableAct(bool on)
{
    const QWidget* focused = window()->focusWidget();
    if (!on && focused == m_act)
        setFocus();
    m_act->setEnabled(on);
    if (on && focused == this)
        m_act->setFocus();
}

void GuidedSqueezes::leave()
{
    m_session->cancel();
    claim(false);
}

} // namespace gripscope
