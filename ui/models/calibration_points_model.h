// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/calibrate_session.h"
#include "ui/charts/channel_scale.h"
#include "ui/models/row_table_model.h"

namespace gripscope {

/// The points of a calibration, taken ones first, then those to come: load, way, reading, what is left.
class CalibrationPointsModel : public RowTableModel {
    Q_OBJECT
public:
    enum class Column { Number, Load, Way, Reading, Residual, Remark };
    static constexpr int columns = 6;

    using RowTableModel::RowTableModel;

    void setPoints(const QString& unit, std::vector<PlannedPoint> planned, std::vector<TakenPoint> taken,
                   std::vector<double> residuals);

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

} // namespace gripscope
