// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

/// A new key: a UUID of version 7 (RFC 9562, section 5.7) as 36 lower-case characters. 48 bits of UTC
/// milliseconds, a 12-bit counter, 62 random bits. Keys made by one process sort in the order they were made,
/// also when the clock is set back or many fall in one millisecond; keys of several stations sort by their
/// clocks. Thread-safe.
[[nodiscard]] QString newTimeOrderedId();

} // namespace gripscope
