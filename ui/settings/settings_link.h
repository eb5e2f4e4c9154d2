// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

namespace gripscope {

class Workbench;

/// Brings what persons set to the theme and the workbench, at once and whenever it changes, and what they set
/// elsewhere (the operator's field, the Rates window, the gripper menu) back into the settings.
class SettingsLink : public QObject {
    Q_OBJECT
public:
    explicit SettingsLink(Workbench& workbench, QObject* parent = nullptr);
    /// What the start connects to; empty: nothing.
    [[nodiscard]] static QString addressAtStart(Workbench& workbench);

private:
    void apply(const QString& key);
    void applyKeeping();
    void rememberGripper();
    Workbench* m_workbench;
    bool m_applying = false;
};

} // namespace gripscope
