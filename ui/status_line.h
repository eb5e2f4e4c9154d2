// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

namespace gripscope {

class ElidedLabel;
class Workbench;

/// The line under every page: gripper, armed or not, latency, library, counts.
class StatusLine : public QFrame {
    Q_OBJECT
public:
    explicit StatusLine(Workbench& workbench, QWidget* parent = nullptr);
    [[nodiscard]] QString text() const { return m_shown; }

private:
    void refresh();
    Workbench* m_workbench;
    ElidedLabel* m_label;
    QString m_shown;
};

} // namespace gripscope
