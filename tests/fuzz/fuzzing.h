// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDir>
#include <QFile>
#include <QString>
#include <QTemporaryDir>

#include <cstdint>
#include <cstdlib>

namespace gripscope::fuzz {

/// A finding where it does not hold.
inline void require(bool holds)
{
    if (!holds)
        std::abort();
}

inline QByteArray bytesOf(const std::uint8_t* data, std::size_t size)
{
    return {reinterpret_cast<const char*>(data), static_cast<qsizetype>(size)};
}

/// For parsers that want a file: in memory where the system has such a folder.
class FuzzFile {
public:
    explicit FuzzFile(const QString& name) : m_path(m_folder.filePath(name)) {}
    [[nodiscard]] QString path() const { return m_path; }
    void write(const QByteArray& bytes) const
    {
        QFile file(m_path);
        require(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }

private:
    static QString parent()
    {
        const QString memory = QStringLiteral("/dev/shm");
        return QDir(memory).exists() ? memory : QDir::tempPath();
    }
    QTemporaryDir m_folder{parent() + QStringLiteral("/gripscope-fuzz-XXXXXX")};
    QString m_path;
};

} // namespace gripscope::fuzz
