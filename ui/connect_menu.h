// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/gripper_factory.h"
#include "devices/hid/hid_watcher.h"

#include <QMenu>

namespace gripscope {

class Workbench;

/// Which gripper to connect to: those on USB, listed as they come and go while the menu is open, the virtual
/// one with any of its cans, an address typed in, or none.
class ConnectMenu : public QMenu {
    Q_OBJECT
public:
    explicit ConnectMenu(Workbench& workbench, QWidget* parent = nullptr);

    /// What the menu says of a gripper on USB: name, serial number, and what else there is to know.
    [[nodiscard]] static QString wordsOf(const FoundDevice& device, bool lastUsed);
    /// Puts these in place of the grippers that are listed.
    void showFound(const std::vector<FoundDevice>& devices);

private:
    void open();
    void follow();
    void choose(const FoundDevice& device);
    void askForAddress();
    void addAddress(const QString& text, const QString& address);
    void addActions();
    void openProfile();
    void addKeeping();
    void keepSessions(bool on);

    Workbench* m_workbench;
    std::unique_ptr<HidWatcher> m_watcher; ///< while the menu is open
    std::uint64_t m_shownRevision = 0;
    QAction* m_none = nullptr;       ///< stands where no gripper is found
    QAction* m_afterFound = nullptr; ///< follows them
    QList<QAction*> m_found;
};

} // namespace gripscope
