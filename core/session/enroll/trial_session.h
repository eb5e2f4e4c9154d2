// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/pending.h"
#include "core/recognition/verdict/verdict.h"
#include "core/session/squeeze/comparable_units.h"
#include "core/session/squeeze/series_session.h"

#include <optional>

namespace gripscope {

/// The types that parts are held against, and this one, be it approved or not.
[[nodiscard]] Expected<ComparableTypes> typesWith(Library& library, const QString& type);

/// One squeeze, to see what it would be called if a type were approved. Measured: verdict(). Nothing is
/// stored, counted or approved by it.
class TrialSession : public SeriesSession {
public:
    TrialSession(ConnectSession& connection, LibraryService& library);

    /// `type`: by name.
    [[nodiscard]] Expected<void> start(const QString& type, const Recipe& recipe,
                                       const VerdictOptions& rates);
    [[nodiscard]] const std::optional<Verdict>& verdict() const { return m_verdict; }

private:
    void clear() override;
    void judge(const Recording& recording) override;
    bool takeJudged() override;
    void forgetJudging() override;
    void conclude() override {}
    [[nodiscard]] Expected<void> judgeBy(const ComparableTypes& types);

    LibraryService& m_library;
    QString m_type;
    VerdictOptions m_rates;
    Recording m_recording;
    Pending<Expected<ComparableTypes>> m_types;
    Pending<Verdict> m_task;
    std::optional<Verdict> m_verdict;
};

} // namespace gripscope
