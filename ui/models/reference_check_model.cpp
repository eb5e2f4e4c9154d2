// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/reference_check_model.h"

#include "ui/models/reference_words.h"
#include "ui/theme/theme.h"
#include "ui/widgets/date_text.h"

#include <algorithm>

namespace gripscope {

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
