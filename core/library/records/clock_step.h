// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>

#include <optional>

namespace gripscope {

/// The clock of a station was set back: what it had stamped from `to` up to `from` may have been stamped by
/// a wrong clock.
struct ClockStep {
    QString station;
    QDateTime from, to; ///< what it showed before, and then
    /// The newest inspection, and the version of the newest enrolled squeeze, of before. Nothing: not told.
    std::optional<qint64> lastInspection = {}, lastVersion = {};
    [[nodiscard]] bool covers(const QString& where, const QDateTime& time) const
    {
        return where == station && to <= time && time <= from;
    }
};

} // namespace gripscope
