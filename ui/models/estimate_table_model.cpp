// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/estimate_table_model.h"

#include "core/base/csv.h"
#include "core/signal/recording/units.h"
#include "ui/format/determined_text.h"
#include "ui/format/estimate_words.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

int parameterOf(EstimateTableModel::Column column)
{
    return int(column) - int(EstimateTableModel::Column::Mass);
}

/// "Fc = 0.40 ± 0.02 N", "k at least 1.5 kN/m".
QString furtherLine(const DeterminedParameter& one)
{
    const QString text = determinedText(one);
    const bool isBound = one.isLowerBound || (one.interval && one.interval->onlyUpperBound);
    return isBound ? toString(one.parameter) + u' ' + text : u"%1 = %2"_s.arg(toString(one.parameter), text);
}

bool isParameter(EstimateTableModel::Column column)
{
    return column >= EstimateTableModel::Column::Mass && column <= EstimateTableModel::Column::Stiffness;
}

} // namespace

void EstimateTableModel::setIdentification(const Identification& identification, const QString& forceUnit,
                                           const QString& positionUnit)
{
    beginResetModel();
    m_rows.clear();
    const ParameterUnits units = comparableUnits(forceUnit, positionUnit);
    m_units = {units.m, units.b, units.k};
    // The recommended estimate chooses the prefix: a wild one beside it must not.
    std::array<double, 3> largest{};
    for (const Estimate& estimate : identification.estimates) {
        Row row{estimate.estimator, estimateVerdict(identification, estimate), {}, {}, {}, estimate.fit};
        for (DeterminedParameter& one : determinedParameters(estimate, forceUnit, positionUnit)) {
            const std::optional<std::size_t> i = linearPlaceOf(one.parameter);
            if (!i || one.isLowerBound) {
                row.further.push_back(std::move(one));
                continue;
            }
            row.parameters[*i] = one.value;
            if (one.interval)
                row.halfWidths[*i] = (one.interval->upper - one.interval->lower) / 2;
            if (estimate.estimator == identification.recommended)
                largest[*i] = one.value;
        }
        m_rows.push_back(std::move(row));
    }
    for (int i = 0; i < 3; ++i) {
        const ShownUnit shown = shownUnit(m_units[std::size_t(i)], largest[std::size_t(i)]);
        m_shownUnits[std::size_t(i)] = shown.unit;
        m_factors[i] = shown.factor;
    }
    endResetModel();
}

void EstimateTableModel::clear()
{
    beginResetModel();
    m_rows.clear();
    endResetModel();
}

std::optional<Estimator> EstimateTableModel::estimatorAt(int row) const
{
    if (row < 0 || row >= int(m_rows.size()))
        return std::nullopt;
    return m_rows[std::size_t(row)].estimator;
}

int EstimateTableModel::rowOf(Estimator estimator) const
{
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        if (m_rows[i].estimator == estimator)
            return int(i);
    return -1;
}

QVariant EstimateTableModel::number(const Row& row, Column column) const
{
    switch (column) {
    case Column::Mass:
    case Column::Damping:
    case Column::Stiffness: {
        const int i = parameterOf(column);
        const std::optional<double>& value = row.parameters[std::size_t(i)];
        return value ? QVariant(*value * m_factors[i]) : QVariant();
    }
    case Column::SimulationFit:
        return optionalNumber(row.fit.simulationPercent);
    case Column::PredictionFit:
        return optionalNumber(row.fit.predictionPercent);
    case Column::Estimator:
    case Column::Verdict:
        break;
    }
    return {};
}

QVariant EstimateTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= int(m_rows.size()))
        return {};
    const Row& row = m_rows[std::size_t(index.row())];
    const auto column = Column(index.column());
    if (role == HalfWidthRole) {
        const int i = parameterOf(column);
        const std::optional<double> half =
            isParameter(column) ? row.halfWidths[std::size_t(i)] : std::nullopt;
        return half ? QVariant(*half * m_factors[i]) : QVariant();
    }
    if (role == FurtherRole) {
        QStringList lines;
        for (const DeterminedParameter& one : row.further)
            lines << furtherLine(one);
        return lines.isEmpty() ? QVariant() : QVariant(lines);
    }
    if (role == Qt::ToolTipRole && column == Column::Estimator) // a narrow window cuts both
        return estimatorName(row.estimator) + u'\n' + row.verdict;
    if (role == Qt::ToolTipRole)
        return column == Column::Verdict ? row.verdict : QVariant();
    if (role != Qt::DisplayRole && role != Qt::EditRole && role != SortRole)
        return {};
    if (column == Column::Estimator)
        return estimatorName(row.estimator);
    if (column == Column::Verdict)
        return row.verdict;
    return number(row, column);
}

