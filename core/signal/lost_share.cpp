// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/signal/lost_share.h"

namespace gripscope {

Window keepLostShare(std::span<const std::int64_t> index, double largestShare)
{
    const Window all{0, index.size()};
    if (index.size() < 2)
        return all;
    const double points = static_cast<double>(index.back() - index.front()) + 1;
    if (points - static_cast<double>(index.size()) <= largestShare * points)
        return all;
    const double penalty = (1 - largestShare) / largestShare;
    Window best{0, 1};
    double bestSum = 1, sum = 1;
    std::size_t first = 0;
    for (std::size_t i = 1; i < index.size(); ++i) {
        sum -= penalty * static_cast<double>(index[i] - index[i - 1] - 1);
        if (sum <= 0) {
            sum = 0;
            first = i;
        }
        sum += 1;
        if (sum > bestSum) {
            bestSum = sum;
            best = {first, i - first + 1};
        }
    }
    return best;
}

} // namespace gripscope
