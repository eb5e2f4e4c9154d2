// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/model_misfit.h"

#include "core/identification/discretization.h"
#include "core/identification/residual_tests.h"
#include "core/identification/series_model.h"
#include "core/identification/small_regression.h"
#include "core/identification/smooth_force.h"
#include "core/words.h"

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
        {u"cubic_spring"_s, Words::tr("a spring that stiffens or softens with travel"), {}},
        {u"quadratic_spring"_s, Words::tr("a spring that differs between both directions"), {}},
        {u"quadratic_damping"_s, Words::tr("damping that grows with speed"), {}},
        {u"dry_friction"_s, Words::tr("dry friction"), {}}};
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
            {u"smooth_force"_s, Words::tr("a force that is smooth between the samples, not a straight line"),
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

/// Colour of the residuals, which the tests must not take for misfit. What the colour of a misfit hides of
/// it is small beside the rest.
std::vector<double> noiseOf(const Estimate& e, const LinearizedRecord& record)
{
    std::vector<double> residuals;
    for (const std::size_t row : record.rows)
        residuals.push_back(e.residual[row]);
    const std::optional<SeriesModel> model = autoregressiveModel(residuals);
    return model ? model->coefficients : std::vector<double>();
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
    effects.reserve(terms.size());
    for (const Candidate& term : terms)
        effects.push_back(term.effect);
    for (std::vector<double>& lagged : laggedForces(force))
        effects.push_back(std::move(lagged));
    effects.insert(effects.end(), known.begin(), known.end());
    const std::vector<double> noise = noiseOf(estimate, record);
    const EffectTriangle data = effectTriangle(record, effects, estimate.residual, noise);
    if (!data.triangle.allFinite())
        return out;

    const Eigen::Index nuisances = record.nuisances.cols();
    const SmallRegression regression(data, nuisances, static_cast<Eigen::Index>(known.size()));
    const auto count = static_cast<Eigen::Index>(terms.size());
    const double leastPower = leastPowerOfBentTerms(regression, count, residualShare(estimate, record));
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
    addRemainder(regression, columns, count, out);
    return out;
}

} // namespace gripscope
