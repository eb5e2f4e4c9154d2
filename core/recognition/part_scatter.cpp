// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognition/part_scatter.h"

#include <map>

namespace gripscope {

namespace {

/// Sums before they are divided.
struct Sums {
    PartScatter scatter;
    double inverse = 0;
    Eigen::Matrix3d noise = Eigen::Matrix3d::Zero();
    double noiseWeight = 0;

    void add(const std::vector<LogSqueeze>& squeezes)
    {
        const std::vector<PartSqueezes> parts = byPart(squeezes);
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const PartSqueezes& part : parts)
            mean += meanOf(part) / double(parts.size());
        // 1 - 1/n: what a squeeze's own noise leaves of itself in its distance from the mean.
        const double weight = 1 - 1.0 / double(parts.size());
        for (const PartSqueezes& part : parts) {
            const Eigen::Vector3d partMean = meanOf(part);
            scatter.between += (partMean - mean) * (partMean - mean).transpose();
            for (const LogSqueeze* squeeze : part) {
                const Eigen::Vector3d difference = squeeze->x - partMean;
                scatter.within += difference * difference.transpose();
                addNoise(*squeeze, part.size() > 1 || weight == 0 ? 1 : weight);
            }
            scatter.withinDegrees += int(part.size()) - 1;
            inverse += weight / double(part.size());
        }
        scatter.betweenDegrees += int(parts.size()) - 1;
    }

private:
    void addNoise(const LogSqueeze& squeeze, double weight)
    {
        if (!squeeze.noise)
            return;
        noise += weight * *squeeze.noise;
        noiseWeight += weight;
    }
};

} // namespace

std::vector<PartSqueezes> byPart(const std::vector<LogSqueeze>& squeezes)
{
    std::vector<PartSqueezes> parts;
    std::map<int, std::size_t> places;
    for (const LogSqueeze& squeeze : squeezes) {
        const auto known = squeeze.part < 0 ? places.end() : places.find(squeeze.part);
        if (known != places.end()) {
            parts[known->second].push_back(&squeeze);
            continue;
        }
        if (squeeze.part >= 0)
            places[squeeze.part] = parts.size();
        parts.push_back({&squeeze});
    }
    return parts;
}

Eigen::Vector3d meanOf(const PartSqueezes& squeezes)
{
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const LogSqueeze* squeeze : squeezes)
        mean += squeeze->x / double(squeezes.size());
    return mean;
}

PartScatter partScatter(const std::vector<std::vector<LogSqueeze>>& types)
{
    Sums sums;
    for (const std::vector<LogSqueeze>& squeezes : types)
        if (!squeezes.empty())
            sums.add(squeezes);
    PartScatter& scatter = sums.scatter;
    if (scatter.betweenDegrees > 0) {
        scatter.between /= scatter.betweenDegrees;
        scatter.meanInverse = sums.inverse / scatter.betweenDegrees;
    }
    if (scatter.withinDegrees > 0)
        scatter.within /= scatter.withinDegrees;
    if (sums.noiseWeight > 0)
        scatter.noise = sums.noise / sums.noiseWeight;
    return scatter;
}

} // namespace gripscope
