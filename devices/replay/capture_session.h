// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/replay/capture_part.h"
#include "devices/replay/capture_writer.h"

namespace gripscope {

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
