// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"

#include <QAbstractTableModel>

namespace gripscope {

/// A calibration that was stored, with what its points say; nothing where they say nothing.
struct CalibrationRow {
    CalibrationRecord record;
    std::optional<CalibrationEvaluation> evaluation;
};

/// The calibrations of the library, newest first.
class CalibrationListModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Column { Taken, Channel, Uncertainty, Due, Gripper, By };
    static constexpr int columns = 6;

    using QAbstractTableModel::QAbstractTableModel;

    void setRows(std::vector<CalibrationRow> rows);
    [[nodiscard]] const CalibrationRow& row(int index) const { return m_rows[std::size_t(index)]; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString text(const CalibrationRow& row, Column column) const;
    std::vector<CalibrationRow> m_rows;
};

} // namespace gripscope
