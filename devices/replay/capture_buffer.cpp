// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/squeeze/squeeze_notes.h"
#include "devices/replay/capture_writer.h"

#include <algorithm>

namespace gripscope {

namespace {
/// More kinds of feature reports than any gripper has.
constexpr std::size_t mostFeatures = 16;

bool isSqueezeEnd(std::span<const std::uint8_t> note)
{
    return std::string_view(reinterpret_cast<const char*>(note.data()), note.size())
        .starts_with(squeezeEndedNote);
}
} // namespace

CaptureBuffer::CaptureBuffer(std::size_t capacity, std::shared_ptr<CaptureMonitor> monitor)
    : m_capacity(capacity), m_monitor(std::move(monitor))
{
    m_filling.bytes.reserve(capacity);
    m_features.reserve(mostFeatures);
}

void CaptureBuffer::add(CaptureKind kind, std::span<const std::uint8_t> bytes)
{
    const std::lock_guard lock(m_mutex);
    if (m_finished)
        return;
    if (kind == CaptureKind::Feature && m_features.size() < mostFeatures)
        m_features.emplace_back(bytes.begin(), bytes.end());
    const std::size_t longest = kind == CaptureKind::Note ? longestCaptureNote : longestCapturedReport;
    const std::size_t used = m_filling.bytes.size();
    const std::size_t size = captureRecordHead + bytes.size();
    // What was dropped is told behind what was kept, so nothing may follow in this chunk.
    if (m_filling.droppedRecords > 0 || used + size > m_capacity || bytes.size() > longest) {
        ++m_filling.droppedRecords;
        m_monitor->dropped(1);
        return;
    }
    // Under the lock, so that times are in order though several threads add.
    const auto age = std::chrono::steady_clock::now() - m_start;
    const auto time_us = std::chrono::duration_cast<std::chrono::microseconds>(age).count();
    m_filling.bytes.resize(used + size);
    std::uint8_t* to = m_filling.bytes.data() + used;
    encodeRecordHead(static_cast<std::uint64_t>(time_us), kind, bytes.size(), to);
    std::copy(bytes.begin(), bytes.end(), to + captureRecordHead);
    ++m_filling.records;
    if (kind == CaptureKind::Note && isSqueezeEnd(bytes))
        ++m_filling.squeezes;
}

void CaptureBuffer::finish()
{
    {
        const std::lock_guard lock(m_mutex);
        m_finished = true;
    }
    m_wake.notify_all();
}

bool CaptureBuffer::take(Chunk& chunk, std::chrono::milliseconds atMost)
{
    chunk.bytes.clear();
    chunk.bytes.reserve(m_capacity); // once; from then on the two change places
    chunk.records = chunk.squeezes = chunk.droppedRecords = 0;
    std::unique_lock lock(m_mutex);
    m_wake.wait_for(lock, atMost, [&] { return m_finished; });
    std::swap(chunk, m_filling);
    return !m_finished || chunk.records > 0 || chunk.droppedRecords > 0;
}

QByteArray CaptureBuffer::features(std::uint64_t time_us) const
{
    const std::lock_guard lock(m_mutex);
    QByteArray records;
    for (const std::vector<std::uint8_t>& feature : m_features)
        records += encodeRecord(time_us, CaptureKind::Feature, feature);
    return records;
}

} // namespace gripscope
