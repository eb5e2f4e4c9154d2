// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/work_watch.h"
#include "core/library/library_service.h"
#include "core/library/records/process_values.h"

namespace gripscope {

/// Reads inspections for charts on the library's thread, stretch by stretch, of which each asks for the next:
/// others, above all who stores, have their turn between two of them.
class ProcessReader {
public:
    struct Found {
        ProcessValues values;
        std::optional<ProcessLimitsRecord> limits; ///< that are fixed for the type
    };

    explicit ProcessReader(LibraryService& library) : m_library(&library) {}
    ~ProcessReader() { cancel(); }
    ProcessReader(const ProcessReader&) = delete;
    ProcessReader& operator=(const ProcessReader&) = delete;

    /// `known`: they stay at the front, and what follows is put behind them.
    void start(const ProcessQuery& query, std::shared_ptr<const ProcessValues> known = {});
    /// At once; a stretch under way, of some 0.1 s, is ended for nothing.
    void cancel();
    [[nodiscard]] bool reading() const { return m_answer.waiting(); }
    [[nodiscard]] double share() const { return m_watch ? m_watch->share() : 0; }
    /// What was read, once; Cancelled is never told.
    [[nodiscard]] std::optional<Expected<Found>> take() { return m_answer.take(); }

private:
    LibraryService* m_library;
    std::shared_ptr<WorkWatch> m_watch;
    Pending<Expected<Found>> m_answer;
};

} // namespace gripscope
