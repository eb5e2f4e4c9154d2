// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/calibration_models.h"

#include "ui/format/calibration_words.h"
#include "ui/format/date_text.h"
#include "ui/format/number_format.h"
#include "ui/format/reference_words.h"
#include "ui/theme/theme.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

void CalibrationListModel::setRows(std::vector<CalibrationRow> rows)
{
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

QString CalibrationListModel::text(const CalibrationRow& row, Column column) const
{
    const CalibrationRecord& record = row.record;
    switch (column) {
    case Column::Taken:
        return dateText(record.takenUtc);
    case Column::Channel:
        return CalibrationWords::channel(record.channel);
    case Column::Gripper:
        return record.gripperSerial;
    case Column::Uncertainty:
        return row.evaluation
                   ? u"± "_s +
                         formatNumber(row.evaluation->expandedUncertainty, {}, record.unit, 2).valueWithUnit()
                   : u"–"_s;
    case Column::Due:
        return dateText(record.due);
    case Column::By:
        return record.operatorName;
    }
    return {};
}

QVariant CalibrationListModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const CalibrationRow& row = m_rows[std::size_t(index.row())];
    const auto column = Column(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::ToolTipRole:
        return row.record.note.isEmpty() ? QVariant() : QVariant(row.record.note);
    case Qt::ForegroundRole:
        return column == Column::Due && row.record.due < QDate::currentDate()
                   ? QVariant(Theme::instance().tokens().notValid)
                   : QVariant();
    default:
        return {};
    }
}

QVariant CalibrationListModel::head(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[columns] = {tr("Taken"),       tr("Channel"), tr("Uncertainty"),
                                    tr("Holds until"), tr("Gripper"), tr("By")};
    return names[column];
}

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
                                       std::vector<TakenPoint> taken, std::vector<double> residuals,
                                       double expandedUncertainty)
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
    // As in the plot, which shows the uncertainty, too.
    m_rest = channelScale(unit, std::max(largestResidual, expandedUncertainty));
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

void ReferenceCheckModel::setChecks(std::vector<ReferenceCheckRecord> checks)
{
    beginResetModel();
    m_checks = std::move(checks);
    endResetModel();
}

std::optional<std::size_t> ReferenceCheckModel::parameterOf(Column column)
{
    switch (column) {
    case Column::Mass:
        return 0;
    case Column::Damping:
        return 1;
    case Column::Stiffness:
        return 2;
    default:
        return std::nullopt;
    }
}

bool ReferenceCheckModel::says(Column column) const
{
    const std::optional<std::size_t> parameter = parameterOf(column);
    return !parameter || std::any_of(m_checks.begin(), m_checks.end(), [&](const auto& check) {
        return check.reference.stated[*parameter].has_value();
    });
}

QString ReferenceCheckModel::text(const ReferenceCheckRecord& check, Column column) const
{
    switch (column) {
    case Column::Made:
        return timeText(check.made);
    case Column::Verdict:
        return ReferenceWords::verdict(check.verdict);
    case Column::By:
        return check.operatorName;
    default:
        return ReferenceWords::error(check, *parameterOf(column));
    }
}

QVariant ReferenceCheckModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const ReferenceCheckRecord& check = m_checks[std::size_t(index.row())];
    const auto column = Column(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return text(check, column);
    case Qt::ToolTipRole:
        return ReferenceWords::outcome(check);
    case Qt::ForegroundRole:
        return column == Column::Verdict && check.verdict != CheckVerdict::Passed
                   ? QVariant(Theme::instance().tokens().notValid)
                   : QVariant();
    default:
        return {};
    }
}

QVariant ReferenceCheckModel::head(int column, int role) const
{
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    const QString names[columns] = {tr("Made"),     tr("Verdict"),  tr("k, error"),
                                    tr("b, error"), tr("m, error"), tr("By")};
    return names[column];
}

} // namespace gripscope
