// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace gripscope::cli {

/// What the program tells its caller, as contracts say.
enum class Exit {
    Done = 0,
    Usage = 2,
    BadInput = 3,
    Device = 4,
    Storage = 5,
    NotAType = 6,
    Differs = 6, ///< from what was written
    NotWitnessed = 7
};

[[nodiscard]] Exit exitFor(const Error& error);

/// Several things can go wrong in one run: the lowest number that is not zero is told.
class ExitCode {
public:
    void add(Exit exit);
    [[nodiscard]] int value() const { return m_value; }

private:
    int m_value = 0;
};

} // namespace gripscope::cli
