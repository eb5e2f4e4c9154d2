// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/workbench.h"
#include "ui/format/link_words.h"
#include "ui/pages/live/live_cards.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/elided_label.h"

#include <QGridLayout>

namespace gripscope {

using namespace Qt::StringLiterals;
using Clock = std::chrono::steady_clock;

LiveLinkPanel::LiveLinkPanel(Workbench& workbench, QWidget* parent) : QFrame(parent), m_workbench(&workbench)
{
    setRole(this, "card");
    setObjectName("liveLink");
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(16, 8, 16, 8);
    grid->setHorizontalSpacing(16);
    grid->setVerticalSpacing(0);
    add(grid, u"link"_s, tr("Link"), 0, 0);
    add(grid, u"reports"_s, tr("Reports"), 0, 1);
    add(grid, u"samples"_s, tr("Samples"), 0, 2);
    add(grid, u"lost"_s, tr("Lost samples"), 0, 3);
    add(grid, u"latency"_s, tr("Latency to the screen"), 0, 4);
    add(grid, u"armed"_s, tr("Armed"), 2, 0);
    add(grid, u"force"_s, tr("Force limit"), 2, 1);
    add(grid, u"travel"_s, tr("Travel limit"), 2, 2);
    add(grid, u"excitation"_s, tr("Squeeze"), 2, 3);
    add(grid, u"stream"_s, tr("Stream"), 2, 4);
    grid->setRowMinimumHeight(2, 20);
    const int shares[] = {2, 3, 3, 4, 4};
    for (int column = 0; column < 5; ++column)
        grid->setColumnStretch(column, shares[column]);
}

void LiveLinkPanel::add(QGridLayout* grid, const QString& id, const QString& caption, int row, int column)
{
    auto* value = new ElidedLabel(u"–"_s, this);
    setRole(value, "strong");
    value->setAccessibleName(caption);
    value->setObjectName(id);
    grid->addWidget(makeLabel(caption, "caption", this), row, column);
    grid->addWidget(value, row + 1, column);
    m_values[id] = value;
}

void LiveLinkPanel::set(const QString& id, const QString& text)
{
    QString& shown = m_texts[id];
    if (shown == text)
        return;
    shown = text;
    m_values.at(id)->setFullText(text);
}

QString LiveLinkPanel::text(const QString& id) const
{
    const auto found = m_texts.find(id);
    return found == m_texts.end() ? QString() : found->second;
}

void LiveLinkPanel::notePainted()
{
    const std::optional<Clock::time_point> arrival = m_workbench->connection().counters().newestArrival;
    // What was painted before is no newer now: a silence is no latency.
    if (!arrival || arrival == m_paintedArrival)
        return;
    m_paintedArrival = arrival;
    const Clock::time_point now = Clock::now();
    m_painted.add(std::chrono::duration<double, std::milli>(now - *arrival).count(), now);
}

void LiveLinkPanel::refresh()
{
    refreshStream();
    refreshGripper();
}

void LiveLinkPanel::refreshStream()
{
    ConnectSession& connection = m_workbench->connection();
    const bool connected = connection.state() == ConnectSession::State::Connected;
    const LinkCounters counters = connection.counters();
    const auto rate = [&](double rate_Hz) {
        return connected ? tr("%1 /s").arg(rate_Hz, 0, 'f', 0) : u"–"_s;
    };
    set(u"link"_s, linkWords(connection.state(), counters));
    set(u"reports"_s, rate(counters.reportRate_Hz));
    set(u"samples"_s, rate(counters.sampleRate_Hz));
    set(u"lost"_s, connected && !connection.identity().lossVisible ? tr("cannot be seen")
                                                                   : lossWords(counters, Clock::now()));
    set(u"latency"_s, connected ? latencyWords(m_painted.quantile_ms(0.5, Clock::now()),
                                               m_painted.quantile_ms(0.99, Clock::now()))
                                : u"–"_s);
    set(u"stream"_s, counters.reports + counters.samples > 0 ? streamWords(counters) : u"–"_s);
}

void LiveLinkPanel::refreshGripper()
{
    ConnectSession& connection = m_workbench->connection();
    const GripperPort* port = connection.port();
    const SafetyGate* gate = connection.gate();
    if (!port || !gate || !connection.identity().commandable) {
        set(u"armed"_s, port ? tr("cannot move") : u"–"_s);
        for (const QString& id : {u"force"_s, u"travel"_s, u"excitation"_s})
            set(id, u"–"_s);
        return;
    }
    const DeviceLimits device = connection.identity().limits;
    const JobLimits limits = gate->effectiveLimits();
    set(u"armed"_s, connection.armed() ? tr("yes") : tr("no"));
    set(u"force"_s, limitWords(limits.maxForce_N, device.maxForce_N, fieldUnit(MechanicalQuantity::Force)));
    set(u"travel"_s,
        limitWords(limits.maxTravel_m, device.maxTravel_m, fieldUnit(MechanicalQuantity::Length)));
    set(u"excitation"_s, squeezeWords(port->squeezeState()));
}

} // namespace gripscope
