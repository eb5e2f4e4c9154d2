// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/type_shift.h"

#include "core/base/words.h"
#include "core/recognition/types/dimensions.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/types/squeeze_values.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

Finding percentShift(double log, double deviation)
{
    return Finding(log < 0 ? QString() : u"+"_s) + Finding::number(100 * std::expm1(log), 'f', 1) + u" ± "_s +
           Finding::number(100 * deviation * std::exp(log), 'f', 1) + u" %"_s;
}

Eigen::Matrix3d designOf(const TypeShift& shift, ShiftKind kind, const Eigen::Vector3d& centre)
{
    if (kind == ShiftKind::Factor)
        return Eigen::Matrix3d::Identity();
    return centre.cwiseQuotient(shift.enrolled.vector()).asDiagonal();
}

} // namespace

std::optional<TypeShift> typeShift(const TypeModels& models, const TypeModel& type,
                                   const std::vector<TypeSqueeze>& squeezes)
{
    if (models.degreesOfFreedom < 3)
        return {};
    TypeShift shift;
    shift.type = type.name;
    const Eigen::Vector3d mean = type.meanLog.array().exp();
    shift.enrolled = {mean(0), mean(1), mean(2)};
    Eigen::Matrix3d precision = Eigen::Matrix3d::Zero();
    Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
    double degrees = 1e300;
    for (const TypeSqueeze& squeeze : squeezes) {
        if (squeeze.type != type.name || !isUsable(squeeze.parameters))
            continue;
        const Eigen::Vector3d log = logOf(squeeze.parameters);
        const TypePrediction seen = predictType(models, type, log, noiseOf(squeeze), {});
        const Eigen::LLT<Eigen::Matrix3d> cholesky(seen.covariance);
        precision += cholesky.solve(Eigen::Matrix3d::Identity());
        weighted += cholesky.solve(log - type.meanLog);
        degrees = std::min(degrees, seen.degreesOfFreedom);
        shift.squeezes += 1;
    }
    if (shift.squeezes == 0 || !(degrees >= dimensions))
        return {};
    const Eigen::LLT<Eigen::Matrix3d> total(precision);
    shift.log = total.solve(weighted);
    shift.covariance = total.solve(Eigen::Matrix3d::Identity()) + type.meanCovarianceLog;
    shift.degreesOfFreedom = degrees;
    shift.tSquared = shift.log.dot(shift.covariance.llt().solve(shift.log));
    shift.pValue = chanceBeyond(shift.tSquared, degrees);
    return shift;
}

Finding changeInWords(const Eigen::Vector3d& log, const Eigen::Matrix3d& covariance)
{
    const Eigen::Vector3d deviation = covariance.diagonal().cwiseSqrt();
    return Words::say("mass %1, damping %2, stiffness %3")
        .arg(percentShift(log(0), deviation(0)), percentShift(log(1), deviation(1)),
             percentShift(log(2), deviation(2)));
}

std::optional<CommonShift> commonShift(const std::vector<TypeShift>& shifts, ShiftKind kind)
{
    if (shifts.empty())
        return {};
    Eigen::Vector3d logCentre = Eigen::Vector3d::Zero();
    double v = 1e300;
    for (const TypeShift& shift : shifts) {
        logCentre += shift.enrolled.vector().array().log().matrix() / double(shifts.size());
        v = std::min(v, shift.degreesOfFreedom);
    }
    const Eigen::Vector3d centre = logCentre.array().exp();
    Eigen::Matrix3d precision = Eigen::Matrix3d::Zero();
    Eigen::Vector3d weighted = Eigen::Vector3d::Zero();
    for (const TypeShift& shift : shifts) {
        const Eigen::Matrix3d design = designOf(shift, kind, centre);
        const Eigen::LLT<Eigen::Matrix3d> cholesky(shift.covariance);
        precision += design.transpose() * cholesky.solve(design);
        weighted += design.transpose() * cholesky.solve(shift.log);
    }
    const Eigen::LLT<Eigen::Matrix3d> total(precision);
    if (!precision.allFinite() || total.info() != Eigen::Success)
        return {};
    CommonShift common;
    common.value = total.solve(weighted);
    common.covariance = total.solve(Eigen::Matrix3d::Identity());
    common.pValue = chanceBeyond(common.value.dot(weighted), v);
    for (const TypeShift& shift : shifts) {
        const Eigen::Vector3d rest = shift.log - designOf(shift, kind, centre) * common.value;
        common.misfit += rest.dot(shift.covariance.llt().solve(rest));
    }
    if (shifts.size() > 1)
        common.agreement = chanceBeyond(common.misfit, v, dimensions * double(shifts.size() - 1));
    if (kind == ShiftKind::Addition) {
        common.value = centre.cwiseProduct(common.value);
        common.covariance = centre.asDiagonal() * common.covariance * centre.asDiagonal();
    }
    if (!common.value.allFinite() || !common.covariance.allFinite())
        return {};
    return common;
}

std::optional<LoneShift> loneShift(const std::vector<TypeShift>& shifts)
{
    if (shifts.empty())
        return {};
    LoneShift lone;
    double v = 1e300;
    for (std::size_t i = 0; i < shifts.size(); ++i) {
        lone.misfit += shifts[i].tSquared;
        v = std::min(v, shifts[i].degreesOfFreedom);
        if (shifts[i].tSquared > shifts[lone.type].tSquared)
            lone.type = i;
    }
    lone.misfit = std::max(0.0, lone.misfit - shifts[lone.type].tSquared);
    if (shifts.size() > 1)
        lone.agreement = chanceBeyond(lone.misfit, v, dimensions * double(shifts.size() - 1));
    return lone;
}

} // namespace gripscope
