// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/shift/shift_words.h"

#include "ui/format/reference_words.h"

#include <QLocale>

#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double normalOf95 = 1.959964;

QString signedPercent(double percent)
{
    return (percent < 0 ? u"−"_s : u"+"_s) + QLocale().toString(std::abs(percent), 'f', 1);
}

} // namespace

PercentInterval percentIntervalOf(double log, double deviation)
{
    const auto percent = [](double value) { return 100 * std::expm1(value); };
    return {percent(log), percent(log - normalOf95 * deviation), percent(log + normalOf95 * deviation)};
}

QString ShiftWords::percentInterval(double log, double deviation)
{
    const PercentInterval interval = percentIntervalOf(log, deviation);
    return tr("%1 % (%2 to %3)")
        .arg(signedPercent(interval.value), signedPercent(interval.low), signedPercent(interval.high));
}

QString ShiftWords::quantity(std::size_t place)
{
    return ReferenceWords::quantity(place);
}

QString ShiftWords::cause(DriftCause cause)
{
    switch (cause) {
    case DriftCause::TooFew:
        return tr("Too few squeezes to say");
    case DriftCause::Nothing:
        return tr("Nothing has moved");
    case DriftCause::Sensor:
        return tr("The force or the position sensor has moved");
    case DriftCause::Fingers:
        return tr("The fingers have changed");
    case DriftCause::Gripper:
        return tr("The gripper has moved: sensor or fingers");
    case DriftCause::Product:
        return tr("The product has moved, not the gripper");
    case DriftCause::Unclear:
    case DriftCause::OneTypeOnly:
        return tr("Something has moved: the product or the gripper");
    case DriftCause::NoCommonCause:
        return tr("Several types have moved, each in its own way");
    }
    return {};
}

QString ShiftWords::nextStep(const DriftReport& report, const QString& batch)
{
    switch (report.cause) {
    case DriftCause::TooFew:
        return tr("Inspect parts, with the expected type stated where it is known: three of a type or more.");
    case DriftCause::Nothing:
        return {};
    case DriftCause::Sensor:
        return tr("Check the calibration of force and position, and calibrate the one that is off.");
    case DriftCause::Fingers:
        return tr("Look at the fingers, then measure the empty gripper again (its baseline).");
    case DriftCause::Gripper:
        return tr("Check the calibration first; where it holds, measure the empty gripper again.");
    case DriftCause::Product:
        return batch.isEmpty()
                   ? tr("Look at the parts of %1 from that inspection on.").arg(report.moved.join(u", "_s))
                   : tr("Look at the batch %1: parts of %2.").arg(batch, report.moved.join(u", "_s));
    case DriftCause::Unclear:
    case DriftCause::OneTypeOnly:
        return tr("Squeeze parts of other types too: only they tell the product from the gripper.");
    case DriftCause::NoCommonCause:
        return tr("Look at the products; enrol again those types that are as they should be.");
    }
    return {};
}

QString ShiftWords::nextPage(DriftCause cause)
{
    switch (cause) {
    case DriftCause::Nothing:
        return {};
    case DriftCause::Sensor:
    case DriftCause::Fingers:
    case DriftCause::Gripper:
        return u"calibrate"_s;
    case DriftCause::Product:
        return u"history"_s;
    case DriftCause::NoCommonCause:
        return u"enroll"_s;
    case DriftCause::TooFew:
    case DriftCause::Unclear:
    case DriftCause::OneTypeOnly:
        break;
    }
    return u"inspect"_s;
}

QString ShiftWords::nextButton(DriftCause cause)
{
    const QString page = nextPage(cause);
    if (page == u"calibrate"_s)
        return tr("Go to Calibrate");
    if (page == u"history"_s)
        return tr("Go to History");
    if (page == u"enroll"_s)
        return tr("Go to Enroll");
    return page.isEmpty() ? QString() : tr("Go to Inspect");
}

} // namespace gripscope
