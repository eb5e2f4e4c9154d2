// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/calibration_record.h"
#include "core/calibration/reference_check.h"
#include "core/session/calibrate/calibrate_session.h"
#include "ui/format/channel_scale.h"
#include "ui/models/row_table_model.h"

#include <vector>

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

/// The points of a calibration, taken ones first, then those to come: load, way, reading, what is left.
class CalibrationPointsModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Number, Load, Way, Reading, Residual, Remark };
    static constexpr int columns = 6;

    using RowTableModel::RowTableModel;

    void setPoints(const QString& unit, std::vector<PlannedPoint> planned, std::vector<TakenPoint> taken,
                   std::vector<double> residuals, double expandedUncertainty = 0);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;

private:
    [[nodiscard]] int length() const override { return int(m_planned.size()); }
    [[nodiscard]] int width() const override { return columns; }
    [[nodiscard]] QVariant head(int column, int role) const override;

    [[nodiscard]] QString text(int row, Column column) const;

    ChannelScale m_loads, m_rest;
    int m_decimals = 3;
    std::vector<PlannedPoint> m_planned;
    std::vector<TakenPoint> m_taken;
    std::vector<double> m_residuals;
};

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
