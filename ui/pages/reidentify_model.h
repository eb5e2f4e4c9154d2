// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pages/reidentify_job.h"

#include <QAbstractTableModel>

namespace gripscope {

/// Squeezes identified again: m, b and k as stored, as found now, and how far they are apart. EditRole holds
/// raw numbers: the deviation as a share.
class ReidentifyModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Column { Squeeze, Mass, Damping, Stiffness, Fit };
    static constexpr int columns = 5;

    using QAbstractTableModel::QAbstractTableModel;
    void clear();
    void append(const ReidentifiedSqueeze& squeeze);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] static QString text(const ReidentifiedSqueeze& row, Column column);
    std::vector<ReidentifiedSqueeze> m_rows;
};

} // namespace gripscope
