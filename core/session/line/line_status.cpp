// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/line/line_status.h"

#include "core/base/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QString clockTime(const QDateTime& time)
{
    return time.toLocalTime().toString(u"HH:mm"_s);
}

Findings linkProblems(const LineLink& link, const JobDesk::View& view)
{
    Findings problems;
    if (link.clients == 0)
        problems.push_back(Words::say("No PLC connected since %1.").arg(clockTime(link.clientsChanged)));
    else if (!view.plcAlive)
        problems.push_back(Words::say("A PLC is connected, and its heartbeat stands still: it has to write "
                                      "another number all the time."));
    if (!link.refusedPeer.isEmpty() && link.clients == 0)
        problems.push_back(Words::say("%1 was turned away: it is not among the addresses that may connect.")
                               .arg(link.refusedPeer));
    return problems;
}

Findings jobProblems(const JobDesk::View& view, JobDesk::TimePoint now, std::chrono::milliseconds patience)
{
    Findings problems;
    if (view.result && view.unreadSince && now - *view.unreadSince >= patience)
        problems.push_back(Words::say("PLC has not acknowledged result %1.").arg(view.result->sequence));
    if (view.lastAnswer > JobAnswer::Taken)
        problems.push_back(refusalInWords(view.lastAnswer, view.lastTrigger, view.lastPartToken));
    return problems;
}

} // namespace

LineWords lineWords(const LineLink& link, const JobDesk::View& view, JobDesk::TimePoint now,
                    std::chrono::milliseconds patience)
{
    LineWords words;
    if (!link.on) {
        words.headline = Words::say("PLC: off");
        words.well = true;
        return words;
    }
    if (link.failed) {
        words.headline = Words::say("PLC: not listening");
        words.problems.push_back(Finding(link.failed->describe()));
        return words;
    }
    words.problems = linkProblems(link, view);
    for (const Finding& problem : jobProblems(view, now, patience))
        words.problems.push_back(problem);
    words.well = words.problems.empty();
    words.headline = words.well ? Words::say("PLC: in step") : Words::say("PLC: see why");
    return words;
}

} // namespace gripscope
