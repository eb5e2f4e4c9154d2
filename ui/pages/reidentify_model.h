// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/models/row_table_model.h"
#include "ui/pages/reidentify_job.h"

namespace gripscope {

/// Squeezes identified again: m, b and k as stored, as found now, and how far they are apart. EditRole holds
/// raw numbers: the deviation as a share.
class ReidentifyModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Squeeze, Mass, Damping, Stiffness, Fit };
    static constexpr int columns = 5;

    using RowTableModel::RowTableModel;
    void clear();
    void append(const ReidentifiedSqueeze& squeeze);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int length() const override { return int(m_rows.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    [[nodiscard]] static QString text(const ReidentifiedSqueeze& row, Column column);
    std::vector<ReidentifiedSqueeze> m_rows;
};

} // namespace gripscope
