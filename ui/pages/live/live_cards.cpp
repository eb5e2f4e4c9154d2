// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/live/live_cards.h"

#include "core/base/words.h"
#include "core/signal/recording/units.h"
#include "ui/feed/live_view.h"
#include "ui/format/number_format.h"
#include "ui/format/parameter_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include <cmath>
#include <functional>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {

constexpr double readingSeconds = 0.1;

/// A piece of a line of the chart, for its legend: told apart by width as well as by colour.
QFrame* makeSwatch(int height, const std::function<QColor()>& color, QWidget* parent)
{
    auto* swatch = new QFrame(parent);
    swatch->setFixedSize(20, height);
    const auto paint = [swatch, color] {
        swatch->setStyleSheet(u"background: %1; border: none;"_s.arg(color().name()));
    };
    paint();
    QObject::connect(&Theme::instance(), &Theme::changed, swatch, paint);
    return swatch;
}

} // namespace

LiveChannelCard::LiveChannelCard(LiveHistory::Channel channel, const QString& name, QWidget* parent)
    : QFrame(parent), m_channel(channel)
{
    setRole(this, "card");
    const bool force = channel == LiveHistory::Channel::Force;
    // The least span keeps sensor noise from filling the chart.
    constexpr double leastForce_N = 2, leastLength_m = 0.2e-3;
    constexpr double forceStep_N = 0.01, lengthStep_m = 1e-6;
    const ShownUnit unit = unitShown();
    m_decimals = std::max(0, int(std::ceil(-std::log10((force ? forceStep_N : lengthStep_m) * unit.factor))));
    m_chart = new StripChart(channel, (force ? leastForce_N : leastLength_m) * unit.factor, this);
    m_chart->setAccessibleName(tr("%1 over time").arg(name));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 8, 16, 4);
    row->setSpacing(8);
    row->addWidget(m_chart, 1);
    buildSide(name);
}

void LiveChannelCard::buildSide(const QString& name)
{
    const bool force = m_channel == LiveHistory::Channel::Force;
    m_value = makeLabel(u"–"_s, "big-number", this);
    m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_value->setAccessibleName(name);
    m_unitLabel = makeLabel(unitShown().unit, "second", this);
    m_unitLabel->setContentsMargins(0, 0, 0, 6);
    m_tared = makeLabel(tr("tared"), "caption", this);
    m_tared->setAlignment(Qt::AlignRight);
    m_tared->hide();
    m_seen = makeLabel({}, "caption", this);
    m_seen->setAlignment(Qt::AlignRight);

    auto* head = new QHBoxLayout;
    head->setSpacing(8);
    head->addWidget(makeSwatch(
        2, [force] { return force ? Theme::instance().tokens().force : Theme::instance().tokens().position; },
        this));
    head->addWidget(makeLabel(name, "strong", this));
    head->addStretch(1);
    auto* number = new QHBoxLayout;
    number->setSpacing(6);
    number->addWidget(m_value, 1);
    number->addWidget(m_unitLabel, 0, Qt::AlignBottom);
    auto* sideBox = new QWidget(this);
    sideBox->setFixedWidth(184);
    auto* side = new QVBoxLayout(sideBox);
    setSpacing(side, 0, 4);
    side->addLayout(head);
    side->addLayout(number);
    side->addWidget(m_tared);
    if (force) {
        m_legend = new QWidget(this);
        auto* legend = new QHBoxLayout(m_legend);
        setSpacing(legend, 0, 8);
        legend->addWidget(makeSwatch(6, &StripChart::commandedColor, this));
        m_commanded = makeLabel({}, "caption", this);
        m_commanded->setObjectName("commandedForce");
        m_commanded->setToolTip(tr("What this program asks of the gripper while it squeezes; without tare"));
        legend->addWidget(m_commanded, 1);
        side->addWidget(m_legend);
    }
    side->addStretch(1);
    side->addWidget(m_seen);
    layout()->addWidget(sideBox);
}

void LiveChannelCard::setCommandable(bool on)
{
    if (m_legend)
        m_legend->setVisible(on);
}

ShownUnit LiveChannelCard::unitShown() const
{
    return fieldUnit(m_channel == LiveHistory::Channel::Force ? MechanicalQuantity::Force
                                                              : MechanicalQuantity::Length);
}

void LiveChannelCard::setDeviceUnit(const QString& unit)
{
    const bool force = m_channel == LiveHistory::Channel::Force;
    const std::optional<double> si = force ? newtonsPer(unit) : metresPer(unit);
    m_factor = si ? *si * unitShown().factor : 1;
    m_unitLabel->setText(si ? unitShown().unit : unit);
    m_chart->setUnit(m_unitLabel->text());
}

