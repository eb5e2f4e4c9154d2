// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/charts/run_length.h"

#include <cmath>

namespace gripscope {

namespace {

std::optional<RunLength> runLengthAt(const ChartSetting& setting, double shift)
{
    switch (setting.kind) {
    case ChartKind::Individuals:
    case ChartKind::MeanRange:
    case ChartKind::MeanDeviation:
        return shewhartRunLength(setting.rules, shift);
    case ChartKind::Ewma:
        return ewmaRunLength(setting.weight, setting.width, shift);
    case ChartKind::Cusum:
        return twoSidedCusumRunLength(setting.reference, setting.decision, shift);
    }
    return {};
}

} // namespace

RunLengths runLengths(const ChartSetting& setting, double shift)
{
    return {runLengthAt(setting, 0), runLengthAt(setting, shift * std::sqrt(setting.size))};
}

} // namespace gripscope
