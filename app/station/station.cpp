// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/station.h"

#include "core/library/audit/audit_trail.h"
#include "core/library/people/people_register.h"
#include "core/people/audit_entry.h"
#include "core/people/secret.h"
#include "core/session/line/plant_words.h"

#include <QDateTime>
#include <QFileInfo>
#include <QJsonArray>
#include <QTextStream>

#include <algorithm>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// As often as the window looks while a squeeze goes on: somebody waits for the verdict.
constexpr std::chrono::milliseconds pollEvery{4};
constexpr std::chrono::seconds armingPatience{5};
/// For the broker's last answers.
constexpr std::chrono::seconds brokerPatience{2};

void tellLog(const QString& text)
{
    QTextStream(stderr) << "gripscope-station: " << text << Qt::endl;
}

std::uint32_t thisRun()
{
    return static_cast<std::uint32_t>(QDateTime::currentSecsSinceEpoch());
}

/// Who may, and that it is told before it is done; the name that arms. On the library's thread.
Expected<QString> consentToArm(Library& library, const QString& name, QString secretText,
                               const GripperIdentity& gripper)
{
    const Secret secret(secretText);
    wipe(secretText);
    library.actAs(Acting{name});
    QString person = name;
    ASSIGN_OR_RETURN(const bool inForce, library.people().inForce());
    if (inForce) {
        ASSIGN_OR_RETURN(const Person known, library.people().named(name));
        ASSIGN_OR_RETURN(Grant grant, library.people().authorise(known.id, secret, Permission::Arm));
        person = grant.by.name();
        library.actAs(Acting{name, std::nullopt, std::move(grant)});
    }
    RETURN_IF_ERROR(library.auditTrail().record(
        Permission::Arm, QString::fromUtf16(audit_action::gripperArmed), gripper.serial,
        {{u"from"_s, u"station"_s}, {u"address"_s, gripper.address}}));
    return person;
}

void tellProblems(LineWords& known, LineWords now)
{
    if (now.problems != known.problems)
        for (const QString& problem : described(now.problems))
            tellLog(problem);
    known = std::move(now);
}

QJsonObject refusal(const Error& error)
{
    return {{u"done"_s, false}, {u"message"_s, error.describe()}};
}

} // namespace

Station::Station(const StationOptions& options)
    : m_options(options), m_library(options.library), m_connection(m_factory),
      m_inspection(m_connection, m_library), m_desk(std::make_shared<SharedJobDesk>(thisRun())),
      m_line(m_connection, m_inspection, m_desk), m_sender(m_connection, m_inspection),
      m_console(options.console,
                [this](const QJsonObject& request, const Console::Answer& back) { answer(request, back); })
{
    m_library.actAs(Acting{u"station"_s});
    m_connection.awaitCalibrations(true);
    m_inspection.setOperator(u"station"_s);
    m_inspection.setExpectedType(options.expectedType);
    m_inspection.setRates(options.rates);
    m_line.setTypes(options.types);
    m_desk->with([&options](JobDesk& desk) {
        desk.setHeartbeatLimit(std::chrono::milliseconds(static_cast<qint64>(options.heartbeat_s * 1000)));
    });
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(pollEvery);
    QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { tick(); });
}

Station::~Station()
{
    m_timer.stop();
    m_connection.stop();
    m_connection.disarm();
}

Expected<void> Station::start()
{
    ASSIGN_OR_RETURN(const bool isThere, Library::isThere(m_options.library));
    if (!isThere)
        return failure(ErrorCode::StorageOpen, {m_options.library, u"there is no such library"_s});
    RETURN_IF_ERROR(m_console.listen());
    RETURN_IF_ERROR(m_connection.connectTo(m_options.address));
    m_server = std::make_unique<ModbusServer>(*m_options.modbus, m_desk);
    if (m_options.mqtt)
        m_sender.begin(*m_options.mqtt, m_options.library);
    if (m_options.plant)
        m_plant = std::make_unique<PlantLink>(*m_options.plant);
    m_timer.start();
    return {};
}

Expected<void> Station::end()
{
    m_timer.stop();
    m_notice.stopping();
    m_server.reset();
    m_inspection.cancel();
    m_connection.disarm();
    m_connection.disconnect();
    static_cast<void>(m_sender.end(brokerPatience));
    if (m_plant)
        static_cast<void>(m_plant->end(brokerPatience));
    if (m_connection.stopState() == StopState::NotObeyed)
        return failure(ErrorCode::StopNotObeyed, {});
    return {};
}

void Station::tick()
{
    m_connection.poll();
    noticeGripper();
    static_cast<void>(m_inspection.poll());
    m_sender.poll(); // before the line can begin the next squeeze
    m_line.poll();
    m_asking.poll();
    m_arming.poll();
    followArming();
    notePlant();
    tellNews();
    const QString status = words().headline.describe();
    if (!m_ready && m_inspection.state() == InspectSession::State::Ready &&
        !m_server->link().listening.isEmpty()) {
        m_ready = true;
        tellLog(u"Listening on %1."_s.arg(m_server->link().listening));
        m_notice.ready(status);
    }
    m_notice.status(status);
    m_notice.alive();
}

