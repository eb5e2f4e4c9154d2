// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/calibrate_session.h"
#include "ui/charts/channel_scale.h"

#include <QAbstractTableModel>

namespace gripscope {

/// The points of a calibration, taken ones first, then those to come: load, way, reading, what is left.
class CalibrationPointsModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum class Column { Number, Load, Way, Reading, Residual, Remark };
    static constexpr int columns = 6;

    using QAbstractTableModel::QAbstractTableModel;

    void setPoints(const QString& unit, std::vector<PlannedPoint> planned, std::vector<TakenPoint> taken,
                   std::vector<double> residuals);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    [[nodiscard]] QString text(int row, Column column) const;

    ChannelScale m_loads, m_rest;
    int m_decimals = 3;
    std::vector<PlannedPoint> m_planned;
    std::vector<TakenPoint> m_taken;
    std::vector<double> m_residuals;
};

} // namespace gripscope
