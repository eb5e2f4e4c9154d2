// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/result_sender.h"

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {
constexpr std::chrono::minutes askedEvery{1};
}

ClockWatch::ClockWatch(QString program) : m_program(std::move(program))
{
    m_process.setStandardInputFile(QProcess::nullDevice());
    m_process.setStandardErrorFile(QProcess::nullDevice());
    QObject::connect(
        &m_process, &QProcess::finished, &m_process,
        [this](int exit, QProcess::ExitStatus status) { take(status == QProcess::NormalExit && exit == 0); });
    QObject::connect(&m_process, &QProcess::errorOccurred, &m_process,
                     [this](QProcess::ProcessError) { take(false); });
}

ClockWatch::~ClockWatch()
{
    m_process.disconnect();
    if (m_process.state() == QProcess::NotRunning)
        return;
    m_process.kill();
    m_process.waitForFinished(); // what is killed ends at once
}

void ClockWatch::poll()
{
    const auto now = WatchClock::now();
    if (m_asked && now - *m_asked < askedEvery)
        return;
    m_asked = now;
    if (m_process.state() != QProcess::NotRunning) {
        m_process.kill(); // a minute without an answer
        return;
    }
    m_process.start(m_program, {u"-n"_s, u"tracking"_s}, QIODevice::ReadOnly);
}

void ClockWatch::take(bool answered)
{
    m_standing =
        answered ? clockStandingFrom(QString::fromUtf8(m_process.readAllStandardOutput())) : std::nullopt;
}

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
