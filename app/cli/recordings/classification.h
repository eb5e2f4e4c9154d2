// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/line/command_line.h"
#include "core/recognition/types/type_shift.h"
#include "core/recognition/verdict/verdict.h"
#include "core/session/inspect/inspect_session.h"
#include "core/session/inspect/squeeze_judged.h"
#include "core/signal/recording/recording_csv.h"

#include <QJsonObject>
#include <QString>

#include <memory>

namespace gripscope::cli {

/// Verdicts on recordings, one after another, as a session of inspections gives them; nothing is stored.
class Classification {
public:
    Classification(const QString& library, const IdentificationOptions& options, const VerdictOptions& rates);
    ~Classification();

    /// What is refused though it could be judged; nothing unless told otherwise.
    void setPolicy(const JudgingPolicy& policy);
    /// What all recordings are adjusted by, or that none is. Until this is said, those of a gripper that the
    /// library has an adjustment for are adjusted by it.
    void setTransfer(const std::optional<CommonShift>& transfer);

    enum class Telling { Unapproved, Nothing };
    /// Reads the types; tells of those that are not approved.
    [[nodiscard]] std::optional<Error> begin(Telling telling = Telling::Unapproved);
    /// Gives a recording that has no measuring chain of its own the library's.
    void complete(Recording& recording, const QString& source);
    /// `source` names the recording in messages.
    [[nodiscard]] Expected<InspectSession::Result> judge(Recording recording, const QString& source);
    /// As it was judged before: at those rates, with what had ended the squeeze before its time, and adjusted
    /// as it was then, or by what the library has now.
    enum class Adjusting { AsThen, AsTheLibrary };
    [[nodiscard]] Expected<InspectSession::Result> judgeAgain(Recording recording, const QString& source,
                                                              const SqueezeJudged& before,
                                                              Adjusting adjusting = Adjusting::AsThen);
    [[nodiscard]] Expected<InspectSession::Result> judge(const QString& file, const CsvReadOptions& reading);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// One entry of the results of classify.
[[nodiscard]] QJsonObject verdictJson(const QString& file, const Verdict& verdict);
/// The same for a person.
[[nodiscard]] QString verdictText(const QString& file, const Verdict& verdict);

/// The library of --library, or the user's own. StorageOpen: there is none; opening would make an empty one,
/// and every part would be unknown to it.
[[nodiscard]] Expected<QString> existingLibrary(const CommandLine& line);

} // namespace gripscope::cli
