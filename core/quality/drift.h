// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/base/finding.h"
#include "core/recognition/types/type_model.h"
#include "core/recognition/types/type_shift.h"

#include <QStringList>

#include <optional>
#include <vector>

namespace gripscope {

struct DriftOptions {
    double weight = 0.2; ///< of the newest squeeze in the moving averages
    /// Squeezes of a type until its charts give a false alarm, on average, at least.
    double averageRunLength = 500;
    int recent = 20;          ///< the last squeezes of a type that are held against its enrolment
    double falseAlarm = 0.01; ///< share of looks at all types in which one that has not moved is said to have
    [[nodiscard]] std::optional<Error> validate() const;
};

/// What moved.
enum class DriftCause {
    TooFew,        ///< no type has enough squeezes, or none has a gate
    Nothing,       ///< no type is seen to have moved
    Sensor,        ///< m, b and k of all types by the same factors: a channel's gain, or the clock
    Fingers,       ///< the same m, b and k on top of all types: the fingers or their baseline
    Gripper,       ///< all types; factors and additions explain it equally well
    Product,       ///< the types named, the others not
    Unclear,       ///< too few squeezes to tell the product from the gripper
    OneTypeOnly,   ///< it moved, and there is no other type to tell the gripper from the product
    NoCommonCause, ///< several types, each in its own way
};
[[nodiscard]] QString toString(DriftCause cause); ///< "too_few", "nothing", "sensor", ...

/// A type's squeezes since its enrolment, in order of time.
struct TypeDrift {
    QString type;
    int squeezes = 0;
    /// Moving averages of log m, b, k where nothing has moved N(0, w/(2 - w)); and T^2 of the three together.
    Eigen::Vector3d average = Eigen::Vector3d::Zero();
    double tSquared = 0;
    std::optional<int> firstAlarm;  ///< the squeeze, counted from 1, at which a chart passed its limit
    std::optional<TypeShift> shift; ///< of the last ones; absent: too few
    bool moved = false;             ///< by that shift, at the stated share of looks
};

struct DriftReport {
    std::vector<TypeDrift> types;      ///< those with squeezes, by name
    double averageLimit = 0;           ///< of |average|
    double tSquaredLimit = 0;          ///< of T^2
    std::optional<CommonShift> factor; ///< of all types together
    std::optional<CommonShift> addition;
    DriftCause cause = DriftCause::TooFew;
    QStringList moved; ///< types that have, by name
    Findings words;    ///< sentences a technician understands
};

/// Recent squeezes of known types, oldest first, held against the enrolment.
///
/// Charts: the distance of each squeeze from the mean of all before it, enrolled or later (recursive
/// residuals), over its standard deviation, both updated with it, brought to a standard normal by its Student
/// t or F distribution. Where nothing moves these are independent whatever the number of enrolled squeezes,
/// so that the run length is the stated one (Hawkins and Maboudou-Tchao, Self-starting multivariate
/// exponentially weighted moving average control charting, Technometrics 2007). The four charts of a type (m,
/// b, k and T^2) have a run length of four times the stated one each, which gives at least that together.
///
/// Shift: the mean of the last ones against the enrolment, see typeShift(); it sees what moved slowly, which
/// the charts take for part of the mean. Cause: factors, additions or one product, three numbers each; those
/// that fit all types (agreement over 1 %) are candidates, and the best has to be e^2 times as likely as the
/// next.
///
/// Squeezes that the gate refused are not among those named: a strong drift shows as unknown parts, unless
/// the expected type was stated.
[[nodiscard]] Expected<DriftReport>
findDrift(const TypeModels& models, const std::vector<TypeSqueeze>& recent, const DriftOptions& options = {});

/// A sentence for whoever inspects parts: what moved, or else whose charts are beyond their limits with their
/// last squeeze. Nothing where neither is so.
[[nodiscard]] std::optional<Finding> driftSignal(const DriftReport& report);

/// The control charts of one type; see findDrift().
class SelfStartingChart {
public:
    /// `models` have at least 3 degrees of freedom; `place` of the type in them.
    SelfStartingChart(const TypeModels& models, std::size_t place, double weight);

