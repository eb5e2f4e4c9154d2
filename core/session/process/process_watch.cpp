// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/process/process_watch.h"

#include "core/base/words.h"
#include "core/session/process/fixed_limits.h"
#include "core/session/process/process_words.h"

#include <utility>

namespace gripscope {

namespace {

Expected<ProcessValues> newestValues(Library& library, const ProcessQuery& query)
{
    ProcessValues values;
    ProcessPlace place;
    while (!place.through) {
        ASSIGN_OR_RETURN(place, library.processStretch(query, place, values));
    }
    return values;
}

/// Signals at the newest point, the plainest first: beyond a limit before patterns.
std::optional<Finding> lastSignal(const QuantityChart& chart, const ProcessValues& values,
                                  const ProcessOptions& options)
{
    const ProcessSignal* found = nullptr;
    for (const ProcessSignal& signal : chart.signalsFound)
        if (signal.last + 1 == chart.points() && (found == nullptr || signal.rule < found->rule))
            found = &signal;
    if (found == nullptr)
        return {};
    return signalSentence(*found, signalNumbers(chart, values, *found), options);
}

std::optional<Finding> newestSignal(const ProcessValues& values, const ProcessOptions& options)
{
    const ProcessRows rows = processRows(values, {});
    if (options.kind == ProcessKind::Hotelling) {
        const Expected<JointChart> chart = drawJoint(values, rows, options);
        if (!chart || !options.fixed->joint || chart->signalsFound.empty() ||
            chart->signalsFound.back().last + 1 != chart->points.size())
            return {};
        const ProcessSignal& signal = chart->signalsFound.back();
        return signalSentence(signal, signalNumbers(*chart, values, signal), options);
    }
    // Stiffness first: it is what a grip feels most surely.
    for (const std::size_t quantity : {2U, 0U, 1U}) {
        if (!options.fixed->quantities[quantity])
            continue;
        const Expected<QuantityChart> chart = drawQuantity(values, rows, quantity, options);
        if (auto signal = chart ? lastSignal(*chart, values, options) : std::nullopt)
            return signal;
    }
    return {};
}

} // namespace

Expected<std::optional<Finding>> processSignalOf(Library& library, const QString& type)
{
    using Found = std::optional<Finding>;
    ASSIGN_OR_RETURN(const auto record, library.processLimits(type));
    const auto fixed = fixedLimitsOf(record);
    if (!fixed)
        return Found();
    ProcessQuery query;
    query.type = type;
    query.after = fixed->last;
    query.newest = ProcessWatch::newest;
    ASSIGN_OR_RETURN(const ProcessValues values, newestValues(library, query));
    ProcessOptions options;
    options.kind = fixed->kind;
    options.rules = fixed->rules;
    options.subgroup = fixed->subgroup;
    options.fixed = fixed;
    if (values.empty())
        return Found();
    const Found signal = newestSignal(values, options);
    if (!signal)
        return Found();
    return Found(Words::say("The charts of %1 signal. %2.").arg(Finding(type)).arg(*signal));
}

void ProcessWatch::look(const QString& type)
{
    if (m_looking.waiting()) {
        m_next = type;
        return;
    }
    m_next.reset();
    if (type.isEmpty()) {
        m_signal.reset();
        return;
    }
    using Found = std::optional<Finding>;
    m_looking =
        PendingCall(m_library.run<Found>([type](Library& library) { return processSignalOf(library, type); }),
                    [this](Expected<Found> found) {
                        // A library that cannot be read is told of by whoever has to read it.
                        m_signal = found ? *std::move(found) : std::nullopt;
                    });
}

bool ProcessWatch::poll()
{
    const bool answered = m_looking.poll();
    if (answered && m_next)
        look(*std::exchange(m_next, std::nullopt));
    return answered;
}

} // namespace gripscope
