// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/calibration_points_model.h"

#include "ui/theme/theme.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

QString number(double value, int decimals)
{
    return QLocale().toString(value, 'f', decimals).replace(u'-', QChar(0x2212));
}

Qt::Alignment alignment(CalibrationPointsModel::Column column)
{
    using Column = CalibrationPointsModel::Column;
    return (column == Column::Way || column == Column::Remark ? Qt::AlignLeft : Qt::AlignRight) |
           Qt::AlignVCenter;
}

} // namespace

void CalibrationPointsModel::setPoints(const QString& unit, std::vector<PlannedPoint> planned,
                                       std::vector<TakenPoint> taken, std::vector<double> residuals)
{
    beginResetModel();
    m_planned = std::move(planned);
    m_taken = std::move(taken);
    m_residuals = std::move(residuals);
    double largestLoad = 0;
    double largestResidual = 0;
    for (const PlannedPoint& point : m_planned)
        largestLoad = std::max(largestLoad, std::abs(point.load));
    for (const double residual : m_residuals)
        largestResidual = std::max(largestResidual, std::abs(residual));
    m_loads = channelScale(unit, largestLoad);
    m_rest = channelScale(unit, largestResidual);
    // Readings with a digit more than what is left of them.
    constexpr int usualDecimals = 3;
    m_decimals = largestResidual > 0
                     ? std::clamp(1 - int(std::floor(std::log10(m_loads.factor * largestResidual))), 0, 9)
                     : usualDecimals;
    endResetModel();
}

QString CalibrationPointsModel::text(int row, Column column) const
{
    const auto index = std::size_t(row);
    const PlannedPoint& point = m_planned[index];
    const TakenPoint* taken = index < m_taken.size() ? &m_taken[index] : nullptr;
    switch (column) {
    case Column::Number:
        return QString::number(row + 1);
    case Column::Load:
        return QLocale().toString(m_loads.factor * (taken ? taken->planned : point).load, 'g', 6);
    case Column::Way:
        return point.ascending ? tr("up") : tr("down");
    case Column::Reading:
        return taken ? number(m_loads.factor * taken->reading.mean, m_decimals) : QString();
    case Column::Residual:
        return index < m_residuals.size() ? number(m_rest.factor * m_residuals[index], 2) : QString();
    case Column::Remark:
        if (taken)
            return taken->doubt;
        return index == m_taken.size() ? tr("next") : QString();
    }
    return {};
}

QVariant CalibrationPointsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const auto column = Column(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return text(index.row(), column);
    case Qt::ToolTipRole:
        return column == Column::Remark ? text(index.row(), column) : QVariant();
    case Qt::TextAlignmentRole:
        return int(alignment(column));
    case Qt::ForegroundRole:
        if (std::size_t(index.row()) > m_taken.size())
            return Theme::instance().tokens().secondText;
        return column == Column::Remark && std::size_t(index.row()) < m_taken.size()
                   ? QVariant(Theme::instance().tokens().notValid)
                   : QVariant();
    default:
        return {};
    }
}

QVariant CalibrationPointsModel::head(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int(alignment(Column(column)));
    if (role != Qt::DisplayRole)
        return {};
    const QString names[columns] = {tr("No."),
                                    m_loads.title(tr("Load")),
                                    tr("Way"),
                                    m_loads.title(tr("Reading")),
                                    m_rest.title(tr("Residual")),
                                    tr("Remark")};
    return names[column];
}

} // namespace gripscope
