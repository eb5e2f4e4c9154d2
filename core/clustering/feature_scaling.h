// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <Eigen/Core>
#include <QString>

namespace gripscope {

/// none: as they are; zscore: (x - mean) / population deviation; log: natural logarithm; zlog: z-score of the
/// logs.
enum class FeatureScaling { None, ZScore, Log, ZLog };
[[nodiscard]] QString toString(FeatureScaling scaling);

/// scaled = (f(x) - shift) / scale column by column, f the identity or the logarithm.
struct FeatureTransform {
    bool logarithm = false;
    Eigen::RowVectorXd shift, scale;

    [[nodiscard]] Eigen::MatrixXd apply(const Eigen::MatrixXd& features) const;
    [[nodiscard]] Eigen::MatrixXd undo(const Eigen::MatrixXd& scaled) const;
};

/// The transform that `scaling` means for this table (rows: items, columns: features). BadInput when a
/// logarithm meets a value <= 0; a column without spread keeps scale 1.
[[nodiscard]] Expected<FeatureTransform> featureTransform(const Eigen::MatrixXd& features,
                                                          FeatureScaling scaling);

} // namespace gripscope
