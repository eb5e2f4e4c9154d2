// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/excitation_design_json.h"

#include <QJsonArray>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QJsonObject candidateJson(const DesignCandidate& candidate, const DesignOptions& options)
{
    QJsonObject errors;
    for (std::size_t i = 0; i < options.objects.size(); ++i) {
        const std::optional<Eigen::Vector3d>& e = candidate.standardErrors[i];
        errors[options.objects[i].name] =
            e ? QJsonValue(QJsonObject{{u"m"_s, (*e)(0)}, {u"b"_s, (*e)(1)}, {u"k"_s, (*e)(2)}})
              : QJsonValue();
    }
    QJsonValue separation, nearest;
    if (options.objects.size() > 1) {
        separation = candidate.separation;
        const auto name = [&](int index) { return options.objects[static_cast<std::size_t>(index)].name; };
        nearest = QJsonArray{name(candidate.nearestFirst), name(candidate.nearestSecond)};
        if (candidate.nearestFirst == candidate.nearestSecond)
            nearest = QJsonValue();
    }
    return {{u"excitation"_s, toString(candidate.kind)},
            {u"bit_s"_s, candidate.bit_s > 0 ? QJsonValue(candidate.bit_s) : QJsonValue()},
            {u"d_efficiency"_s, candidate.dEfficiency},
            {u"separation"_s, separation},
            {u"nearest"_s, nearest},
            {u"standard_errors"_s, errors}};
}

} // namespace

QJsonObject toJson(const ExcitationDesign& design, const DesignOptions& options)
{
    QJsonArray candidates;
    for (const DesignCandidate& candidate : design.candidates)
        candidates.append(candidateJson(candidate, options));
    QJsonArray force;
    if (!design.candidates.empty())
        for (const double value : design.candidates.front().force)
            force.append(value);
    return {{u"samples"_s, static_cast<qint64>(options.samples())},
            {u"sample_time_s"_s, options.sampleTime_s},
            {u"peak"_s, design.amplitude},
            {u"bias"_s, options.bias},
            {u"limit"_s, options.limit},
            {u"candidates"_s, candidates},
            {u"force"_s, force}};
}

} // namespace gripscope
