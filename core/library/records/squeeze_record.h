// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/model/estimate.h"
#include "core/library/records/type_record.h"
#include "core/recognition/types/type_model.h"
#include "core/signal/recording/recording.h"

#include <QDateTime>
#include <QJsonObject>
#include <QString>

#include <optional>
#include <vector>

namespace gripscope {

struct NewGrasp {
    QString typeId;                     ///< of an enrolment; empty for an inspection
    std::optional<Recording> recording; ///< absent for a row of an imported table
    std::vector<Estimate> estimates;    ///< at least one, the recommended first
    QString forceUnit, positionUnit;
    QString source; ///< file or device it came from
    QString operatorName;
    QJsonObject identification;  ///< the whole identify document, for audit; may be empty
    QString part = {};           ///< which part of the type it was, as the operator calls it; may be empty
    QDateTime recorded = {};     ///< now where it is not valid
    QString draftSqueezeId = {}; ///< under which its recording may be in the library already; may be empty
    /// By how much the station's clock was ahead of UTC then; that of now where `recorded` is not valid.
    std::optional<qint64> utcOffset_s = {};
    QString program = {}; ///< the version that identified and judged it; empty: the one that stores it
    /// What it determines besides m, b and k, or in their place, as determinedQuantities() says.
    std::optional<DeterminedQuantities> determined = {};
};

/// A type with its squeezes, for a look at the program; `squeezes` need no typeId.
struct ExampleType {
    QString name;
    Recipe recipe;
    QString forceUnit, positionUnit;
    std::vector<NewGrasp> squeezes;
};

struct GraspRecord {
    QString id, typeId, typeName, source, operatorName;
    QDateTime recorded;
    bool hasRecording = false;
    bool accepted = true; ///< false once the squeeze was dropped from its type
    Estimator estimator = Estimator::OutputError;
    std::optional<MassDampingStiffness> parameters;
    std::optional<Eigen::Matrix3d> covariance;
    std::optional<double> simulationFitPercent;
    QString forceUnit, positionUnit;
    QString firstTypeId; ///< the type it was enrolled in; typeId is where it belongs now
    QString part;        ///< among the squeezes enrolled in that type; empty: not told
    std::optional<DeterminedQuantities> determined = {}; ///< as in NewGrasp
};

} // namespace gripscope
