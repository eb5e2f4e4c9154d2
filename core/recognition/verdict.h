// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "core/identification/identification.h"
#include "core/recognition/type_model.h"

#include <QMap>
#include <QString>
#include <QStringList>

#include <optional>

namespace gripscope {

/// Type: one of the enrolled types. Unknown: outside the gate of every type. Inconclusive: two types too
/// close for this squeeze, or no gate yet. Invalid: the measurement was not good enough to judge the part.
enum class VerdictKind { Type, Unknown, Inconclusive, Invalid };
[[nodiscard]] QString toString(VerdictKind kind);
[[nodiscard]] std::optional<VerdictKind> verdictKindFromString(const QString& text);

struct VerdictOptions {
    double falseReject = 0.01; ///< share of squeezes of known parts that the gate may call unknown
    double wrongType = 0.001;  ///< a type is only named when its posterior is at least 1 - wrongType
    /// The models are in SI: reasons then name values with their units ("9.98 kN/m"). Off for numbers without
    /// units.
    bool siUnits = true;
    /// Both rates at least 1e-6 and at most 0.5.
    [[nodiscard]] std::optional<Error> validate() const;
};

struct Verdict {
    VerdictKind kind = VerdictKind::Invalid;
    QString type;                    ///< empty unless kind is Type
    QString nearest;                 ///< empty when no type is enrolled
    QMap<QString, double> posterior; ///< over the enrolled types, sums to 1 (equal priors)
    std::optional<double> distance;  ///< squared, to the nearest type
    std::optional<double> gate;      ///< squared, of the nearest type
    std::size_t samplesUsed = 0;
    QStringList reasons; ///< sentences a technician understands
};

/// The verdict on m, b, k alone. Posterior: the types' predictive densities of log(m, b, k), equal priors.
/// Each is a Student t with v - 2 degrees of freedom (1 while v < 3) about the type's mean with spread (1 +
/// 1/n) S v/(v - 2):
///     log p = -(3/2) log(1 + 1/n) - (v + 1)/2 log(1 + D^2 / (v (1 + 1/n))) + constant.
/// With v = 0 all are alike. Nearest: the type with the smallest D^2 / (1 + 1/n), so that a squeeze outside
/// its gate is outside every gate. (Murphy, Conjugate Bayesian analysis of the Gaussian distribution, 2007.)
[[nodiscard]] Verdict judge(const TypeModels& models, const MassDampingStiffness& parameters,
                            const VerdictOptions& options = {});
/// The verdict on a squeeze: Invalid when the measurement is, else judge() on the recommended estimate.
/// `siScale`: factor that takes the estimate to the units of the models, siFactor() of the recording's units
/// where the models are in SI.
[[nodiscard]] Verdict judge(const TypeModels& models, const Identification& identification, double siScale,
                            const VerdictOptions& options = {});

/// Leave one out: how many of the squeezes get their own type back when the models are fitted without them.
[[nodiscard]] int leaveOneOutCorrect(const std::vector<TypeSqueeze>& squeezes,
                                     const VerdictOptions& options = {});

} // namespace gripscope
