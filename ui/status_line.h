// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

namespace gripscope {

class ElidedLabel;
class Workbench;

/// The line under every page: gripper, armed or not, latency, how its calibration and its check stand,
/// library and its version, counts.
class StatusLine : public QFrame {
    Q_OBJECT
public:
    explicit StatusLine(Workbench& workbench, QWidget* parent = nullptr);
    [[nodiscard]] QString text() const { return m_shown; }

private:
    void refresh();
    void askVersion();
    [[nodiscard]] QStringList standing() const; ///< of the connected gripper's channels
    Workbench* m_workbench;
    ElidedLabel* m_label;
    QString m_shown;
    qint64 m_version = 0; ///< of the library; 0: not known yet
};

} // namespace gripscope
