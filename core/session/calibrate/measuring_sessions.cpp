// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/calibrate/measuring_sessions.h"

#include "core/base/words.h"
#include "core/identification/identification.h"
#include "core/math/robust_statistics.h"
#include "core/signal/preparation/preparation.h"
#include "core/signal/recording/units.h"

#include <algorithm>
#include <span>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// m, b and k of a series of squeezes, or in words why there are none: what made the first invalid squeeze
/// invalid, or that no numbers came out. Suspect squeezes are used: that a calibration or a check is overdue
/// must not keep anybody from making it good.
tl::expected<RepeatedMeasurement, QString> measuredTogether(std::span<const Identification> squeezes)
{
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        const Validity& validity = squeezes[i].validity;
        if (validity.verdict != ValidityVerdict::Invalid)
            continue;
        const auto decisive = std::find_if(validity.checks.begin(), validity.checks.end(),
                                           [](const auto& check) { return !check.ok && check.decisive; });
        return tl::unexpected(Words::tr("squeeze %1: %2")
                                  .arg(i + 1)
                                  .arg(decisive != validity.checks.end() ? decisive->message.describe()
                                                                         : toString(validity.verdict)));
    }
    if (const std::optional<RepeatedMeasurement> found = repeatedMeasurement(squeezes))
        return *found;
    return tl::unexpected(Words::tr("no m, b and k above zero were found with their uncertainty"));
}

/// A gripper that springs hold back has m, b and k; one that runs freely `carriage` alone explains.
Identification identifyEmpty(const Recording& recording)
{
    IdentificationOptions options;
    options.estimators.push_back(Estimator::Friction);
    Identification held = identify(recording, options);
    if (held.validity.verdict != ValidityVerdict::Invalid)
        return held;
    options.estimators = {Estimator::Carriage};
    Identification free = identify(recording, options);
    return free.validity.verdict != ValidityVerdict::Invalid ? free : held;
}

/// One parameter of the motions that an estimator found in all squeezes; nothing where one found none.
std::optional<ValueWithError> pooled(std::span<const Identification> squeezes, Estimator estimator,
                                     MotionParameter parameter)
{
    std::vector<ValueWithError> found;
    for (const Identification& squeeze : squeezes) {
        const Estimate* const estimate = squeeze.find(estimator);
        if (estimate == nullptr || !estimate->hasAnswer() || !estimate->motion)
            return std::nullopt;
        const std::optional<double> error = estimate->motion->standardError(parameter);
        if (!error || !(*error > 0))
            return std::nullopt;
        found.push_back({estimate->motion->values[parameter], *error});
    }
    return found.empty() ? std::nullopt : std::optional(pooledMean(found));
}

bool areFree(std::span<const Identification> squeezes)
{
    return !squeezes.empty() && std::ranges::all_of(squeezes, [](const Identification& squeeze) {
        return squeeze.recommended == Estimator::Carriage &&
               squeeze.validity.verdict != ValidityVerdict::Invalid;
    });
}

/// The middle one of those that had enough rest before them; 0 where none had.
double restingNoise(std::span<const Identification> squeezes)
{
    std::vector<double> found;
    for (const Identification& squeeze : squeezes)
        for (const PreparationStep& step : squeeze.preparation)
            if (step.id == u"force_noise"_s)
                found.push_back(step.value);
    return found.empty() ? 0 : quantile(found, 0.5);
}

MeasuredQuantities inSi(const RepeatedMeasurement& found, double toSi)
{
    const Eigen::Vector3d values = toSi * found.parameters.vector();
    MeasuredQuantities measured;
    for (std::size_t i = 0; i < measured.size(); ++i)
        measured[i] =
            MeasuredQuantity{values(static_cast<Eigen::Index>(i)), toSi * found.standardUncertainty(i)};
    return measured;
}

} // namespace

BaselineSession::BaselineSession(ConnectSession& connection, LibraryService& library)
    : JudgedSeries(connection, library)
{
}

Expected<void> BaselineSession::start(const Recipe& recipe, int squeezes)
{
    return begin(recipe, squeezes);
}

void BaselineSession::clear()
{
    JudgedSeries::clear();
    m_baseline.reset();
    m_friction.reset();
    m_forceNoise = 0;
    m_problem.clear();
}

void BaselineSession::judge(const Recording& recording)
{
    Recording whole = recording;
    whole.chain.baseline.reset(); // it is the empty gripper itself that is looked for
    whole.chain.friction.reset();
    whole.chain.forceNoiseDeviation = 0;
    judgeBy(identifyEmpty, std::move(whole));
}

void BaselineSession::conclude()
{
    using P = MotionParameter;
    const bool free = areFree(squeezes());
    const Estimator motion = free ? Estimator::Carriage : Estimator::Friction;
    if (free) {
        const auto mass = pooled(squeezes(), motion, P::Mass);
        const auto damping = pooled(squeezes(), motion, P::Damping);
        if (mass && damping)
            m_baseline = GripperBaseline{{mass->value, damping->value, 0},
                                         {mass->standardError, damping->standardError, 0}};
    } else if (const auto found = measuredTogether(squeezes())) {
        const MassDampingStiffness& own = found->parameters;
        m_baseline = GripperBaseline{{own.m, own.b, own.k}, found->ownErrors};
    } else {
        m_problem = found.error();
    }
    if (!m_baseline)
        return;
    if (const auto friction = pooled(squeezes(), motion, P::Friction))
        m_friction = GripperFriction{friction->value, friction->standardError};
    m_forceNoise = restingNoise(squeezes());
}

