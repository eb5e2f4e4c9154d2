// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/records/squeeze_record.h"

#include <vector>

namespace gripscope {

/// Types of the simulated parts, six squeezes each, for Library::loadExampleTypes(): four levels of 5 N about
/// 10 N at 2 kHz, positions with 5 um of noise, each quantity of a part different by 4 % from squeeze to
/// squeeze. What is enrolled is what identify() finds. The same every time. Takes some seconds.
[[nodiscard]] std::vector<ExampleType> simulatedExamples();

} // namespace gripscope
