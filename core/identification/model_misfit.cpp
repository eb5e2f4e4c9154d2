// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model_misfit.h"

#include "core/identification/discretization.h"
#include "core/identification/residual_tests.h"
#include "core/identification/smooth_force.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <boost/math/distributions/fisher_f.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double roundingShare = 1e-9;
/// Candidates that are not linear in the force; they come first.
constexpr std::size_t bentTerms = 4;
/// What is left of a term's norm when the model's columns are taken out must be more than this, or the term
/// cannot be told from them.
constexpr double dependent = 1e-6;

struct Candidate {
    QString id, words;
    std::vector<double> effect;
};

/// What an extra force at the samples' times adds to the position.
std::vector<double> responseTo(const std::vector<double>& extra, const Estimate& e, double sampleTime_s)
{
    return simulate(*e.parameters, extra, {sampleTime_s, ForceHold::First, 0, 0, 0, 0});
}

/// The four shapes, each between -1 and 1, of the force that a term takes up at a position x and velocity v.
std::array<double, bentTerms> shapesAt(double x, double v)
{
    const double sign = v == 0 ? 0.0 : std::copysign(1.0, v);
    return {x * x * x, x * x, v * std::abs(v), sign};
}

std::vector<Candidate> candidates(const Estimate& e, const LinearizedRecord& record,
                                  const std::vector<double>& force, const OutputErrorOptions& options)
{
    const double x0 = e.nuisance.offset.value_or(0);
    double largestX = 0;
    double largestV = 0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        largestX = std::max(largestX, std::abs(e.simulated[i] - x0));
        largestV = std::max(largestV, std::abs(record.velocity[i]));
    }
    const double size = std::max(std::abs(*std::max_element(force.begin(), force.end())),
                                 std::abs(*std::min_element(force.begin(), force.end())));
    std::vector<Candidate> out{
        {u"cubic_spring"_s, u"a spring that stiffens or softens with travel"_s, {}},
        {u"quadratic_spring"_s, u"a spring that differs between both directions"_s, {}},
        {u"quadratic_damping"_s, u"damping that grows with speed"_s, {}},
        {u"dry_friction"_s, u"dry friction"_s, {}}};
    std::vector<double> extra(force.size());
    for (std::size_t which = 0; which < out.size(); ++which) {
        for (std::size_t i = 0; i < force.size(); ++i) {
            const double x = largestX > 0 ? (e.simulated[i] - x0) / largestX : 0;
            const double v = largestV > 0 ? record.velocity[i] / largestV : 0;
            extra[i] = -size * shapesAt(x, v)[which];
        }
        out[which].effect = responseTo(extra, e, options.sampleTime_s);
    }
    if (options.hold == ForceHold::First) {
        std::vector<double> bend = straightAsSpline(force);
        for (std::size_t i = 0; i < bend.size(); ++i)
            bend[i] -= force[i];
        out.push_back(
            {u"smooth_force"_s, u"a force that is smooth between the samples, not a straight line"_s,
             simulate(*e.parameters, bend, {options.sampleTime_s, options.hold, options.lag_s, 0, 0, 0})});
    }
    return out;
}

std::vector<std::vector<double>> laggedForces(const std::vector<double>& force)
{
    std::vector<std::vector<double>> out;
    for (const std::size_t lag : inputLags) {
        std::vector<double> column(force.size());
        for (std::size_t i = 0; i < force.size(); ++i)
            column[i] = force[i > lag ? i - lag : 0];
        out.push_back(std::move(column));
    }
    return out;
}

