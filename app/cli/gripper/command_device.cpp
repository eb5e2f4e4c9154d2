// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/drive.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "core/base/json_value.h"
#include "core/session/connection/report_log.h"
#include "devices/factory/gripper_factory.h"
#include "devices/inspection/device_facts.h"
#include "devices/inspection/self_test.h"
#include "devices/protocol/descriptor_words.h"
#include "devices/protocol/report_words.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

constexpr double describePatience_s = 20; ///< a device may take seconds to say what it is

QJsonObject identityJson(const GripperIdentity& identity, const DeviceFacts& facts)
{
    return {{u"address"_qs, identity.address},
            {u"serial"_qs, identity.serial},
            {u"name"_qs, identity.name},
            {u"firmware"_qs, identity.firmware},
            {u"protocol"_qs, u"%1.%2"_qs.arg(identity.protocolMajor).arg(identity.protocolMinor)},
            {u"usb"_qs, jsonText(facts.usbIds)},
            {u"node"_qs, jsonText(facts.node)},
            {u"force_unit"_qs, identity.forceUnit},
            {u"position_unit"_qs, identity.positionUnit},
            {u"sample_time_s"_qs, identity.sampleTime_s},
            {u"commandable"_qs, identity.commandable},
            {u"max_force_N"_qs, identity.limits.maxForce_N},
            {u"max_travel_m"_qs, identity.limits.maxTravel_m},
            {u"max_samples"_qs, static_cast<qint64>(identity.limits.maxSamples)}};
}

QJsonArray descriptorJson(const DeviceFacts& facts)
{
    QJsonArray items;
    for (const protocol::DescriptorItem& item : protocol::descriptorInWords(facts.descriptor))
        items.append(
            QJsonObject{{u"hex"_qs, item.hex}, {u"depth"_qs, item.depth}, {u"words"_qs, item.words}});
    return items;
}

QJsonArray reportsJson(const std::vector<LoggedReport>& reports)
{
    static const QString directions[] = {u"in"_qs, u"out"_qs, u"feature"_qs};
    QJsonArray out;
    for (const LoggedReport& report : reports) {
        const protocol::ReportWords words = protocol::reportInWords(report.view());
        QJsonObject fields;
        for (const protocol::FieldWords& field : words.fields)
            fields.insert(field.name, field.value);
        out.append(QJsonObject{{u"direction"_qs, directions[static_cast<std::size_t>(report.direction)]},
                               {u"kind"_qs, words.kind},
                               {u"problem"_qs, jsonText(words.problem)},
                               {u"fields"_qs, fields},
                               {u"hex"_qs, protocol::hexDump(report.view()).replace(u'\n', u' ')}});
    }
    return out;
}

QJsonArray linesJson(const SelfTest& test)
{
    QJsonArray lines;
    for (const SelfTestLine& line : test.lines())
        lines.append(QJsonObject{{u"id"_qs, line.id},
                                 {u"name"_qs, line.name},
                                 {u"outcome"_qs, toString(line.outcome)},
                                 {u"value"_qs, line.value ? QJsonValue(*line.value) : QJsonValue()},
                                 {u"figure"_qs, line.figure},
                                 {u"limit"_qs, line.limit},
                                 {u"advice"_qs, line.advice}});
    return lines;
}

void printLines(const SelfTest& test)
{
    for (const SelfTestLine& line : test.lines()) {
        QString text = u"%1%2%3"_qs.arg(toString(line.outcome), -12).arg(line.name, -26).arg(line.figure);
        if (!line.limit.isEmpty())
            text += u"  (%1)"_qs.arg(line.limit);
        if (!line.advice.isEmpty())
            text += u"\n%1%2"_qs.arg(QString(), 38).arg(line.advice);
        print(text);
    }
}

