// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/result_sender.h"

namespace gripscope {

ResultSender::ResultSender(const ConnectSession& connection, const InspectSession& inspection)
    : m_reporter(connection, inspection)
{
}

void ResultSender::begin(const MqttOptions& options, const QString& library)
{
    m_publisher.reset();
    if (!m_outbox || m_library != library)
        m_outbox = std::make_shared<MqttOutbox>(mqttFile(library));
    m_library = library;
    m_publisher = std::make_unique<MqttPublisher>(options, m_outbox);
}

bool ResultSender::end(std::chrono::milliseconds patience)
{
    const bool said = !m_publisher || m_publisher->end(patience);
    m_publisher.reset();
    m_outbox.reset();
    return said;
}

void ResultSender::poll()
{
    std::optional<LineReport> report = m_reporter.next(); // what came while it was off is not sent
    if (!m_publisher)
        return;
    m_clock.poll();
    m_publisher->setGripper(m_reporter.gripper());
    if (!report)
        return;
    report->clock = m_clock.standing();
    m_outbox->offer(*report);
}

MqttLink ResultSender::link() const
{
    if (!m_publisher)
        return {};
    MqttLink link = m_publisher->link();
    link.clock = m_clock.standing();
    return link;
}

} // namespace gripscope
