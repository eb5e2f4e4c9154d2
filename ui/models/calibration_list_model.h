// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "ui/models/row_table_model.h"

namespace gripscope {

/// A calibration that was stored, with what its points say; nothing where they say nothing.
struct CalibrationRow {
    CalibrationRecord record;
    std::optional<CalibrationEvaluation> evaluation;
};

/// The calibrations of the library, newest first.
class CalibrationListModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Taken, Channel, Uncertainty, Due, Gripper, By };
    static constexpr int columns = 6;

    using RowTableModel::RowTableModel;

    void setRows(std::vector<CalibrationRow> rows);
    [[nodiscard]] const CalibrationRow& row(int index) const { return m_rows[std::size_t(index)]; }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int length() const override { return int(m_rows.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    [[nodiscard]] QString text(const CalibrationRow& row, Column column) const;
    std::vector<CalibrationRow> m_rows;
};

} // namespace gripscope
