// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace gripscope {

enum class CheckOutcome {
    Ok,
    Look,   ///< it works, but somebody has to see to it
    Broken, ///< something does not work
};
[[nodiscard]] QString toString(CheckOutcome outcome); ///< "ok", "look", "broken"

/// One question that was asked of this computer.
struct CheckLine {
    QString id;   ///< library, integrity, chain, keys, disk, calibration, clock, permissions, versions
    QString name; ///< "Library"
    CheckOutcome outcome = CheckOutcome::Ok;
    QString found;  ///< what is so
    QString advice; ///< what to do; empty when ok
};
} // namespace gripscope
