// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/result/identification_result.h"

namespace gripscope {

/// Every check of the contract, in its order, and after them `linearity` and `feedback` (and, where it
/// applies, `position_held`), on an identification whose estimates and recommendation are filled in.
///
/// The checks are a family. Residual whiteness (of the innovations where a noise model was found), input
/// independence, linearity and feedback are tests with p-values and share one false-alarm rate of 1 % (Sidak
/// 1967); the hold adds 0.5 % at the most, and 1.2 % once in all the squeezes
/// whose evidence is summed. A test that finds something counts only when that is worth more
/// than the interval of m, b or k. The others are limits on what was measured.
[[nodiscard]] std::vector<ValidityCheck> checkValidity(const Identification& identification,
                                                       const Recording& recording,
                                                       const IdentificationOptions& options);

// Whether the stream came whole, and whether its times are true.

/// `samples_lost`: whether the stream came whole, and its clock ran on. Reports that came twice or damaged,
/// and silences, say nothing of it where no sample is missing. value: samples missing.
[[nodiscard]] ValidityCheck samplesLost(const Identification& data, const Recording& recording);

/// `clock`: the device's clock against the computer's, as known at the end of the squeeze (StreamAccount).
/// Suspect where it is beyond 1,000 ppm with all of its uncertainty, invalid beyond 10,000: m is off by twice
/// as much, b by as much. A connection that is too young, and a recording that does not say, are not judged.
/// value: ppm.
[[nodiscard]] ValidityCheck clockAgainstComputer(const Recording& recording);

/// `sample_time`: whether samples come as often as the device states. Invalid where its own time stamps say
/// otherwise, by more than 1 % or by contradicting the sample count again and again; else by the computer's
/// clock with the limits above, unless the device's clock as such is off as much. value: ppm by which samples
/// come too often, where that is known.
[[nodiscard]] ValidityCheck statedSampleTime(const Identification& data, const Recording& recording);

// Whether the two channels said what there was, within the window that was identified.

/// `position_held`: a position that is renewed far more slowly than its rows come, with what can be said of
/// the stiffness in spite of it; nothing for any other. Suspect, and invalid where that is no interval. value
/// and limit: seconds between renewals, and between samples.
[[nodiscard]] std::optional<ValidityCheck> heldPositionCheck(const Identification& data);
/// `saturation`: samples at the end of a sensor's range, by the device's word or by their look. Suspect; from
/// 1 % of the samples on invalid. value: percent.
[[nodiscard]] ValidityCheck saturation(const Identification& data, const Recording& recording);
/// `stuck`: a channel that stood still while the other moved (stuckStretch()): invalid. value: samples. The
/// force is looked at only where a device sent it during an excitation that is no step.
[[nodiscard]] ValidityCheck stuckChannel(const Identification& data, const Recording& recording);
/// `device_fault`: the device reported a fault of its own at any sample: invalid. value: samples.
[[nodiscard]] ValidityCheck deviceFault(const Recording& recording);

} // namespace gripscope