    /// One more squeeze, as log(m, b, k), with its own covariance there.
    void add(const Eigen::Vector3d& log, const std::optional<Eigen::Matrix3d>& noise);

    [[nodiscard]] Eigen::Vector3d average() const { return m_each; }
    [[nodiscard]] double tSquared() const; ///< |average of the joint scores|^2 (2 - w) / w
    [[nodiscard]] int squeezes() const { return m_squeezes; }

private:
    const TypeModels& m_models;
    std::size_t m_place;
    double m_weight;
    Eigen::Vector3d m_mean;                          ///< of all squeezes so far
    Eigen::Matrix3d m_meanCovariance;                ///< where the covariance of a squeeze is known
    Eigen::Matrix3d m_sum = Eigen::Matrix3d::Zero(); ///< of whitened residuals and what enrolment stands for
    double m_degrees = 0;                            ///< behind it; 0 before the first squeeze
    Eigen::Vector3d m_each = Eigen::Vector3d::Zero();
    Eigen::Vector3d m_joint = Eigen::Vector3d::Zero();
    int m_squeezes = 0;
};

/// Limit of |e_t|^2 (2 - w) / w for an exponentially weighted moving average
///     e_t = w z_t + (1 - w) e_{t-1},  e_0 = 0,  z_t ~ N(0, I) in so many dimensions, independent,
/// that is passed for the first time after `averageRunLength` steps on average: Roberts's EWMA chart with one
/// dimension, Lowry's MEWMA chart (Hotelling's T^2 of the averages) with more. By the Markov chain of the
/// length of e_t (Runger and Prabhu, A Markov chain model for the multivariate exponentially weighted moving
/// averages control chart, 1996); 60 states know the run length to a hundredth. Nothing for w outside 0.01 to
/// 1, run lengths outside 5 to 1e6, or a dimension below 1.
[[nodiscard]] std::optional<double> movingAverageLimit(double weight, int dimension, double averageRunLength);

/// The other way round. Nothing for a limit that is not above zero.
[[nodiscard]] std::optional<double> averageRunLength(double weight, int dimension, double limit);

/// Since when squeezes lie elsewhere: behind the first `before` of those that were looked at.
struct ChangePoint {
    int before = 0;               ///< the most probable
    int earliest = 0, latest = 0; ///< the fewest and the most of the smallest set that has it with 95 %
    double probability = 0;       ///< of `before` itself
    LogVector shift = Eigen::Vector3d::Zero(); ///< behind it: s, of logarithms
    LogMatrix covariance = Eigen::Matrix3d::Zero();
    std::vector<double> posterior = {}; ///< of each place 0, 1, ... squeezes - 1
};

/// When `types` (all of the models where empty) moved together. Model, for squeeze t of type i,
///     log x_t = mu_i + o_i + [t > tau] H_i s + e_t,   e_t ~ N(0, S_t),
/// with o_i ~ N(0, C_i) what is not known of the enrolled mean mu_i, H_i as in commonShift(), s without
/// knowledge beforehand and tau alike likely at any squeeze. o and s are integrated out exactly,
///     ln p(tau) = b' A^-1 b / 2 - ln|A| / 2 + constant,
/// A the precision of (o, s) given tau and b the weighted residuals (Bayesian linear model; Smith, A Bayesian
/// approach to inference about a change-point in a sequence of random variables, Biometrika 1975). S_t is
/// taken for known.
///
/// tau = 0: moved since before the first of these. A change that creeps is dated to about its middle.
/// `squeezes`: oldest first; those of other types, or that do not determine models.space, are passed over but
/// counted in `before`. Nothing for fewer than five that count, or without a scatter.
[[nodiscard]] std::optional<ChangePoint> findChange(const TypeModels& models,
                                                    const std::vector<TypeSqueeze>& squeezes, ShiftKind kind,
                                                    const QStringList& types = {});

} // namespace gripscope
