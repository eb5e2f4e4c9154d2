// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetrics>
#include <QString>
#include <QStringList>

namespace gripscope {

/// The text, or as much of it as `room` holds with dots behind it. Qt's elidedText() puts dots even to one
/// that is as wide as the room to the pixel, as each is that a column was made for.
template <typename Metrics, typename Number>
[[nodiscard]] QString elided(const Metrics& metrics, const QString& text, Number room)
{
    return metrics.horizontalAdvance(text) <= room ? text : metrics.elidedText(text, Qt::ElideRight, room);
}

/// As many of `parts` a line as the room holds, a blank between them.
template <typename Metrics, typename Number>
[[nodiscard]] QStringList filledLines(const Metrics& metrics, const QStringList& parts, Number room)
{
    QStringList lines;
    for (const QString& part : parts) {
        const QString longer = lines.isEmpty() ? part : lines.last() + u' ' + part;
        if (!lines.isEmpty() && metrics.horizontalAdvance(longer) <= room)
            lines.last() = longer;
        else
            lines << part;
    }
    return lines;
}

} // namespace gripscope
