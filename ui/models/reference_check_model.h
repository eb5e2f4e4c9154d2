// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/reference_check.h"
#include "ui/models/row_table_model.h"

#include <vector>

namespace gripscope {

/// The checks of a gripper on its reference object, newest first.
class ReferenceCheckModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Made, Verdict, Stiffness, Damping, Mass, By };
    static constexpr int columns = 6;

    using RowTableModel::RowTableModel;

    void setChecks(std::vector<ReferenceCheckRecord> checks);
    [[nodiscard]] const std::vector<ReferenceCheckRecord>& checks() const { return m_checks; }
    /// Whether any check says something in this column.
    [[nodiscard]] bool says(Column column) const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int length() const override { return int(m_checks.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    [[nodiscard]] static std::optional<std::size_t> parameterOf(Column column);
    [[nodiscard]] QString text(const ReferenceCheckRecord& check, Column column) const;
    std::vector<ReferenceCheckRecord> m_checks;
};

} // namespace gripscope
