// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/models/estimate_table_model.h"

#include "core/base/csv.h"
#include "core/math/normal_interval.h"
#include "core/signal/recording/units.h"
#include "ui/format/estimate_words.h"
#include "ui/format/number_format.h"
#include "ui/format/shown_unit.h"
#include "ui/theme/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

int parameterOf(EstimateTableModel::Column column)
{
    return int(column) - int(EstimateTableModel::Column::Mass);
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
    const std::optional<double> si = siFactor(forceUnit, positionUnit);
    const ParameterUnits units = comparableUnits(forceUnit, positionUnit);
    m_units = {units.m, units.b, units.k};
    m_cubicUnit = cubicStiffnessUnit(forceUnit, positionUnit);
    const double cubic = cubicSiFactor(forceUnit, positionUnit).value_or(1);
    for (const Estimate& estimate : identification.estimates) {
        Row row{estimate.estimator, estimateVerdict(identification, estimate), {}, {}, {}, estimate.fit};
        if (estimate.parameters)
            row.parameters = estimate.parameters->vector() * si.value_or(1);
        if (const auto errors = estimate.standardErrors(); errors && estimate.parameters)
            row.halfWidths = *errors * (normal95 * si.value_or(1));
        const auto& motion = estimate.motion;
        if (const auto error = motion ? motion->standardError(MotionParameter::Cubic) : std::nullopt)
            row.cubic = std::pair(motion->values[MotionParameter::Cubic] * cubic, normal95 * cubic * *error);
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
    const ShownUnit shown = cubicShownUnit(m_cubicUnit, std::max(std::abs(k3), half));
    return u"k3 = %1"_s.arg(formatNumber(k3 * shown.factor, half * shown.factor, shown.unit).text());
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
            cells << exactText(at(row.parameters, i)) << exactText(at(row.halfWidths, i));
        cells << exactText(row.fit.simulationPercent) << exactText(row.fit.predictionPercent) << row.verdict;
        cells << (row.cubic ? exactText(row.cubic->first) : QString())
              << (row.cubic ? exactText(row.cubic->second) : QString());
        text += cells.join(u'\t') + u'\n';
    }
    return text;
}

using EstimateColumn = EstimateTableModel::Column;

namespace {
constexpr int estimateSide = 5; // the table stands in a third of the window

QString fitText(const QVariant& percent)
{
    return percent.isValid() ? formatNumber(percent.toDouble(), std::nullopt, {}, 3).value
                             : QString(QChar(0x2013));
}
} // namespace

EstimateDelegate::Lines EstimateDelegate::linesOf(const QModelIndex& index)
{
    const auto column = EstimateColumn(index.column());
    if (column == EstimateColumn::Estimator)
        return {index.data().toString(),
                index.siblingAtColumn(int(EstimateColumn::Verdict)).data().toString(),
                index.data(EstimateTableModel::CubicRole).toString()};
    if (column == EstimateColumn::Verdict)
        return {index.data().toString(), {}, {}};
    const QVariant value = index.data(EstimateTableModel::SortRole);
    if (!value.isValid())
        return {QString(QChar(0x2013)), {}, {}};
    if (column == EstimateColumn::SimulationFit)
        return {
            fitText(value), fitText(index.siblingAtColumn(int(EstimateColumn::PredictionFit)).data()), {}};
    const QVariant half = index.data(EstimateTableModel::HalfWidthRole);
    const FormattedNumber number =
        formatNumber(value.toDouble(), half.isValid() ? std::optional(half.toDouble()) : std::nullopt, {});
    return {number.value, number.error.isEmpty() ? QString() : QStringLiteral("± ") + number.error, {}};
}

QSize EstimateDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const
{
    const Lines lines = linesOf(index);
    const QFontMetrics first(Theme::font(metrics::fontBase)), second(Theme::font(metrics::fontSmall));
    const bool name = EstimateColumn(index.column()) == EstimateColumn::Estimator;
    const int width =
        name ? first.horizontalAdvance(lines.first)
             : std::max(first.horizontalAdvance(lines.first), second.horizontalAdvance(lines.second));
    const int smallLines = lines.third.isEmpty() ? 1 : 2;
    return {width + 2 * estimateSide, first.height() + smallLines * second.height() + 10};
}

void EstimateDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    const bool selected = option.state & QStyle::State_Selected;
    painter->save();
    painter->fillRect(option.rect,
                      selected ? Theme::mix(tokens.surface, tokens.accent, 0.12) : tokens.surface);
    painter->setPen(QPen(tokens.line, 1));
    painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
    const Lines lines = linesOf(index);
    const QRect box = option.rect.adjusted(estimateSide, 4, -estimateSide, -4);
    const bool text = EstimateColumn(index.column()) == EstimateColumn::Estimator ||
                      EstimateColumn(index.column()) == EstimateColumn::Verdict;
    const Qt::Alignment align = text ? Qt::AlignLeft : Qt::AlignRight;
    int y = box.top();
    const auto draw = [&](const QString& line, const QFont& font, const QColor& color) {
        const QFontMetrics measures(font);
        painter->setFont(font);
        painter->setPen(color);
        painter->drawText(QRect(box.left(), y, box.width(), measures.height()), int(align | Qt::AlignVCenter),
                          measures.elidedText(line, Qt::ElideRight, box.width()));
        y += measures.height();
    };
    const QFont small = Theme::font(metrics::fontSmall);
    draw(lines.first, Theme::font(metrics::fontBase), tokens.text);
    draw(lines.second, small, tokens.secondText);
    draw(lines.third, small, tokens.secondText);
    painter->restore();
}

} // namespace gripscope
