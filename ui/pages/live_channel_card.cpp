// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/live_channel_card.h"

#include "core/signal/units.h"
#include "core/words.h"
#include "ui/theme/theme.h"
#include "ui/widgets/controls.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include <cmath>

using namespace Qt::StringLiterals;

namespace gripscope {

namespace {
constexpr double readingSeconds = 0.1;
}

LiveChannelCard::LiveChannelCard(LiveHistory::Channel channel, const QString& name, QWidget* parent)
    : QFrame(parent), m_channel(channel)
{
    setRole(this, "card");
    const bool force = channel == LiveHistory::Channel::Force;
    m_decimals = force ? 2 : 3;
    // The least span keeps sensor noise from filling the chart: 2 N, 0.2 mm.
    m_chart = new StripChart(channel, force ? 2.0 : 0.2, this);
    m_chart->setAccessibleName(tr("%1 over time").arg(name));

    auto* swatch = new QFrame(this);
    swatch->setFixedSize(20, 4);
    const auto paintSwatch = [swatch, force] {
        const ThemeTokens& t = Theme::instance().tokens();
        swatch->setStyleSheet(u"background: %1; border: none; border-radius: 2px;"_s.arg(
            (force ? t.force : t.position).name()));
    };
    paintSwatch();
    connect(&Theme::instance(), &Theme::changed, swatch, paintSwatch);

    m_value = makeLabel(u"–"_s, "big-number", this);
    m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_value->setAccessibleName(name);
    m_unitLabel = makeLabel(force ? u"N"_s : u"mm"_s, "second", this);
    m_tared = makeLabel(tr("tared"), "caption", this);
    m_tared->setAlignment(Qt::AlignRight);
    m_tared->hide();
    m_seen = makeLabel({}, "caption", this);
    m_seen->setAlignment(Qt::AlignRight);

    auto* head = new QHBoxLayout;
    head->setSpacing(8);
    head->addWidget(swatch);
    head->addWidget(makeLabel(name, "strong", this));
    head->addStretch(1);
    auto* number = new QHBoxLayout;
    number->setSpacing(6);
    number->addWidget(m_value, 1);
    number->addWidget(m_unitLabel, 0, Qt::AlignBottom);
    m_unitLabel->setContentsMargins(0, 0, 0, 6);
    auto* side = new QVBoxLayout;
    side->setSpacing(4);
    side->addLayout(head);
    side->addLayout(number);
    side->addWidget(m_tared);
    side->addStretch(1);
    side->addWidget(m_seen);
    auto* sideBox = new QWidget(this);
    sideBox->setFixedWidth(184);
    side->setContentsMargins(0, 0, 0, 0);
    sideBox->setLayout(side);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(4, 8, 16, 4);
    row->setSpacing(8);
    row->addWidget(m_chart, 1);
    row->addWidget(sideBox);
}

void LiveChannelCard::setDeviceUnit(const QString& unit)
{
    const bool force = m_channel == LiveHistory::Channel::Force;
    const std::optional<double> si = force ? newtonsPer(unit) : metresPer(unit);
    m_factor = si ? (force ? *si : *si * 1000) : 1;
    m_unitLabel->setText(si ? (force ? u"N"_s : u"mm"_s) : unit);
    m_chart->setUnit(m_unitLabel->text());
}

void LiveChannelCard::refreshChart(const LiveHistory& history, double until_s)
{
    m_chart->setScale(m_factor, m_zero);
    m_chart->setStretches(history.columns(m_channel, until_s, m_chart->seconds(),
                                          static_cast<std::size_t>(m_chart->columns())));
    m_chart->setGaps(history.gaps(until_s, m_chart->seconds()));
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
    if (const std::optional<AxisRange> seen = m_chart->seen())
        m_seen->setText(tr("in view\nhighest %1 %3\nlowest %2 %3")
                            .arg(number(seen->high), number(seen->low), m_unitLabel->text()));
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
}

} // namespace gripscope