/// The triangle of all columns as a small regression problem of its own.
class SmallRegression {
public:
    SmallRegression(const EffectTriangle& data, Eigen::Index nuisances, Eigen::Index known)
        : m_triangle(data.triangle), m_rows(data.rows), m_nuisances(nuisances), m_known(known)
    {
        for (Eigen::Index i = 0; i < m_triangle.cols(); ++i) {
            const double norm = m_triangle.col(i).norm();
            m_norms.push_back(norm > 0 && std::isfinite(norm) ? norm : 1);
        }
    }
    /// Residual sum of squares with the model's columns, `extra` (counted from the first effect) and the last
    /// `known` effects.
    struct Answer {
        double rest = 0;
        double degreesOfFreedom = 0;
        double rank = 0;
        Eigen::VectorXd solution; ///< of nuisances, ln m, ln b, ln k, extra, known
    };
    [[nodiscard]] Answer with(const std::vector<Eigen::Index>& extra) const
    {
        const Eigen::Index model = m_nuisances + 3;
        const Eigen::Index own = model + static_cast<Eigen::Index>(extra.size());
        Eigen::MatrixXd columns(m_triangle.rows(), own + m_known);
        Eigen::VectorXd scale(columns.cols());
        for (Eigen::Index i = 0; i < columns.cols(); ++i) {
            Eigen::Index at = i;
            if (i >= own)
                at = m_triangle.cols() - 1 - m_known + i - own;
            else if (i >= model)
                at = model + extra[static_cast<std::size_t>(i - model)];
            scale(i) = 1 / m_norms[static_cast<std::size_t>(at)];
            columns.col(i) = m_triangle.col(at) * scale(i);
        }
        Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
        qr.setThreshold(dependent);
        const Eigen::VectorXd right = m_triangle.col(m_triangle.cols() - 1);
        Answer answer;
        answer.rank = static_cast<double>(qr.rank());
        const Eigen::VectorXd rotated = qr.householderQ().adjoint() * right;
        answer.rest = rotated.tail(rotated.size() - qr.rank()).squaredNorm();
        answer.degreesOfFreedom = m_rows - answer.rank;
        answer.solution = scale.asDiagonal() * qr.solve(right);
        return answer;
    }
    /// d (ln m, ln b, ln k) by one unit of the column `at`, and s^2 (S'S)^-1 for s = 1.
    [[nodiscard]] Eigen::Vector3d shiftBy(Eigen::Index at) const
    {
        return own().colPivHouseholderQr().solve(m_triangle.block<3, 1>(m_nuisances, m_nuisances + 3 + at));
    }
    [[nodiscard]] Eigen::Matrix3d unitCovariance() const
    {
        const Eigen::Matrix3d inverse = own().inverse();
        return inverse * inverse.transpose();
    }

private:
    [[nodiscard]] Eigen::Matrix3d own() const { return m_triangle.block<3, 3>(m_nuisances, m_nuisances); }
    const Eigen::MatrixXd& m_triangle;
    double m_rows;
    Eigen::Index m_nuisances, m_known;
    std::vector<double> m_norms;
};

struct FTest {
    double ratio = 0, p = 1, columns = 0;
};
FTest fTest(const SmallRegression::Answer& without, const SmallRegression::Answer& with)
{
    FTest test;
    test.columns = with.rank - without.rank;
    if (test.columns < 1 || with.degreesOfFreedom < 1 || !(with.rest > 0))
        return test;
    test.ratio =
        (std::max(without.rest - with.rest, 0.0) / test.columns) / (with.rest / with.degreesOfFreedom);
    if (!std::isfinite(test.ratio))
        return test;
    const boost::math::fisher_f distribution(test.columns, with.degreesOfFreedom);
    test.p = boost::math::cdf(boost::math::complement(distribution, test.ratio));
    return test;
}

/// Power of the position about its mean, in the units of the record's columns.
double signalPower(const Estimate& e, const LinearizedRecord& record)
{
    double mean = 0;
    for (const std::size_t row : record.rows)
        mean += e.simulated[row] / record.positionScale / static_cast<double>(record.rows.size());
    double power = 0;
    for (const std::size_t row : record.rows) {
        const double y = e.simulated[row] / record.positionScale - mean;
        power += y * y;
    }
    return power;
}

