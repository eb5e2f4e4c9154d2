// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library_service.h"
#include "core/library/records/batch.h"
#include "core/recognition/types/type_shift.h"
#include "core/session/inspect/inspect_session.h"
#include "core/session/squeeze/comparable_units.h"
#include "core/session/squeeze/early_watch.h"
#include "core/session/squeeze/hold_history.h"
#include "core/session/tasks/pool.h"

#include <chrono>
#include <deque>
#include <functional>
#include <list>

namespace gripscope {

/// One recording after another: identified and judged in the thread pool (a gate may take 50 ms), while the
/// owner polls. The squeezes of a session tell together how a gripper holds its force.
class InspectionJudge {
public:
    IdentificationOptions identification;
    VerdictOptions rates;
    std::optional<CommonShift> transfer; ///< the squeezes come from another gripper than the types
    std::function<void()> wake;          ///< when there is something to take(); may be empty

    struct Judged {
        Recording recording;
        Identification identification;
        Verdict verdict;
        VerdictOptions rates; ///< those in force when it began; they may be set anew meanwhile
    };

    /// UnitsDiffer: the recording cannot be compared with the types.
    [[nodiscard]] Expected<void> start(Recording recording, const ComparableTypes& types);
    /// What was found, once.
    [[nodiscard]] std::optional<Judged> take();
    void forget() { m_task.forget(); }

private:
    struct Found {
        Identification identification;
        Verdict verdict;
    };
    Pending<Found> m_task;
    HoldHistory m_holds;
    Recording m_measured; ///< what is being identified
    VerdictOptions m_ratesThen;
};

/// What inspections read from the library and write into it, on the library's thread while the owner polls:
/// the types, the counts, and the batch that inspections belong to.
class InspectionArchive {
public:
    explicit InspectionArchive(LibraryService& library) : m_library(library) {}
    ~InspectionArchive(); ///< what only waits for its turn is left to the library's thread
    InspectionArchive(const InspectionArchive&) = delete;
    InspectionArchive& operator=(const InspectionArchive&) = delete;

    /// Reads all of it again.
    void load(std::function<void(const Expected<void>&)> done);
    void setClock(SqueezeJob::Clock clock) { m_clock = std::move(clock); }
    /// Stores an inspection, and ends its batch when that is whole by it. One after another in their order:
    /// what the library cannot take now (a full disk, a lock, a file that was taken away) is tried again
    /// every few seconds, and those behind it wait. `told` hears, once, the number; or why no library will
    /// take it.
    void keep(const NewInspection& inspection, std::function<void(const Expected<qint64>&)> told);
    void beginBatch(const NewBatch& batch, std::function<void(const Expected<void>&)> done);
    void endBatch(const QString& operatorName, std::function<void(const Expected<void>&)> done);
    bool poll();                                                            ///< true when an answer came
    [[nodiscard]] std::size_t unstored() const { return m_waiting.size(); } ///< inspections on their way
    [[nodiscard]] const std::optional<Error>& obstacle() const { return m_obstacle; } ///< why they wait
    [[nodiscard]] bool changingBatch() const { return m_changing > 0; } ///< its begin or end is on its way

    [[nodiscard]] const std::vector<TypeRecord>& types() const { return m_types; }
    [[nodiscard]] const ComparableTypes& comparable() const { return m_comparable; }
    [[nodiscard]] const InspectionCounts& counts() const { return m_standing.counts; }
    /// The one under way here, or the one that was ended last, until the next begins.
    [[nodiscard]] const std::optional<BatchRecord>& batch() const { return m_standing.batch; }

private:
    /// How things stand after a request.
    struct Standing {
        InspectionCounts counts;
        std::optional<BatchRecord> batch;
    };
    struct Loaded {
        std::vector<TypeRecord> types;
        ComparableTypes comparable;
        Standing standing;
    };
    struct Kept {
        qint64 number = 0;
        Standing standing;
    };
    [[nodiscard]] static Expected<Loaded> read(Library& library);
    [[nodiscard]] static Expected<Kept> store(Library& library, const NewInspection& inspection);
    [[nodiscard]] static Expected<Standing> standing(Library& library,
                                                     const Expected<std::optional<BatchRecord>>& batch);
    struct Waiting {
        NewInspection inspection;
        std::function<void(const Expected<qint64>&)> told;
    };
    void storeFirst();
    void takeStored(const Expected<Kept>& kept, std::uint64_t request);
    void changeBatch(std::function<Expected<BatchRecord>(Library&)> work,
                     std::function<void(const Expected<void>&)> done);
    void take(Standing standing, std::uint64_t request);

    LibraryService& m_library;
    PendingCall m_loading;
    std::list<PendingCall> m_answers; ///< in the order in which they were asked for
    std::deque<Waiting> m_waiting;    ///< the first is being stored, or will be at m_nextTry
    PendingCall m_storing;
    std::optional<std::chrono::steady_clock::time_point> m_nextTry;
    std::optional<Error> m_obstacle;
    SqueezeJob::Clock m_clock = std::chrono::steady_clock::now;
    int m_changing = 0;
    std::vector<TypeRecord> m_types;
    ComparableTypes m_comparable;
    Standing m_standing;
    std::uint64_t m_requests = 0, m_stood = 0; ///< the number of the last, and of the one m_standing is from
};

struct InspectSession::Private {
    Private(ConnectSession& session, LibraryService& service)
        : connection(session), archive(service), job(session)
    {
    }

    ConnectSession& connection;
    InspectionArchive archive;
    SqueezeJob job;
    InspectionJudge judge;
    EarlyWatch watch;
    SqueezeForecast forecast;
    int listener = 0;
    Recipe recipe;
    QString operatorName, expectedType;
    bool storeResults = true, endsEarly = true, forecasting = false;

    State state = State::Loading;
    QString source, measuredExpectedType, measuredBatch; // as they were when the squeeze began
    std::optional<EarlyEnd> measuredEarlyEnd;
    std::uint64_t squeezes = 0;
    std::optional<Result> result;
    std::optional<Error> error;

    void reload();
    [[nodiscard]] Expected<void> ready() const;
    [[nodiscard]] Recipe wantedRecipe() const;
    [[nodiscard]] std::optional<EarlyStopSetup> earlyStopSetup() const;
    void begin(State next);
    void followSqueeze();
    bool pollForecast();
    void fail(const Error& reason);
    void identify(Recording recording, const QString& from);
    void show(InspectionJudge::Judged judged);
    void keep(const VerdictOptions& rates);
    void noticeFailure(const Expected<void>& done);
};

} // namespace gripscope
