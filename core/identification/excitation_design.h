// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "core/identification/estimate.h"
#include "core/signal/recording.h"

#include <Eigen/Core>
#include <QString>

#include <cstdint>
#include <vector>

namespace gripscope {

/// A type to be told from others: its parameters and how they scatter from squeeze to squeeze (no scatter:
/// the zero matrix), both in the channels' units.
struct DesignObject {
    QString name;
    MassDampingStiffness mean;
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

struct DesignOptions {
    std::vector<DesignObject> objects; ///< one or more
    double peak = 10;                  ///< largest force above and below the bias
    double bias = 20;                  ///< the force that is held before and in the middle
    double limit = 100;                ///< crush limit: no force is ever above it
    bool oneSided = true;              ///< the object can't be pulled: no force is ever below zero
    double duration_s = 1;
    double sampleTime_s = 0.0005;
    double shortestRun_s = 0;  ///< how long the force must stay where it is: the actuator's limit
    double noiseDeviation = 0; ///< of the position
    ForceHold hold = ForceHold::Zero;
    std::uint64_t seed = 1;

    /// Nothing when the options make sense; else what does not, in words.
    [[nodiscard]] std::optional<Error> validate() const;
    [[nodiscard]] std::size_t samples() const;
    /// `peak`, less where the crush limit or the ground is nearer to the bias.
    [[nodiscard]] double amplitude() const;
};

enum class DesignKind { OptimizedBinary, Prbs, InverseRepeat, Multisine, Chirp, WhiteBinary, Step };
[[nodiscard]] QString toString(DesignKind kind); ///< "optimized-binary", "prbs", "inverse-repeat", ...

/// One force and what it is good for.
struct DesignCandidate {
    DesignKind kind = DesignKind::Prbs;
    double bit_s = 0;          ///< bit, shortest run, or half the shortest period; 0 for a step
    std::vector<double> force; ///< bias included
    /// Geometric mean over the objects of (det M / det M of the best binary signal found)^(1/3), M the
    /// information on ln m, ln b, ln k: 1 is as good, 0.25 costs twice the standard error.
    double dEfficiency = 0;
    /// Standard errors of m, b and k to be expected, one an object; empty where the force does not determine
    /// them.
    std::vector<std::optional<Eigen::Vector3d>> standardErrors;
    /// Mahalanobis distance of the nearest pair of objects, in ln m, ln b, ln k, scatter and expected error
    /// together; 0 with one object. Two Gaussian types this far apart are taken for each other at a rate of
    /// Phi(-distance / 2).
    double separation = 0;
    int nearestFirst = 0, nearestSecond = 0; ///< which pair
};

struct ExcitationDesign {
    double amplitude = 0;                    ///< that was used
    std::vector<DesignCandidate> candidates; ///< best first: by separation, with one object by D-efficiency
};

/// Compares excitations of equal peak for telling the objects apart, with x0, v0 and offset free and white
/// position noise, and searches a binary signal that is best for it: sign flips of short runs, one after the
/// other, as long as they help (coordinate exchange, Meyer and Nachtsheim 1995), from several starts; a local
/// optimum. PRBS over bit lengths of 0.5 to 4 over the natural frequency, inverse-repeat binary sequences in
/// four periods, multisines, chirps, a white binary sequence and a step stand beside it. The bias was held
/// long enough for the object to rest. Deterministic.
[[nodiscard]] Expected<ExcitationDesign> designExcitation(const DesignOptions& options);

} // namespace gripscope
