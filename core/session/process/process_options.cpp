// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/process/process_options.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(ProcessKind kind)
{
    return kind == ProcessKind::Hotelling ? u"hotelling"_s : toString(chartKindOf(kind));
}

std::optional<ProcessKind> processKindFromString(const QString& text)
{
    for (const ProcessKind kind :
         {ProcessKind::Individuals, ProcessKind::MeanRange, ProcessKind::MeanDeviation, ProcessKind::Ewma,
          ProcessKind::Cusum, ProcessKind::Hotelling})
        if (text == toString(kind))
            return kind;
    return {};
}

std::optional<RunRules> runRulesFromString(const QString& text)
{
    for (const RunRules rules : {RunRules::None, RunRules::WesternElectric, RunRules::Nelson})
        if (text == toString(rules))
            return rules;
    return {};
}

bool takesSubgroups(ProcessKind kind)
{
    return kind == ProcessKind::MeanRange || kind == ProcessKind::MeanDeviation;
}

bool takesRules(ProcessKind kind)
{
    return kind == ProcessKind::Individuals || takesSubgroups(kind);
}

ChartKind chartKindOf(ProcessKind kind)
{
    switch (kind) {
    case ProcessKind::MeanRange:
        return ChartKind::MeanRange;
    case ProcessKind::MeanDeviation:
        return ChartKind::MeanDeviation;
    case ProcessKind::Ewma:
        return ChartKind::Ewma;
    case ProcessKind::Cusum:
        return ChartKind::Cusum;
    case ProcessKind::Individuals:
    case ProcessKind::Hotelling:
        break;
    }
    return ChartKind::Individuals;
}

} // namespace gripscope
