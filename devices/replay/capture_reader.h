// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/replay/capture.h"

#include <QFile>
#include <QStringList>

#include <memory>
#include <optional>

namespace gripscope {

/// The records of a capture one after another, so that hours of them need no memory. A session that was
/// written in parts (`NAME.part0001.gscap`, ...) reads as one from the part that is named on;
/// parts that were removed are passed over.
class CaptureReader {
public:
    /// FileUnreadable, BadInput.
    [[nodiscard]] static Expected<CaptureReader> open(const QString& file);
    /// One file, though its session may have other parts. FileUnreadable, BadInput.
    [[nodiscard]] static Expected<CaptureReader> openPart(const QString& file);
    /// Over bytes in memory; `name` stands for the file in messages.
    [[nodiscard]] static Expected<CaptureReader> over(const QByteArray& bytes, const QString& name);

    /// The next whole record; nothing at the end. A file that ends in a record ends before it. BadInput with
    /// the place FILE:BYTE, FileUnreadable.
    [[nodiscard]] Expected<std::optional<CaptureRecord>> next();

    /// Bytes behind the last whole record of the part read last: it was cut short.
    [[nodiscard]] qint64 bytesLeft() const { return m_left; }

private:
    CaptureReader() = default;
    Expected<void> begin(std::unique_ptr<QIODevice> part, const QString& name);
    Expected<bool> beginNextPart(); ///< false: there is none
    /// The next record of this part; nothing where it ends, whole or not.
    Expected<std::optional<CaptureRecord>> nextInPart();
    static Expected<CaptureReader> over(QStringList parts);

    std::unique_ptr<QIODevice> m_part;
    QString m_name;
    QStringList m_parts; ///< still to come
    qint64 m_at = 0;     ///< in this part
    qint64 m_left = 0;
    std::uint64_t m_lastTime = 0;
    quint16 m_version = 0;
};

/// The parts of the session that `file` belongs to, from `file` on, in order; only `file` where it is none.
[[nodiscard]] QStringList capturePartsFrom(const QString& file);

} // namespace gripscope
