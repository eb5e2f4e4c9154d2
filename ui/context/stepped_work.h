// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/library.h"

#include <QObject>

#include <functional>

namespace gripscope {

class Workbench;

/// Long work with the library, done a step at a time on its thread, so that others get their turn in between
/// and a person can cancel. Goes away by itself when it has ended.
class SteppedWork : public QObject {
    Q_OBJECT
public:
    struct Progress {
        std::size_t done = 0, total = 0;
        bool more = true; ///< false: that was the last step
    };
    using Step = std::function<Expected<Progress>(Library&)>;

    SteppedWork(Workbench& workbench, Step step, QObject* parent);
    void start();
    /// No further step; what the steps hold is let go of, and with it files that were not finished.
    void cancel();

signals:
    void progressed(qsizetype done, qsizetype total);
    void ended(bool complete); ///< false: cancelled or failed; a failure has been reported

private:
    void next();
    void end(bool complete);

    Workbench* m_workbench;
    Step m_step;
    bool m_cancelled = false;
};

} // namespace gripscope
