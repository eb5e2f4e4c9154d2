// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/control_series.h"

#include "core/session/process/process_words.h"
#include "ui/format/reference_words.h"

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

bool holdsRanges(ProcessKind kind)
{
    return kind == ProcessKind::MeanRange;
}

} // namespace

ShownUnit ControlSeries::unitOf(const ProcessValues& values, std::size_t quantity, double largest)
{
    return shownUnit(values.si ? ReferenceWords::unit(quantity) : u"1"_s, std::abs(largest));
}

ControlSeries::ControlSeries(const ProcessPicture& picture, const ControlPanel& panel)
    : m_picture(&picture), m_panel(panel)
{
    if (panel.what == ControlPanel::What::Joint) {
        if (!picture.joint || !*picture.joint)
            return;
        m_joint = &**picture.joint;
        m_points = m_joint->points.size();
        m_unit.factor = 1;
        return;
    }
    if (!picture.charts[panel.quantity])
        return;
    m_chart = &*picture.charts[panel.quantity];
    const ChartSetting& setting = m_chart->study.setting;
    m_unit = unitOf(*picture.values, panel.quantity, setting.centre);
    m_sums = setting.kind == ChartKind::Cusum;
    if (panel.what == ControlPanel::What::Spread) {
        m_points = m_chart->study.spreadPoints.size();
        return;
    }
    m_points = m_chart->points();
    m_centre = m_sums ? 0 : m_unit.factor * setting.centre;
}

const ChartPoint* ControlSeries::point(std::size_t place) const
{
    if (m_panel.what == ControlPanel::What::Spread) {
        const auto& spread = m_chart->study.spreadPoints[place];
        return spread ? &*spread : nullptr;
    }
    return &m_chart->study.points[place];
}

std::optional<double> ControlSeries::value(std::size_t place) const
{
    if (m_joint != nullptr)
        return m_joint->points[place].tSquared;
    const ChartPoint* const found = point(place);
    if (found == nullptr)
        return {};
    return m_unit.factor * (m_sums ? found->upperSum : found->value);
}

std::optional<double> ControlSeries::second(std::size_t place) const
{
    if (!m_sums || m_panel.what != ControlPanel::What::Location)
        return {};
    return -m_unit.factor * m_chart->study.points[place].lowerSum;
}

double ControlSeries::lower(std::size_t place) const
{
    const ChartPoint* const found = m_joint != nullptr ? nullptr : point(place);
    return found != nullptr ? m_unit.factor * found->lower : 0;
}

double ControlSeries::upper(std::size_t place) const
{
    if (m_joint != nullptr)
        return m_joint->points[place].upper;
    const ChartPoint* const found = point(place);
    return found != nullptr ? m_unit.factor * found->upper
                            : m_unit.factor * m_chart->study.points[place].upper;
}

bool ControlSeries::signal(std::size_t place) const
{
    if (m_joint != nullptr)
        return m_joint->points[place].signal();
    const ChartPoint* const found = point(place);
    return found != nullptr && found->rules != 0;
}

std::uint32_t ControlSeries::row(std::size_t place) const
{
    return m_joint != nullptr ? m_joint->rows[place] : m_chart->row(place);
}

qint64 ControlSeries::number(std::size_t place) const
{
    return m_picture->values->numbers[row(place)];
}

bool ControlSeries::limitsAreLevel() const
{
    return m_joint != nullptr || m_chart->study.setting.kind != ChartKind::Ewma;
}

QString ControlSeries::title() const
{
    if (m_panel.what == ControlPanel::What::Joint)
        return tr("T² of m, b and k together");
    const QString symbol = processSymbol(m_panel.quantity);
    QString name = ReferenceWords::quantity(m_panel.quantity);
    const ProcessKind kind = m_picture->options.kind;
    if (m_panel.what == ControlPanel::What::Spread)
        name = kind == ProcessKind::Individuals ? tr("Moving range of %1").arg(symbol)
               : holdsRanges(kind)              ? tr("Range of %1").arg(symbol)
                                                : tr("Standard deviation of %1").arg(symbol);
    else if (kind == ProcessKind::Ewma)
        name = tr("Moving average of %1").arg(symbol);
    else if (kind == ProcessKind::Cusum)
        name = tr("Sums of %1").arg(symbol);
    else if (takesSubgroups(kind))
        name = tr("Mean of %1").arg(symbol);
    return m_unit.unit.isEmpty() ? name : u"%1 (%2)"_s.arg(name, m_unit.unit);
}

void ControlSeries::addPoint(Span& span, std::size_t place) const
{
    span.signal = span.signal || signal(place);
    for (const std::optional<double>& one : {value(place), second(place)}) {
        if (!one)
            continue;
        span.low = span.any ? std::min(span.low, *one) : *one;
        span.high = span.any ? std::max(span.high, *one) : *one;
        span.any = true;
    }
}

void ControlSeries::addBlock(Span& span, const PointBlock& block) const
{
    const double origin = m_joint != nullptr ? m_joint->blocks.origin : m_chart->blocks.origin;
    const double low = m_unit.factor * (origin + double(block.low));
    const double high = m_unit.factor * (origin + double(block.high));
    span.signal = span.signal || block.signal;
    span.low = span.any ? std::min(span.low, low) : low;
    span.high = span.any ? std::max(span.high, high) : high;
    span.any = true;
}

ControlSeries::Span ControlSeries::span(std::size_t first, std::size_t last) const
{
    Span found;
    const bool blocks = m_panel.what != ControlPanel::What::Spread;
    for (std::size_t place = first; place < last;) {
        if (blocks && place % PointBlocks::size == 0 && place + PointBlocks::size <= last) {
            const auto& all = m_joint != nullptr ? m_joint->blocks.blocks : m_chart->blocks.blocks;
            addBlock(found, all[place / PointBlocks::size]);
            place += PointBlocks::size;
        } else {
            addPoint(found, place++);
        }
    }
    return found;
}

} // namespace gripscope