void printReports(const DeviceFacts& facts, const std::vector<LoggedReport>& reports)
{
    for (const protocol::DescriptorItem& item : protocol::descriptorInWords(facts.descriptor))
        print(u"%1%2%3"_qs.arg(item.hex, -18).arg(QString(), 2 * item.depth).arg(item.words));
    for (const LoggedReport& report : reports) {
        const protocol::ReportWords words = protocol::reportInWords(report.view());
        QStringList fields;
        for (const protocol::FieldWords& field : words.fields)
            fields << u"%1 %2"_qs.arg(field.name, field.value);
        print(u"%1%2"_qs.arg(words.kind, -16)
                  .arg(words.problem.isEmpty() ? fields.join(u"; "_qs) : words.problem));
    }
}

/// One look at a gripper: opened, tested where asked for, told.
class Look {
public:
    explicit Look(bool testing) : m_testing(testing) {}

    /// Usage and device errors; a self-test tells of a gripper that does not open as well.
    Expected<void> take(const QString& address)
    {
        RETURN_IF_ERROR(m_connection.connectTo(address));
        if (!drive([this] { poll(); }, [this] { return ended(); }, describePatience_s))
            return interrupted() ? failure(ErrorCode::Cancelled, {u"The self-test"_qs})
                                 : failure(ErrorCode::DeviceTimeout,
                                           {u"answer"_qs, QString::number(describePatience_s)});
        if (m_testing || m_connection.state() == ConnectSession::State::Connected)
            return {};
        return tl::unexpected<Error>(m_connection.lastError().value_or(
            Error{ErrorCode::DeviceLost, {m_connection.address(), u"it did not open"_qs}}));
    }

    void tell(bool withReports, bool json)
    {
        const GripperIdentity identity = m_connection.identity();
        const DeviceFacts facts = findDeviceFacts(identity.address, identity.serial);
        const GripperPort* const port = m_connection.port();
        const ReportLog* const log = port ? port->reportLog() : nullptr;
        const std::vector<LoggedReport> reports = log ? log->last() : std::vector<LoggedReport>();
        if (!json) {
            print(u"%1, serial %2, firmware %3, %4"_qs.arg(identity.name, identity.serial, identity.firmware,
                                                           identity.address));
            if (withReports)
                printReports(facts, reports);
            return printLines(m_test);
        }
        QJsonObject document{{u"identity"_qs, identityJson(identity, facts)}};
        if (withReports) {
            document.insert(u"descriptor"_qs, descriptorJson(facts));
            document.insert(u"reports"_qs, reportsJson(reports));
        }
        if (m_testing)
            document.insert(u"self_test"_qs,
                            QJsonObject{{u"passed"_qs, m_test.passed()}, {u"lines"_qs, linesJson(m_test)}});
        printJson(document);
    }

    [[nodiscard]] bool fine() const { return !m_testing || m_test.passed(); }

private:
    void poll()
    {
        m_connection.poll();
        if (m_testing && m_test.state() == SelfTest::State::Idle)
            (void)m_test.start();
        m_test.poll();
    }
    [[nodiscard]] bool ended() const
    {
        return m_testing ? m_test.state() == SelfTest::State::Done
                         : m_connection.state() != ConnectSession::State::Connecting;
    }

    bool m_testing;
    DeviceFactory m_factory;
    ConnectSession m_connection{m_factory};
    SelfTest m_test{m_connection};
};

} // namespace

int runDevice(const QStringList& arguments)
{
    CommandLine line(u"device"_qs, u"Says what a gripper is, shows its last reports in words, and tests it "
                                   "without moving it. Exit 4: the self-test found something."_qs);
    line.option(u"device"_qs, u"ADDR"_qs, u"the gripper's address"_qs, u"virtual:"_qs);
    line.flag(u"self-test"_qs,
              u"listens for 2 s, then stops (and disarms) it: rate, losses, clock, noise, stop"_qs);
    line.flag(u"reports"_qs, u"the last reports, and the report descriptor, in words and bytes"_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    catchInterrupts();
    Look look(line.isSet(u"self-test"_qs));
    if (const Expected<void> taken = look.take(line.text(u"device"_qs)); !taken)
        return fail(taken.error(), json);
    look.tell(line.isSet(u"reports"_qs), json);
    return static_cast<int>(look.fine() ? Exit::Done : Exit::Device);
}

} // namespace gripscope::cli
