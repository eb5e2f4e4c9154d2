// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/header_bar.h"

#include "ui/connect_menu.h"
#include "ui/connection_words.h"
#include "ui/people/operator_box.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/device_chip.h"
#include "ui/workbench.h"

#include <QHBoxLayout>

using namespace Qt::StringLiterals;

namespace gripscope {

HeaderBar::HeaderBar(Workbench& workbench, QWidget* parent) : QFrame(parent), m_workbench(&workbench)
{
    setRole(this, "bar");
    setFixedHeight(64);
    m_title = makeLabel({}, "title", this);
    m_chip = new DeviceChip(this);
    m_chip->setObjectName("deviceChip");
    m_menu = new ConnectMenu(workbench, this);
    connect(m_chip, &DeviceChip::clicked, this,
            [this] { m_menu->popup(m_chip->mapToGlobal(QPoint(0, m_chip->height() + 4))); });

    m_arm = makeButton(tr("Arm"), u"object-unlocked"_s, "", this);
    m_arm->setObjectName("armButton");
    m_arm->setCheckable(true);
    m_arm->setMinimumWidth(132);
    connect(m_arm, &QPushButton::clicked, this, [this] {
        if (m_workbench->connection().armed())
            m_workbench->connection().disarm();
        else
            m_workbench->arm();
        refreshArmed();
    });

    m_stop = makeButton(tr("STOP"), {}, "stop", this);
    m_stop->setObjectName("stopButton");
    m_stop->setAccessibleName(tr("Stop the gripper and disarm it"));
    m_stop->setToolTip(tr("Stop the gripper and disarm it (Esc)"));
    m_stop->setFixedHeight(48);
    // On the press, not on the release: that is when a person wants it.
    connect(m_stop, &QPushButton::pressed, &workbench, &Workbench::stop);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 16, 8);
    row->setSpacing(12);
    row->addWidget(m_title);
    row->addStretch(1);
    row->addWidget(m_chip, 0);
    row->addWidget(new OperatorBox(workbench, this));
    row->addWidget(m_arm);
    row->addWidget(m_stop);

    const auto refresh = [this] {
        refreshLink();
        refreshArmed();
    };
    connect(&workbench, &Workbench::connectionChanged, this, refresh);
    connect(&Theme::instance(), &Theme::changed, this, [this] {
        m_arm->setToolTip({}); // its icon has the colours of the theme
        refreshArmed();
    });
    // Counts change without a signal; and a state that came and went between two polls is told by none.
    auto* timer = new QTimer(this);
    connect(timer, &QTimer::timeout, this, refresh);
    timer->start(250);
    refresh();
}

void HeaderBar::setTitle(const QString& title)
{
    m_title->setText(title);
}

void HeaderBar::refreshLink()
{
    const ConnectSession& connection = m_workbench->connection();
    const ConnectionWords words = chipWords(connection);
    m_chip->setLink(connection.state(), words.headline, words.detail);
}

void HeaderBar::refreshArmed()
{
    ConnectSession& connection = m_workbench->connection();
    const bool armed = connection.armed();
    const bool possible =
        connection.state() == ConnectSession::State::Connected && connection.identity().commandable;
    const QString text = armed ? tr("Armed") : tr("Arm");
    if (armed == m_arm->isChecked() && possible == m_arm->isEnabled() && text == m_arm->text() &&
        !m_arm->toolTip().isEmpty())
        return;
    m_arm->setChecked(armed);
    m_arm->setEnabled(possible);
    m_arm->setText(text);
    m_arm->setAccessibleName(armed ? tr("Armed; press to disarm") : tr("Arm the gripper"));
    m_arm->setToolTip(armed      ? tr("The gripper may move. Press to disarm it.")
                      : possible ? tr("Let the gripper move when a squeeze is asked for")
                                 : tr("No gripper that can be commanded is connected"));
    const ThemeTokens& tokens = Theme::instance().tokens();
    m_arm->setIcon(armed ? Theme::instance().icon(u"object-locked"_s, tokens.accent)
                         : Theme::instance().icon(u"object-unlocked"_s));
}

} // namespace gripscope
