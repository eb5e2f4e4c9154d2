// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/plant_words.h"

#include "core/base/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t mostConflictsTold = 2; ///< Library says all

Finding waitingWords(qint64 waiting)
{
    return waiting == 1 ? Words::say("1 result waiting") : Words::say("%1 results waiting").arg(waiting);
}

QString sinceText(const QDateTime& since, const QDateTime& now)
{
    const QDateTime local = since.toLocalTime();
    return local.date() == now.toLocalTime().date() ? local.toString(u"HH:mm"_s)
                                                    : local.toString(u"yyyy-MM-dd HH:mm"_s);
}

Finding headlineOf(const PlantStatus& status, const QDateTime& now)
{
    if (status.reached && status.inStep)
        return Words::say("plant: in step");
    const qint64 waiting = status.waiting.value_or(0);
    if (status.reached)
        return waiting > 0      ? Words::say("plant: %1").arg(waitingWords(waiting))
               : status.problem ? Words::say("plant: not in step")
                                : Words::say("plant: being brought in step");
    if (!status.lastReached.isValid())
        return status.problem ? Words::say("plant: server not reached yet") : Words::say("plant: connecting");
    const QString since = sinceText(status.lastReached, now);
    if (waiting == 0) // or it is not known
        return Words::say("plant: server not reached since %1").arg(since);
    return Words::say("plant: %1, server not reached since %2").arg(waitingWords(waiting)).arg(since);
}

} // namespace

LineWords plantWords(const PlantStatus& status, const QDateTime& now)
{
    LineWords words;
    if (!status.on) {
        words.headline = Words::say("plant: off");
        words.well = true;
        return words;
    }
    words.headline = headlineOf(status, now);
    if (status.problem)
        words.problems.push_back(Finding(status.problem->describe()));
    for (const PlantConflict& conflict : status.conflicts) {
        if (words.problems.size() > mostConflictsTold) {
            words.problems.push_back(Words::say("More that stations decided apart: gripscope-cli library "
                                                "status tells all of it."));
            break;
        }
        words.problems.push_back(Finding(inWords(conflict)));
    }
    words.well = status.reached && words.problems.empty();
    return words;
}

} // namespace gripscope
