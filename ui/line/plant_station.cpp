// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library_service.h"
#include "core/session/line/plant_words.h"
#include "ui/context/workbench.h"
#include "ui/line/line_station.h"
#include "ui/settings/values/settings.h"

namespace gripscope {

PlantStation& PlantStation::of(Workbench& workbench)
{
    if (auto* known = workbench.findChild<PlantStation*>(QString(), Qt::FindDirectChildrenOnly))
        return *known;
    return *new PlantStation(workbench);
}

PlantStation::PlantStation(Workbench& workbench) : QObject(&workbench), m_workbench(&workbench)
{
    connect(&workbench.settings(), &Settings::changed, this, [this](const QString& key) {
        if (key == QLatin1StringView(setting::plantServer.key))
            configure();
    });
    connect(&workbench, &Workbench::ticked, this, &PlantStation::noticeTypes);
    configure();
}

PlantStation::~PlantStation() = default;

void PlantStation::configure()
{
    m_link.reset();
    m_typesTaken = 0;
    m_problem.reset();
    PlantLinkOptions options;
    options.server = m_workbench->settings().get(setting::plantServer).trimmed();
    options.station = m_workbench->library().file();
    m_on = !options.server.isEmpty();
    if (!m_on)
        return;
    if (const Expected<void> fit = checkOptions(options); !fit) {
        m_problem = fit.error();
        return;
    }
    m_link = std::make_unique<PlantLink>(options);
    m_workbench->library().setGuest(m_link->guest());
}

void PlantStation::noticeTypes()
{
    // What is in force stays so for a squeeze.
    if (!m_link || m_workbench->squeezing() ||
        m_workbench->inspection().state() == InspectSession::State::Judging)
        return;
    const qint64 taken = m_link->typesTaken();
    if (std::exchange(m_typesTaken, taken) != taken)
        m_workbench->tellPlantChanged();
}

LineWords PlantStation::words() const
{
    PlantStatus status = m_link ? m_link->status() : PlantStatus();
    status.on = m_on;
    if (m_problem)
        status.problem = m_problem;
    return plantWords(status, QDateTime::currentDateTimeUtc());
}

} // namespace gripscope
