// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/process/process_words.h"

#include "core/base/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Finding spreadReason(const ProcessSignal& signal, const ProcessOptions& options)
{
    if (options.kind == ProcessKind::Individuals)
        return Words::say("the step from the value before is beyond its limit");
    return signal.rising ? Words::say("the values of the subgroup differ more than they should")
                         : Words::say("the values of the subgroup differ less than they should");
}

Finding lengthWords(const RunLength& length)
{
    return Finding::number(length.points, 'f', length.points < 100 ? 1 : 0);
}

} // namespace

QString processSymbol(std::size_t quantity)
{
    return quantity == 0 ? u"m"_s : quantity == 1 ? u"b"_s : u"k"_s;
}

Finding signalReason(const ProcessSignal& signal, const ProcessOptions& options)
{
    if (signal.joint)
        return Words::say("m, b and k together are beyond their limit, mostly by %1")
            .arg(Finding(processSymbol(signal.quantity)));
    if (signal.part == ChartPart::Spread)
        return spreadReason(signal, options);
    if (options.kind == ProcessKind::Cusum)
        return signal.rising ? Words::say("the upper sum is above its limit: the values have risen")
                             : Words::say("the lower sum is above its limit: the values have fallen");
    if (options.kind == ProcessKind::Ewma)
        return signal.rising ? Words::say("the moving average is above its limit")
                             : Words::say("the moving average is below its limit");
    if (signal.rule == 1)
        return signal.rising ? Words::say("above the upper limit") : Words::say("below the lower limit");
    return ruleInWords(options.rules, signal.rule);
}

SignalNumbers signalNumbers(const QuantityChart& chart, const ProcessValues& values,
                            const ProcessSignal& signal)
{
    const std::size_t begins = signal.since * std::size_t(chart.size);
    return {values.numbers[chart.row(signal.first)], values.numbers[chart.row(signal.last)],
            values.numbers[chart.rows[begins]]};
}

SignalNumbers signalNumbers(const JointChart& chart, const ProcessValues& values, const ProcessSignal& signal)
{
    return {values.numbers[chart.rows[signal.first]], values.numbers[chart.rows[signal.last]],
            values.numbers[chart.rows[signal.since]]};
}

Finding signalSentence(const ProcessSignal& signal, const SignalNumbers& numbers,
                       const ProcessOptions& options)
{
    const Finding what = signalReason(signal, options);
    const Finding name(signal.joint ? u"T²"_s : processSymbol(signal.quantity));
    if (numbers.since == numbers.first)
        return Words::say("%1 at inspection %2: %3").arg(name).arg(numbers.first).arg(what);
    return Words::say("%1 at inspection %2: %3, since inspection %4")
        .arg(name)
        .arg(numbers.first)
        .arg(what)
        .arg(numbers.since);
}

Finding runLengthSentence(const RunLengths& lengths, const ProcessOptions& options)
{
    if (!lengths.inControl || !lengths.shifted)
        return Words::say("How seldom a false signal comes cannot be told for this chart.");
    const Finding steady = lengthWords(*lengths.inControl), shifted = lengthWords(*lengths.shifted);
    if (options.kind == ProcessKind::Hotelling)
        return Words::say("While nothing changes, one point in %1 signals by chance; once m, b and k have "
                          "moved together by one standard deviation, a signal comes within %2 points on "
                          "average.")
            .arg(steady)
            .arg(shifted);
    return Words::say("While nothing changes, one point in %1 signals by chance on each chart; once a "
                      "quantity has moved by one sigma, a signal comes within %2 points on average.")
        .arg(steady)
        .arg(shifted);
}

Finding chanceSentence(std::size_t points, const RunLengths& lengths)
{
    if (!lengths.inControl || !(double(points) >= lengths.inControl->points))
        return {};
    return Words::say("Chance alone would make some %1 of them.")
        .arg(Finding::number(double(points) / lengths.inControl->points, 'f', 0));
}

} // namespace gripscope
