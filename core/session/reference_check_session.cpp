// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/reference_check_session.h"

#include "core/session/measured_together.h"
#include "core/signal/units.h"
#include "core/words.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

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
