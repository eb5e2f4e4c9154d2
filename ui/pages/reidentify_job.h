// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/history.h"
#include "core/store/library.h"

#include <QObject>

namespace gripscope {

class Workbench;

/// A stored squeeze beside what another estimator finds in its recording.
struct ReidentifiedSqueeze {
    HistoryEntry entry;
    std::optional<Estimate> estimate; ///< without its curves
    QString trouble;                  ///< why there is none: no recording, or damaged
};

/// Identifies stored squeezes again, one after another: each recording is fetched on the library's thread and
/// identified in the pool.
class ReidentifyJob : public QObject {
    Q_OBJECT
public:
    ReidentifyJob(Workbench& workbench, QObject* parent);

    void start(std::vector<QString> graspIds, Estimator estimator, const Reidentification& how);
    void cancel(); ///< after the squeeze that is being worked on
    [[nodiscard]] bool running() const { return m_running; }
    [[nodiscard]] std::size_t total() const { return m_ids.size(); }
    [[nodiscard]] const std::vector<ReidentifiedSqueeze>& results() const { return m_results; }

signals:
    void progressed();
    void ended();

private:
    void next();
    void take(ReidentifiedSqueeze squeeze);

    Workbench* m_workbench;
    std::vector<QString> m_ids;
    std::vector<ReidentifiedSqueeze> m_results;
    Estimator m_estimator = Estimator::OutputError;
    Reidentification m_how;
    bool m_running = false, m_cancelled = false;
};

} // namespace gripscope
