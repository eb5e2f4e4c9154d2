// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/transfer.h"

#include "core/base/words.h"
#include "core/recognition/types/gates.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/types/squeeze_values.h"
#include "core/recognition/verdict/verdict.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double clearTransferGain = 2; ///< e^2 times as likely
constexpr double chanceOfMisfit = 0.01; ///< of all types together

std::vector<TypeShift> shiftsOf(const TypeModels& models, const std::vector<TypeSqueeze>& squeezes)
{
    std::vector<TypeShift> shifts;
    for (const TypeModel& type : models.types)
        if (const std::optional<TypeShift> shift = typeShift(models, type, squeezes))
            shifts.push_back(*shift);
    return shifts;
}

double logDensity(const TypeModels& models, const TypeModel& type, const TypeSqueeze& squeeze)
{
    const std::optional<LogVector> log = coordinatesOf(squeeze, models.space);
    return log ? predictType(models, type, *log, noiseOf(squeeze, models.space), {}).logDensity : 0;
}

bool isNamed(const TypeModels& models, const TypeSqueeze& squeeze)
{
    VerdictOptions options;
    options.siUnits = false; // strangers are no part of this
    const Verdict verdict = judge(models, squeeze, options);
    return verdict.kind == VerdictKind::Type && verdict.type == squeeze.type;
}

/// Judges `squeeze` as it is and adjusted by what `others` say.
void judgeBoth(const TypeModels& models, const TypeSqueeze& squeeze, const std::vector<TypeSqueeze>& others,
               TransferTrial& trial)
{
    const TypeModel* type = models.find(squeeze.type);
    const std::optional<CommonShift> error = commonShift(shiftsOf(models, others), ShiftKind::Factor);
    if (type == nullptr || !error || !coordinatesOf(squeeze, models.space))
        return;
    const TypeSqueeze moved = adjusted(squeeze, *error);
    trial.squeezes += 1;
    trial.namedBefore += isNamed(models, squeeze);
    trial.namedAfter += isNamed(models, moved);
    trial.logDensityGain += logDensity(models, *type, moved) - logDensity(models, *type, squeeze);
}

/// Every squeeze judged without those that `leavesOut` it names.
template <typename LeavesOut>
TransferTrial leaveOut(const TypeModels& models, const std::vector<TypeSqueeze>& squeezes,
                       const LeavesOut& leavesOut)
{
    TransferTrial trial;
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        std::vector<TypeSqueeze> others;
        for (std::size_t j = 0; j < squeezes.size(); ++j)
            if (!leavesOut(i, j))
                others.push_back(squeezes[j]);
        judgeBoth(models, squeezes[i], others, trial);
    }
    return trial;
}

Findings inWords(const TransferReport& report)
{
    if (!report.error)
        return {Words::say(
            "No squeeze of an enrolled type: nothing can be said of the transfer. Squeeze parts of two "
            "or more enrolled types on this gripper.")};
    Findings words{
        Words::say("What this gripper finds differs from that of the enrolment: %1.")
            .arg(changeInWords(report.error->value, report.error->covariance, report.error->space))};
    if (report.error->agreement < 0.01)
        words.push_back(Words::say(
            "The types differ in it by more than chance: one adjustment does not serve them all."));
    const TransferTrial& shown = report.unseenTypes.value_or(report.trial);
    words.push_back(Words::say("Of %1 squeezes left out, %2 are named right as measured and %3 adjusted.")
                        .arg(QString::number(shown.squeezes), QString::number(shown.namedBefore),
                             QString::number(shown.namedAfter)));
    words.push_back((report.adjust
                         ? Words::say("The adjustment helps: use it.")
                         : Words::say("The adjustment does not help: the types serve as they are, or must be "
                                      "enrolled here.")));
    if (!report.unseenTypes)
        words.push_back(Words::say("Only one type was squeezed here; how others fare is not known."));
    return words;
}

/// In the space of the error alone: what it says nothing of is not known on the first gripper.
TypeSqueeze adjustedLogarithms(const TypeSqueeze& squeeze, const CommonShift& error)
{
    const std::optional<LogVector> log = coordinatesOf(squeeze, error.space);
    if (!log)
        return squeeze;
    TypeSqueeze result = squeeze;
    result.parameters = {};
    result.covariance = {};
    result.determined = DeterminedQuantities{error.space, *log - error.value, {}};
    if (const std::optional<LogMatrix> noise = noiseOf(squeeze, error.space))
        result.determined->covariance = *noise + error.covariance;
    return result;
}

/// What would be known of a type's shift with so many more squeezes like those there are.
LogMatrix covarianceWith(const TypeShift& shift, const LogMatrix& ofEnrolment, int more)
{
    const LogMatrix ofSqueezes = shift.covariance - ofEnrolment;
    return ofSqueezes * (double(shift.squeezes) / double(shift.squeezes + more)) + ofEnrolment;
}

} // namespace

TypeSqueeze adjusted(const TypeSqueeze& squeeze, const CommonShift& error)
{
    if (squeeze.determined || error.space != QuantitySpace{})
        return adjustedLogarithms(squeeze, error);
    if (!isUsable(squeeze.parameters))
        return squeeze;
    TypeSqueeze result = squeeze;
    const Eigen::Vector3d factor = (-error.value).array().exp();
    const Eigen::Vector3d p = squeeze.parameters.vector().cwiseProduct(factor);
    result.parameters = {p(0), p(1), p(2)};
    if (!isUsable(result.parameters))
        return squeeze;
    if (squeeze.covariance) {
        const Eigen::Matrix3d own = factor.asDiagonal() * *squeeze.covariance * factor.asDiagonal();
        const Eigen::Matrix3d added = p.asDiagonal() * error.covariance * p.asDiagonal();
        result.covariance = own + added;
    }
    return result;
}

TransferReport measureTransfer(const TypeModels& models, const std::vector<TypeSqueeze>& squeezes)
{
    TransferReport report;
    report.types = shiftsOf(models, squeezes);
    report.error = commonShift(report.types, ShiftKind::Factor);
    if (report.error) {
        report.trial = leaveOut(models, squeezes, [](std::size_t i, std::size_t j) { return i == j; });
        if (report.types.size() > 1)
            report.unseenTypes = leaveOut(models, squeezes, [&](std::size_t i, std::size_t j) {
                return squeezes[i].type == squeezes[j].type;
            });
        const TransferTrial& deciding = report.unseenTypes.value_or(report.trial);
        report.adjust = deciding.squeezes > 0 && deciding.logDensityGain > clearTransferGain &&
                        deciding.namedAfter >= deciding.namedBefore;
    }
    report.words = inWords(report);
    return report;
}

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
