// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"

#include <QByteArray>
#include <QCryptographicHash>
#include <QFile>

#include <memory>

namespace gripscope {

/// A file that a capture is written to, with its SHA-256 as it grows. Bytes are added whole or not at all.
class CapturePart {
public:
    enum class Existing { Replace, Refuse };
    /// FileUnwritable.
    [[nodiscard]] static Expected<std::unique_ptr<CapturePart>> create(const QString& file,
                                                                       Existing existing);

    /// FileUnwritable: nothing of them is in the file then, as far as the system allows it to be taken back.
    [[nodiscard]] Expected<void> add(const char* bytes, qint64 size);
    /// Closes the file; its SHA-256 in hexadecimal.
    [[nodiscard]] Expected<QString> close();

    [[nodiscard]] qint64 size() const { return m_size; }
    [[nodiscard]] QString file() const { return m_file.fileName(); }

private:
    explicit CapturePart(const QString& file) : m_file(file), m_hash(QCryptographicHash::Sha256) {}

    QFile m_file;
    QCryptographicHash m_hash;
    qint64 m_size = 0;
};

} // namespace gripscope
