// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/connection/gripper_port.h"
#include "devices/replay/capture.h"

#include <optional>
#include <vector>

namespace gripscope {

/// A squeeze as it was cut out of a capture.
struct CapturedSqueeze {
    Recording recording;            ///< no samples where it failed
    std::optional<QString> failure; ///< what the program said of it then
    /// The capture says where the program began and ended, and who squeezed and how; else only the commands
    /// to the gripper do, and the recording tells no more of it than the gripper does.
    bool noted = false;
    std::size_t missingSamples = 0; ///< the program had so many more: the capture lost records
    double begins_s = 0;            ///< since the session began
    QString judged = {};            ///< the note behind it (squeezeJudgedNote); empty: it was no inspection
};

/// What a capture holds, without the samples between the squeezes.
struct CapturedSession {
    QString name;    ///< of a kept session
    QString address; ///< of the gripper; empty where the capture does not say
    GripperIdentity identity;
    double seconds = 0;
    LinkCounters counters;            ///< reports, samples, and what the stream alone tells of
    std::uint64_t droppedRecords = 0; ///< the capture itself did not keep these
    std::vector<CapturedSqueeze> squeezes;
};

/// Reads a session, its squeezes cut out of the stream by the same rule (SqueezeRecorder) and at the same
/// samples as they were when it was taken: the recordings come out bit for bit. What the program's own queue
/// dropped then, because the program did not keep up, is there now. FileUnreadable, BadInput.
[[nodiscard]] Expected<CapturedSession> readCapturedSession(const QString& file);

} // namespace gripscope
