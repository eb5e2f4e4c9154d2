// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/signal/excitation/excitation.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

/// A force that somebody has, to be squeezed with (ExcitationKind::Levels):
///     force = bias + peak * level,  each level from -1 to 1, for `bit_s`.
struct ForceLevels {
    double bias = 0, peak = 0; ///< the middle of the force, and how far it goes from there
    double bit_s = 0;
    std::vector<double> levels;
    QString unit; ///< of bias and peak; empty: not said

    [[nodiscard]] double seconds() const { return bit_s * static_cast<double>(levels.size()); }
};

/// Of forces at equal steps. Equal neighbours are one longer level where all are longer by the same factor.
/// BadInput, at `name`: none or more than mostLevels remain, one is not finite, all are the same.
[[nodiscard]] Expected<ForceLevels> levelsOf(const std::vector<double>& force, double step_s,
                                             const QString& unit, const QString& name);

/// From a table with a column "force", a recording among them, and its times: in a column time_s or behind
/// "# sample_time_s:"; without either `step_s` is from row to row. BadInput where the steps differ by more
/// than a hundredth.
[[nodiscard]] Expected<ForceLevels> parseForceLevels(const QByteArray& text, const QString& name,
                                                     std::optional<double> step_s = {});
/// The same from a file; FileUnreadable.
[[nodiscard]] Expected<ForceLevels> readForceLevels(const QString& file, std::optional<double> step_s = {});
/// Bias and peak in newtons, for which a unit that is not said is taken. BadInput, at `name`, where it is not
/// known.
[[nodiscard]] Expected<ForceLevels> inNewtons(ForceLevels force, const QString& name);
/// A table that parseForceLevels() reads.
[[nodiscard]] QByteArray toCsv(const ForceLevels& levels);

} // namespace gripscope
