// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/transfer_check.h"

#include "core/base/words.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/verdict/verdict.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace gripscope {

namespace {

constexpr double chanceOfMisfit = 0.01; ///< of all types together

/// What would be known of a type's shift with so many more squeezes like those there are.
LogMatrix covarianceWith(const TypeShift& shift, const LogMatrix& ofEnrolment, int more)
{
    const LogMatrix ofSqueezes = shift.covariance - ofEnrolment;
    return ofSqueezes * (double(shift.squeezes) / double(shift.squeezes + more)) + ofEnrolment;
}

} // namespace

std::vector<TransferResidual> transferResiduals(const TransferReport& report)
{
    std::vector<TransferResidual> residuals;
    if (report.types.size() < 2)
        return residuals;
    for (std::size_t i = 0; i < report.types.size(); ++i) {
        std::vector<TypeShift> others = report.types;
        others.erase(others.begin() + std::ptrdiff_t(i));
        const std::optional<CommonShift> common = commonShift(others, ShiftKind::Factor);
        if (!common)
            return {};
        const TypeShift& own = report.types[i];
        TransferResidual residual;
        residual.type = own.type;
        residual.log = own.log - common->value;
        residual.covariance = own.covariance + common->covariance;
        const double squared = residual.log.dot(residual.covariance.llt().solve(residual.log));
        const double degrees = std::min(own.degreesOfFreedom, common->degreesOfFreedom);
        residual.pValue = chanceBeyond(squared, degrees, own.space.dimensions());
        residual.fits = residual.pValue >= chanceOfMisfit / double(report.types.size());
        residuals.push_back(std::move(residual));
    }
    return residuals;
}

LogVector wantedUncertainty(const TypeModels& models)
{
    return models.covarianceLog.diagonal().cwiseSqrt() / 3;
}

std::optional<LogVector> uncertaintyWith(const TypeModels& models, const TransferReport& report, int more)
{
    if (!report.error)
        return {};
    const int p = report.error->space.dimensions();
    LogMatrix precision = LogMatrix::Zero(p, p);
    for (const TypeShift& shift : report.types) {
        const TypeModel* const type = models.find(shift.type);
        if (type == nullptr)
            return {};
        const LogMatrix covariance = covarianceWith(shift, type->meanCovarianceLog, more);
        precision += covariance.llt().solve(LogMatrix::Identity(p, p));
    }
    const Eigen::LLT<LogMatrix> total(precision);
    if (!precision.allFinite() || total.info() != Eigen::Success)
        return {};
    return LogVector(LogMatrix(total.solve(LogMatrix::Identity(p, p))).diagonal().cwiseSqrt());
}

std::optional<int> squeezesNeeded(const TypeModels& models, const TransferReport& report,
                                  const LogVector& wanted)
{
    for (int more = 0; more <= mostFurther; ++more) {
        const std::optional<LogVector> known = uncertaintyWith(models, report, more);
        if (!known || known->size() != wanted.size())
            return {};
        if ((known->array() <= wanted.array()).all())
            return more;
    }
    return {};
}

std::optional<Finding> transferDoubt(const TypeModels& models, const TypeSqueeze& squeeze,
                                     const std::vector<TypeSqueeze>& others)
{
    const std::optional<CommonShift> error = measureTransfer(models, others).error;
    if (!error)
        return {};
    VerdictOptions options;
    options.siUnits = false; // strangers are no part of this
    const Verdict verdict = judge(models, adjusted(squeeze, *error), options);
    if (verdict.kind == VerdictKind::Type && verdict.type != squeeze.type)
        return Words::say("By the other squeezes that was a part of %1, not of %2. Take it back if the wrong "
                          "part was in.")
            .arg(verdict.type, squeeze.type);
    if (verdict.kind == VerdictKind::Unknown)
        return Words::say("By the other squeezes that was no part of %1. Take it back if the wrong part was "
                          "in; if it was the right one, this type is not common to both grippers.")
            .arg(squeeze.type);
    return {};
}

} // namespace gripscope
