// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/window.h"

#include <algorithm>

namespace gripscope {

namespace {

bool isMoving(const Recording& recording, std::size_t i)
{
    return (recording.status[i] & StatusMoving) != 0;
}

bool hasMovingSamples(const Recording& recording)
{
    return recording.status.size() == recording.size() &&
           std::any_of(recording.status.begin(), recording.status.end(),
                       [](std::uint16_t status) { return (status & StatusMoving) != 0; });
}

/// From the first to one past the last moving sample.
Window movingSpan(const Recording& recording)
{
    std::size_t first = 0;
    while (!isMoving(recording, first))
        ++first;
    std::size_t end = recording.size();
    while (!isMoving(recording, end - 1))
        --end;
    return {first, end - first};
}

} // namespace

WindowChoice chooseWindow(const Recording& recording)
{
    WindowChoice choice;
    if (recording.size() == 0)
        return choice;
    const bool moving = hasMovingSamples(recording);
    const Window asked = moving ? movingSpan(recording) : Window{0, recording.size()};
    const std::size_t askedEnd = asked.first + asked.count;

    std::vector<bool> breaksBefore(recording.size(), false);
    for (const Gap& gap : findGaps(recording)) {
        breaksBefore[gap.before] = true;
        if (gap.before > asked.first && gap.before < askedEnd) {
            choice.lostSamples += gap.lostSamples;
            ++choice.gaps;
        }
    }

    Window current{asked.first, 0};
    for (std::size_t i = asked.first; i < askedEnd; ++i) {
        const bool wanted = !moving || isMoving(recording, i);
        if (breaksBefore[i] || !wanted)
            current = {i, 0};
        if (!wanted) {
            current.first = i + 1;
            continue;
        }
        ++choice.eligible;
        ++current.count;
        if (current.count > choice.window.count)
            choice.window = current;
    }
    return choice;
}

Window movingWindow(const Recording& recording)
{
    if (!hasMovingSamples(recording))
        return {0, recording.size()};
    Window longest, current;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        current = isMoving(recording, i) ? Window{current.first, current.count + 1} : Window{i + 1, 0};
        if (current.count > longest.count)
            longest = current;
    }
    return longest;
}

} // namespace gripscope
