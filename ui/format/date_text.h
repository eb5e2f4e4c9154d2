// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QStringView>

namespace gripscope {

/// Dates and times as they are shown: the same in every language and on every page, in the order of
/// ISO 8601, in local time. What is not valid reads "–".

inline constexpr QStringView dateFormat = u"yyyy-MM-dd";

[[nodiscard]] QString dateText(const QDate& date);     ///< "2026-11-22"
[[nodiscard]] QString dateText(const QDateTime& time); ///< its day
[[nodiscard]] QString timeText(const QDateTime& time); ///< "2026-11-22 09:50"
/// With the zone that it is in: for what leaves the station. "2026-11-22 09:50 UTC+01:00".
[[nodiscard]] QString zonedTimeText(const QDateTime& time);
[[nodiscard]] QString exactTimeText(const QDateTime& time); ///< "2026-11-22 09:50:31"
/// By the clock that the time tells, not the reader's: "2026-11-22 09:50:31 +01:00".
[[nodiscard]] QString timeThereText(const QDateTime& time);

} // namespace gripscope
