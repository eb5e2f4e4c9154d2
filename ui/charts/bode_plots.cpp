// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/bode_plots.h"

#include "core/base/words.h"
#include "core/math/normal_interval.h"
#include "ui/theme/theme.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr double degreesPerRadian = 180 / std::numbers::pi;
constexpr double paleShare = 0.45; ///< of a doubtful point's colour on the surface

/// The model's phase at a frequency, to bring a measured one to the nearest turn of it.
double phaseNear(const std::vector<ModelLine>& model, double frequency_Hz)
{
    if (model.empty())
        return -std::numbers::pi / 2; // that of a spring and a mass, from 0 to half a turn
    const auto at =
        std::lower_bound(model.begin(), model.end(), frequency_Hz,
                         [](const ModelLine& line, double wanted) { return line.frequency_Hz < wanted; });
    return at == model.end() ? model.back().phase : at->phase;
}

std::vector<EmpiricalLine> linesOf(const BodeContent& content)
{
    return content.measured ? content.measured->lines : std::vector<EmpiricalLine>();
}

} // namespace

BodePlots::BodePlots(QWidget* parent)
    : PlotStack(parent), m_magnitude(new FrequencyPlot), m_phase(new FrequencyPlot),
      m_coherence(new FrequencyPlot)
{
    setExportNames(tr("Bode plot"), u"bode"_s);
    add(m_magnitude, 42);
    add(m_phase, 34);
    add(m_coherence, 24);
    m_magnitude->setLogarithmicValues();
    m_phase->setVerticalStep(45);
    m_phase->setTitle(tr("Phase (°)"));
    m_coherence->setTitle(tr("Coherence"));
    m_coherence->setHorizontalTitle(tr("f (Hz)"));
    linkFrequencies();
    connect(&Theme::instance(), &Theme::changed, this, [this] { refreshLegend(); });
    show(BodeContent());
}

void BodePlots::linkFrequencies()
{
    const auto all = {m_magnitude, m_phase, m_coherence};
    for (FrequencyPlot* from : all) {
        for (FrequencyPlot* to : all)
            if (from != to)
                connect(from, &PlotFrame::horizontalChanged, to,
                        [to](PlotRange range) { to->setHorizontal(range); });
        connect(from, &PlotFrame::wholeAsked, this, [this] {
            m_magnitude->fitVertical();
            m_phase->fitVertical();
            m_coherence->setVertical({0, 1.05});
        });
    }
}

void BodePlots::show(const BodeContent& content)
{
    m_modelName = content.model.empty() ? QString() : content.modelName;
    m_magnitude->setTitle(content.unit.isEmpty() ? tr("Magnitude (as recorded)")
                                                 : tr("Magnitude (%1)").arg(content.unit),
                          content.unit.isEmpty() ? tr("Magnitude") : u"(%1)"_s.arg(content.unit));
    showMeasured(content);
    showFinding(content.measured);
    double low = HUGE_VAL, high = 0;
    for (const EmpiricalLine& line : linesOf(content)) {
        low = std::min(low, line.frequency_Hz);
        high = std::max(high, line.frequency_Hz);
    }
    if (!content.model.empty()) {
        low = std::min(low, content.model.front().frequency_Hz);
        high = std::max(high, content.model.back().frequency_Hz);
    }
    for (FrequencyPlot* plot : {m_magnitude, m_phase, m_coherence}) {
        if (high > low)
            plot->setWhole({std::log10(low), std::log10(high)});
        plot->showWhole();
    }
    m_magnitude->fitVertical();
    m_phase->fitVertical();
    m_coherence->setVertical({0, 1.05});
    refreshLegend();
}

void BodePlots::showMeasured(const BodeContent& content)
{
    FrequencyCurve magnitude, phase, modelMagnitude, modelPhase;
    FrequencyCurve paleMagnitude, palePhase, coherence, paleCoherence;
    for (const ModelLine& line : content.model) {
        const double value = std::abs(line.response) * content.factor;
        const double ratio = std::exp(normal95 * line.relativeError);
        modelMagnitude.append(line.frequency_Hz, value, value / ratio, value * ratio);
        const double half = normal95 * line.phaseError;
        modelPhase.append(line.frequency_Hz, degreesPerRadian * line.phase,
                          degreesPerRadian * (line.phase - half), degreesPerRadian * (line.phase + half));
    }
    for (const EmpiricalLine& line : linesOf(content)) {
        const double value = std::abs(line.response) * content.factor;
        const double near = phaseNear(content.model, line.frequency_Hz);
        const double angle = near + std::remainder(std::arg(line.response) - near, 2 * std::numbers::pi);
        if (!line.relativeError) {
            paleMagnitude.append(line.frequency_Hz, value);
            palePhase.append(line.frequency_Hz, degreesPerRadian * angle);
            paleCoherence.append(line.frequency_Hz, line.coherence);
            continue;
        }
        const double half = normal95 * *line.relativeError;
        magnitude.append(line.frequency_Hz, value, value * std::exp(-half), value * std::exp(half));
        phase.append(line.frequency_Hz, degreesPerRadian * angle, degreesPerRadian * (angle - half),
                     degreesPerRadian * (angle + half));
        coherence.append(line.frequency_Hz, line.coherence);
    }
    m_magnitude->setCurves(std::move(modelMagnitude), std::move(magnitude), std::move(paleMagnitude));
    m_phase->setCurves(std::move(modelPhase), std::move(phase), std::move(palePhase));
    m_coherence->setCurves({}, std::move(coherence), std::move(paleCoherence));
}

void BodePlots::showFinding(const std::optional<EmpiricalResponse>& measured)
{
    const auto status = measured ? measured->status : EmpiricalResponse::Status::Found;
    QString words;
    if (status == EmpiricalResponse::Status::TooShort)
        words = tr("too few samples in a row for a measured one: %1 are needed")
                    .arg(EmpiricalResponse::leastSamples);
    else if (status == EmpiricalResponse::Status::NotExcited)
        words = tr("the force does not change");
    m_coherence->setEmptyText(words);
    m_magnitude->setEmptyText(words);
    const auto pale = m_coherence->doubtful().value.size();
    if (measured && pale > 0)
        m_coherence->setFinding(
            tr("below %1 pale, not reliable").arg(Words::number(measured->coherenceLimit, 'f', 2)));
    else
        m_coherence->setFinding({});
    if (measured && words.isEmpty())
        words = tr("%n measured frequencies, %1 of them pale for a low coherence", nullptr,
                   int(measured->lines.size()))
                    .arg(pale);
    setAccessibleDescription(words);
}

void BodePlots::refreshLegend()
{
    const ThemeTokens& tokens = Theme::instance().tokens();
    std::vector<FigureSign> signs;
    if (!m_coherence->measured().value.empty())
        signs.push_back({tr("measured, 95 %"), QPen(tokens.position, 1), true});
    if (!m_coherence->doubtful().value.empty())
        signs.push_back({tr("coherence too low"), QPen(tokens.position, 1), true, paleShare});
    if (!m_modelName.isEmpty())
        signs.push_back({tr("model, %1, 95 %").arg(m_modelName), QPen(tokens.model, tokens.curveWidth)});
    setLegend(std::move(signs));
}

} // namespace gripscope