void LiveChannelCard::refreshChart(const LiveHistory& history, const LiveView& view)
{
    const double until_s = view.until_s();
    const auto columns = static_cast<std::size_t>(m_chart->columns());
    m_chart->setScale(m_factor, m_zero);
    m_chart->setTime(view.seconds(), until_s - view.reference_s(), view.held() ? tr("0 s") : tr("now"));
    if (m_channel == LiveHistory::Channel::Force)
        m_chart->setCommanded(
            history.columns(LiveHistory::Channel::CommandedForce, until_s, view.seconds(), columns));
    m_chart->setStretches(history.columns(m_channel, until_s, view.seconds(), columns));
    m_chart->setGaps(history.gaps(until_s, view.seconds()));
}

std::optional<double> LiveChannelCard::meanNow(const LiveHistory& history, double until_s) const
{
    // One column a sample: min and max are the sample itself.
    const auto samples = static_cast<std::size_t>(readingSeconds / history.sampleTime_s()) + 1;
    double sum = 0;
    std::size_t count = 0;
    for (const LiveHistory::Stretch& stretch : history.columns(m_channel, until_s, readingSeconds, samples))
        for (const PlotPoint& p : stretch) {
            sum += p.y;
            ++count;
        }
    if (count == 0)
        return std::nullopt;
    return sum / static_cast<double>(count) * m_factor;
}

void LiveChannelCard::refreshValue(const LiveHistory& history, double until_s)
{
    const std::optional<double> mean = meanNow(history, until_s);
    if (!mean)
        return showNoValue();
    const double shown = *mean - m_zero;
    m_value->setText(number(shown));
    m_tared->setVisible(m_zero != 0);
    if (m_commanded)
        showCommanded(history, until_s);
    if (const std::optional<AxisRange> seen = m_chart->seen())
        m_seen->setText(
            tr("in view\n%1 to %2 %3").arg(number(seen->low), number(seen->high), m_unitLabel->text()));
}

void LiveChannelCard::showCommanded(const LiveHistory& history, double until_s)
{
    const std::optional<LiveHistory::Reading> asked =
        history.reading(LiveHistory::Channel::CommandedForce, until_s);
    m_commanded->setText(
        asked ? tr("commanded %1 %2").arg(number(asked->middle() * m_factor), m_unitLabel->text())
              : tr("commanded"));
}

QString LiveChannelCard::readingText(const std::optional<ReadValue>& reading) const
{
    if (!reading)
        return u"–"_s;
    const auto shown = [&](double value) { return number(value * m_factor - m_zero); };
    if (reading->range && shown(reading->value - reading->halfWidth) != shown(reading->value))
        return tr("%1 to %2 %3")
            .arg(shown(reading->value - reading->halfWidth), shown(reading->value + reading->halfWidth),
                 m_unitLabel->text());
    return shown(reading->value) + QChar(0x00A0) + m_unitLabel->text();
}

QString LiveChannelCard::changeText(const std::optional<ReadValue>& change) const
{
    if (!change)
        return u"–"_s;
    const double halfWidth = change->halfWidth * m_factor;
    return formatNumber(change->value * m_factor, halfWidth > 0 ? std::optional(halfWidth) : std::nullopt,
                        m_unitLabel->text())
        .text();
}

QString LiveChannelCard::number(double shown) const
{
    const double least = std::pow(10.0, -m_decimals) / 2;
    QString text = Words::number(std::abs(shown) < least ? 0.0 : shown, 'f', m_decimals);
    return text.replace(QLatin1Char('-'), QChar(0x2212));
}

void LiveChannelCard::showNoValue()
{
    m_value->setText(u"–"_s);
    m_seen->clear();
    if (m_commanded)
        m_commanded->setText(tr("commanded"));
}

LiveEstimateCard::LiveEstimateCard(QWidget* parent) : QFrame(parent)
{
    setRole(this, "card");
    setObjectName("liveEstimate");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(16, 8, 16, 8);
    row->setSpacing(24);
    const auto add = [&](const QString& name) { return addCaptionedValue(row, name, 120, this); };
    m_values = {add(tr("Mass")), add(tr("Damping")), add(tr("Stiffness"))};
    m_samples = add(tr("Samples"));
    m_samples->setMinimumWidth(64);
    m_what = makeLabel({}, "second", this);
    m_what->setWordWrap(true);
    m_what->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_what, 1);
}

void LiveEstimateCard::show(const std::optional<RecursiveState>& state, bool following,
                            const QString& forceUnit, const QString& positionUnit)
{
    for (QLabel* value : m_values)
        value->setText(u"–"_s);
    m_samples->setText(state ? formatCount(static_cast<qint64>(state->samples)) : u"–"_s);
    if (!state) {
        m_what->setText(tr("m, b and k appear here while the gripper squeezes"));
        return;
    }
    m_what->setText(following ? tr("this squeeze so far") : tr("the last squeeze"));
    if (!state->parameters)
        return;
    std::optional<Eigen::Vector3d> errors;
    if (state->covariance)
        errors = state->covariance->diagonal().cwiseMax(0.0).cwiseSqrt();
    const ParameterTexts texts = parameterTexts(*state->parameters, errors, forceUnit, positionUnit);
    m_values[0]->setText(texts.m.text());
    m_values[1]->setText(texts.b.text());
    m_values[2]->setText(texts.k.text());
}

} // namespace gripscope
