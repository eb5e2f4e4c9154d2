// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QMap>

#include <optional>
#include <vector>

namespace gripscope::test {

/// Protobuf read by its wire format alone, and nothing of the program's: fields by number.
struct WireFields {
    QMap<int, quint64> numbers; ///< varints and eight bytes
    QMap<int, QByteArray> texts;
    std::vector<QByteArray> metrics; ///< field 2 of a payload, each time it is there
};
inline quint64 wireVarint(const QByteArray& bytes, qsizetype& at)
{
    quint64 value = 0;
    for (int shift = 0; at < bytes.size(); shift += 7) {
        const auto byte = static_cast<quint8>(bytes[at++]);
        value |= quint64(byte & 0x7f) << shift;
        if (byte < 0x80)
            break;
    }
    return value;
}
inline WireFields wireFields(const QByteArray& bytes)
{
    WireFields fields;
    for (qsizetype at = 0; at < bytes.size();) {
        const quint64 key = wireVarint(bytes, at);
        const int number = int(key >> 3);
        if ((key & 7) == 0) {
            fields.numbers[number] = wireVarint(bytes, at);
        } else if ((key & 7) == 1) {
            quint64 value = 0;
            for (int i = 0; i < 8; ++i)
                value |= quint64(static_cast<quint8>(bytes[at++])) << (8 * i);
            fields.numbers[number] = value;
        } else {
            const auto length = qsizetype(wireVarint(bytes, at));
            fields.texts[number] = bytes.mid(at, length);
            if (number == 2)
                fields.metrics.push_back(bytes.mid(at, length));
            at += length;
        }
    }
    return fields;
}
inline std::optional<quint64> seqOf(const QByteArray& payload)
{
    const WireFields fields = wireFields(payload);
    return fields.numbers.contains(3) ? std::optional(fields.numbers[3]) : std::nullopt;
}
/// The metric of a payload with this name.
inline std::optional<WireFields> metricNamed(const QByteArray& payload, const QByteArray& name)
{
    for (const QByteArray& bytes : wireFields(payload).metrics)
        if (const WireFields metric = wireFields(bytes); metric.texts.value(1) == name)
            return metric;
    return {};
}

} // namespace gripscope::test
