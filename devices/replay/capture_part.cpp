// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/replay/capture_part.h"

namespace gripscope {

Expected<std::unique_ptr<CapturePart>> CapturePart::create(const QString& file, Existing existing)
{
    auto part = std::unique_ptr<CapturePart>(new CapturePart(file));
    const QIODevice::OpenMode mode =
        QIODevice::WriteOnly | QIODevice::Unbuffered |
        (existing == Existing::Refuse ? QIODevice::NewOnly : QIODevice::Truncate);
    if (!part->m_file.open(mode))
        return failure(ErrorCode::FileUnwritable, {file, part->m_file.errorString()});
    return part;
}

Expected<void> CapturePart::add(const char* bytes, qint64 size)
{
    qint64 done = 0;
    while (done < size) {
        const qint64 written = m_file.write(bytes + done, size - done);
        if (written <= 0) {
            const QString reason = m_file.errorString();
            if (!m_file.isSequential() && m_file.resize(m_size))
                m_file.seek(m_size);
            return failure(ErrorCode::FileUnwritable, {m_file.fileName(), reason});
        }
        done += written;
    }
    m_hash.addData(QByteArrayView(bytes, size));
    m_size += size;
    return {};
}

Expected<QString> CapturePart::close()
{
    m_file.close();
    if (m_file.error() != QFileDevice::NoError && !m_file.exists())
        return failure(ErrorCode::FileUnwritable, {m_file.fileName(), m_file.errorString()});
    return QString::fromLatin1(m_hash.result().toHex());
}

} // namespace gripscope
