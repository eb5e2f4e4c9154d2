// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/line/line_station.h"

#include "ui/context/workbench.h"
#include "ui/settings/values/settings.h"

#include <QDateTime>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

QStringList partsOf(const QString& text, QChar by)
{
    QStringList parts;
    for (const QString& part : text.split(by, Qt::SkipEmptyParts))
        parts << part.trimmed();
    return parts;
}

ModbusServerOptions serverOptions(const Settings& settings)
{
    ModbusServerOptions options;
    if (const QString host = settings.get(setting::lineHost).trimmed(); !host.isEmpty())
        options.host = host;
    options.port = static_cast<std::uint16_t>(settings.get(setting::linePort));
    options.peers = partsOf(settings.get(setting::linePeers), u';');
    return options;
}

} // namespace

LineStation& LineStation::of(Workbench& workbench)
{
    if (auto* known = workbench.findChild<LineStation*>(QString(), Qt::FindDirectChildrenOnly))
        return *known;
    return *new LineStation(workbench);
}

LineStation::LineStation(Workbench& workbench)
    : QObject(&workbench), m_workbench(&workbench),
      m_desk(std::make_shared<SharedJobDesk>(static_cast<std::uint32_t>(QDateTime::currentSecsSinceEpoch()))),
      m_session(workbench.connection(), workbench.inspection(), m_desk)
{
    connect(&workbench.settings(), &Settings::changed, this, [this](const QString& key) {
        if (key.startsWith("line/"_L1))
            configure();
    });
    connect(&workbench, &Workbench::ticked, this, &LineStation::poll);
    // A result is taken before anybody can begin the next squeeze.
    connect(&workbench, &Workbench::inspectionChanged, this, &LineStation::poll);
    configure();
}

void LineStation::configure()
{
    const Settings& settings = m_workbench->settings();
    m_server.reset();
    m_problem.reset();
    m_on = settings.get(setting::lineOn);
    m_session.setTypes(partsOf(settings.get(setting::lineTypes), u';'));
    m_desk->with([&settings](JobDesk& desk) {
        desk.setHeartbeatLimit(
            std::chrono::milliseconds(static_cast<qint64>(1000 * settings.get(setting::lineHeartbeat))));
    });
    if (!m_on)
        return;
    const ModbusServerOptions options = serverOptions(settings);
    if (const Expected<void> checked = checkOptions(options); !checked)
        m_problem = checked.error();
    else
        m_server = std::make_unique<ModbusServer>(options, m_desk);
}

void LineStation::poll()
{
    if (!m_on && !m_session.working())
        return;
    const bool inspects = m_workbench->inspection().state() == InspectSession::State::Squeezing;
    m_session.setOccupied(m_workbench->squeezing() && !inspects);
    m_session.poll();
    for (const Finding& news : m_session.takeNews())
        m_workbench->messages().report(news.describe());
}

LineLink LineStation::link() const
{
    if (m_server)
        return m_server->link();
    LineLink none;
    none.on = m_on;
    none.failed = m_problem;
    return none;
}

LineWords LineStation::words() const
{
    const auto now = std::chrono::steady_clock::now();
    return lineWords(link(), m_desk->with([now](const JobDesk& desk) { return desk.view(now); }), now);
}

} // namespace gripscope
