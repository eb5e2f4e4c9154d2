// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/field_problem.h"

#include "core/base/words.h"

namespace gripscope::protocol {

using namespace Qt::StringLiterals;

namespace {

/// A number with the unit that the document gives the field.
QString withUnit(Field field, double value)
{
    const QString number = Words::number(value, 'g', 10);
    switch (field) {
    case Field::Watchdog:
        return u"%1 ms"_qs.arg(number);
    case Field::SampleTime:
    case Field::Lag:
        return u"%1 s"_qs.arg(number);
    case Field::LargestForce:
    case Field::LongestTravel:
        return Words::tr("%1 counts").arg(number);
    case Field::LongestExcitation:
        return Words::tr("%1 samples").arg(number);
    default:
        return number;
    }
}

} // namespace

std::optional<FieldProblem> outside(Field field, double value, double least, double most)
{
    if (value >= least && value <= most)
        return std::nullopt;
    return FieldProblem{field, value, least, most};
}

QString fieldName(Field field)
{
    switch (field) {
    case Field::ExcitationState:
        return Words::tr("excitation state");
    case Field::SampleCount:
        return Words::tr("number of samples");
    case Field::Result:
        return Words::tr("result");
    case Field::ArmKey:
        return Words::tr("key");
    case Field::ForceCount:
        return Words::tr("number of forces");
    case Field::ForceUnit:
        return Words::tr("force unit");
    case Field::PositionUnit:
        return Words::tr("position unit");
    case Field::ForceBetweenSamples:
        return Words::tr("force between samples");
    case Field::TakesCommands:
        return Words::tr("takes commands");
    case Field::Watchdog:
        return Words::tr("watchdog");
    case Field::ForcePerCount:
        return Words::tr("one count of force");
    case Field::PositionPerCount:
        return Words::tr("one count of position");
    case Field::SampleTime:
        return Words::tr("sample time");
    case Field::Lag:
        return Words::tr("position later by");
    case Field::LargestForce:
        return Words::tr("largest force");
    case Field::LongestTravel:
        return Words::tr("longest travel");
    case Field::LongestExcitation:
        return Words::tr("longest excitation");
    }
    return u"?"_qs;
}

QString describe(const FieldProblem& problem)
{
    const QString value = withUnit(problem.field, problem.value);
    if (problem.least == problem.most)
        return Words::tr("\"%1\" is %2; it must be %3")
            .arg(fieldName(problem.field), value, withUnit(problem.field, problem.least));
    return Words::tr("\"%1\" is %2; it must be from %3 to %4")
        .arg(fieldName(problem.field), value, withUnit(problem.field, problem.least),
             withUnit(problem.field, problem.most));
}

} // namespace gripscope::protocol
