// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/process/process_chart.h"

namespace gripscope {

/// "m", "b", "k".
[[nodiscard]] QString processSymbol(std::size_t quantity);

/// What is wrong, without where: "8 points in a row on one side of the centre"; sums say which way it went.
[[nodiscard]] Finding signalReason(const ProcessSignal& signal, const ProcessOptions& options);

/// Which inspections a signal is of, by number.
struct SignalNumbers {
    qint64 first = 0, last = 0; ///< told at the first, kept up until the last
    qint64 since = 0;           ///< where the pattern begins
};
[[nodiscard]] SignalNumbers signalNumbers(const QuantityChart& chart, const ProcessValues& values,
                                          const ProcessSignal& signal);
[[nodiscard]] SignalNumbers signalNumbers(const JointChart& chart, const ProcessValues& values,
                                          const ProcessSignal& signal);

/// "k at inspection 120: 8 points in a row on one side of the centre, since inspection 113"
[[nodiscard]] Finding signalSentence(const ProcessSignal& signal, const SignalNumbers& numbers,
                                     const ProcessOptions& options);

/// "While nothing changes, a signal comes every 92 points on average; after a shift by one sigma within 9.2."
[[nodiscard]] Finding runLengthSentence(const RunLengths& lengths, const ProcessOptions& options);
/// How many signals so many points give while nothing changes: "Chance alone would make some 33 of them."
/// Empty where that is less than one, or not known.
[[nodiscard]] Finding chanceSentence(std::size_t points, const RunLengths& lengths);

} // namespace gripscope
