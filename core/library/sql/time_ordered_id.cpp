// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/time_ordered_id.h"

#include <QDateTime>
#include <QRandomGenerator>
#include <QUuid>

#include <algorithm>
#include <mutex>

namespace gripscope {

namespace {

struct Tick {
    std::uint64_t milliseconds = 0;
    std::uint16_t counter = 0;
};

/// Milliseconds never run back; within one, the counter runs, and when it is used up, time is taken from the
/// next.
Tick nextTick()
{
    static std::mutex mutex;
    static Tick last;
    constexpr std::uint16_t counterEnd = 1 << 12;
    const auto now = std::uint64_t(std::max<qint64>(0, QDateTime::currentMSecsSinceEpoch()));
    const std::lock_guard lock(mutex);
    if (now > last.milliseconds)
        last = {now, std::uint16_t(QRandomGenerator::system()->bounded(counterEnd / 2))};
    else if (last.counter + 1 < counterEnd)
        ++last.counter;
    else
        last = {last.milliseconds + 1, 0};
    return last;
}

} // namespace

QString newTimeOrderedId()
{
    const Tick tick = nextTick();
    const std::uint64_t random = QRandomGenerator::system()->generate64();
    const QUuid id(std::uint32_t(tick.milliseconds >> 16),
                   std::uint16_t(tick.milliseconds),             // 48 bits of time
                   std::uint16_t(0x7000 | tick.counter),         // version 7
                   std::uint8_t(0x80 | ((random >> 56) & 0x3f)), // variant 10
                   std::uint8_t(random >> 48), std::uint8_t(random >> 40), std::uint8_t(random >> 32),
                   std::uint8_t(random >> 24), std::uint8_t(random >> 16), std::uint8_t(random >> 8),
                   std::uint8_t(random));
    return id.toString(QUuid::WithoutBraces);
}

} // namespace gripscope
