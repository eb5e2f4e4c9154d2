// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_writer.h"

#include "devices/replay/capture_session.h"

#include <QDateTime>
#include <QRandomGenerator>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// In order of time, and no other's.
QString newSessionName()
{
    return QDateTime::currentDateTimeUtc().toString(u"yyyyMMddThhmmsszzzZ"_s) +
           u"-%1"_s.arg(QRandomGenerator::global()->bounded(0x10000), 4, 16, QLatin1Char('0'));
}

} // namespace

Expected<std::unique_ptr<CaptureWriter>> CaptureWriter::create(const CaptureDestination& destination,
                                                               std::shared_ptr<CaptureMonitor> monitor)
{
    const QString session = destination.folder.isEmpty() ? QString() : newSessionName();
    if (!monitor)
        monitor = std::make_shared<CaptureMonitor>();
    auto writing = std::make_shared<CaptureSession>(destination, session, monitor);
    if (!destination.file.isEmpty())
        RETURN_IF_ERROR(writing->createFile());
    auto buffer = std::make_shared<CaptureBuffer>(destination.limits.bufferBytes, std::move(monitor));
    return std::unique_ptr<CaptureWriter>(
        new CaptureWriter(buffer, session, BoundedThread([writing, buffer] { writing->run(*buffer); })));
}

CaptureWriter::CaptureWriter(std::shared_ptr<CaptureBuffer> buffer, QString session, BoundedThread thread)
    : m_buffer(std::move(buffer)), m_session(std::move(session)), m_thread(std::move(thread))
{
}

CaptureWriter::~CaptureWriter()
{
    m_buffer->finish();
}

void CaptureWriter::add(CaptureKind kind, std::span<const std::uint8_t> bytes)
{
    m_buffer->add(kind, bytes);
}

bool CaptureWriter::finishBy(std::chrono::steady_clock::time_point deadline)
{
    m_buffer->finish();
    return m_thread.finishBy(deadline);
}

} // namespace gripscope
