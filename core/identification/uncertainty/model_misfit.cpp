// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/identification/model/discretization.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/noise/noise_model.h"
#include "core/identification/noise/residual_tests.h"
#include "core/identification/uncertainty/budget_lines.h"
#include "core/identification/uncertainty/effect_regression.h"
#include "core/math/distributions.h"
#include "core/math/least_squares.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Regressions on chosen columns of an EffectTriangle, all from its few rows: the nuisances and the
/// sensitivities to ln m, ln b, ln k always, the last `known` effects always, the others as asked for.
class SmallRegression {
public:
    SmallRegression(const EffectTriangle& data, Eigen::Index nuisances, Eigen::Index known);

    struct Answer {
        double rest = 0; ///< residual sum of squares
        double degreesOfFreedom = 0;
        double rank = 0;
        Eigen::VectorXd solution; ///< of nuisances, ln m, ln b, ln k, extra, known
    };
    /// With the effects `extra`, counted from the first one.
    [[nodiscard]] Answer with(const std::vector<Eigen::Index>& extra) const;
    /// What leaving out one unit of an effect does to (ln m, ln b, ln k) of the model alone.
    [[nodiscard]] Eigen::Vector3d shiftBy(Eigen::Index effect) const;
    /// (S'S)^-1 with the nuisances projected out.
    [[nodiscard]] Eigen::Matrix3d unitCovariance() const;

private:
    [[nodiscard]] Eigen::Matrix3d own() const;
    const Eigen::MatrixXd& m_triangle;
    double m_rows;
    Eigen::Index m_nuisances, m_known;
    std::vector<double> m_norms;
};

/// The F test of two nested regressions.
struct FTest {
    double ratio = 0;   ///< F
    double p = 1;       ///< that the further columns explain nothing
    double columns = 0; ///< how many more, as far as they are independent
};

/// What is left of a column's norm when the columns before it are taken out must be more than this, or it
/// cannot be told from them.
constexpr double indistinguishable = 1e-6;

SmallRegression::SmallRegression(const EffectTriangle& data, Eigen::Index nuisances, Eigen::Index known)
    : m_triangle(data.triangle), m_rows(data.rows), m_nuisances(nuisances), m_known(known)
{
    for (Eigen::Index i = 0; i < m_triangle.cols(); ++i) {
        const double norm = m_triangle.col(i).norm();
        m_norms.push_back(norm > 0 && std::isfinite(norm) ? norm : 1);
    }
}

SmallRegression::Answer SmallRegression::with(const std::vector<Eigen::Index>& extra) const
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
    const PivotedSolution solved =
        solvePivoted(columns, m_triangle.col(m_triangle.cols() - 1), {.relative = indistinguishable});
    Answer answer;
    answer.rank = static_cast<double>(solved.rank);
    answer.rest = solved.rest(0);
    answer.degreesOfFreedom = m_rows - answer.rank;
    answer.solution = scale.cwiseProduct(solved.solution.col(0));
    return answer;
}

Eigen::Vector3d SmallRegression::shiftBy(Eigen::Index effect) const
{
    return solvePivoted(own(), m_triangle.block<3, 1>(m_nuisances, m_nuisances + 3 + effect)).solution;
}

Eigen::Matrix3d SmallRegression::unitCovariance() const
{
    const Eigen::Matrix3d inverse = own().inverse();
    return inverse * inverse.transpose();
}

Eigen::Matrix3d SmallRegression::own() const
{
    return m_triangle.block<3, 3>(m_nuisances, m_nuisances);
}

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
    test.p = fisherAbove(test.ratio, test.columns, with.degreesOfFreedom);
    return test;
}

/// Candidates that are not linear in the force; they come first.
constexpr std::size_t bentTerms = 4;

