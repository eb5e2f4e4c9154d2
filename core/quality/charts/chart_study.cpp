// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/chart_study.h"

#include "core/base/words.h"

#include <algorithm>

namespace gripscope {

namespace {

constexpr std::size_t enoughPoints = 20;

bool isShewhart(ChartKind kind)
{
    return kind != ChartKind::Ewma && kind != ChartKind::Cusum;
}

SpreadMethod spreadOf(ChartKind kind)
{
    switch (kind) {
    case ChartKind::Individuals:
        return SpreadMethod::MovingRange;
    case ChartKind::MeanRange:
        return SpreadMethod::Range;
    case ChartKind::MeanDeviation:
        return SpreadMethod::Deviation;
    case ChartKind::Ewma:
    case ChartKind::Cusum:
        break;
    }
    return SpreadMethod::Automatic;
}

std::optional<Error> checkSubgroups(const Subgroups& groups, const ChartOptions& options)
{
    const std::size_t used = options.estimateFrom.value_or(groups.count());
    const bool estimates = !options.target || !options.sigma;
    if (options.estimateFrom && (used < 2 || used > groups.count()))
        return Error{ErrorCode::Usage,
                     {Words::say("The first %1 points cannot settle the limits: there are %2, and at least 2 "
                                 "are needed.")
                          .arg(used)
                          .arg(groups.count())}};
    if (estimates && used < 2)
        return Error{
            ErrorCode::BadInput,
            {Words::say("The subgroups"), Words::say("there is one"),
             Words::say("at least two are needed to settle limits; state target and sigma, or smaller "
                        "subgroups")}};
    const bool needsPairs = options.kind == ChartKind::MeanRange || options.kind == ChartKind::MeanDeviation;
    if (needsPairs && groups.layout.largest() < 2)
        return Error{ErrorCode::BadInput,
                     {Words::say("The subgroups"), Words::say("each holds one value"),
                      Words::say("take i-mr, ewma or cusum, or larger subgroups")}};
    if (options.kind == ChartKind::Individuals && groups.layout.largest() > 1)
        return Error{ErrorCode::BadInput,
                     {Words::say("The subgroups"), Words::say("they hold several values each"),
                      Words::say("take xbar-r or xbar-s, or leave the subgroups out")}};
    return {};
}

Expected<ChartStudy> settle(const Subgroups& groups, const ChartOptions& options)
{
    ChartStudy study;
    study.setting = {options.kind,
                     0,
                     1,
                     isShewhart(options.kind) ? options.rules : RunRules::None,
                     options.weight,
                     options.width,
                     options.reference,
                     options.decision,
                     double(groups.values.size()) / double(groups.count())};
    study.setting.centre = options.target.value_or(0);
    study.setting.sigma = options.sigma.value_or(1);
    RETURN_IF_ERROR(study.setting.validate());
    RETURN_IF_ERROR(checkSubgroups(groups, options));
    const Subgroups part = options.estimateFrom ? groups.first(*options.estimateFrom) : Subgroups();
    const Subgroups& phaseOne = options.estimateFrom ? part : groups;
    if (!options.target)
        study.setting.centre = summaryOf(phaseOne.values).mean;
    if (options.sigma)
        return study;
    ASSIGN_OR_RETURN(study.spread, withinSpread(phaseOne, spreadOf(options.kind)));
    study.setting.sigma = study.spread->sigma;
    return study;
}

/// Since when each sum has not been 0.
class SumStarts {
public:
    void add(std::size_t point, const ChartPoint& drawn)
    {
        m_upper = drawn.upperSum > 0 ? m_upper.value_or(point) : std::optional<std::size_t>();
        m_lower = drawn.lowerSum > 0 ? m_lower.value_or(point) : std::optional<std::size_t>();
    }
    void describe(ChartSignal& signal, const ChartPoint& drawn) const
    {
        signal.rising = drawn.upperSum > drawn.upper;
        signal.since = signal.rising ? m_upper : m_lower;
    }

private:
    std::optional<std::size_t> m_upper, m_lower;
};

void noteSignals(ChartStudy& study, SumStarts& starts, std::size_t point, const ChartStep& step)
{
    starts.add(point, step.location);
    for (RuleSet left = step.location.rules, rule = 1; left != 0; left >>= 1, ++rule) {
        if (!(left & 1U))
            continue;
        ChartSignal signal{point, ChartPart::Location, rule, {}, step.location.value > step.location.upper};
        if (study.setting.kind == ChartKind::Cusum)
            starts.describe(signal, step.location);
        study.signalsFound.push_back(signal);
    }
    if (step.spread && step.spread->rules != 0)
        study.signalsFound.push_back(
            {point, ChartPart::Spread, 1, {}, step.spread->value > step.spread->upper});
}

std::optional<Error> drawPoints(ChartStudy& study, const Subgroups& groups)
{
    Expected<LiveChart> chart = LiveChart::of(study.setting);
    if (!chart)
        return chart.error();
    const bool withSpread = isShewhart(study.setting.kind);
    study.points.reserve(groups.count());
    study.spreadPoints.reserve(withSpread ? groups.count() : 0);
    SumStarts starts;
    for (std::size_t i = 0; i < groups.count(); ++i) {
        const Expected<ChartStep> step = chart->add(groups[i]);
        if (!step)
            return step.error();
        study.points.push_back(step->location);
        if (withSpread)
            study.spreadPoints.push_back(step->spread);
        noteSignals(study, starts, i, *step);
    }
    return {};
}

void sayWhatMatters(ChartStudy& study, const Subgroups& groups, const ChartOptions& options)
{
    const std::size_t used = options.estimateFrom.value_or(groups.count());
    if ((!options.target || !options.sigma) && used < enoughPoints)
        study.messages.push_back(
            Words::say("The limits come from %1 points; they are uncertain themselves. Take at least %2.")
                .arg(used)
                .arg(enoughPoints));
    if (groups.layout.smallest() != groups.layout.largest())
        study.messages.push_back(Words::say("The subgroups have %1 to %2 values, and each its own limits.")
                                     .arg(groups.layout.smallest())
                                     .arg(groups.layout.largest()));
    if (study.spread && study.spread->singles > 0)
        study.messages.push_back(Words::say("%1 subgroups hold one value; they say nothing about sigma.")
                                     .arg(study.spread->singles));
    if (!isShewhart(options.kind) && options.rules != RunRules::None)
        study.messages.push_back(Words::say("Run rules are for charts of independent points; on EWMA and "
                                            "CUSUM charts only the limits count."));
}

Finding whatHappened(const ChartSignal& signal, const ChartSetting& setting)
{
    if (signal.part == ChartPart::Spread)
        return setting.kind == ChartKind::Individuals
                   ? Words::say("the step from the value before is beyond its limit")
               : signal.rising ? Words::say("the values of the subgroup differ more than they should")
                               : Words::say("the values of the subgroup differ less than they should");
    if (setting.kind == ChartKind::Cusum)
        return (signal.rising ? Words::say("the upper sum is above its limit: higher since about point %1")
                              : Words::say("the lower sum is above its limit: lower since about point %1"))
            .arg(signal.since.value_or(signal.point) + 1);
    if (setting.kind == ChartKind::Ewma)
        return signal.rising ? Words::say("the moving average is above its limit")
                             : Words::say("the moving average is below its limit");
    return ruleInWords(setting.rules, signal.rule);
}

} // namespace

Expected<ChartStudy> studyChart(const Subgroups& groups, const ChartOptions& options)
{
    ASSIGN_OR_RETURN(ChartStudy study, settle(groups, options));
    RETURN_IF_ERROR(drawPoints(study, groups));
    sayWhatMatters(study, groups, options);
    return study;
}

Finding signalInWords(const ChartSignal& signal, const ChartSetting& setting)
{
    return Words::say("Point %1: %2").arg(signal.point + 1).arg(whatHappened(signal, setting));
}

} // namespace gripscope
