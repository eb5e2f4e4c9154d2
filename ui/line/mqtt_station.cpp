// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/context/workbench.h"
#include "ui/line/line_station.h"
#include "ui/settings/values/settings.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
/// For a farewell while a person waits for the window.
constexpr std::chrono::milliseconds farewell{40};
} // namespace

Expected<MqttOptions> mqttOptions(const Settings& settings)
{
    MqttOptions options;
    options.tls = settings.get(setting::mqttTls);
    if (const QString broker = settings.get(setting::mqttBroker).trimmed(); !broker.isEmpty())
        RETURN_IF_ERROR(parseBroker(broker, options));
    options.caFile = settings.get(setting::mqttCa);
    options.user = settings.get(setting::mqttUser);
    options.passwordFile = settings.get(setting::mqttPasswordFile);
    options.jsonTopic = settings.get(setting::mqttTopic).trimmed();
    setSparkplug(settings.get(setting::mqttSparkplug).trimmed(), options);
    options.primaryHost = settings.get(setting::mqttPrimaryHost).trimmed();
    RETURN_IF_ERROR(checkOptions(options));
    return options;
}

MqttStation& MqttStation::of(Workbench& workbench)
{
    if (auto* known = workbench.findChild<MqttStation*>(QString(), Qt::FindDirectChildrenOnly))
        return *known;
    return *new MqttStation(workbench);
}

MqttStation::MqttStation(Workbench& workbench)
    : QObject(&workbench), m_workbench(&workbench), m_sender(workbench.connection(), workbench.inspection())
{
    connect(&workbench.settings(), &Settings::changed, this, [this](const QString& key) {
        if (key.startsWith("mqtt/"_L1))
            configure();
    });
    connect(&workbench, &Workbench::ticked, this, [this] { m_sender.poll(); });
    // A result is taken before anybody can begin the next squeeze.
    connect(&workbench, &Workbench::inspectionChanged, this, [this] { m_sender.poll(); });
    configure();
}

MqttStation::~MqttStation()
{
    static_cast<void>(m_sender.end(farewell));
}

void MqttStation::configure()
{
    const Settings& settings = m_workbench->settings();
    m_on = settings.get(setting::mqttOn);
    m_problem.reset();
    const Expected<MqttOptions> options = m_on ? mqttOptions(settings) : MqttOptions();
    if (!options)
        m_problem = options.error();
    if (m_on && options)
        m_sender.begin(*options, m_workbench->library().file());
    else
        static_cast<void>(m_sender.end(farewell));
}

LineWords MqttStation::words() const
{
    MqttLink link = m_sender.link();
    link.on = m_on;
    if (m_problem)
        link.problem = m_problem;
    return mqttWords(link);
}

} // namespace gripscope