struct Candidate {
    QString id;
    Finding words;
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
        {u"cubic_spring"_s, Words::say("a spring that stiffens or softens with travel"), {}},
        {u"quadratic_spring"_s, Words::say("a spring that differs between both directions"), {}},
        {u"quadratic_damping"_s, Words::say("damping that grows with speed"), {}},
        {u"dry_friction"_s, Words::say("dry friction"), {}}};
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
            {u"smooth_force"_s, Words::say("a force that is smooth between the samples, not a straight line"),
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

/// Power of the residuals over that of the model's position about its mean.
double residualShare(const Estimate& e, const LinearizedRecord& record)
{
    double mean = 0;
    for (const std::size_t row : record.rows)
        mean += e.simulated[row] / record.positionScale / static_cast<double>(record.rows.size());
    double power = 0;
    double error = 0;
    for (const std::size_t row : record.rows) {
        const double y = e.simulated[row] / record.positionScale - mean;
        const double r = e.residual[row] / record.positionScale;
        power += y * y;
        error += r * r;
    }
    return power > 0 ? error / power : 0;
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

/// What a bent term must explain, see chooseTerms().
double leastPowerOfBentTerms(const SmallRegression& regression, Eigen::Index terms, double residualShare)
{
    std::vector<Eigen::Index> everything;
    for (Eigen::Index i = 0; i < terms + static_cast<Eigen::Index>(inputLags.size()); ++i)
        everything.push_back(i);
    const double whole = regression.with({}).rest;
    const double misfit = std::max(whole - regression.with(everything).rest, 0.0);
    // The error of linearising in a misfit of share r is of share r^2 of the position; twice that counts.
    return whole > 0 ? 4 * residualShare * misfit * misfit / whole : 0;
}

/// What past and present force explains beyond the chosen terms.
void addRemainder(const SmallRegression& regression, std::vector<Eigen::Index> columns, Eigen::Index terms,
                  ModelMisfit& out)
{
    const SmallRegression::Answer without = regression.with(columns);
    for (std::size_t i = 0; i < inputLags.size(); ++i)
        columns.push_back(terms + static_cast<Eigen::Index>(i));
    const SmallRegression::Answer all = regression.with(columns);
    const FTest test = fTest(without, all);
    if (test.columns < 1)
        return;
    out.remainderP = test.p;
    const Eigen::Matrix3d covariance =
        (test.ratio - 1) * all.rest / all.degreesOfFreedom * regression.unitCovariance();
    if (test.p < misfitLevel / 2 && test.ratio > 1 && covariance.allFinite()) {
        out.remainder = covariance;
        out.remainderDegreesOfFreedom = test.columns;
    }
}

} // namespace

std::vector<double> residualColour(const Estimate& estimate, const LinearizedRecord& record)
{
    std::vector<double> residuals;
    residuals.reserve(record.rows.size());
    for (const std::size_t row : record.rows)
        residuals.push_back(estimate.residual[row]);
    const std::optional<SeriesModel> model = autoregressiveModel(residuals);
    return model ? model->coefficients : std::vector<double>();
}

ModelMisfit modelMisfit(const Estimate& estimate, const LinearizedRecord& record,
                        const std::vector<double>& force, const OutputErrorOptions& options,
                        const std::vector<std::vector<double>>& known, bool frictionIsKnown)
{
    ModelMisfit out;
    if (!record.usable() || estimate.residual.size() != force.size() ||
        estimate.simulated.size() != force.size() || isRounding(estimate, record))
        return out;
    std::vector<Candidate> terms = candidates(estimate, record, force, options);
    std::size_t bent = bentTerms;
    if (!frictionIsKnown)
        bent -= std::erase_if(terms, [](const Candidate& term) { return term.id == u"dry_friction"_s; });
    std::vector<std::vector<double>> effects;
    effects.reserve(terms.size());
    for (const Candidate& term : terms)
        effects.push_back(term.effect);
    for (std::vector<double>& lagged : laggedForces(force))
        effects.push_back(std::move(lagged));
    effects.insert(effects.end(), known.begin(), known.end());
    // What the colour of a misfit hides of it is small beside the rest.
    const std::vector<double> noise = residualColour(estimate, record);
    const EffectTriangle data = effectTriangle(record, effects, estimate.residual, noise);
    if (!data.triangle.allFinite())
        return out;

    const Eigen::Index nuisances = record.nuisances.cols();
    const SmallRegression regression(data, nuisances, static_cast<Eigen::Index>(known.size()));
    const auto count = static_cast<Eigen::Index>(terms.size());
    const double leastPower = leastPowerOfBentTerms(regression, count, residualShare(estimate, record));
    std::vector<Eigen::Index> columns =
        chooseTerms(regression, count, static_cast<Eigen::Index>(bent), leastPower);
    const SmallRegression::Answer with = regression.with(columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Candidate& term = terms[static_cast<std::size_t>(columns[i])];
        const double size = with.solution(nuisances + 3 + static_cast<Eigen::Index>(i));
        const Eigen::Vector3d shift = size * regression.shiftBy(columns[i]);
        if (shift.allFinite())
            out.terms.push_back({term.id, term.words, shift});
    }
    addRemainder(regression, columns, count, out);
    return out;
}

} // namespace gripscope
