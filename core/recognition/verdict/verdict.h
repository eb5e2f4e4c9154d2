// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/identification/identification.h"
#include "core/quality/conformity/conformity.h"
#include "core/recognition/types/instrument_range.h"
#include "core/recognition/types/type_model.h"
#include "core/recognition/types/type_shift.h"

#include <QMap>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

namespace gripscope {

/// Type: one of the enrolled types. Unknown: outside the gate of every type. Inconclusive: two types too
/// close for this squeeze, or no gate yet. Invalid: the measurement was not good enough to judge the part.
enum class VerdictKind { Type, Unknown, Inconclusive, Invalid };
[[nodiscard]] QString toString(VerdictKind kind);
[[nodiscard]] std::optional<VerdictKind> verdictKindFromString(const QString& text);

/// Three rates, each with a denominator of its own.
struct VerdictOptions {
    /// Of the squeezes of known parts, the share that the gate may call unknown.
    double falseReject = 0.01;
    /// Of the squeezes of known parts, the share that may be named another type.
    double wrongType = 0.001;
    /// The models are in SI: reasons then name values with their units ("9.98 kN/m"). Off for numbers without
    /// units.
    bool siUnits = true;
    /// Of the strangers a gripper may meet, spread evenly over `range`, the share that may be named a type.
    double strangerAccept = 0.01;
    /// Absent: the false-reject rate holds on average over enrolments. Else for this library, with this
    /// confidence (0.95): a wider gate.
    std::optional<double> confidence = {};
    /// For types that spread unlike and squeezes with heavier tails than a Gaussian's; wider gates.
    bool robust = false;
    /// Absent: InstrumentRange{} where the models are in SI; else nothing is said about strangers.
    std::optional<InstrumentRange> range = {};
    /// Share of strangers among all that is squeezed; only Verdict::strangerPosterior uses it.
    double strangerShare = 0.1;
    /// `range`, or InstrumentRange{} where the models are in SI.
    [[nodiscard]] std::optional<InstrumentRange> strangerRange() const;
    /// Rates at least 1e-6 and at most 0.5, confidence from 0.5 to 0.9999, a range that is one.
    [[nodiscard]] std::optional<Error> validate() const;
    friend bool operator==(const VerdictOptions&, const VerdictOptions&) = default;
};

struct Verdict {
    VerdictKind kind = VerdictKind::Invalid;
    QString type;                    ///< empty unless kind is Type
    QString nearest;                 ///< empty when no type is enrolled
    QMap<QString, double> posterior; ///< over the enrolled types, sums to 1 (equal priors)
    std::optional<double> distance;  ///< squared, to the nearest type
    std::optional<double> gate;      ///< squared, of the nearest type
    std::size_t samplesUsed = 0;
    Findings reasons;      ///< sentences a technician understands
    QString rival = {};    ///< the type that is least ruled out beside the nearest; empty with one type
    QStringList open = {}; ///< the nearest and those not told from it; empty where it is none of them
    /// Inconclusive though the types are told apart: named `nearest`, so would too many strangers be.
    bool heldForStranger = false;
    /// Inconclusive between nearest and rival: so many times as long a squeeze would tell them apart.
    std::optional<double> timesLonger = {};
    std::optional<double> strangerPosterior = {}; ///< that it is of no enrolled type, see strangerShare
    std::optional<double> strangerAccept = {};    ///< share of strangers that would be named some type
    ValiditySummary validity = {};                ///< what the measurement behind it is worth
    /// How a part of `type` stands to the limits of that type; absent: it has none, or there is no type.
    std::optional<Conformity> conformity = {};
    /// `reasons`, how the part stands to its limits, and what makes the measurement suspect.
    [[nodiscard]] Findings allReasons() const;
};

/// The verdict on a squeeze in models.space (m, b, k) and, where it is known, with its covariance C. Invalid
/// where it does not determine all of that space.
///
/// Unknown: outside every gate. distance and gate are (1 + 1/n) times d' V^-1 d (TypePrediction) and its
/// limit: with one C for all squeezes the D^2 and the gate of falseRejectGate(), with `confidence` that of
/// toleranceGate(). Nearest: the least d' V^-1 d, of those within their gates where any is.
///
/// Type: also the most probable, every other type ruled out at the wrong-type rate (testNaming()), and the
/// density above what keeps the stranger-accept rate (strangerLimit()). Posterior: predictive densities,
/// equal priors; with v = 0 all are alike. Else, and without a gate (v < p, 3 for m, b, k), Inconclusive.
[[nodiscard]] Verdict judge(const TypeModels& models, const TypeSqueeze& squeeze,
                            const VerdictOptions& options = {});
/// The same for one of which m, b, k are known.
[[nodiscard]] Verdict judge(const TypeModels& models, const MassDampingStiffness& parameters,
                            const VerdictOptions& options = {},
                            const std::optional<Eigen::Matrix3d>& covariance = {});
/// The verdict on a measurement: Invalid when it is, or where nothing was found, else judge() on what was
/// found, identifiedSqueeze() of the identification, in the units of the models. `transfer`: the error of the
/// gripper that squeezed, against the one the types were enrolled on (measureTransfer()); it is taken off
/// first.
[[nodiscard]] Verdict judge(const TypeModels& models, const Identification& identification,
                            const std::optional<TypeSqueeze>& found, const VerdictOptions& options = {},
                            const std::optional<CommonShift>& transfer = {});
/// The same by any judge of squeezes.
using SqueezeJudge = std::function<Verdict(const TypeSqueeze& squeeze)>;
[[nodiscard]] Verdict verdictOnMeasurement(const Identification& identification,
                                           const std::optional<TypeSqueeze>& found,
                                           const std::optional<CommonShift>& transfer,
                                           const SqueezeJudge& judgeSqueeze);

/// Of each quantity of models.space (m, b, k).
using GateIntervals = std::vector<TypeInterval>;
/// Where the gate of each type ends, in order of the models and in their units, for a squeeze as well known
/// as those enrolled: exp(mean -+ sqrt(g V_ii)) with d' V^-1 d <= g the gate of judge(), the box about that
/// ellipsoid. A squeeze beyond it in one of them is outside the gate; one within it need not be inside.
/// Empty where there is no gate. Takes its time like toleranceGate().
[[nodiscard]] std::vector<GateIntervals> gateIntervals(const TypeModels& models,
                                                       const VerdictOptions& options = {});

/// Leave one out, in spaceOf(squeezes): how many of the squeezes get their own type back when the models are
/// fitted without them.
[[nodiscard]] int leaveOneOutCorrect(const std::vector<TypeSqueeze>& squeezes,
                                     const VerdictOptions& options = {});

} // namespace gripscope
