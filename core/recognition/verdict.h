// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/recognition/type_model.h"

#include <QMap>
#include <QString>
#include <QStringList>

#include <optional>

namespace gripscope {

/// Type: one of the enrolled types. Unknown: outside the gate of every type. Inconclusive: two types too close for
/// this squeeze, or no gate yet. Invalid: the measurement was not good enough to judge the part.
enum class VerdictKind { Type, Unknown, Inconclusive, Invalid };
[[nodiscard]] QString toString(VerdictKind kind);
[[nodiscard]] std::optional<VerdictKind> verdictKindFromString(const QString& text);

struct VerdictOptions {
    double falseReject = 0.01;  ///< share of squeezes of known parts that the gate may call unknown
    double wrongType = 0.001;   ///< a type is only named when its posterior is at least 1 - wrongType
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
    QStringList reasons;             ///< sentences a technician understands
};

/// The verdict on m, b, k alone. Posterior: predictive Student t densities of the types (v - 2 degrees of freedom,
/// spread (1 + 1/n) S), equal priors.
[[nodiscard]] Verdict judge(const TypeModels& models, const MassDampingStiffness& parameters,
                            const VerdictOptions& options = {});
/// The verdict on a squeeze: Invalid when the measurement is, else judge() on the recommended estimate.
/// `siScale`: factor that takes the estimate to the units of the models.
[[nodiscard]] Verdict judge(const TypeModels& models, const Identification& identification, double siScale,
                            const VerdictOptions& options = {});

/// Leave one out: how many of the squeezes get their own type back when the models are fitted without them.
[[nodiscard]] int leaveOneOutCorrect(const std::vector<TypeSqueeze>& squeezes, const VerdictOptions& options = {});

} // namespace gripscope
