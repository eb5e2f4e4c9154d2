// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/work_watch.h"
#include "core/library/library_service.h"
#include "core/session/process/process_chart.h"
#include "core/session/tasks/pool.h"

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

/// All that a page shows of a process, drawn from one state.
struct ProcessPicture {
    std::shared_ptr<const ProcessValues> values;
    ProcessOptions options;
    ProcessFilter filter;
    ProcessRows rows;                                           ///< that the filter lets through
    std::array<Expected<QuantityChart>, 3> charts = noCharts(); ///< m, b, k; not of T^2
    std::optional<Expected<JointChart>> joint;                  ///< of T^2 alone
    std::array<Expected<ProcessCapability>, 3> capabilities = noCapabilities();
    RunLengths runLengths;

    [[nodiscard]] static std::array<Expected<QuantityChart>, 3> noCharts();
    [[nodiscard]] static std::array<Expected<ProcessCapability>, 3> noCapabilities();
};

/// The charts of a type's inspections as a page holds them: read once, drawn anew in a pool of its own when
/// options or filter change, gone on with when something was inspected. Polled; never waits.
class ProcessSession {
public:
    enum class State { Idle, Reading, Drawing, Shown, Cancelled, Failed };

    explicit ProcessSession(LibraryService& library);
    ~ProcessSession();

    /// Reads anew, unless that is what is there already.
    void setQuery(const ProcessQuery& query);
    void setFilter(const ProcessFilter& filter);
    /// `options.fixed` is the session's own: what the library has for the type.
    void setOptions(const ProcessOptions& options);
    void setUsesFixed(bool uses); ///< limits that are fixed; else those of the inspections shown
    void reload();                ///< all of it: something was voided
    void refresh();               ///< what was stored since
    void cancel();                ///< at once; what was shown before stays
    /// From the inspections with these numbers, of those that the filter lets through; kept in the library.
    Expected<void> fix(qint64 first, qint64 last, const QString& operatorName);
    void release(const QString& operatorName); ///< no fixed limits any more

    bool poll(); ///< true when there is something new
    [[nodiscard]] State state() const { return m_state; }
    [[nodiscard]] bool busy() const { return m_state == State::Reading || m_state == State::Drawing; }
    [[nodiscard]] double share() const { return m_reader.share(); } ///< of the reading
    [[nodiscard]] const std::shared_ptr<const ProcessPicture>& picture() const { return m_picture; }
    [[nodiscard]] const std::shared_ptr<const ProcessValues>& values() const { return m_values; }
    [[nodiscard]] const ProcessQuery& query() const { return m_query; }
    [[nodiscard]] const ProcessOptions& options() const { return m_options; }
    [[nodiscard]] const std::optional<FixedLimits>& fixedLimits() const { return m_fixed; }
    [[nodiscard]] const std::optional<ProcessLimitsRecord>& fixedRecord() const { return m_record; }
    [[nodiscard]] bool usesFixed() const { return m_usesFixed; }
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }

private:
    void read(std::shared_ptr<const ProcessValues> known);
    void takeRead(ProcessReader::Found found);
    void takeRecord(const std::optional<ProcessLimitsRecord>& record);
    void draw();
    void takeDrawn();
    void fail(const Error& error);
    void store(const QString& limits, const QString& operatorName);

    struct Drawing;
    LibraryService* m_library;
    ProcessReader m_reader;
    ProcessQuery m_query;
    ProcessFilter m_filter;
    ProcessOptions m_options;
    bool m_usesFixed = true;
    State m_state = State::Idle;
    bool m_behind = false; ///< something was stored while it was busy
    std::shared_ptr<const ProcessValues> m_values;
    std::optional<FixedLimits> m_fixed;
    std::optional<ProcessLimitsRecord> m_record;
    std::shared_ptr<const ProcessPicture> m_picture;
    std::optional<Error> m_error;
    PendingCall m_storing;
    std::shared_ptr<Drawing> m_drawing;
    std::optional<std::pair<QString, RunLengths>> m_runLengths; ///< by what they depend on
    QThreadPool m_pool;
};

} // namespace gripscope
