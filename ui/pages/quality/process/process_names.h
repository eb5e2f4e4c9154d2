// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/process/process_session.h"
#include "ui/charts/control_series.h"

#include <QCoreApplication>

namespace gripscope {

/// What the charts of a process are called.
class ProcessNames {
    Q_DECLARE_TR_FUNCTIONS(ProcessNames)
public:
    [[nodiscard]] static QString kind(ProcessKind kind); ///< "Individuals and moving range"
    [[nodiscard]] static QString rules(RunRules rules);  ///< "Western Electric"
    /// Where the limits come from: fixed by whom and when, or the inspections shown.
    [[nodiscard]] static QString limits(const ProcessSession& session);
    /// Why there is no chart of a quantity: too few, not determined, or what else was wrong.
    [[nodiscard]] static QString missing(const ProcessPicture& picture, std::size_t quantity);
    /// "2026-11-22 09:50", of an inspection.
    [[nodiscard]] static QString time(const ProcessValues& values, std::uint32_t row);

    /// m, b and k, or one of them with its ranges, or T^2; `quantity` 3: all.
    [[nodiscard]] static std::vector<ControlPanel> panels(const ProcessPicture& picture,
                                                          std::size_t quantity);
    static constexpr std::size_t allQuantities = 3;
};

/// A line of the capability, worded.
struct CapabilityLine {
    QString name, value, interval;
};
class CapabilityNumbers {
    Q_DECLARE_TR_FUNCTIONS(CapabilityNumbers)
public:
    /// Cp, Cpk, Pp, Ppk, Cpm with their 95 % intervals; none without limits.
    [[nodiscard]] static std::vector<CapabilityLine> of(const ProcessCapability& capability);
    /// Verdict, ppm, normality, and the way for what is not normal; a sentence each.
    [[nodiscard]] static QStringList sentences(const ProcessCapability& capability);
};

} // namespace gripscope
