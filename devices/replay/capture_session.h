// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "devices/replay/capture_folder.h"
#include "devices/replay/capture_writer.h"

#include <QByteArray>
#include <QCryptographicHash>
#include <QFile>

#include <memory>
#include <vector>

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

/// One session on its way into its files: opens parts, closes and lists them, makes room for them. The
/// writing thread's own.
class CaptureSession {
public:
    CaptureSession(CaptureDestination destination, QString session, std::shared_ptr<CaptureMonitor> monitor);

    /// The first file of a session that has one file only.
    [[nodiscard]] Expected<void> createFile();
    /// Takes what `buffer` gets until it is finished.
    void run(CaptureBuffer& buffer);

private:
    using Clock = std::chrono::steady_clock;
    using Chunk = CaptureBuffer::Chunk;

    void keep(const Chunk& chunk, const CaptureBuffer& buffer);
    [[nodiscard]] Expected<void> write(const Chunk& chunk, const CaptureBuffer& buffer);
    [[nodiscard]] Expected<void> beginPart(const QByteArray& features, std::uint64_t time_us);
    void tellPruning(const std::vector<CaptureFolder::Part>& removed);
    [[nodiscard]] Expected<void> closePart();
    [[nodiscard]] bool partIsDue() const;
    [[nodiscard]] QByteArray sessionNote(std::uint64_t time_us) const;
    [[nodiscard]] bool inFolder() const { return !m_destination.folder.isEmpty(); }
    void meet(const Error& problem);

    const CaptureDestination m_destination;
    const std::shared_ptr<CaptureMonitor> m_monitor;
    const QString m_session;
    std::uint64_t m_records = 0; ///< in files
    bool m_lostAny = false;
    std::optional<Error> m_problem;
    std::unique_ptr<CapturePart> m_part;
    int m_parts = 0;
    Clock::time_point m_partBegan;
    qint64 m_partSqueezes = 0;
    std::uint64_t m_untold = 0;    ///< dropped records that the capture does not tell of yet
    Clock::time_point m_notBefore; ///< when a disk that failed is tried again
};

} // namespace gripscope
