// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/recognition/types/type_model.h"

#include <QDateTime>
#include <QStringList>

#include <optional>
#include <vector>

namespace gripscope {

// What a library holds, all in the same units: SI where the channels' units are known.

/// The approved types, and the squeezes they were enrolled with: what verdicts are made of.
[[nodiscard]] Expected<TypeModels> approvedModels(Library& library);

/// The inspected squeezes, oldest first, with the type they are of: the expected one where it was stated,
/// else the one that was named. `leftOut` counts those of neither, those without m, b and k, and those
/// voided.
struct InspectedSqueezes {
    std::vector<TypeSqueeze> squeezes; ///< as the gripper of the types would have found them, where adjusted
    int leftOut = 0;
    /// Where a squeeze is from, one for each.
    struct Origin {
        qint64 number = 0; ///< of the inspection
        QDateTime inspected;
        QString batch, gripperSerial, station;
        friend bool operator==(const Origin&, const Origin&) = default;
    };
    std::vector<Origin> origins = {};
    QStringList grippers = {}, stations = {}; ///< that inspections are from, whatever was chosen
};
struct InspectedChoice {
    std::optional<int> newest = {}; ///< so many inspections are looked at; absent: all
    /// Without those that were not recognised as the type that was expected: whoever squeezes another part
    /// has not seen the type move.
    bool recognisedOnly = false;
    QString gripperSerial = {}, station = {}; ///< of these alone; empty: of all
};
[[nodiscard]] Expected<InspectedSqueezes> inspectedSqueezes(Library& library,
                                                            const InspectedChoice& choice = {});

} // namespace gripscope
