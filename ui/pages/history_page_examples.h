// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/signal/recording.h"

#include <QObject>

#include <vector>

namespace gripscope {

class Workbench;

/// Fills an empty history for a tour: seven simulated squeezes of the paper's cans and one of a stranger,
/// judged and stored one after another by the session like any others. Their source says that they are
/// simulated. A history that holds anything is left alone.
class ExampleInspections : public QObject {
    Q_OBJECT
public:
    ExampleInspections(Workbench& workbench, QObject* parent);

    void start();
    [[nodiscard]] bool busy() const { return m_busy; }

signals:
    void finished();

private:
    void judgeNext();
    void finish();

    Workbench* m_workbench;
    std::vector<Recording> m_waiting;
    bool m_busy = false, m_simulated = false;
};

} // namespace gripscope
