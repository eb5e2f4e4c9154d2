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
    /// "as expected", "voided: as expected", or its kind where it was not inspected.
    [[nodiscard]] static QString outcome(const HistoryEntry& entry);
    [[nodiscard]] static QString device(const HistoryEntry& entry); ///< name and serial number
    /// One of the library's own names: "oe" is "Output error".
    [[nodiscard]] static QString estimator(const QString& id);
    /// Free or rest, the hold, the offset: how a squeeze was identified again.
    [[nodiscard]] static QString how(const Reidentification& again);
    [[nodiscard]] static QString validity(ValidityVerdict validity); ///< "valid", "suspect", "invalid"
    [[nodiscard]] static QString notRecorded();
    /// The validity of a squeeze with the checks that it failed: "suspect: calibration".
    [[nodiscard]] static QString validity(const SqueezeDetails& details);
    /// The rates that a verdict was held to, all of them.
    [[nodiscard]] static QString heldTo(const HeldTo& held);
    /// By which calibration a channel was corrected, see HistoryEntry::forceCalibration.
    [[nodiscard]] static QString calibration(const std::optional<QString>& words);
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
