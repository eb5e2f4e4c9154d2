// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/estimate_table_model.h"

#include "core/signal/units.h"
#include "ui/charts/fit_plots.h"
#include "ui/models/estimate_words.h"
#include "ui/models/shown_unit.h"
#include "ui/widgets/number_format.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double quantile975 = 1.959963984540054; // half a 95 % interval in standard errors

QVariant optionalNumber(const std::optional<double>& value)
{
    return value ? QVariant(*value) : QVariant();
}

int parameterOf(EstimateTableModel::Column column)
{
    return int(column) - int(EstimateTableModel::Column::Mass);
}

bool isParameter(EstimateTableModel::Column column)
{
    return column >= EstimateTableModel::Column::Mass && column <= EstimateTableModel::Column::Stiffness;
}

/// From the channels' units to SI: force over position cubed.
std::optional<double> cubicFactor(const QString& forceUnit, const QString& positionUnit)
{
    const std::optional<double> newtons = newtonsPer(forceUnit), metres = metresPer(positionUnit);
    return newtons && metres ? std::optional(*newtons / (*metres * *metres * *metres)) : std::nullopt;
}

QString cubicUnit(const QString& forceUnit, const QString& positionUnit)
{
    if (cubicFactor(forceUnit, positionUnit))
        return u"N/m\u00B3"_s;
    return forceUnit == u"1" && positionUnit == u"1" ? u"1"_s : u"%1/%2\u00B3"_s.arg(forceUnit, positionUnit);
}

} // namespace

void EstimateTableModel::setIdentification(const Identification& identification, const QString& forceUnit,
                                           const QString& positionUnit)
{
    beginResetModel();
    m_rows.clear();
    const std::optional<double> si = siFactor(forceUnit, positionUnit);
    const ParameterUnits units =
        si ? parameterUnits(u"N"_s, u"m"_s) : parameterUnits(forceUnit, positionUnit);
    m_units = {units.m, units.b, units.k};
    m_cubicUnit = cubicUnit(forceUnit, positionUnit);
    const double cubic = cubicFactor(forceUnit, positionUnit).value_or(1);
    for (const Estimate& estimate : identification.estimates) {
        Row row{estimate.estimator, estimateVerdict(identification, estimate), {}, {}, {}, estimate.fit};
        if (estimate.parameters)
            row.parameters = estimate.parameters->vector() * si.value_or(1);
        if (const auto errors = estimate.standardErrors(); errors && estimate.parameters)
            row.halfWidths = *errors * (quantile975 * si.value_or(1));
        if (estimate.cubic && estimate.parameters)
            row.cubic =
                std::pair(estimate.cubic->k3 * cubic,
                          quantile975 * cubic * std::sqrt(std::max(0.0, estimate.cubic->covariance(3, 3))));
        m_rows.push_back(std::move(row));
    }
    // The recommended estimate chooses the prefix: a wild one beside it must not.
    const Estimate* best = identification.best();
    for (int i = 0; i < 3; ++i) {
        const double largest = best && best->parameters ? best->parameters->vector()[i] * si.value_or(1) : 0;
        const ShownUnit shown = shownUnit(m_units[std::size_t(i)], largest);
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
        return row.parameters ? QVariant((*row.parameters)[i] * m_factors[i]) : QVariant();
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

QVariant EstimateTableModel::cubicText(const Row& row) const
{
    if (!row.cubic)
        return {};
    const auto [k3, half] = *row.cubic;
    // A can's k3, or the error of one that has none, runs to billions of newtons a cubic metre.
    const bool perMillimetre = m_cubicUnit == u"N/m\u00B3" && std::max(std::abs(k3), half) >= 1e6;
    const double factor = perMillimetre ? 1e-9 : 1;
    const QString unit = perMillimetre ? u"N/mm\u00B3"_s : m_cubicUnit;
    return u"k3 = %1"_s.arg(formatNumber(k3 * factor, half * factor, unit).text());
}

QVariant EstimateTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= int(m_rows.size()))
        return {};
    const Row& row = m_rows[std::size_t(index.row())];
    const auto column = Column(index.column());
    if (role == HalfWidthRole) {
        if (!isParameter(column) || !row.halfWidths)
            return {};
        const int i = parameterOf(column);
        return (*row.halfWidths)[i] * m_factors[i];
    }
    if (role == CubicRole)
        return cubicText(row);
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

QString EstimateTableModel::toTsv() const
{
    const auto full = [](std::optional<double> value) {
        return value ? QString::number(*value, 'g', QLocale::FloatingPointShortest) : QString();
    };
    const auto at = [](const std::optional<Eigen::Vector3d>& values, int i) {
        return values ? std::optional((*values)[i]) : std::nullopt;
    };
    QStringList header{u"estimator"_s};
    for (const auto& [name, i] : {std::pair(u"m"_s, 0), std::pair(u"b"_s, 1), std::pair(u"k"_s, 2)}) {
        const QString unit =
            m_units[std::size_t(i)] == u"1" ? QString() : u" (%1)"_s.arg(m_units[std::size_t(i)]);
        header << name + unit << name + u" 95 % half width"_s + unit;
    }
    const QString unit = m_cubicUnit == u"1" ? QString() : u" (%1)"_s.arg(m_cubicUnit);
    header << u"simulation fit (%)"_s << u"prediction fit (%)"_s << u"verdict"_s << u"k3"_s + unit
           << u"k3 95 % half width"_s + unit;
    QString text = header.join(u'\t') + u'\n';
    for (const Row& row : m_rows) {
        QStringList cells{toString(row.estimator)};
        for (int i = 0; i < 3; ++i)
            cells << full(at(row.parameters, i)) << full(at(row.halfWidths, i));
        cells << full(row.fit.simulationPercent) << full(row.fit.predictionPercent) << row.verdict;
        cells << (row.cubic ? full(row.cubic->first) : QString())
              << (row.cubic ? full(row.cubic->second) : QString());
        text += cells.join(u'\t') + u'\n';
    }
    return text;
}

} // namespace gripscope
