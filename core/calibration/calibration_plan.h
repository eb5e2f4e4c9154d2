// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/sensor_calibration.h"

#include <QString>

#include <span>

namespace gripscope {

/// How a calibration is to be taken.
struct CalibrationPlan {
    SensorChannel channel = SensorChannel::Force;
    std::vector<double> loads{0, 10, 20, 30, 40, 50}; ///< in the channel's unit, ascending, all different
    int runs = 2;                                     ///< each up and, where wanted, down again
    bool descending = true;
    int degree = 1;
    CalibrationReference reference;
    double averaging_s = 1;
    bool loadsAreRead = false; ///< from a load cell at each point; those of the plan are what to aim at
    bool checkAfter = false;   ///< a run more at the end, not fitted: how the channel is left
    CalibrationConditions conditions;
};

struct PlannedPoint {
    double load = 0;
    int run = 1;           ///< counted from 1
    bool ascending = true; ///< reached from below
    bool check = false;    ///< of the run that is not fitted
};

/// Why a plan cannot be carried out, and what would do; nothing when it can.
[[nodiscard]] std::optional<Error> problemOf(const CalibrationPlan& plan);

/// Up through all loads and down again, as often as there are runs. A run begins where the one before ended:
/// that load is not taken twice. Without descending each run starts at the least load again. The check, where
/// one is wanted, is the last run.
[[nodiscard]] std::vector<PlannedPoint> plannedPoints(const CalibrationPlan& plan);

enum class SteadyStatus { Steady, Moving, TooFewSamples };

/// What a channel said while nothing moved.
struct SteadyReading {
    SteadyStatus status = SteadyStatus::TooFewSamples;
    double mean = 0;
    double deviation = 0; ///< standard deviation of single samples
    double drift = 0;     ///< from the beginning to the end, by a straight line
    std::size_t samples = 0;
};

struct SteadyOptions {
    std::size_t leastSamples = 20;
    double driftAllowed = 0; ///< a smaller drift is of no account, in the channel's unit
};

/// Mean of `values`, evenly spaced in time, all finite. Moving: a straight line through the means of ten
/// blocks drifts by more than is allowed and by more than its own noise explains (Student's t, 8 degrees of
/// freedom, p = 0.001); blocks, since neighbouring samples need not be independent. Linear in the samples.
[[nodiscard]] SteadyReading steadyReading(std::span<const double> values, const SteadyOptions& options);

} // namespace gripscope
