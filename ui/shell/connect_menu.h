// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/factory/gripper_factory.h"
#include "devices/hid/hid_watcher.h"
#include "ui/windows/dialog.h"

#include <QMenu>

#include <memory>

namespace gripscope {

class LagStep;
class Workbench;

/// What to type so that this user may open a gripper: a command a line, to be copied. Closes by itself when
/// the gripper is connected.
class AccessDialog : public Dialog {
    Q_OBJECT
public:
    AccessDialog(Workbench& workbench, const FoundDevice& device, QWidget* parent = nullptr);
};

/// Measures the lag between a gripper's channels with the person in front of it: what to grip, arming, the
/// squeezes as they come, the result, and whether to use it.
class LagDialog : public Dialog {
    Q_OBJECT
public:
    explicit LagDialog(Workbench& workbench, QWidget* parent = nullptr);

protected:
    void done(int result) override;

private:
    LagStep* m_step;
};

/// Which gripper to connect to: those on USB, listed as they come and go while the menu is open, the virtual
/// one with any of its cans, an address typed in; then what can be done with the one that is connected, and
/// what belongs to none.
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
    void addTitle(const QString& words); ///< of the section that follows
    QAction* addAddress(const QString& text, const QString& address);
    void addGripper(); ///< what can be done with the one that is connected
    void addVirtual(); ///< what hands do to the virtual one
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
