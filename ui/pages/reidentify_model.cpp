// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/reidentify_model.h"

#include "ui/models/estimate_words.h"
#include "ui/models/history_words.h"
#include "ui/widgets/number_format.h"
#include "ui/widgets/parameter_text.h"

namespace gripscope {

using namespace Qt::StringLiterals;
using Column = ReidentifyModel::Column;

namespace {

const QString dash(QChar(0x2013));

double component(const MassDampingStiffness& p, Column column)
{
    return column == Column::Mass ? p.m : column == Column::Damping ? p.b : p.k;
}

FormattedNumber component(const ParameterTexts& texts, Column column)
{
    return column == Column::Mass ? texts.m : column == Column::Damping ? texts.b : texts.k;
}

/// Of what was found from what is stored, relative.
std::optional<double> deviation(const ReidentifiedSqueeze& row, Column column)
{
    const auto& before = row.entry.parameters;
    if (!before || !row.estimate || !row.estimate->parameters || component(*before, column) == 0)
        return {};
    return component(*row.estimate->parameters, column) / component(*before, column) - 1;
}

/// "9.98 → 9.91 kN/m", the deviation below.
QString parameterText(const ReidentifiedSqueeze& row, Column column)
{
    const HistoryEntry& entry = row.entry;
    if (!row.estimate || !row.estimate->parameters)
        return column == Column::Mass ? row.trouble : QString();
    const QString now =
        component(parameterTexts(*row.estimate, entry.forceUnit, entry.positionUnit), column).text();
    if (!entry.parameters)
        return now;
    const QString before = component(parameterTexts(*entry.parameters, entry.standardErrors, entry.forceUnit,
                                                    entry.positionUnit),
                                     column)
                               .text();
    const std::optional<double> share = deviation(row, column);
    return u"%1\n%2 (%3)"_s.arg(before, now, share ? deviationText(*share) : dash);
}

} // namespace

void ReidentifyModel::clear()
{
    beginResetModel();
    m_rows.clear();
    endResetModel();
}

void ReidentifyModel::append(const ReidentifiedSqueeze& squeeze)
{
    const int row = int(m_rows.size());
    beginInsertRows({}, row, row);
    m_rows.push_back(squeeze);
    endInsertRows();
}

QString ReidentifyModel::text(const ReidentifiedSqueeze& row, Column column)
{
    const auto fit = [](const std::optional<double>& percent) {
        return percent ? formatPercent(*percent) : dash;
    };
    switch (column) {
    case Column::Squeeze:
        return HistoryWords::title(row.entry);
    case Column::Fit:
        return u"%1\n%2"_s.arg(fit(row.entry.simulationFitPercent),
                               fit(row.estimate ? row.estimate->fit.simulationPercent : std::nullopt));
    case Column::Mass:
    case Column::Damping:
    case Column::Stiffness:
        break;
    }
    return parameterText(row, column);
}

QVariant ReidentifyModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const ReidentifiedSqueeze& row = m_rows[std::size_t(index.row())];
    const auto column = Column(index.column());
    switch (role) {
    case Qt::DisplayRole:
        return text(row, column);
    case Qt::EditRole: {
        const std::optional<double> share =
            column == Column::Squeeze || column == Column::Fit ? std::nullopt : deviation(row, column);
        return share ? QVariant(*share) : QVariant();
    }
    case Qt::ToolTipRole:
        return row.trouble;
    default:
        return {};
    }
}

QVariant ReidentifyModel::head(int column, int role) const
{
    if (role != Qt::DisplayRole)
        return {};
    switch (Column(column)) {
    case Column::Squeeze:
        return tr("Squeeze");
    case Column::Mass:
        return tr("m: stored, now");
    case Column::Damping:
        return tr("b: stored, now");
    case Column::Stiffness:
        return tr("k: stored, now");
    case Column::Fit:
        return tr("Fit");
    }
    return {};
}

} // namespace gripscope
