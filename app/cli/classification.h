// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command_line.h"
#include "core/recognition/types/type_shift.h"
#include "core/recognition/verdict/verdict.h"
#include "core/session/inspect/inspect_session.h"
#include "core/signal/recording/recording_csv.h"

#include <memory>

namespace gripscope::cli {

/// Verdicts on recordings, one after another, as a session of inspections gives them; nothing is stored.
class Classification {
public:
    Classification(const QString& library, const IdentificationOptions& options, const VerdictOptions& rates,
                   const std::optional<CommonShift>& transfer);
    ~Classification();

    /// Reads the types.
    [[nodiscard]] std::optional<Error> begin();
    /// `source` names the recording in messages.
    [[nodiscard]] Expected<InspectSession::Result> judge(Recording recording, const QString& source);
    [[nodiscard]] Expected<Verdict> judge(const QString& file, const CsvReadOptions& reading);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// The library of --library, or the user's own. StorageOpen: there is none; opening would make an empty one,
/// and every part would be unknown to it.
[[nodiscard]] Expected<QString> existingLibrary(const CommandLine& line);

} // namespace gripscope::cli
