// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library_service.h"
#include "core/library/records/batch.h"
#include "core/library/records/gripper_adjustment.h"
#include "core/quality/drift.h"
#include "core/recognition/early/early_stop.h"
#include "core/recognition/verdict/inspection_outcome.h"
#include "core/session/inspect/judging_policy.h"
#include "core/session/squeeze/squeeze_job.h"

#include <functional>
#include <memory>
#include <optional>

namespace gripscope {

/// Inspections one after another.
///
///     Loading -> Ready -> Squeezing -> Judging -> Ready (result()) ...
///
/// The squeezes of a session tell together how a gripper holds its force (hold_evidence.h); what was judged
/// before stays as it was.
///
/// A squeeze of the gripper ends as soon as it is decided (EarlyStop, in the thread pool; a decision that
/// comes late only makes the squeeze longer). Its record is identified and judged as any other, and where
/// that says something else than the decision, the verdict is inconclusive (verdictOnEarlyEnd()).
///
/// The verdict is shown as soon as it is known; storing goes on behind it (Result::keeping): first into a
/// file that outlives this program (InspectionSpill), then into the library. What the library cannot take is
/// tried again, in its order, by the next program too; until then that is lastError(). After mostUnstored of
/// them, and where that file has no room, there is no further squeeze.
class InspectSession {
public:
    enum class State { Loading, Ready, Squeezing, Judging };
    static constexpr std::size_t mostUnstored = 50; ///< some megabytes

    InspectSession(ConnectSession& connection, LibraryService& library);
    ~InspectSession();
    InspectSession(const InspectSession&) = delete;
    InspectSession& operator=(const InspectSession&) = delete;

    void setOperator(const QString& name);
    void setExpectedType(const QString& name); ///< empty: none
    void setRates(const VerdictOptions& rates);
    /// From the next squeeze on. What is refused is kept like any other, not valid, with the reason.
    void setPolicy(const JudgingPolicy& policy);
    void setIdentificationOptions(const IdentificationOptions& options);
    /// The squeezes come from another gripper than the types, with this error or none, whatever gripper they
    /// name. Until this is said, those of a gripper that the library has an adjustment for are adjusted by
    /// it. Nothing ends early where squeezes are adjusted.
    void setTransfer(const std::optional<CommonShift>& error);
    void setTransferOfLibrary(); ///< again as before that was said
    /// Used when nothing is expected. Until then it is that of the approved type with the lowest crush limit,
    /// with the least travel of all of them, since it may be any. A type that is expected has its own.
    void setRecipe(const Recipe& recipe);
    void setStoring(bool store);            ///< off: classify only (the command line)
    void setEarlyEnd(bool early);           ///< on unless told otherwise
    void setClock(SqueezeJob::Clock clock); ///< for the time limits of a squeeze, and when to store again
    /// Whether forecast() is worked out while nothing else is done; off unless told otherwise.
    void setForecasting(bool on);
    /// Called on another thread when a squeeze was judged, so that poll() need not wait for its next turn.
    void setWake(std::function<void()> wake);
    void reload(); ///< the library changed
    /// What was scanned on the part that is squeezed next; kept with it, and forgotten once it was squeezed.
    void setPartNumber(const QString& number);
    /// shiftCounts() are of the inspections with a number behind this one; 0: of all.
    void setShiftStart(qint64 after);
    /// The inspection shown by result(), which is stored, counts no longer. Done behind; a failure is
    /// lastError().
    void voidLast(const QString& reason);

    /// Inspections that begin from now on are counted for a batch, until it is whole (then it ends by itself)
    /// or is ended. One that is under way goes on after a restart. Done behind; a failure is lastError().
    void beginBatch(const NewBatch& batch);
    void endBatch();

