// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/fit_plots.h"

#include "ui/charts/channel_curve.h"
#include "ui/format/estimate_words.h"
#include "ui/format/residual_words.h"
#include "ui/theme/theme.h"

#include <QGridLayout>
#include <QLineSeries>
#include <QScatterSeries>

#include <algorithm>
#include <cmath>

namespace gripscope {

namespace {

using Values = std::vector<double>;
using SharedValues = std::shared_ptr<const Values>;

SharedValues shifted(const Values& values, double by)
{
    auto result = std::make_shared<Values>(values);
    for (double& value : *result)
        value -= by;
    return result;
}

double standardDeviation(const Values& values)
{
    if (values.size() < 2)
        return 0;
    double mean = 0;
    for (const double value : values)
        mean += value / double(values.size());
    double sum = 0;
    for (const double value : values)
        sum += (value - mean) * (value - mean);
    return std::sqrt(sum / double(values.size() - 1));
}

double largest(const Values& values)
{
    double result = 0;
    for (const double value : values)
        result = std::max(result, std::abs(value));
    return result;
}

/// The last `count` of `values`: residuals of an ARX model start where its first prediction does.
Values tail(const Values& values, std::size_t count)
{
    const std::size_t n = std::min(count, values.size());
    return {values.end() - std::ptrdiff_t(n), values.end()};
}

Values partOf(const Values& values, Window part)
{
    const std::size_t first = std::min(part.first, values.size());
    const std::size_t end = std::min(part.first + part.count, values.size());
    return {values.begin() + std::ptrdiff_t(first), values.begin() + std::ptrdiff_t(end)};
}

} // namespace

FitPlots::FitPlots(QWidget* parent)
    : QWidget(parent), m_response(new TimePlot), m_force(new TimePlot), m_residuals(new TimePlot),
      m_auto(new CorrelationPlot), m_cross(new CorrelationPlot)
{
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(0);
    grid->addWidget(m_response, 0, 0, 1, 2);
    grid->addWidget(m_force, 1, 0, 1, 2);
    grid->addWidget(m_residuals, 2, 0, 1, 2);
    grid->addWidget(m_auto, 3, 0);
    grid->addWidget(m_cross, 3, 1);
    m_response->setMinimumHeight(116);
    m_force->setMinimumHeight(92);
    m_residuals->setMinimumHeight(104);
    m_auto->setMinimumHeight(112);
    const int stretches[] = {40, 18, 26, 26};
    for (int row = 0; row < 4; ++row)
        grid->setRowStretch(row, stretches[row]);
    m_residuals->setHorizontalTitle(tr("Time (s)"));
    m_auto->setHorizontalTitle(tr("Lag (ms)"));
    m_cross->setHorizontalTitle(tr("Lag (ms)"));
    m_auto->setTitle(tr("Residual autocorrelation"), tr("Autocorrelation"));
    m_cross->setTitle(tr("Residuals against force"), tr("Against force"));
    m_response->setExportNames(tr("Position"), QStringLiteral("position"), tr("Time (s)"));
    m_force->setExportNames(tr("Force"), QStringLiteral("force"), tr("Time (s)"));
    m_residuals->setExportNames(tr("Residuals"), QStringLiteral("residuals"));
    m_auto->setExportNames(tr("Residual autocorrelation"), QStringLiteral("autocorrelation"));
    m_cross->setExportNames(tr("Residuals against force"), QStringLiteral("cross-correlation"));
    linkTime();
    clear();
}

void FitPlots::linkTime()
{
    const auto plots = {m_response, m_force, m_residuals};
    for (TimePlot* from : plots) {
        for (TimePlot* to : plots) {
            if (from == to)
                continue;
            connect(from, &PlotFrame::horizontalChanged, to,
                    [to](PlotRange range) { to->setHorizontal(range); });
            connect(from, &PlotFrame::wholeAsked, to, [to] { to->fitVertical(); });
        }
        connect(from, &PlotFrame::wholeAsked, from, [from] { from->fitVertical(); });
    }
}

void FitPlots::clear()
{
    m_response->setTitle(tr("Position"));
    m_force->setTitle(tr("Force"));
    m_residuals->setTitle(tr("Residuals"));
    for (TimePlot* plot : {m_response, m_force, m_residuals}) {
        plot->setCurves({});
        plot->setBand(std::nullopt);
    }
    for (CorrelationPlot* plot : {m_auto, m_cross}) {
        plot->setCorrelation({});
        plot->setFinding({});
    }
}

void FitPlots::show(const Identification& identification, Estimator estimator, const QString& forceUnit,
                    const QString& positionUnit)
{
    if (identification.time_s.empty()) {
        clear();
        return;
    }
    const Estimate* estimate = identification.find(estimator);
    const Window part = estimate ? estimate->part : Window();
    const bool modelled = estimate && !estimate->simulated.empty() &&
                          estimate->simulated.size() == part.count &&
                          part.first + part.count <= identification.position.size();
    const ChannelScales position(positionUnit, largest(identification.position));
    const ChannelScales force(forceUnit, largest(identification.force));
    const SharedValues time = shifted(identification.time_s, identification.time_s.front());

    const auto missing = std::make_shared<const std::vector<std::size_t>>(identification.lost);
    std::vector<PlotCurve> curves{channelCurve(tr("measured"), CurveRole::MeasuredPosition, time,
                                               identification.position, position, tr("Measured position"))};
    curves.front().missing = missing;
    if (modelled)
        curves.push_back(channelCurve(tr("model, %1").arg(estimatorName(estimator)), CurveRole::Model,
                                      std::make_shared<Values>(partOf(*time, part)), estimate->simulated,
                                      position, tr("Model, %1").arg(estimatorName(estimator))));
    m_response->setTitle(position.shown.title(tr("Position")));
    m_response->setCurves(std::move(curves));
    m_force->setTitle(force.shown.title(tr("Force")));
    PlotCurve forces =
        channelCurve(QString(), CurveRole::Force, time, identification.force, force, tr("Force"));
    forces.missing = missing;
    forces.held = identification.hold == ForceHold::Zero;
    m_force->setCurves({std::move(forces)});

    const Values residual = estimate ? estimate->residual : Values();
    const ChannelScales small(positionUnit, largest(residual));
    const auto residualTime = std::make_shared<Values>(tail(partOf(*time, part), residual.size()));
    const QString name =
        estimate && estimate->coefficients ? tr("Residuals, one step ahead") : tr("Residuals");
    m_residuals->setTitle(small.shown.title(name));
    m_residuals->setEmptyText(tr("no model, no residuals"));
    const double twoSd = 2 * standardDeviation(residual) * small.shown.factor;
    m_residuals->setCurves(
        {channelCurve(QString(), CurveRole::Residual, residualTime, residual, small, name)});
    if (twoSd > 0)
        m_residuals->setBand(PlotRange{-twoSd, twoSd}, tr("± 2 sd"));
    else
        m_residuals->setBand(std::nullopt);
    for (TimePlot* plot : {m_response, m_force, m_residuals})
        plot->setDuration(time->back());
    m_response->fitVertical();
    m_force->fitVertical();
    m_residuals->fitVertical(1.3 * twoSd);
    showCorrelations(identification, estimate);
}

void FitPlots::showCorrelations(const Identification& identification, const Estimate* estimate)
{
    constexpr int lags = 25; // what the whiteness test looks at, and a little more
    const ResidualFindings findings = residualFindings(identification, estimate);
    m_auto->setFinding(findings.whiteness.words, findings.whiteness.doubtful);
    m_cross->setFinding(findings.inputIndependence.words, findings.inputIndependence.doubtful);
    for (CorrelationPlot* plot : {m_auto, m_cross})
        plot->setEmptyText(tr("no model, no residuals"));
    if (!estimate || estimate->residual.empty()) {
        m_auto->setCorrelation({});
        m_cross->setCorrelation({});
        return;
    }
    m_auto->setCorrelation(autocorrelation(estimate->residual, lags), identification.sampleTime_s);
    m_cross->setCorrelation(
        crossCorrelation(estimate->residual,
                         tail(partOf(identification.force, estimate->part), estimate->residual.size()), lags),
        identification.sampleTime_s);
}

CorrelationPlot::CorrelationPlot(QWidget* parent)
    : PlotFrame(parent), m_stems(new QLineSeries(this)), m_heads(new QScatterSeries(this)),
      m_outsideHeads(new QScatterSeries(this))
{
    m_heads->setMarkerSize(4);
    m_outsideHeads->setMarkerSize(7);
    attach(m_stems);
    attach(m_heads);
    attach(m_outsideHeads);
    setRubberBand(QChartView::NoRubberBand);
    CorrelationPlot::themeChanged();
}

void CorrelationPlot::setCorrelation(const Correlation& correlation, double sampleTime_s)
{
    m_correlation = correlation;
    m_sampleTime_s = sampleTime_s;
    QList<QPointF> stems, heads, outside;
    const double lag_ms = 1000 * sampleTime_s;
    double largest = 0;
    std::pair<double, double> ends{HUGE_VAL, -HUGE_VAL};

    const bool automatic = !correlation.lags.empty() && correlation.lags.front() == 0;
    for (std::size_t i = 0; i < correlation.lags.size(); ++i) {
        if (automatic && correlation.lags[i] == 0)
            continue; // always 1, and would press everything else flat
        const QPointF head(correlation.lags[i] * lag_ms, correlation.values[i]);
        // One line that runs along zero and up each stem.
        stems << QPointF(head.x(), 0) << head << QPointF(head.x(), 0);
        (std::abs(head.y()) > correlation.band ? outside : heads) << head;
        ends.first = std::min(ends.first, head.x());
        ends.second = std::max(ends.second, head.x());
        largest = std::max(largest, std::abs(head.y()));
    }
    m_stems->replace(stems);
    m_heads->replace(heads);
    m_outsideHeads->replace(outside);
    m_lagsOutside = int(outside.size());
    m_empty = stems.isEmpty();
    if (m_empty) {
        setBand(std::nullopt);
        return;
    }
    setBand(PlotRange{-correlation.band, correlation.band}, tr("95 % band"));
    setWhole({ends.first - 0.7 * lag_ms, ends.second + 0.7 * lag_ms});
    const double half = std::min(1.05, 1.2 * std::max(largest, 1.5 * correlation.band));
    setVertical({-half, half});
    setAccessibleDescription(tr("%n lag(s) outside of the 95 % band", nullptr, m_lagsOutside));
}

PlotTable CorrelationPlot::numbers() const
{
    using Values = std::vector<double>;
    const auto lags = std::make_shared<Values>(m_correlation.lags.begin(), m_correlation.lags.end());
    const auto lags_ms = std::make_shared<Values>(*lags);
    for (double& lag : *lags_ms)
        lag *= 1000 * m_sampleTime_s;
    const auto band = std::make_shared<Values>(lags->size(), m_correlation.band);
    return {{tr("Lag (samples)"), lags},
            {tr("Lag (ms)"), lags_ms},
            {tr("Correlation"), std::make_shared<Values>(m_correlation.values)},
            {tr("95 % band (half width)"), band}};
}

void CorrelationPlot::themeChanged()
{
    PlotFrame::themeChanged();
    const ThemeTokens& tokens = Theme::instance().tokens();
    m_stems->setPen(QPen(tokens.text, 0.75 * tokens.curveWidth));
    m_heads->setColor(tokens.text);
    m_heads->setBorderColor(tokens.text);
    m_outsideHeads->setColor(tokens.notValid);
    m_outsideHeads->setBorderColor(tokens.surface);
}

} // namespace gripscope
