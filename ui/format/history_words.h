// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/history.h"
#include "core/signal/recording/units.h"
#include "ui/format/fact.h"

#include <QCoreApplication>

namespace gripscope {

/// What the history says of a squeeze, wherever it says it.
class HistoryWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::HistoryWords)
public:
    [[nodiscard]] static QString kind(SqueezeKind kind);
    /// "Inspection 12", "A, enrolled 31 May 2024 12:00".
    [[nodiscard]] static QString title(const HistoryEntry& entry);
    [[nodiscard]] static QString device(const HistoryEntry& entry); ///< name and serial number
    /// One of the library's own names: "oe" is "Output error".
    [[nodiscard]] static QString estimator(const QString& id);
    /// Free or rest, the hold, the offset: how a squeeze was identified again.
    [[nodiscard]] static QString how(const Reidentification& again);
    /// "412 squeezes", and of them what came out how.
    [[nodiscard]] static QString summary(const HistoryCounts& counts);
    /// What narrows a query, a fact each; none where everything is let through.
    [[nodiscard]] static std::vector<Fact> filter(const HistoryQuery& query);
    /// All that is known of a squeeze, but for its estimates and reasons.
    [[nodiscard]] static std::vector<Fact> facts(const SqueezeDetails& details);
    /// m, b and k of an estimate with the half widths of their 95 % intervals, a fact each.
    [[nodiscard]] static std::vector<Fact> parameters(const StoredEstimate& estimate,
                                                      const QString& forceUnit, const QString& positionUnit);
};

} // namespace gripscope
