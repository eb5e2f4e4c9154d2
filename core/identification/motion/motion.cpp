// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/motion/motion.h"

#include "core/base/parallel_runs.h"
#include "core/base/words.h"
#include "core/identification/model/evidence.h"
#include "core/identification/model/identifiability.h"
#include "core/identification/motion/motion_search.h"
#include "core/identification/output_error/output_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace gripscope {

namespace {

using P = MotionParameter;

/// Of longer records a first part is enough to find the way.
constexpr std::size_t firstPart = 8000;
/// Ljung-Box below which residuals are certainly not white.
constexpr double certainColourP = 0.001;

constexpr const char* tooFewSamples =
    QT_TRANSLATE_NOOP("Words", "there are fewer samples than the motion has unknowns; record for longer");

Estimate failed(const MotionOptions& options, EstimateStatus status, const Finding& message)
{
    return statusOnly(options.estimator, status, message);
}

/// The linear motion as a point of the search; nothing of it where it was not found.
MotionPoint linearPoint(const MotionProblem& problem, const MotionOptions& options)
{
    MotionPoint point;
    std::optional<MassDampingStiffness> linear = options.start;
    Nuisance nuisance = options.startNuisance;
    if (!linear && problem.terms.mass && problem.terms.spring) {
        OutputErrorOptions asked{options};
        asked.lost.clear();
        asked.residuals = ResidualDepth::Sums;
        std::vector<double> force = problem.force;
        std::vector<double> position = problem.position;
        for (double& value : force)
            value *= problem.forceScale;
        for (double& value : position)
            value = value * problem.positionScale + problem.positionShift;
        const Estimate found = estimateOutputError(force, position, asked);
        linear = found.parameters;
        nuisance = found.nuisance;
    }
    if (!linear)
        return point;
    MotionValues values = options.startTerms;
    values[P::Mass] = linear->m;
    values[P::Damping] = linear->b;
    values[P::Stiffness] = linear->k;
    point.values = inProblemUnits(problem, values);
    point.x0 = nuisance.x0.value_or(0) / problem.positionScale;
    point.v0 = nuisance.v0.value_or(0) * problem.sampleTime_s / problem.positionScale;
    if (nuisance.offset)
        point.offset = (*nuisance.offset - problem.positionShift) / problem.positionScale;
    return point;
}

/// Cost in variances of the residuals, small beside what one standard error changes.
constexpr double clearlyHigher = 0.02;

/// With friction there are several lowest points: all starts are followed, the others side by side once the
/// first has told what they have to be better than.
std::optional<MotionSearchResult> searchFromAll(const MotionProblem& problem,
                                                const std::vector<MotionPoint>& starts,
                                                const MotionOptions& options)
{
    if (starts.empty())
        return std::nullopt;
    MotionSearchOptions own{options.maxIterations, options.arrived};
    std::vector<MotionSearchResult> found(starts.size());
    found.front() = searchMotion(problem, starts.front(), own);
    if (found.front().isSettled())
        own.lowest = found.front().cost();
    shareAmongThreads(static_cast<std::int64_t>(starts.size()) - 1, 0, [&](std::int64_t other) {
        const auto i = static_cast<std::size_t>(other) + 1;
        found[i] = searchMotion(problem, starts[i], own);
    });
    MultiStart<MotionSearchResult> searches(-1); // none is too good for the others to be compared
    searches.run(found, [](const MotionSearchResult& result) { return std::optional(result); });
    return searches.best();
}

std::optional<MotionSearchResult>
searchFrom(const MotionProblem& problem, const std::vector<MotionPoint>& starts, const MotionOptions& options)
{
    if (problem.terms.friction)
        return searchFromAll(problem, starts, options);
    MultiStart<MotionSearchResult> searches(poorShare * positionEnergy(problem));
    searches.run(starts, [&](const MotionPoint& start) {
        const auto& best = searches.best();
        MotionSearchOptions own{options.maxIterations, options.arrived};
        if (best && best->isSettled())
            own.lowest = best->cost();
        // Other starts lead into the same valley as often as not: one that settles has to end no higher.
        if (best && best->outcome == SearchOutcome::Boundary)
            own.lowest = (1 + clearlyHigher / MotionSearchResult::degreesOfFreedom(problem)) * best->cost();
        return std::optional(searchMotion(problem, start, own));
    });
    return searches.best();
}

bool isLong(const MotionProblem& problem)
{
    return problem.force.size() > 2 * firstPart;
}

/// The search on the first part of a long record, whose answer is where that on all of it begins.
std::vector<MotionPoint> startsFor(const MotionProblem& problem, const MotionPoint& linear,
                                   const MotionOptions& options)
{
    if (isLong(problem)) {
        MotionProblem part = problem;
        static_cast<OutputErrorProblem&>(part) = firstSamples(problem, firstPart);
        const auto found = searchFrom(part, motionStarts(part, linear), options);
        if (found && found->isSettled() && found->cost() <= poorShare * positionEnergy(part))
            return {found->point};
    }
    return motionStarts(problem, linear);
}

/// From a start that is near, as long as it explains the record: where that does not settle the record does
/// not determine the motion. Else from all.
std::optional<MotionSearchResult> searchWell(const MotionProblem& problem, const MotionPoint& linear,
                                             const MotionOptions& options)
{
    if (options.startIsNear) {
        const auto found = searchFrom(problem, {startNear(problem, linear)}, options);
        if (found && found->linear.finite && found->cost() <= poorShare * positionEnergy(problem))
            return found;
    }
    return searchFrom(problem, startsFor(problem, linear, options), options);
}

/// Certain that friction does not hold the part when the record begins: chi-square with one degree of
/// freedom, p = 0.001.
constexpr double certainlyMoves = 10.83;

/// Where a search for a part that moves at the start may begin: the part at rest, moving, where that is
/// better already; all starts where there is none at rest.
std::vector<MotionPoint> movingStarts(const MotionProblem& problem, const MotionPoint& linear,
                                      const std::optional<MotionSearchResult>& resting,
                                      const MotionOptions& options)
{
    if (!resting || !resting->isSettled())
        return startsFor(problem, linear, options);
    std::vector<MotionPoint> best;
    double lowest = resting->cost();
    const double slope = startSpeed(problem);
    for (const double v0 : {linear.v0, slope, 0.3 * slope}) {
        MotionPoint moving = resting->point;
        moving.v0 = v0;
        // Of a long record only a part gave the start: the first answer is no reason to stop looking.
        if (isLong(problem) && !problem.terms.spring && v0 != 0)
            best.push_back(moving);
        const std::optional<MotionCost> there = costAt(problem, moving);
        if (there && there->cost < lowest) {
            lowest = there->cost;
            best = {moving};
        }
    }
    return best;
}

/// At rest at the start, or, where that is refuted, moving.
std::optional<MotionSearchResult> searchWithFriction(MotionProblem& problem, const MotionOptions& options)
{
    problem.startsAtRest = true;
    const MotionPoint linear = linearPoint(problem, options);
    const auto resting = searchWell(problem, linear, options);
    problem.startsAtRest = false;
    if (!problem.freeInitialState)
        return resting;
    const std::vector<MotionPoint> starts = movingStarts(problem, linear, resting, options);
    if (!starts.empty()) {
        const auto moving = searchFrom(problem, starts, options);
        const double variance = resting ? resting->cost() / MotionSearchResult::degreesOfFreedom(problem) : 0;
        const bool settled = moving && moving->isSettled();
        if (settled && (!resting || !resting->isSettled() ||
                        resting->cost() - moving->cost() > certainlyMoves * variance))
            return moving;
    }
    problem.startsAtRest = true;
    return resting;
}

/// Model output, residuals, fits and their tests at the solution.
void describe(const MotionProblem& problem, const MotionSearchResult& search, const MotionRows& rows,
              const std::vector<double>& position, Estimate& estimate)
{
    estimate.simulated = positionsAt(problem, search.point);
    estimate.simulated.resize(position.size());
    for (double& x : estimate.simulated)
        x = x * problem.positionScale + problem.positionShift;
    estimate.residuals.degreesOfFreedom = MotionSearchResult::degreesOfFreedom(problem);
    // As many nuisances as there are unknowns of the start, at the most.
    OutputErrorProblem record = problem;
    const int start = problem.startUnknowns();
    record.freeInitialState = start >= 2;
    record.freeOffset = start == 1 || start >= 3;
    describeResiduals(record, position, rows.sensitivities, rows.residuals, estimate);
}

Nuisance nuisanceOf(const MotionProblem& problem, const MotionPoint& point)
{
    Nuisance nuisance;
    if (problem.seeksPosition())
        nuisance.x0 = point.x0 * problem.positionScale;
    if (problem.seeksSpeed())
        nuisance.v0 = point.v0 * problem.positionScale / problem.sampleTime_s;
    if (problem.seeksOffset())
        nuisance.offset = point.offset * problem.positionScale + problem.positionShift;
    return nuisance;
}

/// m, b, k and their covariance for all who ask for no more, where the motion has all three.
void fillLinearPart(Estimate& estimate)
{
    const MotionEstimate& motion = *estimate.motion;
    if (!motion.terms.mass || !motion.terms.spring)
        return;
    estimate.parameters =
        MassDampingStiffness{motion.values[P::Mass], motion.values[P::Damping], motion.values[P::Stiffness]};
    estimate.covariance = motion.covariance.topLeftCorner<3, 3>();
}

Estimate answer(const MotionProblem& problem, const MotionSearchResult& search,
                const std::vector<double>& position, const MotionOptions& options)
{
    const MotionValues values = inChannelUnits(problem, search.point.values);
    const Eigen::VectorXd scales = errorScales(problem, search.point);
    const std::optional<MotionRows> rows = motionRows(problem, search.point);
    std::optional<Eigen::MatrixXd> covariance = whiteCovariance(problem, search, scales);
    MotionPoint inChannels;
    inChannels.values = values;
    if (!rows || !covariance || !inChannels.isPhysical(problem.terms))
        return failed(options, EstimateStatus::NotIdentifiable,
                      Words::say("the parameters or their errors are outside the range of numbers"));
    const bool converged = search.outcome == SearchOutcome::Converged;
    Estimate estimate =
        converged ? failed(options, EstimateStatus::Converged, Words::say("converged"))
                  : failed(options, EstimateStatus::NotConverged, Words::say("the search did not settle"));
    estimate.nuisance = nuisanceOf(problem, search.point);
    describe(problem, search, *rows, position, estimate);
    if (estimate.residuals.whitenessP && *estimate.residuals.whitenessP < certainColourP)
        if (auto coloured = colouredCovariance(*rows, scales, problem.positionScale, estimate))
            covariance =
                problem.frictionPrior
                    ? withKnownFriction(*coloured, problem.columnOf(P::Friction) - problem.startUnknowns(),
                                        std::pow(options.knownFriction->standardError, 2))
                    : *coloured;
    estimate.motion = MotionEstimate{problem.terms,
                                     values,
                                     *covariance,
                                     frictionLimit(problem, search, values, *covariance),
                                     influencesOf(problem, search, *rows, scales),
                                     {}};
    if (problem.frictionPrior)
        estimate.motion->offKnownFriction =
            (values[P::Friction] - options.knownFriction->value) / options.knownFriction->standardError;
    fillLinearPart(estimate);
    return estimate;
}

P boundaryParameter(const MotionProblem& problem, const MotionSearchResult& search)
{
    return problem.terms.parameters()[static_cast<std::size_t>(search.boundaryIndex)];
}

Finding boundaryOf(const MotionProblem& problem, const MotionSearchResult& search)
{
    const P parameter = boundaryParameter(problem, search);
    if (const auto linear = linearPlaceOf(parameter))
        return boundaryMessage(static_cast<int>(*linear), search.boundaryAtZero);
    return search.boundaryAtZero
               ? Words::say("%1 cannot be told from zero; leave its term out, or squeeze longer and with "
                            "more levels of force")
                     .arg(toString(parameter))
               : Words::say("%1 cannot be told from infinity; leave its term out, or squeeze longer and with "
                            "more levels of force")
                     .arg(toString(parameter));
}

/// What keeps the estimator from starting, or nothing.
std::optional<Estimate> obstacle(const MotionProblem& problem, const MotionOptions& options)
{
    const auto stop = [&](EstimateStatus status, const Finding& words) {
        return std::optional(failed(options, status, words));
    };
    if (!problem.terms.mass && problem.terms.friction)
        return stop(EstimateStatus::NotApplicable,
                    Words::say("friction without a mass is not among the models"));
    if (problem.measuredRows() <= problem.unknowns())
        return stop(EstimateStatus::TooFewSamples, Words::say(tooFewSamples));
    if (isConstant(problem.position))
        return stop(EstimateStatus::NotIdentifiable, Words::say(constantPosition));
    if (isConstant(problem.force) && problem.freeInitialState)
        return stop(EstimateStatus::NotIdentifiable,
                    Words::say("a constant force does not determine the motion; squeeze with a force that "
                               "varies, for instance one of four levels"));
    return std::nullopt;
}

void widen(Estimate& estimate, double factor)
{
    if (estimate.covariance)
        *estimate.covariance *= factor * factor;
    if (estimate.motion)
        estimate.motion->covariance *= factor * factor;
}

std::optional<MotionSearchResult> searchFreely(MotionProblem& problem, const MotionOptions& options)
{
    if (problem.terms.friction)
        return searchWithFriction(problem, options);
    return searchWell(problem, linearPoint(problem, options), options);
}

/// The search from where one ended, with the friction known; its weight from the noise that was left there,
/// twice, since knowing it changes what is left.
std::optional<MotionSearchResult> searchWithPrior(MotionProblem& problem, const MotionSearchResult& free,
                                                  const MotionOptions& options)
{
    constexpr int rounds = 2;
    const double unit = problem.unitOf(P::Friction);
    const GripperFriction& known = *options.knownFriction;
    MotionSearchResult found = free;
    found.point.values[P::Friction] = known.value / unit;
    for (int i = 0; i < rounds; ++i) {
        const double own = std::pow(problem.priorResidual(found.point.values[P::Friction]), 2);
        const double variance = (found.cost() - own) / MotionSearchResult::degreesOfFreedom(problem);
        problem.frictionPrior =
            FrictionPrior{known.value / unit, std::sqrt(variance) / (known.standardError / unit)};
        const auto next = searchFrom(problem, {found.point}, options);
        if (!next || !next->isSettled())
            return std::nullopt;
        found = *next;
    }
    return found;
}

/// Beyond as many standard errors what was known of the friction is not true of this squeeze.
constexpr double refutedBeyond = 4;

/// With what is known of the friction, as long as the record does not refute that.
std::optional<MotionSearchResult> bestMotion(MotionProblem& problem, const MotionOptions& options)
{
    const auto free = searchFreely(problem, options);
    if (!free || !options.knownFriction || !problem.terms.friction || problem.terms.eachWay ||
        !(options.knownFriction->standardError > 0) || !(free->cost() > 0) || !free->linear.finite)
        return free;
    const auto known = searchWithPrior(problem, *free, options);
    const double variance = free->cost() / MotionSearchResult::degreesOfFreedom(problem);
    if (known && known->cost() - free->cost() <= refutedBeyond * refutedBeyond * variance)
        return known;
    problem.frictionPrior.reset();
    return free;
}

Estimate estimateKnown(KnownForces known, const std::vector<double>& position, const MotionOptions& options)
{
    MotionProblem& problem = known.problem;
    if (const std::optional<Estimate> stop = obstacle(problem, options))
        return *stop;
    const std::optional<MotionSearchResult> search = bestMotion(problem, options);
    if (!search || search->outcome == SearchOutcome::Lost)
        return failed(options, EstimateStatus::NotIdentifiable, Words::say(noAnswer));
    Estimate estimate = failed(options, EstimateStatus::NotIdentifiable, Finding());
    if (search->outcome == SearchOutcome::Boundary) {
        estimate.message = boundaryOf(problem, *search);
        if (search->boundaryAtZero)
            estimate.notFromZero = boundaryParameter(problem, *search);
    } else if (!search->isDetermined())
        estimate.message = Words::say(poorForce);
    else
        estimate = answer(problem, *search, position, options);
    estimate.iterations = search->iterations;
    widen(estimate, known.errorFactor);
    return estimate;
}

/// With the lost forces found once more, beginning at what was found with those that were known before.
std::optional<Estimate> estimateAgain(const KnownForces& known, const Estimate& found,
                                      const std::vector<double>& position, const MotionOptions& options)
{
    if (found.status != EstimateStatus::Converged)
        return std::nullopt;
    const std::optional<KnownForces> again = knownForcesAgain(known, found, options);
    if (!again)
        return std::nullopt;
    MotionOptions near = options;
    near.start = found.parameters;
    near.startNuisance = found.nuisance;
    near.startTerms = found.motion->values;
    Estimate better = estimateKnown(*again, position, near);
    if (better.status != EstimateStatus::Converged)
        return std::nullopt;
    better.iterations += found.iterations;
    return better;
}

/// Standard error, relative, from which on damping of a motion without mass is not told from none.
constexpr double hardlyKnown = 0.5;

/// Where the record does not tell the damping of a spring and a damper: the spring alone, if that is found.
std::optional<Estimate> estimateWithoutDamping(const Estimate& found, const std::vector<double>& force,
                                               const std::vector<double>& position,
                                               const MotionOptions& options)
{
    if (options.terms != damperAndSpring)
        return std::nullopt;
    const bool isKnown =
        found.status == EstimateStatus::Converged &&
        *found.motion->standardError(P::Damping) <= hardlyKnown * found.motion->values[P::Damping];
    if (isKnown || (!found.motion && found.notFromZero != P::Damping))
        return std::nullopt;
    MotionOptions alone = options;
    alone.terms.damping = false;
    Estimate spring = estimateKnown(knownForces(force, position, alone), position, alone);
    const bool isEnough =
        spring.status == EstimateStatus::Converged && (!found.motion || !isDecisivelyWorse(spring, found, 0));
    return isEnough ? std::optional(spring) : std::nullopt;
}

} // namespace

