// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/printable.h"

namespace gripscope {

namespace {

bool turnsDirection(char16_t c)
{
    return c == 0x061c || c == 0x200e || c == 0x200f || (c >= 0x202a && c <= 0x202e) ||
           (c >= 0x2066 && c <= 0x2069);
}

bool isHalf(const QString& text, qsizetype at)
{
    const QChar c = text[at];
    if (c.isHighSurrogate())
        return at + 1 >= text.size() || !text[at + 1].isLowSurrogate();
    return c.isLowSurrogate() && (at == 0 || !text[at - 1].isHighSurrogate());
}

QString writtenOut(char16_t c)
{
    switch (c) {
    case u'\n':
        return QStringLiteral("\\n");
    case u'\r':
        return QStringLiteral("\\r");
    case u'\t':
        return QStringLiteral("\\t");
    default:
        return c < 0x100 ? QStringLiteral("\\x%1").arg(int(c), 2, 16, QLatin1Char('0'))
                         : QStringLiteral("\\u%1").arg(int(c), 4, 16, QLatin1Char('0'));
    }
}

/// The end of the first `length` characters, and the start of the last, not within a surrogate pair.
qsizetype whole(const QString& text, qsizetype at)
{
    return at > 0 && at < text.size() && text[at].isLowSurrogate() ? at - 1 : at;
}

QString written(const QString& text, bool keepLines)
{
    QString out;
    out.reserve(text.size());
    for (qsizetype i = 0; i < text.size(); ++i) {
        const bool kept = keepLines && (text[i] == u'\n' || text[i] == u'\t');
        if (!kept && isSteering(text, i))
            out += writtenOut(text[i].unicode());
        else
            out += text[i];
    }
    return out;
}

QString shortened(const QString& text, qsizetype most, bool keepLines)
{
    if (text.size() <= most)
        return written(text, keepLines);
    const qsizetype head = whole(text, most * 3 / 4);
    const qsizetype tail = whole(text, text.size() - most / 4);
    return written(text.left(head), keepLines) + QStringLiteral(" \u2026 ") +
           written(text.mid(tail), keepLines);
}

} // namespace

bool isSteering(const QString& text, qsizetype at)
{
    const char16_t c = text[at].unicode();
    if (c >= 0x20 && c < 0x7f)
        return false;
    return c < 0xa0 || c == 0x2028 || c == 0x2029 || c == 0xfeff || turnsDirection(c) || isHalf(text, at);
}

QString printable(const QString& text, qsizetype most)
{
    return shortened(text, most, false);
}

QString printableLines(const QString& text, qsizetype most)
{
    return shortened(text, most, true);
}

QString printableLines(const QString& text)
{
    return written(text, true);
}

} // namespace gripscope
