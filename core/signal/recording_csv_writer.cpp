// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/measuring_chain_csv.h"
#include "core/signal/recording_csv.h"

#include <QSaveFile>

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

/// One line that reads back as it is: no line breaks, no spaces around it.
QByteArray oneLine(QString text)
{
    for (QChar& c : text) {
        if (c == QLatin1Char('\n') || c == QLatin1Char('\r'))
            c = QLatin1Char(' ');
    }
    return text.trimmed().toUtf8();
}

void appendSetting(QByteArray& text, const QString& key, const QString& value)
{
    text += "# " + oneLine(key).replace(':', ' ').trimmed() + ": " + oneLine(value) + '\n';
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
    if (recording.forceLag_s != 0 || recording.provenance.contains(forceLagSourceKey())) {
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
    QSaveFile output(file);
    const QByteArray text = toCsv(recording);
    if (!output.open(QIODevice::WriteOnly) || output.write(text) != text.size() || !output.commit())
        return failure(ErrorCode::FileUnwritable, {file, output.errorString()});
    return {};
}

} // namespace gripscope
