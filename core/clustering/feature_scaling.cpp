// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/feature_scaling.h"

#include "core/base/words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A power of two that brings the largest of these numbers near 1, so that squares neither vanish nor
/// overflow; no digit changes by it.
double powerOfTwoFor(const Eigen::ArrayXd& numbers)
{
    const double largest = numbers.abs().maxCoeff();
    return largest > 0 ? std::ldexp(1.0, std::min(-std::ilogb(largest), 1000)) : 1;
}

/// Population deviation of a column; 1 when all its values are the same, so that it stays as it is.
double columnScale(const Eigen::ArrayXd& column, double mean)
{
    if (column.maxCoeff() == column.minCoeff())
        return 1;
    const Eigen::ArrayXd away = column - mean;
    const double unit = powerOfTwoFor(away);
    return std::sqrt((away * unit).square().mean()) / unit;
}

tl::unexpected<Error> badValue(Eigen::Index row, Eigen::Index column, double found, const Finding& expected)
{
    return failure(ErrorCode::BadInput,
                   {Words::say("Row %1, feature %2").arg(row + 1).arg(column + 1),
                    Words::say("found %1").arg(found), Words::say("expected %1").arg(expected)});
}

} // namespace

QString toString(FeatureScaling scaling)
{
    switch (scaling) {
    case FeatureScaling::None:
        return u"none"_s;
    case FeatureScaling::ZScore:
        return u"zscore"_s;
    case FeatureScaling::Log:
        return u"log"_s;
    case FeatureScaling::ZLog:
        return u"zlog"_s;
    }
    return {};
}

Eigen::MatrixXd FeatureTransform::apply(const Eigen::MatrixXd& features) const
{
    Eigen::MatrixXd scaled = logarithm ? Eigen::MatrixXd(features.array().log()) : features;
    scaled.rowwise() -= shift;
    return scaled.array().rowwise() / scale.array();
}

Eigen::MatrixXd FeatureTransform::undo(const Eigen::MatrixXd& scaled) const
{
    Eigen::MatrixXd features = scaled.array().rowwise() * scale.array();
    features.rowwise() += shift;
    return logarithm ? Eigen::MatrixXd(features.array().exp()) : features;
}

Expected<FeatureTransform> featureTransform(const Eigen::MatrixXd& features, FeatureScaling scaling)
{
    const bool logarithm = scaling == FeatureScaling::Log || scaling == FeatureScaling::ZLog;
    for (Eigen::Index i = 0; i < features.rows(); ++i)
        for (Eigen::Index j = 0; j < features.cols(); ++j) {
            if (!std::isfinite(features(i, j)))
                return badValue(i, j, features(i, j), Words::say("a finite number"));
            if (logarithm && features(i, j) <= 0)
                return badValue(i, j, features(i, j),
                                Words::say("a number above 0, since its logarithm is asked for"));
        }
    FeatureTransform transform;
    transform.logarithm = logarithm;
    transform.shift = Eigen::RowVectorXd::Zero(features.cols());
    transform.scale = Eigen::RowVectorXd::Ones(features.cols());
    if (features.rows() == 0 || scaling == FeatureScaling::None || scaling == FeatureScaling::Log)
        return transform;
    const Eigen::MatrixXd x = logarithm ? Eigen::MatrixXd(features.array().log()) : features;
    for (Eigen::Index j = 0; j < x.cols(); ++j) {
        const double unit = powerOfTwoFor(x.col(j).array());
        transform.shift(j) = (x.col(j) * unit).mean() / unit;
        transform.scale(j) = columnScale(x.col(j).array(), transform.shift(j));
        if (!std::isfinite(transform.shift(j)) || !std::isfinite(transform.scale(j)) ||
            transform.scale(j) <= 0)
            return failure(ErrorCode::BadInput,
                           {Words::say("Feature %1").arg(j + 1),
                            Words::say("found numbers too large or too small"),
                            Words::say("expected numbers whose squares can be computed")});
    }
    return transform;
}

} // namespace gripscope
