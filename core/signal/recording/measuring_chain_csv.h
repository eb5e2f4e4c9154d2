// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/finding.h"
#include "core/signal/recording/measuring_chain.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <string_view>

namespace gripscope {

/// The measuring chain in the head of a recording (CSV), one `key: value` a line, C locale:
///     force_lag_uncertainty_s, force_scale_uncertainty, position_scale_uncertainty, frame_compliance,
///     frame_compliance_uncertainty, friction, friction_uncertainty
///                                       one number from 0 to largestReading
///     baseline, baseline_uncertainty    three of them with commas between: m,b,k
/// A key that is absent leaves the default.
enum class ChainSetting {
    Taken,
    NoSuchKey,
    BadValue, ///< the value is not what measuringChainExpectation() says
};

/// Puts `value` where `key` says.
[[nodiscard]] ChainSetting setMeasuringChain(MeasuringChain& chain, std::string_view key,
                                             std::string_view value);
/// "expected ..." for a key with a bad value.
[[nodiscard]] Finding measuringChainExpectation(std::string_view key);

/// The lines "# key: value\n" that read back to the same bits; none for what has its default.
[[nodiscard]] QByteArray measuringChainLines(const MeasuringChain& chain);

} // namespace gripscope
