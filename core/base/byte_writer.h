// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QtEndian>

namespace gripscope {

/// Numbers as bytes, the most significant first, one behind the other.
class ByteWriter {
public:
    template <typename Number>
    ByteWriter& number(Number value)
    {
        char bytes[sizeof value];
        qToBigEndian(value, bytes);
        m_bytes.append(bytes, sizeof value);
        return *this;
    }
    ByteWriter& plain(QByteArrayView bytes)
    {
        m_bytes.append(bytes);
        return *this;
    }
    /// With their length before them, so that nothing can be moved from one to the next.
    ByteWriter& counted(QByteArrayView bytes)
    {
        return number(static_cast<quint64>(bytes.size())).plain(bytes);
    }
    ByteWriter& text(const QString& text) { return counted(text.toUtf8()); }
    [[nodiscard]] const QByteArray& bytes() const { return m_bytes; }

private:
    QByteArray m_bytes;
};

} // namespace gripscope