QVariant EstimateTableModel::head(int section, int role) const
{
    const auto column = Column(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            Qt::Alignment(Qt::AlignVCenter | (isParameter(column) || column == Column::SimulationFit ||
                                                      column == Column::PredictionFit
                                                  ? Qt::AlignRight
                                                  : Qt::AlignLeft)));
    if (role == Qt::ToolTipRole && column == Column::SimulationFit)
        return tr("Above: fit of the model running free from the start, 100 (1 - |y - model| / |y - mean|). "
                  "Below: fit one step ahead from measured positions; says little about m, b and k");
    if (role == Qt::ToolTipRole && column == Column::PredictionFit)
        return tr("Fit one step ahead from measured positions; says little about m, b and k");
    if (role != Qt::DisplayRole)
        return {};
    const auto withUnit = [this, column](const QString& name) {
        const QString& unit = m_shownUnits[std::size_t(parameterOf(column))];
        return unit.isEmpty() ? name : name + u'\n' + unit;
    };
    switch (column) {
    case Column::Estimator:
        return tr("Estimator");
    case Column::Mass:
        return withUnit(tr("m"));
    case Column::Damping:
        return withUnit(tr("b"));
    case Column::Stiffness:
        return withUnit(tr("k"));
    case Column::SimulationFit:
        return tr("sim. %\npred. %"); // one over the other, as the delegate writes them
    case Column::PredictionFit:
        return tr("pred. %");
    case Column::Verdict:
        return tr("Verdict");
    }
    return {};
}

std::vector<DeterminedParameter> EstimateTableModel::furtherColumns() const
{
    std::vector<DeterminedParameter> found;
    for (const Row& row : m_rows)
        for (const DeterminedParameter& one : row.further)
            if (std::ranges::find(found, one.parameter, &DeterminedParameter::parameter) == found.end())
                found.push_back(one);
    std::ranges::sort(found, {}, &DeterminedParameter::parameter);
    return found;
}

QString EstimateTableModel::toTsv() const
{
    const auto inUnit = [](const QString& unit) { return unit == u"1" ? QString() : u" (%1)"_s.arg(unit); };
    const std::vector<DeterminedParameter> further = furtherColumns();
    QStringList header{u"estimator"_s};
    for (const auto& [name, i] : {std::pair(u"m"_s, 0), std::pair(u"b"_s, 1), std::pair(u"k"_s, 2)}) {
        const QString unit = inUnit(m_units[std::size_t(i)]);
        header << name + unit << name + u" 95 % half width"_s + unit;
    }
    header << u"simulation fit (%)"_s << u"prediction fit (%)"_s << u"verdict"_s;
    for (const DeterminedParameter& column : further) {
        const QString name = toString(column.parameter) + (column.isLowerBound ? u" at least"_s : QString());
        header << name + inUnit(column.unit)
               << toString(column.parameter) + u" 95 % half width"_s + inUnit(column.unit);
    }
    QString text = header.join(u'\t') + u'\n';
    for (const Row& row : m_rows) {
        QStringList cells{toString(row.estimator)};
        for (std::size_t i = 0; i < row.parameters.size(); ++i)
            cells << exactText(row.parameters[i]) << exactText(row.halfWidths[i]);
        cells << exactText(row.fit.simulationPercent) << exactText(row.fit.predictionPercent) << row.verdict;
        for (const DeterminedParameter& column : further) {
            const auto found =
                std::ranges::find(row.further, column.parameter, &DeterminedParameter::parameter);
            const bool has = found != row.further.end();
            cells << (has ? exactText(found->value) : QString())
                  << (has && found->interval
                          ? exactText((found->interval->upper - found->interval->lower) / 2)
                          : QString());
        }
        text += cells.join(u'\t') + u'\n';
    }
    return text;
}

} // namespace gripscope