double expectedGain(const std::vector<double>& force, const std::vector<double>& position,
                    const MotionOptions& options, const MotionTerms& base)
{
    constexpr std::array<double, 4> taus{0.002, 0.01, 0.05, 0.25}; // of the record's length
    constexpr double little = 0.01;
    KnownForces known = knownForces(force, position, options);
    MotionProblem& problem = known.problem;
    problem.startsAtRest = options.terms.friction;
    if (!options.start || !known.areKnown() || obstacle(problem, options))
        return 0;
    MotionPoint point = linearPoint(problem, options);
    MotionProblem fewer = problem;
    fewer.terms = base;
    const std::optional<MotionCost> there = costAt(fewer, point);
    if (!there || !(there->cost > 0))
        return 0;
    const double cost = there->cost;
    const bool newDashpot = options.terms.relaxation && !base.relaxation;
    if (!base.friction)
        point.values[P::Friction] = point.values[P::FrictionBack] = 0;
    if (!base.cubic)
        point.values[P::Cubic] = 0;
    if (newDashpot)
        point.values[P::Relaxing] = little * point.values[P::Stiffness];
    double best = 0;
    for (const double tau : taus) {
        if (newDashpot)
            point.values[P::RelaxationTime] =
                std::max(1.0, tau * static_cast<double>(problem.position.size()));
        const MotionLinearization with = linearize(problem, point);
        if (with.finite)
            best = std::max(best, cost - (with.cost - with.residual.squaredNorm()));
        if (!newDashpot)
            break;
    }
    return best / (cost / MotionSearchResult::degreesOfFreedom(fewer));
}

Estimate estimateMotion(const std::vector<double>& force, const std::vector<double>& position,
                        const MotionOptions& options)
{
    if (force.size() != position.size())
        return failed(options, EstimateStatus::NotApplicable,
                      Words::say("force and position have different lengths"));
    if (force.empty())
        return failed(options, EstimateStatus::TooFewSamples, Words::say(tooFewSamples));
    const KnownForces known = knownForces(force, position, options);
    if (!known.areKnown())
        return failed(options, known.completed.outputError.status, known.completed.outputError.message);
    Estimate estimate = estimateKnown(known, position, options);
    if (std::optional<Estimate> better = estimateAgain(known, estimate, position, options))
        return *better;
    return estimateWithoutDamping(estimate, force, position, options).value_or(estimate);
}

} // namespace gripscope
