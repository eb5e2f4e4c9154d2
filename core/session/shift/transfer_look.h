// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/recognition/verdict/transfer.h"
#include "core/session/quality/kept_study.h"

#include <QMap>

namespace gripscope {

class Library;

/// A squeeze of a transfer, by the measurement it is.
struct TransferSqueeze {
    QString measurementId;
    TypeSqueeze squeeze; ///< as measured, its type the one that was asked for
};

/// How types serve here, by the squeezes so far.
struct TransferLook {
    TypeModels models;
    TransferReport report;
    std::vector<TransferResidual> residuals;
    int squeezes = 0;
    QStringList missing;                        ///< types of the plan without a squeeze so far
    LogVector wanted = Eigen::Vector3d::Zero(); ///< standard uncertainties that are enough, of the logarithms
    std::optional<int> more;                    ///< further squeezes of each type until then; nothing: never
    std::optional<Finding> doubt;               ///< about the newest squeeze
    Findings advice;                            ///< what to do next and why

    /// There is an adjustment that one may answer for: three squeezes or more of each type that was squeezed,
    /// and no type that it does not fit.
    [[nodiscard]] bool acceptable() const;
    [[nodiscard]] QStringList misfits() const; ///< types that it does not fit
};

/// Pure. `planned`: the types that are to be squeezed.
[[nodiscard]] TransferLook lookAtTransfer(const TypeModels& models,
                                          const std::vector<TransferSqueeze>& squeezes,
                                          const QStringList& planned);

/// The recording of a measurement. NotFound: none was kept.
[[nodiscard]] Expected<Recording> transferRecording(Library& library, const StudyMeasurementRecord& measured);

/// The squeeze as recognition takes it, identified anew with its covariance. Nothing where it determines
/// neither m, b and k nor anything else, or is not valid.
[[nodiscard]] std::optional<TypeSqueeze> transferSqueeze(const QString& type, const Recording& recording,
                                                         const IdentificationOptions& options);

} // namespace gripscope
