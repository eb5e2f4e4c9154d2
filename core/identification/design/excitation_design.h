// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/identification/model/estimate.h"
#include "core/identification/model/response_sensitivities.h"
#include "core/signal/recording/recording.h"

#include <Eigen/Core>
#include <QString>

#include <cstdint>
#include <functional>
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

// The parts of the search.

/// What the information matrices of one signal, one an object, on (ln m, ln b, ln k) and for noise of
/// variance 1, are worth.
class DesignCriterion {
public:
    explicit DesignCriterion(const DesignOptions& options);

    /// Mean over the objects of ln det M / 3; very negative where one is singular.
    [[nodiscard]] static double meanLogDeterminant(const std::vector<Eigen::Matrix3d>& information);

    struct Separation {
        double distance = 0;
        int first = 0, second = 0;
    };
    /// Mahalanobis distance of the nearest pair; 0 where an object's information is singular, or with one
    /// object.
    [[nodiscard]] Separation separation(const std::vector<Eigen::Matrix3d>& information) const;

private:
    double m_noiseVariance;
    std::vector<Eigen::Vector3d> m_logarithms;
    std::vector<Eigen::Matrix3d> m_scatter; ///< of the logarithms
};

/// Binary signals, +1 or -1 on runs of equal length, and their information matrices, one an object. The
/// sensitivities are linear in the signal, so with R_j those to a force of 1 on run j alone the information
/// of signs s is sum_jk s_j s_k R_j' R_k (nuisances projected out): once these products are known a flip
/// costs a few operations, whatever the number of samples.
class BinaryExchange {
public:
    /// `runSamples` samples a run, the last one as long as the record allows. Held force.
    BinaryExchange(const DesignOptions& options, std::size_t runSamples);

    [[nodiscard]] std::size_t runs() const { return m_runs; }
    using Score = std::function<double(const std::vector<Eigen::Matrix3d>&)>;
    /// Flips signs as long as one raises the score, at most `sweeps` times through all runs.
    [[nodiscard]] std::vector<int> improve(std::vector<int> signs, const Score& score, int sweeps) const;
    [[nodiscard]] std::vector<Eigen::Matrix3d> information(const std::vector<int>& signs) const;

private:
    /// R_j' R_k of one object.
    using Products = std::vector<Eigen::Matrix3d>;
    [[nodiscard]] Products productsFor(const ResponseSensitivities& pulse, std::size_t runSamples) const;
    [[nodiscard]] const Eigen::Matrix3d& product(std::size_t object, std::size_t j, std::size_t k) const
    {
        return m_products[object][j * m_runs + k];
    }

    std::size_t m_runs;
    std::vector<Products> m_products; ///< an object
};

} // namespace gripscope
