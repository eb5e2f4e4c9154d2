// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect_menu.h"

#include "devices/virtual/virtual_button.h"
#include "ui/access_dialog.h"
#include "ui/inspector/device_inspector.h"
#include "ui/lag_dialog.h"
#include "ui/people/supervised_settings.h"
#include "ui/profile_dialog.h"
#include "ui/settings/settings.h"
#include "ui/workbench.h"

#include <QInputDialog>

using namespace Qt::StringLiterals;

namespace gripscope {

ConnectMenu::ConnectMenu(Workbench& workbench, QWidget* parent) : QMenu(parent), m_workbench(&workbench)
{
    setAccessibleName(tr("Connect to a gripper"));
    connect(this, &QMenu::aboutToShow, this, &ConnectMenu::open);
    connect(this, &QMenu::aboutToHide, this, [this] { m_watcher.reset(); });
    connect(&workbench, &Workbench::ticked, this, &ConnectMenu::follow);
}

QString ConnectMenu::wordsOf(const FoundDevice& device, bool lastUsed)
{
    QStringList more;
    more << (device.serial.isEmpty() ? tr("no serial number") : tr("serial %1").arg(device.serial));
    if (!device.port.isEmpty())
        more << tr("at %1").arg(device.port);
    if (!device.toAllow.isEmpty())
        more << tr("no permission: see what to type");
    else if (lastUsed)
        more << tr("used last");
    return u"%1 · %2"_s.arg(device.name, more.join(u" · "_s));
}

void ConnectMenu::open()
{
    clear();
    m_found.clear();
    m_none = addAction(tr("Looking for grippers on USB…"));
    m_none->setEnabled(false);
    m_afterFound = addSeparator();
    for (const QString& can : {u"A"_s, u"B"_s, u"C"_s, u"D"_s})
        addAddress(tr("Virtual gripper, can %1").arg(can),
                   can == "A"_L1 ? u"virtual:"_s : u"virtual:?object=%1"_s.arg(can));
    addSeparator();
    addActions();
    m_shownRevision = 0;
    m_watcher = std::make_unique<HidWatcher>();
}

void ConnectMenu::addAddress(const QString& text, const QString& address)
{
    QAction* action = addAction(text);
    const ConnectSession& connection = m_workbench->connection();
    action->setCheckable(true);
    action->setChecked(connection.state() == ConnectSession::State::Connected &&
                       connection.address() == address);
    connect(action, &QAction::triggered, m_workbench, [this, address] { m_workbench->connectTo(address); });
}

void ConnectMenu::addActions()
{
    connect(addAction(tr("Other address…")), &QAction::triggered, this, &ConnectMenu::askForAddress);
    QAction* inspect = addAction(tr("Inspect the gripper…") + u"\tF9"_s);
    inspect->setObjectName("inspectGripper");
    connect(inspect, &QAction::triggered, this,
            [this] { DeviceInspector::open(*m_workbench, parentWidget()->window()); });
    QAction* lag = addAction(tr("Measure the lag between its channels…"));
    lag->setObjectName("measureLag");
    lag->setEnabled(m_workbench->connection().state() == ConnectSession::State::Connected);
    connect(lag, &QAction::triggered, this,
            [this] { (new LagDialog(*m_workbench, parentWidget()))->open(); });
    QAction* profile = addAction(tr("Profile of another maker's gripper…"));
    profile->setObjectName("gripperProfile");
    connect(profile, &QAction::triggered, this, [this] { openProfile(); });
    QAction* button = addAction(tr("Press the virtual gripper's button"));
    button->setObjectName("pressButton");
    button->setVisible(m_workbench->connection().state() == ConnectSession::State::Connected &&
                       m_workbench->connection().address().startsWith("virtual:"_L1));
    connect(button, &QAction::triggered, this, [] { virtual_button::press(); });
    addKeeping();
    const bool awaiting = m_workbench->connection().awaiting();
    QAction* disconnect = addAction(awaiting ? tr("Do not wait for the gripper") : tr("Disconnect"));
    disconnect->setObjectName("disconnect");
    disconnect->setEnabled(m_workbench->connection().state() != ConnectSession::State::Disconnected);
    connect(disconnect, &QAction::triggered, m_workbench, [this] { m_workbench->connection().disconnect(); });
}

void ConnectMenu::addKeeping()
{
    QAction* keep = addAction(tr("Keep the raw reports of every session"));
    keep->setObjectName("keepSessions");
    keep->setCheckable(true);
    keep->setChecked(m_workbench->keepsSessions());
    connect(keep, &QAction::triggered, m_workbench, [this](bool on) {
        changeSettings(*m_workbench, parentWidget(),
                       {{QString::fromLatin1(setting::keepSessions.key), !on, on}},
                       [this, on] { keepSessions(on); });
    });
}

void ConnectMenu::keepSessions(bool on)
{
    m_workbench->setKeeping(m_workbench->keeping(), on);
    m_workbench->report(on ? tr("From the next connection on, the raw reports of grippers are kept in %1.")
                                 .arg(m_workbench->keeping().folder)
                           : tr("From the next connection on, raw reports are not kept. Squeezes cannot be "
                                "replayed then."));
}

void ConnectMenu::follow()
{
    if (!m_watcher || m_watcher->revision() == m_shownRevision)
        return;
    const HidWatcher::Snapshot seen = m_watcher->snapshot();
    m_shownRevision = seen.revision;
    m_workbench->compute<std::vector<FoundDevice>>( // it may read profiles
        this, [nodes = seen.nodes] { return devicesAmong(nodes); },
        [this](const std::vector<FoundDevice>& found) {
            if (m_watcher)
                showFound(found);
        });
}

void ConnectMenu::showFound(const std::vector<FoundDevice>& devices)
{
    for (QAction* action : m_found)
        delete action;
    m_found.clear();
    const QString lastUsed = m_workbench->settings().get(setting::lastGripper);
    const ConnectSession& connection = m_workbench->connection();
    for (const FoundDevice& device : devices) {
        if (!device.address.startsWith("hid:"_L1))
            continue;
        auto* action = new QAction(wordsOf(device, device.address == lastUsed), this);
        action->setCheckable(true);
        action->setChecked(connection.state() == ConnectSession::State::Connected &&
                           connection.identity().address == device.address);
        connect(action, &QAction::triggered, m_workbench, [this, device] { choose(device); });
        insertAction(m_afterFound, action);
        m_found << action;
    }
    m_none->setVisible(m_found.isEmpty());
    m_none->setText(tr("No gripper found on USB"));
}

void ConnectMenu::choose(const FoundDevice& device)
{
    m_workbench->connectTo(device.address);
    if (!device.toAllow.isEmpty())
        (new AccessDialog(*m_workbench, device, parentWidget()))->open();
}

void ConnectMenu::openProfile()
{
    auto* dialog = new ProfileDialog(*m_workbench, parentWidget());
    const QString address = m_workbench->connection().address();
    if (m_workbench->connection().state() == ConnectSession::State::Connected &&
        !address.startsWith("replay:"_L1))
        dialog->listen(address);
    dialog->show(); // beside the pages, which go on
}

void ConnectMenu::askForAddress()
{
    auto* dialog = new QInputDialog(parentWidget());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Connect to a gripper"));
    dialog->setLabelText(tr("Address, such as virtual:?object=B&seed=7, hid: or replay:FILE"));
    dialog->setTextValue(m_workbench->connection().address());
    dialog->setOkButtonText(tr("Connect"));
    dialog->resize(480, 160);
    connect(dialog, &QInputDialog::textValueSelected, m_workbench,
            [this](const QString& address) { m_workbench->connectTo(address.trimmed()); });
    dialog->open();
}

} // namespace gripscope
