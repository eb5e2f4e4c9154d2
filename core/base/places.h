// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// `text` with its places filled in, in one pass, so that a %1 inside of what fills one (a file name, say)
/// stays as it is. A place is %1 to %9, or %L1 to %L9 as QString::arg() knows them: the same here, since what
/// fills it is in the reader's language already. `fill(2)` gives what %2 stands for.
template <typename Fill>
[[nodiscard]] QString withPlacesFilled(const QString& text, const Fill& fill)
{
    QString out;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const qsizetype local = i + 1 < text.size() && text[i + 1] == QChar(u'L') ? 1 : 0;
        const qsizetype digit = i + 1 + local;
        const int place = text[i] == QChar(u'%') && digit < text.size() ? text[digit].digitValue() : -1;
        if (place < 1) {
            out += text[i];
            continue;
        }
        i = digit;
        out += fill(std::size_t(place));
    }
    return out;
}

} // namespace gripscope
