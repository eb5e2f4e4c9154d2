// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/signal/excitation/excitation.h"
#include "core/signal/recording/recording.h"

#include <Eigen/Core>
#include <QString>
#include <QStringList>

#include <vector>

namespace gripscope {

/// Length of a bit of the PRBS.
inline constexpr double efficiencyBit_s = 0.5;

/// One experiment with known truth, to be repeated: an object at rest at zero, a force of peak 1 that is held
/// between samples, white Gaussian noise on the position such that the true model fits `fitPercent`.
struct EfficiencySetting {
    QString type; ///< of the paper, "A" to "D"
    MassDampingStiffness truth;
    ExcitationKind excitation = ExcitationKind::Prbs;
    double fitPercent = 90;
    std::size_t samples = 200;
    double sampleTime_s = 0.05;

    [[nodiscard]] QString name() const; ///< "A-prbs-90-200"
};

/// The 48 settings of the study: the four types of the paper's appendix (means, without units), PRBS and
/// multisine, 85, 90 and 95 % noise fit, 200 and 1,000 samples 0.05 s apart.
[[nodiscard]] std::vector<EfficiencySetting> efficiencySettings();

/// Those that have one of the words of each kind: {"A", "B", "prbs"} are types A and B with a PRBS. Words:
/// types, excitations, fits, numbers of samples, whole names. Empty: all. Nothing left: a word that no
/// setting has, or words that exclude each other.
[[nodiscard]] std::vector<EfficiencySetting> selectSettings(const QStringList& words);

/// What is known of a setting before the first noise is drawn.
struct EfficiencyExperiment {
    std::vector<double> force, position; ///< position without noise
    std::vector<int> harmonics;          ///< of the multisine, multiples of `fundamental_rad_s`
    double fundamental_rad_s = 0;
    double noiseDeviation = 0;
    /// Cramer-Rao bound on the standard deviations of m, b and k with x0, v0 and offset free.
    Eigen::Vector3d bound = Eigen::Vector3d::Zero();
};

/// PRBS: bits of 0.5 s. Multisine: equal amplitudes on all harmonics of the record's length within 0.2 to 3
/// rad/s, phases after Schroeder (1970), one period a record.
[[nodiscard]] EfficiencyExperiment makeExperiment(const EfficiencySetting& setting);

} // namespace gripscope
