// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"

#include <QRegularExpression>

namespace gripscope {

using namespace Qt::StringLiterals;

Finding Words::say(const char* sentence)
{
    Finding out(QString::fromUtf8(sentence));
    out.m_kind = Finding::Kind::Sentence;
    return out;
}

Finding Words::heard(const Findings& sentences, const QString& english)
{
    for (const Finding& sentence : sentences) {
        QString pattern = QRegularExpression::escape(sentence.m_text);
        for (int place = 1; place <= 9; ++place) // in order: each captures what its place holds
            pattern.replace(u"\\%%1"_s.arg(place), u"(.*)"_s);
        const auto match = QRegularExpression(QRegularExpression::anchoredPattern(pattern)).match(english);
        if (!match.hasMatch())
            continue;
        Finding out = sentence;
        for (int place = 1; place <= match.lastCapturedIndex(); ++place)
            out = out.arg(match.captured(place));
        return out;
    }
    return english;
}

QString Words::number(double value, char format, int digits)
{
    return Finding::number(value, format, digits).describe();
}

} // namespace gripscope