Expected<void> BaselineSession::accept()
{
    if (state() != State::Measured || !m_baseline)
        return failure(ErrorCode::Usage,
                       {Words::tr("There is no baseline that was measured well enough to be used.")});
    MeasuringChain chain = connection().measuringChain();
    chain.baseline = m_baseline;
    chain.friction = m_friction;
    if (m_forceNoise > 0)
        chain.forceNoiseDeviation = m_forceNoise;
    return storeChain({serial(), connection().forceLag_s(), chain, operatorName(),
                       Words::tr("empty gripper, %1 squeezes").arg(squeezes().size())});
}

Expected<void> BaselineSession::remove()
{
    if (busy() || !connection().measuringChain().baseline)
        return failure(ErrorCode::Usage, {Words::tr("There is no baseline that could be taken away now.")});
    clear();
    MeasuringChain chain = connection().measuringChain();
    chain.baseline.reset();
    chain.friction.reset();
    return storeChain({connection().identity().serial, connection().forceLag_s(), chain, operatorName(),
                       Words::tr("the empty gripper is no longer taken off")});
}

LagSession::LagSession(ConnectSession& connection, LibraryService& library)
    : JudgedSeries(connection, library)
{
}

Expected<void> LagSession::start(const Recipe& recipe, int squeezes)
{
    return begin(recipe, squeezes);
}

void LagSession::clear()
{
    JudgedSeries::clear();
    m_result = {};
}

void LagSession::judge(const Recording& recording)
{
    judgeBy(estimateLag, recording);
}

void LagSession::conclude()
{
    m_result = combineLags(squeezes());
}

Expected<void> LagSession::accept()
{
    if (state() != State::Measured || m_result.status != LagStatus::Measured)
        return failure(ErrorCode::Usage,
                       {Words::tr("There is no lag that was measured well enough to be used.")});
    MeasuringChain chain = connection().measuringChain();
    chain.forceLagUncertainty_s = m_result.standardError_s;
    return storeChain({serial(), m_result.lag_s, chain, operatorName(),
                       Words::tr("lag from %1 squeezes").arg(m_result.squeezes)});
}

LagEstimate estimateLag(const Recording& recording)
{
    const PreparedRecord record = prepare(recording);
    LagEstimationOptions options;
    options.sampleTime_s = record.sampleTime_s;
    options.hold = record.hold.value_or(ForceHold::First);
    options.holdIsKnown = record.hold.has_value();
    options.expectedLag_s = record.forceLag_s;
    options.lost = record.lost;
    return estimateLag(record.force, record.position, options);
}

Recipe recipeOf(const ReferenceObject& reference)
{
    constexpr double headroom = 1.2; ///< above what is commanded; the gripper's own limits hold, too
    Recipe recipe;
    recipe.name = u"check"_s;
    recipe.bias_N = reference.bias_N;
    recipe.peak_N = reference.peak_N;
    recipe.maxForce_N = headroom * (reference.bias_N + reference.peak_N);
    return recipe;
}

ReferenceCheckSession::ReferenceCheckSession(ConnectSession& connection, LibraryService& library)
    : JudgedSeries(connection, library)
{
}

Expected<void> ReferenceCheckSession::start()
{
    const std::optional<ReferenceStanding>& standing = connection().calibration().reference();
    if (!standing)
        return failure(ErrorCode::Usage, {Words::tr("This gripper has no reference object yet.")});
    const GripperIdentity identity = connection().identity();
    const std::optional<double> toSi = siFactor(identity.forceUnit, identity.positionUnit);
    if (!toSi)
        return failure(
            ErrorCode::Usage,
            {Words::tr("The units of this gripper's channels (%1, %2) are not known, so that m, b and k "
                       "cannot be held against what is stated.")
                 .arg(identity.forceUnit, identity.positionUnit)});
    const ReferenceObjectRecord reference = standing->reference;
    const Expected<void> begun = begin(recipeOf(reference), reference.squeezes);
    if (begun) {
        m_reference = reference;
        m_toSi = *toSi;
    }
    return begun;
}

void ReferenceCheckSession::clear()
{
    JudgedSeries::clear();
    m_check.reset();
}

void ReferenceCheckSession::judge(const Recording& recording)
{
    judgeBy([](const Recording& one) { return identify(one); }, recording);
}

void ReferenceCheckSession::conclude()
{
    ReferenceCheckRecord check;
    check.gripperSerial = serial();
    check.referenceId = m_reference.id;
    check.reference = m_reference;
    check.operatorName = operatorName();
    check.squeezes = static_cast<int>(squeezes().size());
    check.made = QDateTime::currentDateTimeUtc();
    if (const auto found = measuredTogether(squeezes())) {
        check.measured = inSi(*found, m_toSi);
        check.verdict = judgeCheck(m_reference, check.measured);
    } else {
        check.obstacle = found.error();
    }
    m_check = check;
    store<CalibrationsInForce>(
        [check](Library& library) {
            return library.addReferenceCheck(check).and_then(
                [&] { return library.calibrationsInForce(check.gripperSerial); });
        },
        [this](const CalibrationsInForce& standing) {
            if (connection().identity().serial == serial())
                connection().setCalibrations(standing);
        });
}

} // namespace gripscope
