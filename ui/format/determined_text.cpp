// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/determined_text.h"

#include "ui/format/interval_text.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

struct DeterminedWords {
    Q_DECLARE_TR_FUNCTIONS(gripscope::DeterminedText)
};

ShownUnit shownUnitOf(const DeterminedParameter& one)
{
    switch (one.parameter) {
    case MotionParameter::Cubic:
        return cubicShownUnit(one.unit,
                              std::max(std::abs(one.value), one.interval ? one.interval->upper : 0));
    case MotionParameter::RelaxationTime:
    case MotionParameter::Friction:
    case MotionParameter::FrictionBack:
    case MotionParameter::ForceOffset:
        return {one.unit == u"1" ? QString() : one.unit, 1};
    default:
        return shownUnit(one.unit, std::abs(one.value));
    }
}

} // namespace

QString parameterName(MotionParameter parameter)
{
    switch (parameter) {
    case MotionParameter::Mass:
        return DeterminedWords::tr("Mass m");
    case MotionParameter::Damping:
        return DeterminedWords::tr("Damping b");
    case MotionParameter::Stiffness:
        return DeterminedWords::tr("Stiffness k");
    case MotionParameter::Friction:
        return DeterminedWords::tr("Friction Fc");
    case MotionParameter::Relaxing:
        return DeterminedWords::tr("Yielding stiffness k1");
    case MotionParameter::RelaxationTime:
        return DeterminedWords::tr("Yields within τ");
    case MotionParameter::Cubic:
        return DeterminedWords::tr("Cubic stiffness k3");
    case MotionParameter::DampingBack:
        return DeterminedWords::tr("Damping back b");
    case MotionParameter::FrictionBack:
        return DeterminedWords::tr("Friction back Fc");
    case MotionParameter::ForceOffset:
        return DeterminedWords::tr("Offset of the force");
    }
    return {};
}

QString determinedText(const DeterminedParameter& one)
{
    const ShownUnit shown = shownUnitOf(one);
    const double value = one.value * shown.factor;
    if (one.isLowerBound)
        return DeterminedWords::tr("at least %1")
            .arg(formatNumber(value, std::nullopt, shown.unit, 2).valueWithUnit());
    if (!one.interval)
        return formatNumber(value, std::nullopt, shown.unit).text();
    CoverageInterval interval = *one.interval;
    interval.lower *= shown.factor;
    interval.upper *= shown.factor;
    return intervalText(value, interval, shown.unit);
}

QString furtherText(const std::vector<DeterminedParameter>& all)
{
    QStringList parts;
    for (const DeterminedParameter& one : all)
        if (!linearPlaceOf(one.parameter))
            parts << u"%1 %2"_s.arg(parameterName(one.parameter), determinedText(one));
    return parts.join(u" · "_s);
}

} // namespace gripscope
