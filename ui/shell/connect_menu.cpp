// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/connect_menu.h"

#include "devices/virtual/virtual_button.h"
#include "devices/virtual/virtual_load.h"
#include "ui/context/workbench.h"
#include "ui/inspector/device_inspector.h"
#include "ui/people/authorize.h"
#include "ui/profiles/profile_dialog.h"
#include "ui/settings/values/settings.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/plain_text.h"
#include "ui/windows/question.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QVBoxLayout>
#include <QWidgetAction>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
const RegisteredDialog<AccessDialog> accessDialogRow("access", [](Workbench& bench, QWidget* over) {
    return new AccessDialog(bench, {}, over);
});
} // namespace

AccessDialog::AccessDialog(Workbench& workbench, const FoundDevice& device, QWidget* parent) : Dialog(parent)
{
    setObjectName("accessDialog");
    setManualPage(u"connect"_s);
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Allow access to the gripper"));
    auto* column = new QVBoxLayout(this);
    setSpacing(column, 24, 16);
    column->addWidget(makeLabel(tr("This user may not open %1").arg(device.name), "heading", this));
    const QString missing =
        device.missing.isEmpty() ? QString() : tr("What is missing is %1.").arg(device.missing) + u' ';
    auto* what = makeLabel(missing + tr("Type this line in a terminal. It asks for the password of an "
                                        "administrator. Gripscope then connects the gripper by itself."),
                           "", this);
    what->setWordWrap(true);
    column->addWidget(what);

    const QString text = device.toAllow;
    auto* commands = new QPlainTextEdit(text, this);
    commands->setObjectName("accessCommands");
    commands->setAccessibleName(tr("Line to type"));
    commands->setReadOnly(true);
    commands->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    commands->setMinimumHeight(152);
    column->addWidget(commands, 1);

    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    auto* copy = makeButton(tr("Copy"), u"edit-copy"_s, "primary", this);
    connect(copy, &QPushButton::clicked, this,
            [text] { QGuiApplication::clipboard()->setText(text + u'\n'); });
    auto* close = makeButton(tr("Close"), {}, "", this);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    row->addStretch(1);
    row->addWidget(close);
    row->addWidget(copy);
    column->addLayout(row);
    resize(720, 360);
    connect(&workbench, &Workbench::connectionChanged, this,
            [this, bench = &workbench, address = device.address] {
                const ConnectSession& connection = bench->connection();
                // Another gripper may be connected all the time.
                if (connection.state() == ConnectSession::State::Connected &&
                    connection.identity().address == address)
                    accept();
            });
}

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
    addTitle(tr("Grippers"));
    m_none = addAction(tr("Looking for grippers on USB…"));
    m_none->setEnabled(false);
    m_afterFound = addAddress(tr("Virtual gripper, can %1").arg(u"A"_s), u"virtual:"_s);
    for (const QString& can : {u"B"_s, u"C"_s, u"D"_s})
        addAddress(tr("Virtual gripper, can %1").arg(can), u"virtual:?object=%1"_s.arg(can));
    addAddress(tr("Virtual gripper, foam that goes on yielding"), u"virtual:?object=firm-foam"_s);
    addAddress(tr("Virtual gripper, tomato"), u"virtual:?object=tomato"_s);
    addAddress(tr("Virtual gripper, worn: 1 N of friction"), u"virtual:?own-friction=1"_s);
    addAddress(tr("Virtual gripper, slow: 100 samples a second"), u"virtual:?rate=100"_s);
    connect(addAction(tr("Other address…")), &QAction::triggered, this, &ConnectMenu::askForAddress);
    addTitle(tr("This gripper"));
    addGripper();
    addTitle(tr("Tools"));
    QAction* profile = addAction(tr("Profile of another maker's gripper…"));
    profile->setObjectName("gripperProfile");
    connect(profile, &QAction::triggered, this, [this] { openProfile(); });
    addKeeping();
    m_shownRevision = 0;
    m_watcher = std::make_unique<HidWatcher>();
}

/// The style sheet paints separators without words.
void ConnectMenu::addTitle(const QString& words)
{
    if (!isEmpty())
        addSeparator();
    QLabel* label = makeLabel(words, "caption", this);
    label->setContentsMargins(16, 6, 16, 2);
    auto* title = new QWidgetAction(this);
    title->setText(words); // for who hears the menu
    title->setDefaultWidget(label);
    title->setEnabled(false); // nothing that keys stop at
    addAction(title);
}

QAction* ConnectMenu::addAddress(const QString& text, const QString& address)
{
    QAction* action = addAction(withoutKeys(text));
    const ConnectSession& connection = m_workbench->connection();
    action->setCheckable(true);
    action->setChecked(connection.state() == ConnectSession::State::Connected &&
                       connection.address() == address);
    connect(action, &QAction::triggered, m_workbench, [this, address] { m_workbench->connectTo(address); });
    return action;
}

void ConnectMenu::addGripper()
{
    const ConnectSession& connection = m_workbench->connection();
    QAction* inspect = addAction(tr("Inspect the gripper…") + u"\tF9"_s);
    inspect->setObjectName("inspectGripper");
    connect(inspect, &QAction::triggered, this,
            [this] { DeviceInspector::open(*m_workbench, parentWidget()->window()); });
    QAction* lag = addAction(tr("Measure the lag between its channels…"));
    lag->setObjectName("measureLag");
    lag->setEnabled(connection.state() == ConnectSession::State::Connected);
    connect(lag, &QAction::triggered, this,
            [this] { (new LagDialog(*m_workbench, parentWidget()))->open(); });
    if (connection.state() == ConnectSession::State::Connected &&
        connection.address().startsWith("virtual:"_L1))
        addVirtual();
    QAction* disconnect =
        addAction(connection.awaiting() ? tr("Do not wait for the gripper") : tr("Disconnect"));
    disconnect->setObjectName("disconnect");
    disconnect->setEnabled(connection.state() != ConnectSession::State::Disconnected);
    connect(disconnect, &QAction::triggered, m_workbench, [this] { m_workbench->connection().disconnect(); });
}

void ConnectMenu::addVirtual()
{
    QAction* button = addAction(tr("Press the virtual gripper's button"));
    button->setObjectName("pressButton");
    connect(button, &QAction::triggered, this, [] { virtual_button::press(); });
    constexpr double part_N = 0.5; // far above the noise of its force, far below every limit
    QAction* part = addAction(tr("A part leans on the virtual gripper"));
    part->setObjectName("leanPart");
    part->setCheckable(true);
    part->setChecked(virtual_load::load_N() > 0);
    connect(part, &QAction::triggered, this, [](bool on) { virtual_load::set(on ? part_N : 0); });
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
    m_workbench->messages().tell(
        on ? tr("From the next connection on, the raw reports of grippers are kept in %1.")
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
    m_workbench->background().compute<std::vector<FoundDevice>>( // it may read profiles
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
        auto* action = new QAction(withoutKeys(wordsOf(device, device.address == lastUsed)), this);
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
    dialog->open(); // beside the pages, which go on
}

void ConnectMenu::askForAddress()
{
    auto* dialog = new TextQuestion(tr("Connect to a gripper"),
                                    tr("Address, such as virtual:?object=B&seed=7, hid: or replay:FILE"),
                                    m_workbench->connection().address(), tr("Connect"), parentWidget());
    connect(dialog, &TextQuestion::answered, m_workbench,
            [this](const QString& address) { m_workbench->connectTo(address.trimmed()); });
    dialog->open();
}

} // namespace gripscope
