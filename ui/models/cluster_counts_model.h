// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/cluster_agreement.h"

#include <QAbstractTableModel>

namespace gripscope {

/// How many squeezes of each type fell into each cluster: a row a type, a column a cluster.
class ClusterCountsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    static constexpr int SortRole = Qt::UserRole;
    using QAbstractTableModel::QAbstractTableModel;

    void setAgreement(const ClusterAgreement& agreement);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    ClusterAgreement m_agreement;
};

} // namespace gripscope
