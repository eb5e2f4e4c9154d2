// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// One line of a list of findings: what it is, and the number with its unit, or words.
struct Fact {
    QString name, text;
    bool number = true; ///< else words, which wrap
};

/// Its first letter large, unless that is a symbol (m, b, k); a full stop behind.
[[nodiscard]] inline QString asSentence(QString text)
{
    if (text.isEmpty())
        return text;
    const bool symbol = QStringView(u"mbk").contains(text[0]) && (text.size() == 1 || !text[1].isLetter());
    if (!symbol)
        text[0] = text[0].toUpper();
    return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

} // namespace gripscope
