// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/quality/shift/drift_charts.h"

#include "ui/pages/quality/shift/shift_words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr std::array<std::size_t, 3> shownOrder{2, 1, 0}; // k first: it is known best

std::vector<IntervalChart::Item> itemsOf(const LogVector& log, const LogMatrix& covariance)
{
    std::vector<IntervalChart::Item> items;
    for (const std::size_t quantity : shownOrder) {
        const auto i = Eigen::Index(quantity);
        if (i >= log.size())
            return {};
        const PercentInterval interval = percentIntervalOf(log(i), std::sqrt(covariance(i, i)));
        items.push_back({interval.value, interval.low, interval.high});
    }
    return items;
}

/// Of one squeeze, in percent; nothing where it does not determine the quantity.
std::optional<double> percentOff(const TypeModels& models, const TypeSqueeze& squeeze, std::size_t quantity)
{
    const TypeModel* const type = models.find(squeeze.type);
    const Eigen::Vector3d values = squeeze.parameters.vector();
    const double value = values(Eigen::Index(quantity));
    if (type == nullptr || models.space != QuantitySpace{} || !(value > 0) || !std::isfinite(value))
        return {};
    return 100 * std::expm1(std::log(value) - type->meanLog(Eigen::Index(quantity)));
}

} // namespace

IntervalChart DriftCharts::shifts(const DriftLook& look, const QMap<QString, int>& places)
{
    IntervalChart chart;
    chart.title = tr("Since the enrolment, the last squeezes of each type (change, 95 %)");
    chart.fileName = u"drift_shifts"_s;
    chart.empty = tr("No type has three squeezes since its enrolment.");
    for (const std::size_t quantity : shownOrder)
        chart.panels.push_back({tr("%1 (%)").arg(ShiftWords::quantity(quantity))});
    for (const TypeDrift& type : look.report.types)
        if (type.shift)
            chart.rows.push_back({type.type, places.value(type.type), false,
                                  itemsOf(type.shift->log, type.shift->covariance)});
    if (look.report.factor && chart.rows.size() > 1)
        chart.rows.push_back({tr("All together"), 0, true,
                              itemsOf(look.report.factor->value, look.report.factor->covariance)});
    return chart;
}

CourseChart DriftCharts::course(const DriftLook& look, std::size_t quantity, const QMap<QString, int>& places)
{
    CourseChart chart;
    chart.title = tr("%1, squeeze by squeeze (% from the enrolment)").arg(ShiftWords::quantity(quantity));
    chart.fileName = u"drift_course"_s;
    chart.axisTitle = tr("Inspection");
    chart.empty = tr("No inspected squeeze of an approved type.");
    std::vector<int> shownBefore{0}; // of so many squeezes, so many are shown
    QStringList types;
    for (std::size_t i = 0; i < look.inspected.squeezes.size(); ++i) {
        const TypeSqueeze& squeeze = look.inspected.squeezes[i];
        if (const std::optional<double> percent = percentOff(look.models, squeeze, quantity)) {
            chart.points.push_back({*percent, places.value(squeeze.type)});
            chart.names << QString::number(look.inspected.origins[i].number);
            if (!types.contains(squeeze.type))
                types << squeeze.type;
        }
        shownBefore.push_back(int(chart.points.size()));
    }
    types.sort();
    for (const QString& type : types)
        chart.legend.push_back({type, places.value(type)});
    const std::optional<ChangePoint>& change = look.change;
    if (!change || change->shift.size() != 3)
        return chart;
    const auto i = Eigen::Index(quantity);
    const PercentInterval now = percentIntervalOf(change->shift(i), std::sqrt(change->covariance(i, i)));
    const auto at = [&](int before) { return shownBefore[std::size_t(before)]; };
    chart.change =
        CourseChart::Change{at(change->before),
                            at(change->earliest),
                            at(change->latest),
                            now.value,
                            now.low,
                            now.high,
                            tr("since %1").arg(look.inspected.origins[std::size_t(change->before)].number)};
    return chart;
}

IntervalChart DriftCharts::adjustment(const TransferLook& look, const QMap<QString, int>& places)
{
    IntervalChart chart;
    chart.title = tr("This gripper against the enrolment: as measured, and adjusted (95 %)");
    chart.fileName = u"transfer"_s;
    chart.empty = tr("No squeeze yet.");
    for (const std::size_t quantity : shownOrder)
        chart.panels.push_back({tr("%1 (%)").arg(ShiftWords::quantity(quantity))});
    for (const TypeShift& type : look.report.types) {
        chart.rows.push_back({tr("%1, as measured").arg(type.type), places.value(type.type), false,
                              itemsOf(type.log, type.covariance)});
        const auto left = std::ranges::find(look.residuals, type.type, &TransferResidual::type);
        if (left != look.residuals.end())
            chart.rows.push_back({tr("%1, adjusted").arg(type.type), places.value(type.type), false,
                                  itemsOf(left->log, left->covariance)});
    }
    if (look.report.error)
        chart.rows.push_back({tr("The adjustment"), 0, true,
                              itemsOf(look.report.error->value, look.report.error->covariance)});
    return chart;
}

} // namespace gripscope
