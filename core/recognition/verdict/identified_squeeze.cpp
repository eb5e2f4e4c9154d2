// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/verdict/identified_squeeze.h"

#include "core/math/normal_interval.h"
#include "core/recognition/types/squeeze_values.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

using P = MotionParameter;

constexpr double mostLogError = 0.5;
constexpr double mostLogErrorOfFriction = 1.0 / 3;

/// Which parameter each quantity is; a relaxing share is one over another.
struct QuantityParts {
    TypeQuantity quantity;
    P parameter;
    std::optional<P> over = {};
};
constexpr QuantityParts quantityParts[mostDimensions] = {
    {TypeQuantity::Mass, P::Mass},
    {TypeQuantity::Damping, P::Damping},
    {TypeQuantity::Stiffness, P::Stiffness},
    {TypeQuantity::RelaxingShare, P::Relaxing, P::Stiffness},
    {TypeQuantity::RelaxationTime, P::RelaxationTime},
    {TypeQuantity::Friction, P::Friction},
};

/// The logarithms of a motion's parameters and their covariance, in its order; NaN where a parameter has
/// none.
struct LogParameters {
    std::vector<P> parameters;
    Eigen::VectorXd logs;
    Eigen::MatrixXd covariance;

    [[nodiscard]] std::optional<Eigen::Index> placeOf(P parameter) const
    {
        const auto found = std::ranges::find(parameters, parameter);
        if (found == parameters.end() || !std::isfinite(logs[found - parameters.begin()]))
            return {};
        return found - parameters.begin();
    }
};

LogParameters logParameters(const MotionEstimate& motion, const Identification& identification,
                            const QString& forceUnit, const QString& positionUnit)
{
    LogParameters found{motion.terms.parameters(), {}, motion.covariance};
    const auto count = static_cast<Eigen::Index>(found.parameters.size());
    found.logs = Eigen::VectorXd::Constant(count, std::numeric_limits<double>::quiet_NaN());
    if (found.covariance.rows() != count || found.covariance.cols() != count)
        return {};
    Eigen::VectorXd toLogs = Eigen::VectorXd::Zero(count);
    for (const DeterminedParameter& told : determinedParameters(identification, forceUnit, positionUnit)) {
        const auto at = std::ranges::find(found.parameters, told.parameter) - found.parameters.begin();
        const bool isBound = told.isLowerBound || (told.interval && told.interval->onlyUpperBound);
        if (at == count || isBound || !(told.value > 0))
            continue;
        found.logs[at] = std::log(told.value);
        toLogs[at] = comparableUnit(told.parameter, forceUnit, positionUnit).factor / told.value;
        if (const auto linear = linearPlaceOf(told.parameter); linear && identification.baseline)
            found.covariance(at, at) += std::pow(identification.baseline->standardErrors[*linear], 2);
    }
    found.covariance = toLogs.asDiagonal() * found.covariance * toLogs.asDiagonal();
    return found;
}

} // namespace

MotionParameter parameterOf(TypeQuantity quantity)
{
    return std::ranges::find(quantityParts, quantity, &QuantityParts::quantity)->parameter;
}

std::optional<DeterminedQuantities> determinedQuantities(const Identification& identification,
                                                         const QString& forceUnit,
                                                         const QString& positionUnit)
{
    const Estimate* const recommended = identification.find(identification.recommended);
    if (recommended == nullptr || !recommended->hasAnswer())
        return {};
    const std::optional<MotionEstimate> motion = motionOf(*recommended);
    if (!motion || (!recommended->motion && !recommended->covariance))
        return {};
    const LogParameters known = logParameters(*motion, identification, forceUnit, positionUnit);
    const Eigen::Index count = known.logs.size();
    std::vector<TypeQuantity> quantities;
    Eigen::MatrixXd rows(mostDimensions, count); // each quantity's logarithm, as a sum of those
    for (const auto& [quantity, parameter, over] : quantityParts) {
        const std::optional<Eigen::Index> at = known.placeOf(parameter);
        const std::optional<Eigen::Index> under = over ? known.placeOf(*over) : std::nullopt;
        if (!at || (over && !under))
            continue;
        Eigen::VectorXd row = Eigen::VectorXd::Zero(count);
        row[*at] = 1;
        if (under)
            row[*under] -= 1;
        const double variance = row.dot(known.covariance * row);
        const double most = quantity == TypeQuantity::Friction ? mostLogErrorOfFriction : mostLogError;
        if (!(variance >= 0 && variance <= most * most))
            continue;
        rows.row(static_cast<Eigen::Index>(quantities.size())) = row;
        quantities.push_back(quantity);
    }
    const QuantitySpace space{std::move(quantities)};
    if (space.quantities.empty() || space == QuantitySpace{})
        return {};
    const auto used = rows.topRows(space.dimensions());
    // A parameter that has no logarithm is in none of the rows.
    const Eigen::VectorXd logs = known.logs.unaryExpr([](double x) { return std::isfinite(x) ? x : 0.0; });
    return DeterminedQuantities{space, LogVector(used * logs),
                                LogMatrix(used * known.covariance * used.transpose())};
}

std::vector<DeterminedParameter> determinedParameters(const DeterminedQuantities& determined,
                                                      const QString& forceUnit, const QString& positionUnit)
{
    const int dimensions = determined.space.dimensions();
    if (determined.log.size() != dimensions)
        return {};
    std::vector<DeterminedParameter> all;
    for (const auto& [quantity, parameter, over] : quantityParts) {
        const std::optional<int> place = determined.space.placeOf(quantity);
        const std::optional<int> under = determined.space.placeOf(TypeQuantity::Stiffness);
        if (!place || (over && !under))
            continue;
        LogVector row = LogVector::Zero(dimensions);
        row[*place] = 1;
        if (over) // k1 is its share of k
            row[*under] = 1;
        const double log = row.dot(determined.log);
        DeterminedParameter one{
            parameter, std::exp(log), {}, false, comparableUnit(parameter, forceUnit, positionUnit).unit};
        if (determined.covariance) {
            const double reach = normal95 * std::sqrt(std::max(0.0, row.dot(*determined.covariance * row)));
            one.interval = CoverageInterval{std::exp(log - reach), std::exp(log + reach), true};
        }
        all.push_back(std::move(one));
    }
    return all;
}

std::optional<TypeSqueeze> identifiedSqueeze(const QString& type, const Identification& identification,
                                             const QString& forceUnit, const QString& positionUnit)
{
    std::optional<TypeSqueeze> linear;
    if (const std::optional<CorrectedParameters> object = identification.object())
        linear = scaledSqueeze(type, *object, comparableUnit(P::Stiffness, forceUnit, positionUnit).factor);
    return foundSqueeze(type, std::move(linear),
                        determinedQuantities(identification, forceUnit, positionUnit));
}

} // namespace gripscope