void Station::noticeGripper()
{
    if (m_connection.state() != ConnectSession::State::Connected)
        return;
    const QString serial = m_connection.identity().serial;
    const QString now = u"%1 %2"_s.arg(m_connection.reconnections()).arg(serial);
    if (now == m_known || m_asking.waiting())
        return;
    m_known = now;
    applyKnown(serial);
}

void Station::applyKnown(const QString& serial)
{
    m_asking = {
        m_library.run<KnownGripper>([serial](Library& library) { return knownGripper(library, serial); }),
        [this](const Expected<KnownGripper>& found) {
            if (found)
                return putInForce(m_connection, *found);
            m_connection.tellCalibrationsUnread(found.error());
            m_known.clear(); // to be asked again
        }};
}

void Station::noticeError(std::optional<Error>& known, const std::optional<Error>& now)
{
    if (known == now)
        return;
    known = now;
    if (now)
        tellLog(now->describe());
}

void Station::tellNews()
{
    for (const Finding& news : m_line.takeNews())
        tellLog(news.describe());
    noticeError(m_connectionError, m_connection.lastError());
    noticeError(m_inspectionError, m_inspection.lastError());
    if (m_sender.on())
        tellProblems(m_mqttWords, mqttWords(m_sender.link()));
    if (m_plant)
        tellProblems(m_plantWords, plantWords(m_plant->status(), QDateTime::currentDateTimeUtc()));
}

void Station::notePlant()
{
    // What is in force stays so for a squeeze.
    if (!m_plant || m_inspection.state() != InspectSession::State::Ready)
        return;
    const qint64 taken = m_plant->typesTaken();
    if (std::exchange(m_typesTaken, taken) == taken)
        return;
    m_inspection.reload();
    m_known.clear(); // its calibrations are asked for again
}

LineWords Station::words() const
{
    const auto now = std::chrono::steady_clock::now();
    const JobDesk::View view = m_desk->with([now](const JobDesk& desk) { return desk.view(now); });
    return lineWords(m_server->link(), view, now);
}

QJsonObject Station::status() const
{
    const auto now = std::chrono::steady_clock::now();
    const JobDesk::View view = m_desk->with([now](const JobDesk& desk) { return desk.view(now); });
    const LineWords line = words();
    QJsonArray problems;
    for (const QString& problem : described(line.problems))
        problems.append(problem);
    return {{u"done"_s, true},
            {u"state"_s, toString(view.state)},
            {u"armed"_s, m_connection.armed()},
            {u"gripper"_s, m_connection.identity().serial},
            {u"line"_s, line.headline.describe()},
            {u"problems"_s, problems},
            {u"listening"_s, m_server->link().listening},
            {u"results"_s, view.result ? qint64(view.result->sequence) : 0},
            {u"overruns"_s, qint64(view.overruns)},
            {u"unstored"_s, qint64(m_inspection.unstored())},
            {u"mqtt"_s, m_mqttWords.headline.describe()},
            {u"mqttProblems"_s, QJsonArray::fromStringList(described(m_mqttWords.problems))},
            {u"plant"_s, m_plantWords.headline.describe()},
            {u"plantProblems"_s, QJsonArray::fromStringList(described(m_plantWords.problems))}};
}

void Station::answer(const QJsonObject& request, const Console::Answer& answer)
{
    const QString command = request[u"command"_s].toString();
    if (command == u"arm"_s)
        return arm(request, answer);
    if (command == u"stop"_s)
        m_connection.stop();
    if (command == u"stop"_s || command == u"disarm"_s) {
        m_connection.disarm();
        return answer({{u"done"_s, true}});
    }
    answer(command == u"status"_s
               ? status()
               : refusal({ErrorCode::Usage, {u"The command is arm, disarm, stop or status."_s}}));
}

void Station::arm(const QJsonObject& request, const Console::Answer& answer)
{
    if (m_connection.state() != ConnectSession::State::Connected)
        return answer(refusal(m_connection.lastError().value_or(
            Error{ErrorCode::DeviceLost, {m_connection.address(), u"it is not connected"_s}})));
    if (m_arming.waiting() || m_armed)
        return answer(refusal({ErrorCode::Usage, {u"Somebody is arming it at this moment."_s}}));
    m_arming = {m_library.run<QString>([name = request[u"person"_s].toString(),
                                        secret = request[u"secret"_s].toString(),
                                        gripper = m_connection.identity()](Library& library) {
                    return consentToArm(library, name, secret, gripper);
                }),
                [this, answer](const Expected<QString>& person) {
                    person ? armNow(*person, answer) : answer(refusal(person.error()));
                }};
}

void Station::armNow(const QString& person, const Console::Answer& answer)
{
    if (const Expected<void> done = m_connection.arm(person); !done)
        return answer(refusal(done.error()));
    m_armed = answer;
    m_armBy = std::chrono::steady_clock::now() + armingPatience;
}

void Station::followArming()
{
    if (!m_armed)
        return;
    const std::optional<Error> reason = m_connection.disarmReason();
    const bool late = std::chrono::steady_clock::now() > m_armBy;
    if (!m_connection.armed() && !reason && !late)
        return;
    const Console::Answer answer = std::exchange(m_armed, nullptr);
    if (m_connection.armed())
        return answer({{u"done"_s, true}});
    m_connection.disarm();
    answer(refusal(reason.value_or(Error{ErrorCode::DeviceTimeout, {u"arm"_s, u"5"_s}})));
}

} // namespace gripscope
