// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/discretization.h"
#include "core/math/gaussian.h"
#include "core/signal/excitation/excitation.h"
#include "core/signal/recording/recording.h"

#include <algorithm>
#include <cmath>

namespace gripscope::test {

/// A gripper whose force is controlled: a stiff drive pushes the object, a servo makes the measured force
/// follow the command, and a slow disturbance drifts.
///
///     object   m x'' + b x' + k x = u + w        u measured, held between samples; w not measured
///     drive    u[t] = a[t] - driveStiffness x[t-1]
///     servo    a[t+1] = a[t] + servoGain (r[t] - u[t])
///
/// The drive is stiff (3 times the object), so that a position that drifts takes force away until the servo
/// has put it back: u is correlated with w, which no estimator that takes u for an independent input
/// survives. w is a random walk whose deviation at the record's end is `drift` times the peak of the command
/// (or a straight line to that value).
struct ControlledGripper {
    MassDampingStiffness truth{0.0396209, 0.1374754, 0.1022911}; ///< can A in the paper's numbers
    double sampleTime_s = 0.05, bit_s = 0.2, peak = 1;
    std::size_t samples = 1984; ///< 8 periods of 2 times 31 bits
    double driveStiffness = 0.3, servoGain = 0.1;
    double drift = 0.1;
    bool straightDrift = false;
    double positionNoise = 0; ///< relative to the position's deviation
    std::uint64_t seed = 1;

    [[nodiscard]] Recording make() const
    {
        ExcitationOptions excitation;
        excitation.kind = ExcitationKind::InverseRepeat;
        excitation.peak = peak;
        excitation.bias = 0;
        excitation.bit_s = bit_s;
        excitation.sampleTime_s = sampleTime_s;
        excitation.samples = samples;
        excitation.seed = seed;
        excitation.oneSided = false;
        const std::vector<double> command = *makeExcitation(excitation);
        Recording recording;
        recording.sampleTime_s = sampleTime_s;
        recording.hold = ForceHold::Zero;
        recording.provenance.insert(QStringLiteral("excitation_period_samples"),
                                    QString::number(*excitationPeriod(excitation)));
        run(command, recording);
        addNoise(recording);
        return recording;
    }

private:
    void run(const std::vector<double>& command, Recording& recording) const
    {
        const ExactStep<2> step = discretize(truth, sampleTime_s, ForceHold::Zero);
        GaussianNoise random(seed + 500000);
        const double perSample = drift * peak / std::sqrt(static_cast<double>(samples));
        Eigen::Vector2d state = Eigen::Vector2d::Zero();
        double actuator = 0;
        double disturbance = 0;
        double before = 0;
        for (std::size_t t = 0; t < command.size(); ++t) {
            const double force = actuator - driveStiffness * before;
            before = state(0);
            recording.time_s.push_back(static_cast<double>(t) * sampleTime_s);
            recording.force.push_back(force);
            recording.position.push_back(state(0));
            actuator += servoGain * (command[t] - force);
            disturbance += straightDrift ? drift * peak / static_cast<double>(samples) : perSample * random();
            state = (step.phi * state + step.gamma0 * (force + disturbance)).eval();
        }
    }
    void addNoise(Recording& recording) const
    {
        double power = 0;
        for (const double y : recording.position)
            power += y * y / static_cast<double>(recording.position.size());
        GaussianNoise random(seed + 1000000);
        for (double& y : recording.position)
            y += positionNoise * std::sqrt(power) * random();
    }
};

} // namespace gripscope::test
