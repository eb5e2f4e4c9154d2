// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library.h"
#include "core/recognition/types/type_model.h"
#include "core/signal/recording/units.h"

#include <optional>
#include <vector>

namespace gripscope {

/// An enrolled squeeze in the space of m, b, k.
struct SpaceSqueeze {
    QString id;     ///< the squeeze's in the library, "A 3" in the paper's tables
    int type = 0;   ///< index into TypeSpace::types
    int number = 1; ///< within its type, from 1
    MassDampingStiffness parameters;
    bool hasRecording = false;
    std::optional<Eigen::Matrix3d> covariance = {}; ///< of m, b, k, from its identification
    /// Besides m, b and k, which are shown: what types are told apart by where all have it.
    std::optional<DeterminedQuantities> determined = {};
};
/// Where the squeeze lies with 95 % confidence; none where its error is not known.
[[nodiscard]] std::optional<Ellipsoid> ownEllipsoid(const SpaceSqueeze& squeeze);

/// All that the Types page shows of one set of types, worked out away from the screen's thread.
struct TypeSpace {
    bool paper = false;
    ParameterUnits units;
    QStringList types;       ///< sorted
    std::vector<int> signs;  ///< one a type: its colour and shape (TypeRecord::place)
    std::vector<int> counts; ///< squeezes a type
    std::vector<SpaceSqueeze> squeezes;
    TypeModels models;
    std::vector<std::optional<Ellipsoid>>
        ellipsoids; ///< 95 %, one a type; none while there are too few squeezes

    /// Types whose squeezes tell no m, b and k together, as those of a slow gripper: they have no place here.
    struct Elsewhere {
        QString name;
        int squeezes = 0;
    };
    std::vector<Elsewhere> elsewhere; ///< sorted

    /// The two types that are most easily taken for each other, by all that their squeezes determine.
    struct Pair {
        QString one, other;
        double distance = 0; ///< Mahalanobis, in standard deviations
    };
    std::optional<Pair> nearest;

    [[nodiscard]] const SpaceSqueeze* find(const QString& id) const;
};
/// Types A to D of the paper's appendix, units as printed.
[[nodiscard]] TypeSpace paperTypeSpace();
/// The accepted squeezes of a library, in SI where their units allow it. On the library's thread.
[[nodiscard]] Expected<TypeSpace> libraryTypeSpace(Library& library);

} // namespace gripscope
