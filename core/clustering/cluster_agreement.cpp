// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/clustering/cluster_agreement.h"

#include <QMap>

#include <algorithm>

namespace gripscope {

namespace {

double pairs(double n)
{
    return n * (n - 1) / 2;
}

QStringList sortedNames(const QStringList& truth)
{
    QStringList names = truth;
    names.removeDuplicates();
    names.sort();
    return names;
}

/// Hubert and Arabie, Comparing partitions, Journal of Classification 2 (1985): (index - expected) / (largest
/// - expected). Without anything to compare (both are one lump, or both all apart) it is 0/0: the partitions
/// are then the same, so 1.
double adjustedRandIndex(const Eigen::MatrixXi& counts)
{
    double together = 0;
    for (int n : counts.reshaped())
        together += pairs(n);
    double inTruth = 0;
    for (int n : Eigen::VectorXi(counts.rowwise().sum()))
        inTruth += pairs(n);
    double inClusters = 0;
    for (int n : Eigen::RowVectorXi(counts.colwise().sum()))
        inClusters += pairs(n);
    const double all = pairs(counts.sum());
    const double expected = all > 0 ? inTruth * inClusters / all : 0;
    const double largest = (inTruth + inClusters) / 2;
    return largest == expected ? 1 : (together - expected) / (largest - expected);
}

} // namespace

ClusterAgreement clusterAgreement(const QStringList& truth, const std::vector<int>& labels, int clusters)
{
    ClusterAgreement agreement;
    agreement.truths = sortedNames(truth);
    agreement.counts = Eigen::MatrixXi::Zero(agreement.truths.size(), clusters);
    const std::size_t items = std::min(std::size_t(truth.size()), labels.size());
    for (std::size_t i = 0; i < items; ++i)
        if (labels[i] >= 0 && labels[i] < clusters)
            ++agreement.counts(agreement.truths.indexOf(truth[qsizetype(i)]), labels[i]);
    agreement.adjustedRandIndex = adjustedRandIndex(agreement.counts);
    return agreement;
}

std::vector<std::vector<int>> clusterTable(const QStringList& truth, const std::vector<int>& labels)
{
    const QStringList names = sortedNames(truth);
    std::vector<std::vector<int>> columns(std::size_t(names.size()));
    const std::size_t items = std::min(std::size_t(truth.size()), labels.size());
    std::size_t rows = 0;
    for (std::size_t i = 0; i < items; ++i) {
        std::vector<int>& column = columns[std::size_t(names.indexOf(truth[qsizetype(i)]))];
        column.push_back(labels[i] + 1);
        rows = std::max(rows, column.size());
    }
    std::vector<std::vector<int>> table(rows, std::vector<int>(columns.size(), 0));
    for (std::size_t c = 0; c < columns.size(); ++c)
        for (std::size_t r = 0; r < columns[c].size(); ++r)
            table[r][c] = columns[c][r];
    return table;
}

} // namespace gripscope
