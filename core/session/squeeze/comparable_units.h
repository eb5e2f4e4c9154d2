// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/library/library.h"
#include "core/recognition/types/models_by_space.h"
#include "core/recognition/verdict/verdict.h"

#include <QMap>

#include <memory>
#include <vector>

namespace gripscope {

/// What takes m, b, k from one pair of channel units to another: 1 for the same texts, the quotient of their
/// SI factors where both are known. UnitsDiffer where they cannot be compared ("1" against "N" and "m").
[[nodiscard]] Expected<double> parameterFactor(const QString& fromForce, const QString& fromPosition,
                                               const QString& toForce, const QString& toPosition);

/// The types of a library as models in which every squeeze has the same units. All types whose units are
/// known share one in SI; types as printed (units "1") share one of their own, since they cannot be compared
/// with the others.
class ComparableTypes {
public:
    ComparableTypes() = default;
    /// `squeezes`: as the library gives them, in SI where the units of their types are known.
    ComparableTypes(const std::vector<TypeRecord>& types, const std::vector<TypeSqueeze>& squeezes);

    struct Choice {
        std::shared_ptr<const ModelsBySpace> types;
        double factor = 1; ///< takes m, b, k to the units of the models
    };
    /// The models a squeeze in these units can be held against. Empty ones when there is nothing to be held
    /// against, UnitsDiffer when all that there is has units that cannot be compared.
    [[nodiscard]] Expected<Choice> modelsFor(const QString& forceUnit, const QString& positionUnit) const;
    /// In m, b and k: those in SI where there are any, else the first others.
    [[nodiscard]] const TypeModels& main() const { return *m_main->linear(); }

private:
    QMap<QString, std::shared_ptr<const ModelsBySpace>> m_models; ///< by system of units
    QMap<QString, QString> m_unitsOf;                             ///< of a system, in words
    std::shared_ptr<const ModelsBySpace> m_main = std::make_shared<ModelsBySpace>();
};

/// judge() by all that this recording and the types determine.
[[nodiscard]] Verdict judgeRecording(const ModelsBySpace& types, const Identification& identification,
                                     const Recording& recording, const VerdictOptions& rates,
                                     const std::optional<CommonShift>& transfer = {});

} // namespace gripscope
