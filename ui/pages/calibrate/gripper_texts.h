// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/lag/lag_estimation.h"
#include "core/session/calibrate/gripper_traits.h"
#include "core/session/connection/gripper_port.h"
#include "ui/format/fact.h"
#include "ui/format/parameter_text.h"

#include <QCoreApplication>

#include <span>
#include <vector>

namespace gripscope {

/// What a gripper is characterised by, in numbers for the screen, all with 95 % intervals.
class GripperTexts {
    Q_DECLARE_TR_FUNCTIONS(GripperTexts)
public:
    [[nodiscard]] static ParameterTexts baseline(const GripperBaseline& baseline,
                                                 const GripperIdentity& identity);
    [[nodiscard]] static QString friction(const GripperFriction& friction, const GripperIdentity& identity);
    /// "1,000 ± 30 kN/m", of a frame with that compliance.
    [[nodiscard]] static QString frame(double compliance, double standardError,
                                       const GripperIdentity& identity);
    /// k of a squeeze, also of one that tells no m; empty where it tells none.
    [[nodiscard]] static QString stiffness(const Identification& squeeze, const GripperIdentity& identity);
    [[nodiscard]] static QString lag(const LagEstimate& lag);

    /// One of the things that are measured by themselves, as it is in force.
    struct Section {
        QString heading;
        std::vector<Fact> facts; ///< none: nobody measured it
        QString when;            ///< and by whom
    };
    /// The empty gripper, the frame, the lag. `chain`: what is in force; `newestFirst`: how it came to be.
    [[nodiscard]] static std::vector<Section> sections(const NewMeasuringChain& chain,
                                                       std::span<const MeasuringChainRecord> newestFirst,
                                                       const GripperIdentity& identity);
};

} // namespace gripscope
