// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QString>
#include <QStringList>

#include <vector>

namespace gripscope {

/// Truth against clusters. `counts(i, j)`: items of the i-th truth (sorted by name) in cluster j.
struct ClusterAgreement {
    QStringList truths;
    Eigen::MatrixXi counts;
    double adjustedRandIndex =
        0; ///< 1: the same partition; about 0: no better than chance. Hubert and Arabie 1985
};
/// `labels`: one a truth, from 0 to clusters - 1.
[[nodiscard]] ClusterAgreement clusterAgreement(const QStringList& truth, const std::vector<int>& labels,
                                                int clusters);

/// The paper's Table 1: row t holds, for each truth in sorted order, the cluster (numbered from 1) of its
/// t-th item (0 where that truth has fewer items).
[[nodiscard]] std::vector<std::vector<int>> clusterTable(const QStringList& truth,
                                                         const std::vector<int>& labels);

} // namespace gripscope
