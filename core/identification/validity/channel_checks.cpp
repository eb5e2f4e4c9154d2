// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/identification/validity/validity_checks.h"
#include "core/signal/preparation/sensor_faults.h"
#include "core/signal/recording/channel_quantity.h"

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// Share of saturated samples above which the measurement is invalid; any saturated sample makes it suspect.
constexpr double largestSaturatedShare = 0.01;

Finding saturationWords(const SaturatedSamples& found, std::size_t samples)
{
    Findings words;
    const auto tell = [&](const SaturatedChannel& channel, const Finding& sentence) {
        if (channel.count() > 0)
            words.push_back(sentence.arg(channel.count()).arg(samples));
    };
    tell(found.force, Words::say("the force stands at the end of its sensor's range in %1 of %2 samples."));
    tell(found.position,
         Words::say("the position stands at the end of its sensor's range in %1 of %2 samples."));
    const bool unmarked = found.force.marked + found.position.marked == 0;
    if (unmarked)
        words.push_back(Words::say("The gripper itself did not notice."));
    words.push_back(Words::say("Squeeze with less force, and check where the sensor's range ends."));
    return Finding::joined(words, u" "_s);
}

bool hasChannels(const Recording& recording, Window window)
{
    return recording.position.size() == recording.force.size() &&
           window.first + window.count <= recording.force.size();
}

/// A step stands still when it is done, and what was not commanded may stand still as it likes.
bool forceIsMeantToMove(const Recording& recording)
{
    const QString excitation = recording.provenance.value(u"excitation"_s);
    return !excitation.isEmpty() && excitation != u"step"_s && !excitation.startsWith(u"none"_s);
}

std::optional<Window> stuckForce(const Recording& recording, std::span<const double> force,
                                 std::span<const double> position)
{
    if (recording.status.size() != recording.size() || !forceIsMeantToMove(recording))
        return std::nullopt;
    return stuckStretch(force, position);
}

bool positionIsHeld(const Identification& data)
{
    return std::ranges::any_of(data.preparation,
                               [](const PreparationStep& step) { return step.id == u"position_held"; });
}

} // namespace

std::optional<ValidityCheck> heldPositionCheck(const Identification& data)
{
    const auto step = std::ranges::find(data.preparation, u"position_held"_s, &PreparationStep::id);
    const Estimate* const estimate = data.find(Estimator::Static);
    if (step == data.preparation.end() || estimate == nullptr)
        return std::nullopt;
    ValidityCheck check;
    check.id = u"position_held"_s;
    check.value = step->value;
    check.limit = data.sampleTime_s;
    check.ok = false;
    check.decisive = estimate->status != EstimateStatus::Converged;
    check.message = Words::say("the position is renewed only every %1 s: no mass and no damping. %2")
                        .arg(step->value, 'g', 2)
                        .arg(estimate->message.asSentence());
    return check;
}

ValidityCheck saturation(const Identification& data, const Recording& recording)
{
    ValidityCheck check;
    check.id = u"saturation"_s;
    check.value = check.limit = 0;
    check.message = Words::say("no sample stands at the end of a sensor's range");
    const Window window = data.choice.window;
    if (window.count == 0 || !hasChannels(recording, window))
        return check;
    SaturatedSamples found = saturatedSamples(recording, window);
    if (positionIsHeld(data))
        found.position.look = {};
    const std::size_t count = found.force.count() + found.position.count();
    const double share = static_cast<double>(count) / static_cast<double>(window.count);
    check.value = 100 * share;
    check.ok = count == 0;
    check.decisive = share > largestSaturatedShare;
    if (!check.ok)
        check.message = saturationWords(found, window.count);
    return check;
}

ValidityCheck stuckChannel(const Identification& data, const Recording& recording)
{
    ValidityCheck check;
    check.id = u"stuck"_s;
    check.value = check.limit = 0;
    check.message = Words::say("no channel stood still while the other moved");
    const Window window = data.choice.window;
    if (!hasChannels(recording, window))
        return check;
    const auto part = [window](const std::vector<double>& values) {
        return std::span<const double>(values).subspan(window.first, window.count);
    };
    const auto force = part(recording.force), position = part(recording.position);
    const std::optional<Window> positionStuck =
        positionIsHeld(data) ? std::nullopt : stuckStretch(position, force);
    const std::optional<Window> stuck =
        positionStuck ? positionStuck : stuckForce(recording, force, position);
    if (!stuck)
        return check;
    check.ok = false;
    check.decisive = true;
    check.value = static_cast<double>(stuck->count);
    const Finding words =
        positionStuck
            ? Words::say("the position channel is stuck: it stands at %1 in %2 of %3 samples while "
                         "the force moves. Check the position sensor and its cable, then squeeze "
                         "again.")
                  .arg(channelQuantity(MechanicalQuantity::Length, position[stuck->first],
                                       recording.positionUnit))
            : Words::say("the force channel is stuck: it stands at %1 in %2 of %3 samples while the "
                         "position moves. Check the force sensor and its cable, then squeeze "
                         "again.")
                  .arg(channelQuantity(MechanicalQuantity::Force, force[stuck->first], recording.forceUnit));
    check.message = words.arg(stuck->count).arg(window.count);
    return check;
}

ValidityCheck deviceFault(const Recording& recording)
{
    ValidityCheck check;
    check.id = u"device_fault"_s;
    check.limit = 0;
    const auto faults = std::count_if(recording.status.begin(), recording.status.end(),
                                      [](std::uint16_t status) { return (status & StatusFault) != 0; });
    check.value = static_cast<double>(faults);
    check.ok = faults == 0;
    check.decisive = true;
    check.message =
        check.ok ? Words::say("the gripper reported no fault of its own")
                 : Words::say("the gripper reported a fault of its own in %1 of %2 samples, so what it "
                              "measured cannot be relied on. Find out what is wrong with it, then squeeze "
                              "again.")
                       .arg(faults)
                       .arg(recording.size());
    return check;
}

} // namespace gripscope
