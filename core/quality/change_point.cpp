// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/drift.h"
#include "core/recognition/types/predictive.h"
#include "core/recognition/types/squeeze_values.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gripscope {

namespace {

constexpr std::size_t fewestForAChange = 5;
constexpr double changeConfidence = 0.95;

/// A squeeze that counts: its residual and precision, and where among all it is.
struct ChangeStep {
    std::size_t type = 0; ///< among those that are looked at
    int place = 0;        ///< among all squeezes
    LogVector residual;
    LogMatrix precision;
};

class ChangeModel {
public:
    ChangeModel(const TypeModels& models, const std::vector<TypeSqueeze>& squeezes, ShiftKind kind,
                const QStringList& types)
        : m_p(models.space.dimensions())
    {
        for (const TypeModel& type : models.types)
            if (types.isEmpty() || types.contains(type.name))
                m_types.push_back(&type);
        for (std::size_t i = 0; i < squeezes.size(); ++i)
            add(models, squeezes[i], int(i));
        setDesigns(kind);
    }

    [[nodiscard]] const std::vector<ChangeStep>& steps() const { return m_steps; }

    /// Log evidence, and s, of a change in front of each of the steps.
    struct Evidence {
        double log = 0;
        LogVector shift;
        LogMatrix covariance;
    };
    [[nodiscard]] std::vector<Evidence> evidences() const
    {
        const Eigen::Index size = m_p * Eigen::Index(m_types.size() + 1), last = size - m_p;
        Eigen::MatrixXd precision = Eigen::MatrixXd::Zero(size, size);
        Eigen::VectorXd weighted = Eigen::VectorXd::Zero(size);
        for (std::size_t i = 0; i < m_types.size(); ++i) {
            const LogMatrix prior = m_types[i]->meanCovarianceLog.llt().solve(LogMatrix::Identity(m_p, m_p));
            precision.block(m_p * Eigen::Index(i), m_p * Eigen::Index(i), m_p, m_p) += prior;
        }
        for (const ChangeStep& step : m_steps) {
            const Eigen::Index at = m_p * Eigen::Index(step.type);
            precision.block(at, at, m_p, m_p) += step.precision;
            weighted.segment(at, m_p) += step.precision * step.residual;
        }
        std::vector<Evidence> found(m_steps.size());
        for (std::size_t t = m_steps.size(); t-- > 0;) { // from the last squeeze alone to all of them
            const ChangeStep& step = m_steps[t];
            const LogMatrix& design = m_designs[step.type];
            const LogMatrix across = step.precision * design;
            const Eigen::Index at = m_p * Eigen::Index(step.type);
            precision.block(at, last, m_p, m_p) += across;
            precision.block(last, at, m_p, m_p) += across.transpose();
            precision.block(last, last, m_p, m_p) += design.transpose() * across;
            weighted.segment(last, m_p) += across.transpose() * step.residual;
            const Eigen::LLT<Eigen::MatrixXd> cholesky(precision);
            const Eigen::VectorXd solution = cholesky.solve(weighted);
            const Eigen::MatrixXd factor = cholesky.matrixL();
            found[t].log = weighted.dot(solution) / 2 - factor.diagonal().array().log().sum();
            found[t].shift = solution.tail(m_p);
            Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(size, m_p);
            unit.bottomRows(m_p).setIdentity();
            found[t].covariance = cholesky.solve(unit).bottomRows(m_p);
        }
        return found;
    }

private:
    void add(const TypeModels& models, const TypeSqueeze& squeeze, int place)
    {
        const auto type =
            std::ranges::find(m_types, squeeze.type, [](const TypeModel* one) { return one->name; });
        const std::optional<LogVector> log = coordinatesOf(squeeze, models.space);
        if (type == m_types.end() || !log)
            return;
        const TypePrediction seen = predictType(models, **type, *log, noiseOf(squeeze, models.space), {});
        const Eigen::LLT<LogMatrix> cholesky(seen.covariance);
        if (cholesky.info() != Eigen::Success)
            return;
        m_steps.push_back({std::size_t(type - m_types.begin()), place, *log - (*type)->meanLog,
                           cholesky.solve(LogMatrix::Identity(m_p, m_p))});
    }
    void setDesigns(ShiftKind kind)
    {
        LogVector centre = LogVector::Zero(m_p);
        for (const TypeModel* const type : m_types)
            centre += type->meanLog / double(m_types.size());
        for (const TypeModel* const type : m_types) {
            const LogVector ratio = (centre - type->meanLog).array().exp();
            m_designs.push_back(kind == ShiftKind::Factor ? LogMatrix(LogMatrix::Identity(m_p, m_p))
                                                          : LogMatrix(ratio.asDiagonal()));
        }
    }

    Eigen::Index m_p;
    std::vector<const TypeModel*> m_types;
    std::vector<LogMatrix> m_designs;
    std::vector<ChangeStep> m_steps;
};

/// The smallest set of places that has the change with the stated probability: its first and last.
std::pair<std::size_t, std::size_t> credibleSet(const std::vector<double>& posterior)
{
    std::vector<std::size_t> order(posterior.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return posterior[a] > posterior[b]; });
    double sum = 0;
    std::size_t first = order.front(), last = order.front();
    for (const std::size_t place : order) {
        first = std::min(first, place);
        last = std::max(last, place);
        sum += posterior[place];
        if (sum >= changeConfidence)
            break;
    }
    return {first, last};
}

} // namespace

std::optional<ChangePoint> findChange(const TypeModels& models, const std::vector<TypeSqueeze>& squeezes,
                                      ShiftKind kind, const QStringList& types)
{
    if (models.degreesOfFreedom < models.space.dimensions() || models.types.empty())
        return {};
    const ChangeModel model(models, squeezes, kind, types);
    const std::vector<ChangeStep>& steps = model.steps();
    if (steps.size() < fewestForAChange)
        return {};
    const std::vector<ChangeModel::Evidence> evidences = model.evidences();
    const auto best = std::ranges::max_element(evidences, {}, &ChangeModel::Evidence::log);
    std::vector<double> probability;
    double sum = 0;
    for (const ChangeModel::Evidence& one : evidences) {
        probability.push_back(std::exp(one.log - best->log));
        sum += probability.back();
    }
    if (!std::isfinite(sum) || !best->shift.allFinite() || !best->covariance.allFinite())
        return {};
    for (double& one : probability)
        one /= sum;
    const auto at = std::size_t(best - evidences.begin());
    const auto [first, last] = credibleSet(probability);
    ChangePoint change;
    // In front of the first that counts: in front of all.
    const auto before = [&](std::size_t step) { return step == 0 ? 0 : steps[step].place; };
    change.before = before(at);
    change.earliest = before(first);
    change.latest = before(last);
    change.probability = probability[at];
    change.shift = best->shift;
    change.covariance = best->covariance;
    change.posterior.assign(squeezes.size(), 0);
    for (std::size_t i = 0; i < steps.size(); ++i)
        change.posterior[std::size_t(before(i))] += probability[i];
    return change;
}

} // namespace gripscope
