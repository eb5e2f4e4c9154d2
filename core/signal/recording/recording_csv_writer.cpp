// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/bounded_file.h"
#include "core/base/csv.h"
#include "core/base/words.h"
#include "core/signal/recording/measuring_chain_csv.h"
#include "core/signal/recording/recording_csv.h"
#include "core/signal/recording/recording_limits.h"

#include <array>
#include <charconv>

namespace gripscope {

namespace {

template <typename Number>
void append(QByteArray& text, Number value)
{
    std::array<char, 32> buffer; // the longest double has 24 characters
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    text.append(buffer.data(), result.ptr - buffer.data());
}

void appendSetting(QByteArray& text, const QString& key, const QString& value)
{
    QString name = key;
    name.replace(QLatin1Char(':'), QLatin1Char(' ')); // the first colon ends it
    text += "# " + factText(std::move(name)).toUtf8() + ": " + factText(value).toUtf8() + '\n';
}

void appendHead(QByteArray& text, const Recording& recording)
{
    text += "# gripscope-recording: 1\n# sample_time_s: ";
    append(text, recording.sampleTime_s);
    text += '\n';
    appendSetting(text, QStringLiteral("force_unit"), recording.forceUnit);
    appendSetting(text, QStringLiteral("position_unit"), recording.positionUnit);
    if (recording.hold)
        appendSetting(text, QStringLiteral("force_hold"), toString(*recording.hold));
    if (lagIsStated(recording)) {
        text += "# force_lag_s: ";
        append(text, recording.forceLag_s);
        text += '\n';
    }
    text += measuringChainLines(recording.chain);
    for (auto it = recording.provenance.begin(); it != recording.provenance.end(); ++it)
        appendSetting(text, it.key(), it.value());
}

} // namespace

QByteArray toCsv(const Recording& recording)
{
    const bool hasSequence = !recording.sequence.empty();
    const bool hasStatus = !recording.status.empty();
    QByteArray text;
    text.reserve(static_cast<qsizetype>(recording.size()) * 64 + 1024);
    appendHead(text, recording);
    text += "time_s,force,position";
    text += hasSequence ? ",sequence" : "";
    text += hasStatus ? ",status" : "";
    text += '\n';
    for (std::size_t i = 0; i < recording.size(); ++i) {
        append(text, recording.time_s[i]);
        text += ',';
        append(text, recording.force[i]);
        text += ',';
        append(text, recording.position[i]);
        if (hasSequence) {
            text += ',';
            append(text, recording.sequence[i]);
        }
        if (hasStatus) {
            text += ',';
            append(text, recording.status[i]);
        }
        text += '\n';
    }
    return text;
}

Expected<void> writeRecordingCsv(const Recording& recording, const QString& file)
{
    if (const std::optional<Finding> reason = outOfRange(recording)) // it could not be read again
        return failure(ErrorCode::Usage, {Words::say("The recording can't be kept: %1.").arg(*reason)});
    return writeWhole(file, toCsv(recording));
}

} // namespace gripscope
