// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/types/type_shift.h"

#include "core/base/words.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/types/quantity_name.h"
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

LogMatrix designOf(const TypeShift& shift, ShiftKind kind, const LogVector& logCentre)
{
    if (kind == ShiftKind::Factor)
        return LogMatrix::Identity(logCentre.size(), logCentre.size());
    const LogVector ratio = (logCentre - shift.enrolledLog).array().exp();
    return ratio.asDiagonal();
}

} // namespace

std::optional<TypeShift> typeShift(const TypeModels& models, const TypeModel& type,
                                   const std::vector<TypeSqueeze>& squeezes)
{
    const int p = models.space.dimensions();
    if (models.degreesOfFreedom < p)
        return {};
    TypeShift shift;
    shift.type = type.name;
    shift.space = models.space;
    shift.enrolledLog = type.meanLog;
    LogMatrix precision = LogMatrix::Zero(p, p);
    LogVector weighted = LogVector::Zero(p);
    double degrees = 1e300;
    for (const TypeSqueeze& squeeze : squeezes) {
        const std::optional<LogVector> log = coordinatesOf(squeeze, models.space);
        if (squeeze.type != type.name || !log)
            continue;
        const TypePrediction seen = predictType(models, type, *log, noiseOf(squeeze, models.space), {});
        const Eigen::LLT<LogMatrix> cholesky(seen.covariance);
        precision += cholesky.solve(LogMatrix::Identity(p, p));
        weighted += cholesky.solve(*log - type.meanLog);
        degrees = std::min(degrees, seen.degreesOfFreedom);
        shift.squeezes += 1;
    }
    if (shift.squeezes == 0 || !(degrees >= p))
        return {};
    const Eigen::LLT<LogMatrix> total(precision);
    shift.log = total.solve(weighted);
    shift.covariance = total.solve(LogMatrix::Identity(p, p)) + type.meanCovarianceLog;
    shift.degreesOfFreedom = degrees;
    shift.tSquared = shift.log.dot(shift.covariance.llt().solve(shift.log));
    shift.pValue = chanceBeyond(shift.tSquared, degrees, p);
    return shift;
}

Finding changeInWords(const LogVector& log, const LogMatrix& covariance, const QuantitySpace& space)
{
    const LogVector deviation = covariance.diagonal().cwiseSqrt();
    if (space != QuantitySpace{}) {
        Findings each;
        for (int i = 0; i < space.dimensions(); ++i)
            each.push_back(nameWithin(space.quantities[std::size_t(i)]) + u" "_s +
                           percentShift(log(i), deviation(i)));
        return Finding::joined(each, u", "_s);
    }
    return Words::say("mass %1, damping %2, stiffness %3")
        .arg(percentShift(log(0), deviation(0)), percentShift(log(1), deviation(1)),
             percentShift(log(2), deviation(2)));
}

std::optional<CommonShift> commonShift(const std::vector<TypeShift>& shifts, ShiftKind kind)
{
    if (shifts.empty())
        return {};
    const int p = shifts.front().space.dimensions();
    LogVector logCentre = LogVector::Zero(p);
    double v = 1e300;
    for (const TypeShift& shift : shifts) {
        logCentre += shift.enrolledLog / double(shifts.size());
        v = std::min(v, shift.degreesOfFreedom);
    }
    LogMatrix precision = LogMatrix::Zero(p, p);
    LogVector weighted = LogVector::Zero(p);
    for (const TypeShift& shift : shifts) {
        const LogMatrix design = designOf(shift, kind, logCentre);
        const Eigen::LLT<LogMatrix> cholesky(shift.covariance);
        precision += design.transpose() * cholesky.solve(design);
        weighted += design.transpose() * cholesky.solve(shift.log);
    }
    const Eigen::LLT<LogMatrix> total(precision);
    if (!precision.allFinite() || total.info() != Eigen::Success)
        return {};
    CommonShift common;
    common.space = shifts.front().space;
    common.degreesOfFreedom = v;
    common.value = total.solve(weighted);
    common.covariance = total.solve(LogMatrix::Identity(p, p));
    common.pValue = chanceBeyond(common.value.dot(weighted), v, p);
    for (const TypeShift& shift : shifts) {
        const LogVector rest = shift.log - designOf(shift, kind, logCentre) * common.value;
        common.misfit += rest.dot(shift.covariance.llt().solve(rest));
    }
    if (shifts.size() > 1)
        common.agreement = chanceBeyond(common.misfit, v, p, p * double(shifts.size() - 1));
    if (kind == ShiftKind::Addition) {
        const LogVector centre = logCentre.array().exp();
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
    const int p = shifts.front().space.dimensions();
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
        lone.agreement = chanceBeyond(lone.misfit, v, p, p * double(shifts.size() - 1));
    return lone;
}

} // namespace gripscope
