// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_writer.h"

#include <QFile>
#include <QLoggingCategory>

namespace gripscope {

namespace {
Q_LOGGING_CATEGORY(logCapture, "gripscope.devices.capture")
constexpr std::chrono::milliseconds period{200}; ///< at most so much is lost when the program dies
} // namespace

Expected<std::unique_ptr<CaptureWriter>> CaptureWriter::create(const QString& file)
{
    QFile out(file);
    if (!out.open(QIODevice::WriteOnly | QIODevice::Truncate))
        return failure(ErrorCode::FileUnwritable, {file, out.errorString()});
    return std::unique_ptr<CaptureWriter>(new CaptureWriter(file));
}

CaptureWriter::CaptureWriter(const QString& file) : m_file(file), m_thread([this] { run(); }) {}

CaptureWriter::~CaptureWriter()
{
    finish();
}

void CaptureWriter::finish()
{
    if (!m_thread.joinable())
        return;
    {
        const std::lock_guard lock(m_mutex);
        m_ending = true;
    }
    m_wake.notify_all();
    m_thread.join();
}

void CaptureWriter::add(CaptureKind kind, std::span<const std::uint8_t> bytes)
{
    const std::lock_guard lock(m_mutex);
    if (m_ending)
        return;
    // Under the lock, so that times are in order though two threads add.
    const auto age = std::chrono::steady_clock::now() - m_start;
    const auto time_us = std::chrono::duration_cast<std::chrono::microseconds>(age).count();
    m_waiting += encodeRecord(static_cast<std::uint64_t>(time_us), kind, bytes);
}

void CaptureWriter::run()
{
    QFile out(m_file);
    bool fine = out.open(QIODevice::WriteOnly | QIODevice::Append);
    std::unique_lock lock(m_mutex);
    for (bool last = false; !last;) {
        m_wake.wait_for(lock, period, [&] { return m_ending; });
        last = m_ending;
        const QByteArray bytes = std::exchange(m_waiting, {});
        lock.unlock();
        const bool written = fine && out.write(bytes) == bytes.size() && out.flush();
        if (fine && !written)
            qCWarning(logCapture, "the capture %s ends early: %s", qUtf8Printable(m_file),
                      qUtf8Printable(out.errorString()));
        fine = written;
        lock.lock();
    }
}

} // namespace gripscope
