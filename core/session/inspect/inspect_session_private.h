// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library_service.h"
#include "core/library/records/batch.h"
#include "core/library/spill/inspection_spill.h"
#include "core/quality/drift.h"
#include "core/recognition/types/type_shift.h"
#include "core/session/inspect/inspect_session.h"
#include "core/session/process/process_watch.h"
#include "core/session/squeeze/comparable_units.h"
#include "core/session/squeeze/early_watch.h"
#include "core/session/squeeze/hold_history.h"
#include "core/session/tasks/pool.h"

#include <chrono>
#include <deque>
#include <functional>
#include <list>
#include <optional>

namespace gripscope {

/// One recording after another: identified and judged in the thread pool (a gate may take 50 ms), while the
/// owner polls. The squeezes of a session tell together how a gripper holds its force.
class InspectionJudge {
public:
    IdentificationOptions identification;
    VerdictOptions rates;
    std::function<void()> wake; ///< when there is something to take(); may be empty

    struct Judged {
        Recording recording;
        Identification identification;
        Verdict verdict;
        VerdictOptions rates; ///< those in force when it began; they may be set anew meanwhile
    };

    /// `transfer`: the squeeze comes from another gripper than the types. UnitsDiffer: the recording cannot
    /// be compared with the types.
    [[nodiscard]] Expected<void> start(Recording recording, const ComparableTypes& types,
                                       const std::optional<CommonShift>& transfer);
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
    /// Sets room aside for what the library cannot take, and goes on with what earlier programs left there.
    /// `done` hears that it is known whether there is room, once; without room it is tried again every few
    /// seconds. `lost` hears what of the earlier could not be read or stored, and where it is kept.
    void openSpill(std::function<void()> done, std::function<void(const Error&)> lost);
    [[nodiscard]] bool spillAsked() const { return m_spillAsked; }
    [[nodiscard]] bool spillKnown() const;
    [[nodiscard]] const std::optional<Error>& spillProblem() const { return m_spillProblem; }
    /// Whether one more inspection would be safe; Usage says why not.
    [[nodiscard]] Expected<void> roomForOneMore() const;
    /// Puts an inspection into the spill file, then stores it, and ends its batch when that is whole by it.
    /// One after another in their order: what the library cannot take now (a full disk, a lock, a file that
    /// was taken away) is tried again every few seconds, and those behind it wait. `told` hears, once, the
    /// number; or why no library will take it.
    void keep(const NewInspection& inspection, std::function<void(const Expected<qint64>&)> told);
    void beginBatch(const NewBatch& batch, std::function<void(const Expected<void>&)> done);
    void endBatch(const QString& operatorName, std::function<void(const Expected<void>&)> done);
    void voidInspection(qint64 number, const QString& reason, const QString& operatorName,
                        std::function<void(const Expected<void>&)> done);
    void setShiftStart(qint64 after);
    bool poll();                                                            ///< true when an answer came
    [[nodiscard]] std::size_t unstored() const { return m_waiting.size(); } ///< inspections on their way
    [[nodiscard]] std::size_t spilled() const; ///< of these, so many would outlive this program
    [[nodiscard]] const std::optional<Error>& obstacle() const { return m_obstacle; } ///< why they wait
    [[nodiscard]] bool changingBatch() const { return m_changing > 0; } ///< its begin or end is on its way

    [[nodiscard]] const std::vector<TypeRecord>& types() const { return m_types; }
    /// Of a gripper with this serial number.
    [[nodiscard]] const AdjustmentStanding* adjustmentOf(const QString& gripperSerial) const;
    [[nodiscard]] const ComparableTypes& comparable() const { return m_comparable; }
    /// Of the library, that these types are of.
    [[nodiscard]] qint64 version() const { return m_version; }
    [[nodiscard]] const InspectionCounts& counts() const { return m_standing.counts; }
    [[nodiscard]] const InspectionCounts& shiftCounts() const { return m_standing.shift; }
    /// The one under way here, or the one that was ended last, until the next begins.
    [[nodiscard]] const std::optional<BatchRecord>& batch() const { return m_standing.batch; }

private:
    /// How things stand after a request.
    struct Standing {
        InspectionCounts counts, shift;
        std::optional<BatchRecord> batch;
    };
    struct Loaded {
        std::vector<TypeRecord> types;
        ComparableTypes comparable;
        Standing standing;
        qint64 version = 0;
        std::vector<AdjustmentStanding> adjustments;
    };
    struct Kept {
        qint64 number = 0;
        Standing standing;
    };
    // `after`: where the shift begins.
    [[nodiscard]] static Expected<Loaded> read(Library& library, qint64 after);
    [[nodiscard]] static Expected<Kept> store(Library& library, const NewInspection& inspection,
                                              qint64 after);
    [[nodiscard]] static Expected<Standing>
    standing(Library& library, const Expected<std::optional<BatchRecord>>& batch, qint64 after);
    enum class Spilled {
        NotYet,
        OnItsWay,
        Yes,
        Cannot, ///< it is kept by this program alone
    };
    struct Waiting {
        NewInspection inspection;
        std::function<void(const Expected<qint64>&)> told;
        Spilled spilled = Spilled::NotYet;
        qint64 place = 0; ///< in the spill file, where it is there
        bool fromBefore = false;
    };
    [[nodiscard]] static Expected<Kept> storeWaiting(Library& library, InspectionSpill& spill,
                                                     const Waiting& waiting, qint64 after);
    [[nodiscard]] std::function<Expected<Kept>(Library&)> storing(const Waiting& waiting) const;
    void spillNext();
    void takeSpilled(const QString& id, const Expected<qint64>& place);
    void tryToOpenSpill();
    void takeOpened(Expected<InspectionSpill::Opened> opened);
    void goOnWith(std::vector<SpilledInspection> earlier);
    void storeNext();
    void takeStored(const Expected<Kept>& kept, std::uint64_t request);
    /// `work` returns the batch under way, or the one that it ended.
    void change(std::function<Expected<std::optional<BatchRecord>>(Library&)> work,
                std::function<void(const Expected<void>&)> done);
    void changeBatch(std::function<Expected<BatchRecord>(Library&)> work,
                     std::function<void(const Expected<void>&)> done);
    void take(Standing standing, std::uint64_t request);

