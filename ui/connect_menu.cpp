// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/connect_menu.h"

#include "ui/lag_dialog.h"
#include "ui/workbench.h"

#include <QInputDialog>

using namespace Qt::StringLiterals;

namespace gripscope {

ConnectMenu::ConnectMenu(Workbench& workbench, QWidget* parent) : QMenu(parent), m_workbench(&workbench)
{
    setAccessibleName(tr("Connect to a gripper"));
    connect(this, &QMenu::aboutToShow, this, &ConnectMenu::rebuild);
}

QAction* ConnectMenu::addAddress(const QString& text, const QString& address)
{
    QAction* action = addAction(text);
    action->setData(address);
    action->setCheckable(true);
    action->setChecked(m_workbench->connection().state() == ConnectSession::State::Connected &&
                       m_workbench->connection().address() == address);
    connect(action, &QAction::triggered, m_workbench, [this, address] { m_workbench->connectTo(address); });
    return action;
}

void ConnectMenu::rebuild()
{
    clear();
    for (const QString& can : {u"A"_s, u"B"_s, u"C"_s, u"D"_s})
        addAddress(tr("Virtual gripper, can %1").arg(can),
                   can == "A"_L1 ? u"virtual:"_s : u"virtual:?object=%1"_s.arg(can));
    addSeparator();
    m_looking = addAction(tr("Looking for grippers on USB…"));
    m_looking->setEnabled(false);
    m_afterFound = addSeparator();
    connect(addAction(tr("Other address…")), &QAction::triggered, this, &ConnectMenu::askForAddress);
    QAction* lag = addAction(tr("Measure the lag between its channels…"));
    lag->setObjectName("measureLag");
    lag->setEnabled(m_workbench->connection().state() == ConnectSession::State::Connected);
    connect(lag, &QAction::triggered, this,
            [this] { (new LagDialog(*m_workbench, parentWidget()))->open(); });
    QAction* disconnect = addAction(tr("Disconnect"));
    disconnect->setEnabled(m_workbench->connection().state() != ConnectSession::State::Disconnected);
    connect(disconnect, &QAction::triggered, m_workbench, [this] { m_workbench->connection().disconnect(); });
    look();
}

void ConnectMenu::look()
{
    m_workbench->compute<std::vector<FoundDevice>>(
        this, [] { return findDevices(); },
        [this](const std::vector<FoundDevice>& found) { showFound(found); });
}

void ConnectMenu::showFound(const std::vector<FoundDevice>& devices)
{
    if (!m_looking)
        return;
    bool any = false;
    for (const FoundDevice& device : devices) {
        if (!device.address.startsWith("hid:"_L1))
            continue;
        any = true;
        QAction* action = addAddress(tr("%1, serial %2").arg(device.name, device.serial), device.address);
        if (device.state != "available"_L1)
            action->setText(tr("%1, serial %2 (%3)").arg(device.name, device.serial, device.state));
        insertAction(m_afterFound, action);
    }
    m_looking->setVisible(!any);
    m_looking->setText(tr("No gripper found on USB"));
    m_looking = nullptr;
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
