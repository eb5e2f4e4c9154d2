// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/cluster_counts_model.h"

#include "ui/widgets/number_format.h"

namespace gripscope {

void ClusterCountsModel::setAgreement(const ClusterAgreement& agreement)
{
    beginResetModel();
    m_agreement = agreement;
    endResetModel();
}

int ClusterCountsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_agreement.counts.rows());
}

int ClusterCountsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : int(m_agreement.counts.cols());
}

QVariant ClusterCountsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const int count = m_agreement.counts(index.row(), index.column());
    switch (role) {
    case SortRole:
        return count;
    case Qt::DisplayRole: // an empty cell shows the pattern better than a nought
        return count > 0 ? QVariant(formatCount(count)) : QVariant();
    case Qt::TextAlignmentRole:
        return int(Qt::AlignCenter);
    default:
        return {};
    }
}

QVariant ClusterCountsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (section < 0 || (role != Qt::DisplayRole && role != Qt::ToolTipRole))
        return {};
    if (orientation == Qt::Vertical)
        return section < m_agreement.truths.size() ? QVariant(m_agreement.truths[section]) : QVariant();
    return role == Qt::DisplayRole ? QVariant(section + 1) : QVariant(tr("Cluster %1").arg(section + 1));
}

} // namespace gripscope