    LibraryService& m_library;
    PendingCall m_loading;
    std::list<PendingCall> m_answers; ///< in the order in which they were asked for
    std::deque<Waiting> m_waiting;    ///< the first is being stored, or will be at m_nextTry
    PendingCall m_storing, m_spilling, m_openingSpill;
    /// Shared with what was asked of the library, which says there what is stored.
    std::shared_ptr<InspectionSpill> m_spill = std::make_shared<InspectionSpill>();
    bool m_spillAsked = false;
    std::function<void()> m_spillOpened; ///< told once
    std::function<void(const Error&)> m_lost;
    std::optional<Error> m_spillProblem; ///< why nothing more can be kept safe
    std::optional<std::chrono::steady_clock::time_point> m_nextSpillTry;
    std::optional<std::chrono::steady_clock::time_point> m_nextTry;
    std::optional<Error> m_obstacle;
    SqueezeJob::Clock m_clock = std::chrono::steady_clock::now;
    int m_changing = 0;
    qint64 m_shiftStart = 0;
    std::vector<TypeRecord> m_types;
    std::vector<AdjustmentStanding> m_adjustments;
    ComparableTypes m_comparable;
    qint64 m_version = 0;
    Standing m_standing;
    std::uint64_t m_requests = 0, m_stood = 0; ///< the number of the last, and of the one m_standing is from
};

/// Holds the newest inspected squeezes against the enrolment of their types while parts are inspected
/// (findDrift(), in the thread pool); those that were recognised, so that another part is no news of the type
/// that was expected. What the library has is read once; each squeeze that is inspected joins
/// it. One look at a time; what comes meanwhile is looked at next.
class DriftWatch {
public:
    /// So many inspections are looked back at: enough for the charts of some types.
    static constexpr int newest = 400;

    explicit DriftWatch(LibraryService& library) : m_library(library) {}

    /// The types are these from now on; the squeezes are those of the library.
    void load(const TypeModels& models);
    /// One more, in the models' units. Before load() was answered it is among those of the library, or the
    /// next load()'s.
    void add(const TypeSqueeze& squeeze);
    bool poll(); ///< true when there is something new
    /// Of the last look; nothing before the first.
    [[nodiscard]] const std::optional<DriftReport>& report() const { return m_report; }

private:
    void look();

    LibraryService& m_library;
    TypeModels m_models;
    std::deque<TypeSqueeze> m_squeezes; ///< oldest first
    PendingCall m_loading, m_looking;
    bool m_isNew = false; ///< something was not looked at yet
    std::optional<DriftReport> m_report;
};

struct InspectSession::Private {
    Private(ConnectSession& session, LibraryService& service)
        : connection(session), archive(service), drift(service), process(service), job(session)
    {
    }

    ConnectSession& connection;
    InspectionArchive archive;
    DriftWatch drift;
    ProcessWatch process;
    QString processType; ///< of the inspection that was stored last
    SqueezeJob job;
    InspectionJudge judge;
    EarlyWatch watch;
    SqueezeForecast forecast;
    int listener = 0;
    std::optional<Recipe> recipe; ///< that was asked for
    bool isTransferStated = false;
    std::optional<CommonShift> statedTransfer;
    QString operatorName, expectedType, partNumber;
    bool storeResults = true, endsEarly = true, forecasting = false;

    State state = State::Loading;
    // As they were when the squeeze began.
    QString source, measuredExpectedType, measuredBatch, measuredPartNumber;
    std::optional<EarlyEnd> measuredEarlyEnd;
    JudgingPolicy policy, measuredPolicy;
    qint64 judgedVersion = 0;            // of the library, when the squeeze was judged
    std::vector<TypeRecord> judgedTypes; // with the limits of that version
    std::optional<CommonShift> judgedTransfer;
    QString judgedAdjustment; // its key in the library
    std::uint64_t squeezes = 0;
    int invalidInARow = 0;
    std::optional<Result> result;
    std::optional<Error> error;

    void reload();
    void openSpill();
    [[nodiscard]] Expected<void> ready();
    [[nodiscard]] Recipe wantedRecipe() const;
    /// What squeezes of a gripper are adjusted by.
    [[nodiscard]] std::optional<CommonShift> transferOf(const QString& gripperSerial) const;
    [[nodiscard]] std::optional<EarlyStopSetup> earlyStopSetup() const;
    void begin(State next);
    void followSqueeze();
    bool pollForecast();
    void fail(const Error& reason);
    void identify(Recording recording, const QString& from);
    void show(InspectionJudge::Judged judged);
    [[nodiscard]] std::optional<Conformity> conformityTo(const QString& type,
                                                         const InspectionJudge::Judged& judged) const;
    void keep(const VerdictOptions& rates);
    void watchDrift(const NewInspection& inspection);
    void noticeFailure(const Expected<void>& done);
};

} // namespace gripscope
