// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/math/distributions.h"
#include "core/quality/gauge/gauge_study.h"

#include <cmath>

namespace gripscope {

Expected<std::optional<RepeatConsistency>> repeatConsistency(const GaugeLayout& layout,
                                                             const Eigen::VectorXd& values,
                                                             const Eigen::VectorXd& standardUncertainty)
{
    for (Eigen::Index i = 0; i < standardUncertainty.size(); ++i)
        if (!(standardUncertainty[i] > 0))
            return failure(ErrorCode::BadInput,
                           {Words::say("Uncertainty of measurement %1").arg(i + 1),
                            Finding::number(standardUncertainty[i]), Words::say("above 0")});
    if (!layout.replicated)
        return std::nullopt;
    const Eigen::Index cells = Eigen::Index(layout.count.size());
    const Eigen::VectorXd centred = values.array() - values[0];
    const double size = standardUncertainty.maxCoeff(); // squares of tiny numbers must not vanish
    const Eigen::ArrayXd relative = standardUncertainty.array() / size;
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(cells), mean = weight;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const double w = 1 / (relative[i] * relative[i]);
        const int cell = layout.cell[std::size_t(i)];
        weight[cell] += w;
        mean[cell] += w * (centred[i] - mean[cell]) / weight[cell];
    }
    RepeatConsistency found;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        const double off = (centred[i] - mean[layout.cell[std::size_t(i)]]) / standardUncertainty[i];
        found.chiSquared += off * off;
    }
    found.degreesOfFreedom = double(values.size() - cells);
    found.above = chiSquaredAbove(found.chiSquared, found.degreesOfFreedom);
    found.below = chiSquaredBelow(found.chiSquared, found.degreesOfFreedom);
    found.ratio = std::sqrt(found.chiSquared / found.degreesOfFreedom);
    found.statedDeviation = size * std::sqrt(relative.square().mean());
    return found;
}

} // namespace gripscope
