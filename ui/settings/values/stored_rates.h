// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/verdict/verdict.h"

namespace gripscope {

class Settings;

/// What a technician set for verdicts, kept from one start of the program to the next.
struct StoredRates {
    VerdictOptions rates;
    bool earlyEnd = true;
};

/// What was never stored, or is no rate any more, is as if nobody had set it.
[[nodiscard]] StoredRates readRates(const Settings& settings);
void writeRates(Settings& settings, const StoredRates& stored);

} // namespace gripscope
