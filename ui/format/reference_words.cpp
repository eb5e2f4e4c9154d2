// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/format/reference_words.h"

#include "core/signal/recording/units.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"

#include <QLocale>
#include <QStringList>

#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr double expanded = 2; ///< as the En number takes it
constexpr int secondsAnHour = 3600;
constexpr int hoursADay = 24;

QString signedPercent(double percent)
{
    const QString number = QLocale().toString(std::abs(percent), 'f', std::abs(percent) < 9.95 ? 1 : 0);
    return (percent < 0 ? u"−"_s : u"+"_s) + number + u" %"_s;
}

bool isSurprising(const ReferenceCheckRecord& check)
{
    for (std::size_t i = 0; i < ReferenceWords::quantities; ++i)
        if (check.reference.stated[i] && check.measured[i] &&
            std::abs(enNumber(*check.measured[i], *check.reference.stated[i]).value_or(INFINITY)) > 1)
            return true;
    return false;
}

} // namespace

QString ReferenceWords::quantity(std::size_t parameter)
{
    const QString names[quantities] = {tr("Mass m"), tr("Damping b"), tr("Stiffness k")};
    return names[parameter];
}

QString ReferenceWords::unit(std::size_t parameter)
{
    const ParameterUnits si = siParameterUnits();
    const QString units[quantities] = {si.m, si.b, si.k};
    return units[parameter];
}

QString ReferenceWords::verdict(CheckVerdict verdict)
{
    switch (verdict) {
    case CheckVerdict::Passed:
        return tr("passed");
    case CheckVerdict::Failed:
        return tr("failed");
    case CheckVerdict::NotValid:
        break;
    }
    return tr("measurement not valid");
}

QString ReferenceWords::status(const std::optional<ReferenceStanding>& standing, const QDateTime& now)
{
    if (!standing)
        return tr("No reference object yet.");
    switch (checkStatus(standing, now)) {
    case CheckStatus::NotAsked:
        return tr("No check was made yet, and none is asked for.");
    case CheckStatus::Failed:
        return tr("Failed on %1: measurements are marked as suspect.").arg(timeText(standing->last->made));
    case CheckStatus::Due:
        return standing->last ? tr("Due since %1: measurements are marked as suspect.")
                                    .arg(timeText(*checkHoldsUntil(*standing)))
                              : tr("Due, it was never made: measurements are marked as suspect.");
    case CheckStatus::Passed:
        break;
    }
    const std::optional<QDateTime> until = checkHoldsUntil(*standing);
    return until ? tr("Passed, and holds until %1.").arg(timeText(*until))
                 : tr("Passed on %1.").arg(timeText(standing->last->made));
}

QString ReferenceWords::brief(const std::optional<ReferenceStanding>& standing, const QDateTime& now)
{
    switch (checkStatus(standing, now)) {
    case CheckStatus::NotAsked:
        return {};
    case CheckStatus::Failed:
        return tr("spring check failed");
    case CheckStatus::Due:
        return tr("spring check due");
    case CheckStatus::Passed:
        break;
    }
    const qint64 hours = std::max<qint64>(standing->last->made.secsTo(now), 0) / secondsAnHour;
    if (hours < 1)
        return tr("spring check this hour");
    return hours < 2 * hoursADay ? tr("spring check %1 h ago").arg(hours)
                                 : tr("spring check %1 days ago").arg(hours / hoursADay);
}

std::vector<Fact> ReferenceWords::reference(const ReferenceObject& reference)
{
    std::vector<Fact> facts{{tr("Object"), reference.name, false}};
    if (!reference.certificate.isEmpty())
        facts.push_back({tr("Its certificate"), reference.certificate, false});
    for (std::size_t i = quantities; i-- > 0;)
        if (const std::optional<ReferenceQuantity>& stated = reference.stated[i])
            facts.push_back(
                {quantity(i),
                 tr("%1, within %2 %")
                     .arg(formatNumber(stated->value, expanded * stated->standardUncertainty, unit(i), 4)
                              .text())
                     .arg(QLocale().toString(100 * stated->tolerance / stated->value, 'g', 3)),
                 false});
    facts.push_back({tr("A check"),
                     tr("%n squeezes of %1", nullptr, reference.squeezes)
                         .arg(pushText(reference.bias_N, reference.peak_N)),
                     false});
    facts.push_back({tr("Holds for"),
                     reference.intervalHours > 0 ? tr("%n hours", nullptr, reference.intervalHours)
                                                 : tr("no check is asked for"),
                     false});
    return facts;
}

QString ReferenceWords::error(const ReferenceCheckRecord& check, std::size_t parameter)
{
    const std::optional<ReferenceQuantity>& stated = check.reference.stated[parameter];
    const std::optional<MeasuredQuantity>& measured = check.measured[parameter];
    if (!stated || !measured)
        return u"–"_s;
    const QString percent = signedPercent(100 * (measured->value / stated->value - 1));
    const std::optional<double> en = enNumber(*measured, *stated);
    return en ? tr("%1, En %2").arg(percent, QLocale().toString(std::abs(*en), 'f', 1)) : percent;
}

QString ReferenceWords::outcome(const ReferenceCheckRecord& check)
{
    QStringList found;
    for (std::size_t i = quantities; i-- > 0;)
        if (check.reference.stated[i] && check.measured[i])
            found << tr("%1: %2 (%3)")
                         .arg(quantity(i),
                              formatNumber(check.measured[i]->value,
                                           expanded * check.measured[i]->standardUncertainty, unit(i))
                                  .text(),
                              error(check, i));
    const QString numbers = found.join(u'\n');
    switch (check.verdict) {
    case CheckVerdict::Passed:
        return (isSurprising(check)
                    ? tr("Passed: within the tolerance, but off by more than the uncertainties explain. "
                         "Calibrate soon.")
                    : tr("Passed.")) +
               u'\n' + numbers;
    case CheckVerdict::Failed:
        return tr("Failed: off by more than the tolerance. See that the object sits well and nothing rubs, "
                  "and check again; then calibrate.") +
               u'\n' + numbers;
    case CheckVerdict::NotValid:
        break;
    }
    return check.obstacle.isEmpty()
               ? tr("Not valid: the squeezes do not tell m, b and k well enough for the tolerance. Take more "
                    "squeezes, or more force.") +
                     u'\n' + numbers
               : tr("Not valid, so nothing is said of the gripper: %1").arg(asSentence(check.obstacle));
}

} // namespace gripscope
