// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/overlay_plots.h"

#include "ui/charts/fit_plots.h"
#include "ui/format/channel_scale.h"
#include "ui/theme/theme.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using Channel = OverlaidSqueeze::Values OverlaidSqueeze::*;

double largestIn(const std::vector<OverlaidSqueeze>& squeezes, Channel channel)
{
    double largest = 0;
    for (const OverlaidSqueeze& squeeze : squeezes)
        for (const double value : *(squeeze.*channel))
            largest = std::max(largest, std::abs(value));
    return largest;
}

std::vector<PlotCurve> curvesOf(const std::vector<OverlaidSqueeze>& squeezes, Channel channel, double factor)
{
    std::vector<PlotCurve> curves;
    for (std::size_t i = 0; i < squeezes.size(); ++i) {
        auto shown = std::make_shared<std::vector<double>>(*(squeezes[i].*channel));
        for (double& value : *shown)
            value *= factor;
        PlotCurve curve;
        curve.x = squeezes[i].time_s;
        curve.y = std::move(shown);
        curve.held = channel == &OverlaidSqueeze::force && squeezes[i].held;
        curve.place = int(i);
        curves.push_back(std::move(curve));
    }
    return curves;
}

} // namespace

OverlayPlots::OverlayPlots(QWidget* parent)
    : PlotStack(parent), m_position(new TimePlot), m_force(new TimePlot)
{
    setExportNames(tr("Squeezes over each other"), u"overlay"_s);
    add(m_position, 60);
    add(m_force, 40);
    m_position->setTitle(tr("Position"));
    m_force->setTitle(tr("Force"));
    m_force->setHorizontalTitle(tr("Time (s)"));
    for (TimePlot* from : {m_position, m_force}) {
        TimePlot* to = from == m_position ? m_force : m_position;
        connect(from, &PlotFrame::horizontalChanged, to, [to](PlotRange range) { to->setHorizontal(range); });
        connect(from, &PlotFrame::wholeAsked, this, [this] {
            m_position->fitVertical();
            m_force->fitVertical();
        });
    }
    connect(&Theme::instance(), &Theme::changed, this, [this] { refreshLegend(); });
}

void OverlayPlots::setSqueezes(std::vector<OverlaidSqueeze> squeezes)
{
    std::erase_if(squeezes, [](const OverlaidSqueeze& one) { return !one.time_s || one.time_s->empty(); });
    if (!squeezes.empty())
        std::erase_if(squeezes, [force = squeezes.front().forceUnit,
                                 position = squeezes.front().positionUnit](const OverlaidSqueeze& one) {
            return one.forceUnit != force || one.positionUnit != position;
        });
    squeezes.resize(std::min(squeezes.size(), most));
    m_squeezes = std::move(squeezes);
    showCurves();
    refreshLegend();
}

void OverlayPlots::showCurves()
{
    double end = 0;
    for (const OverlaidSqueeze& squeeze : m_squeezes)
        end = std::max(end, squeeze.time_s->back());
    const OverlaidSqueeze first = m_squeezes.empty() ? OverlaidSqueeze() : m_squeezes.front();
    const ChannelScale position =
        channelScale(first.positionUnit, largestIn(m_squeezes, &OverlaidSqueeze::position));
    const ChannelScale force = channelScale(first.forceUnit, largestIn(m_squeezes, &OverlaidSqueeze::force));
    m_position->setTitle(position.title(tr("Position")));
    m_force->setTitle(force.title(tr("Force")));
    m_position->setCurves(curvesOf(m_squeezes, &OverlaidSqueeze::position, position.factor));
    m_force->setCurves(curvesOf(m_squeezes, &OverlaidSqueeze::force, force.factor));
    for (TimePlot* plot : {m_position, m_force}) {
        plot->setDuration(end);
        plot->fitVertical();
    }
}

void OverlayPlots::refreshLegend()
{
    std::vector<FigureSign> signs;
    for (std::size_t i = 0; i < m_squeezes.size(); ++i)
        signs.push_back({m_squeezes[i].name, placePen(int(i))});
    setLegend(std::move(signs));
}

PlotTable OverlayPlots::numbers() const
{
    PlotTable table;
    for (const OverlaidSqueeze& squeeze : m_squeezes) {
        const auto add = [&](const QString& what, const OverlaidSqueeze::Values& values) {
            table.push_back({u"%1: %2"_s.arg(squeeze.name, what), values});
        };
        const auto titled = [](const QString& name, const QString& unit) {
            return unit == u"1" ? name : u"%1 (%2)"_s.arg(name, unit);
        };
        add(tr("Time (s)"), squeeze.time_s);
        add(titled(tr("Force"), squeeze.forceUnit), squeeze.force);
        add(titled(tr("Position"), squeeze.positionUnit), squeeze.position);
    }
    return table;
}

} // namespace gripscope
