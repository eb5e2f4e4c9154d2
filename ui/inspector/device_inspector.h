// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "devices/inspection/device_facts.h"
#include "ui/windows/dialog.h"

class QTableWidget;

namespace gripscope {

class ReportsTab;
class SelfTestTab;
class Workbench;

/// What a gripper is, what it sends and how well: identity, report descriptor, last reports, counters,
/// self-test. A window beside the main one; there is one at a time.
class DeviceInspector : public Dialog {
    Q_OBJECT
public:
    /// Opens it, or brings the one that is open to the front.
    using Dialog::open;
    static DeviceInspector* open(Workbench& workbench, QWidget* parent);

    explicit DeviceInspector(Workbench& workbench, QWidget* parent = nullptr);
    [[nodiscard]] ReportsTab& reports() { return *m_reports; }
    [[nodiscard]] SelfTestTab& selfTest() { return *m_selfTest; }

private:
    QWidget* makeIdentity();
    QWidget* makeDescriptor();
    QWidget* makeCounters();
    void lookUp();  ///< identity and descriptor, when the gripper changes
    void refresh(); ///< reports and counters
    void showIdentity(const DeviceFacts& facts);
    void showDescriptor(const DeviceFacts& facts);
    void showCounters();

    Workbench* m_workbench;
    ReportsTab* m_reports;
    SelfTestTab* m_selfTest;
    QTableWidget *m_identity = nullptr, *m_descriptor = nullptr, *m_counters = nullptr;
    LinkCounters m_lookedAt; ///< as they were when someone asked to count from there on
    QString m_known;         ///< address and serial of the gripper that is shown
};

} // namespace gripscope
