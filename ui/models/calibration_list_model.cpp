// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/calibration_list_model.h"

#include "ui/models/calibration_words.h"
#include "ui/theme/theme.h"
#include "ui/widgets/date_text.h"
#include "ui/widgets/number_format.h"

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

} // namespace gripscope
