// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/squeeze_notes.h"

#include "core/signal/recording/recording_csv.h"
#include "core/signal/recording/recording_limits.h"

#include <QStringList>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString title(std::string_view note)
{
    return QString::fromLatin1(note.data(), static_cast<qsizetype>(note.size()));
}

/// The value behind `key: ` in a line of its own.
std::optional<QString> fact(const QString& note, const QString& key)
{
    for (const QString& line : note.split(u'\n'))
        if (line.startsWith(key + u": "_s))
            return line.mid(key.size() + 2);
    return {};
}

std::optional<std::uint64_t> count(const QString& note, const QString& key)
{
    bool isNumber = false;
    const std::uint64_t value = fact(note, key).value_or(QString()).toULongLong(&isNumber);
    return isNumber ? std::optional(value) : std::nullopt;
}

/// How many samples a squeeze has or is to have: nothing where no recording can have so many.
std::optional<std::size_t> sampleCount(const QString& note)
{
    const std::optional<std::uint64_t> value = count(note, u"samples"_s);
    return value && *value <= mostSamples ? std::optional(static_cast<std::size_t>(*value)) : std::nullopt;
}

} // namespace

QString toNote(const SqueezeBegins& begins)
{
    const bool everything = begins.mode == SqueezeRecorder::Mode::Everything;
    return title(squeezeBeginsNote) +
           u"mode: %1\nsamples: %2\n"_s.arg(everything ? u"everything"_s : u"movement"_s).arg(begins.samples);
}

QString toNote(const SqueezeEnded& ended)
{
    const QString failure =
        ended.failure ? u"failure: %1\n"_s.arg(QString(*ended.failure).replace(u'\n', u' ')) : u""_s;
    return title(squeezeEndedNote) + failure + u"samples: %1\n"_s.arg(ended.samples) +
           QString::fromUtf8(toCsv(slice(ended.head, {})));
}

std::optional<SqueezeBegins> squeezeBegins(const QString& note)
{
    const std::optional<std::size_t> samples = sampleCount(note);
    if (!note.startsWith(title(squeezeBeginsNote)) || !samples)
        return {};
    const bool everything = fact(note, u"mode"_s) == u"everything"_s;
    return SqueezeBegins{everything ? SqueezeRecorder::Mode::Everything : SqueezeRecorder::Mode::Movement,
                         *samples, count(note, u"after"_s)};
}

std::optional<SqueezeEnded> squeezeEnded(const QString& note)
{
    const std::optional<std::size_t> samples = sampleCount(note);
    const qsizetype head = note.indexOf(u"# gripscope-recording"_s);
    const qsizetype end = note.indexOf(u"\ntime_s"_s);
    if (!note.startsWith(title(squeezeEndedNote)) || !samples || head < 0 || end < head)
        return {};
    // A head alone is no recording; with a row it is one.
    const QByteArray text = note.mid(head, end - head).toUtf8() + "\ntime_s,force,position\n0,0,0\n";
    Expected<Recording> recording = parseRecordingCsv(text, u"note"_s);
    if (!recording)
        return {};
    return SqueezeEnded{fact(note.left(head), u"failure"_s), *samples, slice(*recording, {})};
}

} // namespace gripscope
