// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/bode_plots.h"
#include "ui/context/navigator.h"
#include "ui/format/channel_scale.h"
#include "ui/format/estimate_words.h"
#include "ui/pages/fit/fit_page.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t modelPoints = 240;
constexpr double mostDecades = 4, shareOfHalfRate = 0.999;

double largestMagnitude(const std::vector<double>& values)
{
    double largest = 0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    return largest;
}

/// From once in the record to half the sample rate.
std::vector<double> modelFrequencies(const Identification& identification)
{
    const double high = shareOfHalfRate / (2 * identification.sampleTime_s);
    const double once = 1 / (identification.sampleTime_s * double(identification.force.size()));
    return logarithmicFrequencies(std::max(once, high * std::pow(10.0, -mostDecades)), high, modelPoints);
}

} // namespace

BodeContent FitPage::bodeContent(const FitSubject& subject, Estimator estimator,
                                 const std::optional<EmpiricalResponse>& measured)
{
    const Identification& found = subject.identification;
    BodeContent content;
    content.measured = measured;
    content.modelName = estimatorName(estimator);
    const ChannelScale force = channelScale(subject.recording.forceUnit, largestMagnitude(found.force));
    const ChannelScale position =
        channelScale(subject.recording.positionUnit, largestMagnitude(found.position));
    if (!force.unit.isEmpty() && !position.unit.isEmpty())
        content.unit = u"%1/%2"_s.arg(position.unit, force.unit);
    content.factor = position.factor / force.factor;
    const Estimate* estimate = found.find(estimator);
    if (estimate && estimate->parameters && found.sampleTime_s > 0 && !found.force.empty())
        content.model = modelResponse(*estimate->parameters, estimate->covariance,
                                      {found.sampleTime_s, found.hold, subject.recording.forceLag_s},
                                      modelFrequencies(found));
    return content;
}

} // namespace gripscope