    [[nodiscard]] Expected<void> squeeze();
    /// `earlyEnd`: of a squeeze that is judged again, what had ended it before its time.
    [[nodiscard]] Expected<void> judgeRecording(Recording recording, const QString& source,
                                                const std::optional<EarlyEnd>& earlyEnd = {});
    void cancel();
    bool poll(); ///< never waits; true when something changed

    enum class Keeping {
        NotWanted, ///< classified only
        Waiting,   ///< not stored yet
        Stored,
        Refused, ///< the library will never take it; lastError() says why
    };
    struct Result {
        Keeping keeping = Keeping::NotWanted;
        qint64 number = 0; ///< in the library; 0 until it is stored
        Recording recording;
        Identification identification;
        Verdict verdict;
        InspectionOutcome outcome = InspectionOutcome::NotValid;
        QString expectedType;
        double seconds = 0; ///< lengthSeconds() of its recording
        /// Counts the squeezes of the session, so that two results are told apart before they are stored.
        std::uint64_t squeeze = 0;
        /// What ended the squeeze before its time.
        std::optional<EarlyEnd> earlyEnd = {};
        bool refused = false;      ///< by the policy; it could have been judged
        VerdictOptions rates = {}; ///< that the verdict is held to; others may be in force by now
        QString partNumber = {};
        int invalidInARow = 0;     ///< with this one; 0 where it is valid
        bool voided = false;       ///< it counts no longer
        QString adjustmentId = {}; ///< of the library, that it was judged with; empty: none
    };
    [[nodiscard]] State state() const;
    [[nodiscard]] double progress() const;
    [[nodiscard]] const std::optional<Result>& result() const; ///< of the last squeeze
    [[nodiscard]] bool looking() const;                        ///< samples of the squeeze are being looked at
    /// How long squeezes of the enrolled types take until they are decided. Nothing while this is worked out,
    /// where it cannot be, and where squeezes do not end early.
    [[nodiscard]] const std::optional<EarlyTimes>& forecast() const;
    [[nodiscard]] Recipe nextRecipe() const; ///< what the next squeeze is made by
    [[nodiscard]] bool earlyEnd() const;
    [[nodiscard]] const VerdictOptions& rates() const;
    [[nodiscard]] const JudgingPolicy& policy() const;
    [[nodiscard]] InspectionCounts counts() const; ///< of all inspections
    [[nodiscard]] const InspectionCounts& shiftCounts() const;
    [[nodiscard]] const QString& expectedType() const;
    [[nodiscard]] const QString& partNumber() const; ///< of the next squeeze
    /// The batch under way, or the one that ended last while the program ran.
    [[nodiscard]] const std::optional<BatchRecord>& batch() const;
    [[nodiscard]] bool changingBatch() const; ///< a begin or an end is on its way into the library
    /// Of the approved types, which alone a part can be; in SI where any type's units are known.
    [[nodiscard]] const TypeModels& models() const;
    [[nodiscard]] const std::vector<TypeRecord>& types() const; ///< all in use, approved or not
    [[nodiscard]] std::vector<TypeRecord> approvedTypes() const;
    /// Of the connected gripper, that its squeezes are adjusted by; nothing where they are not.
    [[nodiscard]] std::optional<AdjustmentStanding> adjustment() const;
    /// The newest inspected squeezes, of this session and before, against the enrolment of their types; as of
    /// the last look, which follows each squeeze.
    [[nodiscard]] const std::optional<DriftReport>& drift() const;
    /// What the control charts of the last squeeze's type say of it, where somebody fixed their limits: a
    /// sentence with the quantity, what is wrong and since which inspection. Nothing where all is steady.
    [[nodiscard]] const std::optional<Finding>& processSignal() const;
    [[nodiscard]] bool
    storing() const; ///< inspections are on their way into the library, and nothing is wrong
    [[nodiscard]] std::size_t unstored() const; ///< so many are on their way, or wait
    [[nodiscard]] std::size_t spilled() const;  ///< of these, so many are kept should the program end now
    [[nodiscard]] std::optional<Error> lastError() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace gripscope
