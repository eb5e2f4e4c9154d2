// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"

#include <QDateTime>
#include <QString>

#include <array>
#include <cstdint>
#include <optional>

namespace gripscope {

// What a line (a PLC, whatever the wire) asks of a station and gets, with the names and numbers of OPC
// 40100-1 (machine vision, whose job, result and state machine these are) and OPC 40001-101 (result
// transfer).

/// Operational is Initialized to ContinuousExecution. The numbers are this program's own, and are sent.
enum class LineState : std::uint16_t {
    Preoperational = 0,      ///< no gripper, or the library is still being read
    Initialized = 1,         ///< a gripper, not armed: nothing may move
    Ready = 2,               ///< armed: a job may come
    SingleExecution = 3,     ///< a squeeze is under way, whoever asked for it
    ContinuousExecution = 4, ///< has no use here, and keeps its number
    Halted = 5,              ///< stopped, by a person or since the PLC fell silent: until a person arms again
    Error = 6,               ///< nothing can be squeezed; the station says why
};
[[nodiscard]] QString toString(LineState state); ///< "Preoperational", ...

/// OPC 40001-101, ResultState.
enum class ResultState : std::uint16_t {
    Undefined = 0,
    Completed = 1,
    Processing = 2,
    Aborted = 3,
    Failed = 4
};

/// OPC 40001-101, ResultEvaluation. What was not measured, or not well enough to judge, is NotDecidable and
/// never NotOk: nothing is held against the part.
enum class ResultEvaluation : std::uint16_t { Undefined = 0, Ok = 1, NotOk = 2, NotDecidable = 3 };
[[nodiscard]] QString toString(ResultEvaluation evaluation); ///< "Undefined", "OK", "NotOK", "NotDecidable"

/// Why the evaluation is what it is.
enum class ResultReason : std::uint16_t {
    None = 0,
    AsExpected = 1,
    OtherType = 2,
    Unknown = 3,
    Inconclusive = 4,
    NotValid = 5,
    DoesNotConform = 6,
    NotMeasured = 7, ///< the squeeze did not come to its end
};
[[nodiscard]] ResultEvaluation evaluationOf(ResultReason reason);
[[nodiscard]] QString toString(ResultState state);   ///< "Undefined", "Completed", ...
[[nodiscard]] QString toString(ResultReason reason); ///< "None", "AsExpected", ...

/// What became of a job that was asked for.
enum class JobAnswer : std::uint16_t {
    None = 0,             ///< nothing was asked yet
    Taken = 1,            ///< its result will come, whatever happens to the squeeze
    ResultUnread = 2,     ///< overrun: a result has not been acknowledged
    Busy = 3,             ///< overrun: the last part is still being squeezed or judged
    NotArmed = 4,         ///< a person at the station has to arm
    NotReady = 5,         ///< Preoperational, Halted or Error
    NoSuchType = 6,       ///< there is no type with that number
    HeartbeatMissing = 7, ///< the PLC's own heartbeat stands still
    OutOfStep = 8,        ///< not the number that is next: a late or lost write; nothing was changed by it
};
[[nodiscard]] bool isOverrun(JobAnswer answer);
/// A sentence: "Trigger 12 for part 4711 was refused: the gripper is not armed. ..."
[[nodiscard]] Finding refusalInWords(JobAnswer answer, std::uint16_t trigger, std::uint32_t partToken);

/// StartSingleJob(MeasId, PartId).
struct LineJob {
    std::uint16_t trigger = 0; ///< counted by the PLC; 0: nothing is asked
    std::uint16_t type = 0; ///< MeasId: a type by its number in the station's list; 0: as set at the station
    std::uint32_t partToken = 0; ///< PartId: the PLC's, echoed in the result
    friend bool operator==(const LineJob&, const LineJob&) = default;
};

struct LineQuantity {
    double value = 0;
    std::optional<double> standardUncertainty;
    friend bool operator==(const LineQuantity&, const LineQuantity&) = default;
};

/// A result as OPC 40001-101 has it.
struct LineResult {
    std::uint32_t sequence = 0; ///< ResultId: counted from 1 in this run; it alone orders results
    LineJob job;                ///< as it was asked for
    ResultState state = ResultState::Undefined;
    ResultEvaluation evaluation = ResultEvaluation::Undefined;
    ResultReason reason = ResultReason::None;
    bool partial = false;        ///< IsPartial: the squeeze did not come to its end
    bool simulated = false;      ///< IsSimulated: by a virtual gripper, or a recording that is played
    std::uint16_t typeFound = 0; ///< its number; 0: none that has one
    std::array<std::optional<LineQuantity>, 3> quantities; ///< m, b, k in kg, N s/m, N/m; nothing: not known
    QDateTime utc;                                         ///< the station's, when it was judged
    friend bool operator==(const LineResult&, const LineResult&) = default;
};

} // namespace gripscope