/// Terms one after the other, the best first, while they are significant. The first `bent` terms are not
/// linear in the force and must each explain `leastPower`: what is quadratic in a large misfit looks like
/// many small terms.
std::vector<Eigen::Index> chooseTerms(const SmallRegression& regression, Eigen::Index count,
                                      Eigen::Index bent, double leastPower)
{
    std::vector<Eigen::Index> chosen;
    const double level = misfitLevel / 2 / static_cast<double>(count);
    while (static_cast<Eigen::Index>(chosen.size()) < count) {
        const SmallRegression::Answer before = regression.with(chosen);
        std::optional<Eigen::Index> best;
        double bestRest = before.rest;
        for (Eigen::Index i = 0; i < count; ++i) {
            if (std::find(chosen.begin(), chosen.end(), i) != chosen.end())
                continue;
            std::vector<Eigen::Index> more = chosen;
            more.push_back(i);
            const SmallRegression::Answer after = regression.with(more);
            const bool enough = i >= bent || before.rest - after.rest >= leastPower;
            if (enough && after.rest < bestRest && fTest(before, after).p < level) {
                best = i;
                bestRest = after.rest;
            }
        }
        if (!best)
            break;
        chosen.push_back(*best);
    }
    return chosen;
}

bool isRounding(const Estimate& e, const LinearizedRecord& record)
{
    double error = 0;
    double size = 0;
    for (const std::size_t row : record.rows) {
        error = std::max(error, std::abs(e.residual[row]));
        size = std::max(size, std::abs(e.simulated[row]));
    }
    return !(error > roundingShare * size);
}

} // namespace

ModelMisfit modelMisfit(const Estimate& estimate, const LinearizedRecord& record,
                        const std::vector<double>& force, const OutputErrorOptions& options,
                        const std::vector<std::vector<double>>& known)
{
    ModelMisfit out;
    if (!record.usable() || estimate.residual.size() != force.size() ||
        estimate.simulated.size() != force.size() || isRounding(estimate, record))
        return out;
    const std::vector<Candidate> terms = candidates(estimate, record, force, options);
    std::vector<std::vector<double>> effects;
    for (const Candidate& term : terms)
        effects.push_back(term.effect);
    for (std::vector<double>& lagged : laggedForces(force))
        effects.push_back(std::move(lagged));
    effects.insert(effects.end(), known.begin(), known.end());
    const std::vector<double> noise = estimate.noise ? estimate.noise->coefficients : std::vector<double>();
    const EffectTriangle data = effectTriangle(record, effects, estimate.residual, noise);
    if (!data.triangle.allFinite())
        return out;

    const Eigen::Index nuisances = record.nuisances.cols();
    const SmallRegression regression(data, nuisances, static_cast<Eigen::Index>(known.size()));
    const auto count = static_cast<Eigen::Index>(terms.size());
    std::vector<Eigen::Index> everything;
    for (Eigen::Index i = 0; i < count + static_cast<Eigen::Index>(inputLags.size()); ++i)
        everything.push_back(i);
    const double misfit = std::max(regression.with({}).rest - regression.with(everything).rest, 0.0);
    // The error of linearising in a misfit of share r is of share r^2 of the position; twice that counts.
    const double leastPower = 4 * misfit * misfit / signalPower(estimate, record);
    std::vector<Eigen::Index> columns =
        chooseTerms(regression, count, static_cast<Eigen::Index>(bentTerms), leastPower);
    const SmallRegression::Answer with = regression.with(columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Candidate& term = terms[static_cast<std::size_t>(columns[i])];
        const double size = with.solution(nuisances + 3 + static_cast<Eigen::Index>(i));
        const Eigen::Vector3d shift = size * regression.shiftBy(columns[i]);
        if (shift.allFinite())
            out.terms.push_back({term.id, term.words, shift});
    }
    for (std::size_t i = 0; i < inputLags.size(); ++i)
        columns.push_back(count + static_cast<Eigen::Index>(i));
    const SmallRegression::Answer all = regression.with(columns);
    const FTest test = fTest(with, all);
    if (test.columns < 1)
        return out;
    out.remainderP = test.p;
    const Eigen::Matrix3d covariance =
        (test.ratio - 1) * all.rest / all.degreesOfFreedom * regression.unitCovariance();
    if (test.p < misfitLevel / 2 && test.ratio > 1 && covariance.allFinite()) {
        out.remainder = covariance;
        out.remainderDegreesOfFreedom = test.columns;
    }
    return out;
}

} // namespace gripscope
