// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/report_words.h"

#include "core/base/words.h"
#include "devices/protocol/codec.h"

#include <QStringList>

#include <array>

namespace gripscope::protocol {

using namespace Qt::StringLiterals;

namespace {

using Fields = std::vector<FieldWords>;

QString number(std::int64_t value)
{
    return QString::number(value);
}

QString real(double value)
{
    return Words::number(value, 'g', 12);
}

QString seconds(std::uint32_t time_us)
{
    return u"%1 s"_qs.arg(1e-6 * time_us, 0, 'f', 6);
}

QString words(ExcitationState state)
{
    const std::array names{Words::tr("none"), Words::tr("loading"), Words::tr("running"),
                           Words::tr("finished"), Words::tr("stopped")};
    const auto index = static_cast<std::size_t>(state);
    return index < names.size() ? names[index] : number(static_cast<int>(state));
}

QString words(ForceUnit unit)
{
    const std::array names{Words::tr("not known"), u"N"_qs, u"mN"_qs, u"kN"_qs};
    return names.at(static_cast<std::size_t>(unit));
}

QString words(PositionUnit unit)
{
    const std::array names{Words::tr("not known"), u"m"_qs, u"mm"_qs, u"um"_qs};
    return names.at(static_cast<std::size_t>(unit));
}

Fields fieldsOf(const StreamReport& m)
{
    Fields fields{{Words::tr("status"), statusWords(m.status)},
                  {Words::tr("report sequence"), number(m.reportSequence)},
                  {Words::tr("first sample"), number(m.firstSample)},
                  {Words::tr("device time"), seconds(m.timestamp_us)},
                  {Words::tr("excitation"),
                   Words::tr("%1, number %2").arg(words(m.excitation)).arg(m.excitationNumber)},
                  {Words::tr("samples"), number(m.count)}};
    for (std::size_t i = 0; i < m.count; ++i)
        fields.push_back(
            {Words::tr("sample %1").arg(i + 1),
             Words::tr("force %1, position %2 counts").arg(m.samples[i].force).arg(m.samples[i].position)});
    return fields;
}

Fields fieldsOf(const Acknowledgement& m)
{
    return {{Words::tr("status"), statusWords(m.status)},
            {Words::tr("command"), Words::tr("%1, number %2")
                                       .arg(reportName(static_cast<std::uint8_t>(m.command)))
                                       .arg(m.commandNumber)},
            {Words::tr("result"), describe(m.command, m.result, m.detail)},
            {Words::tr("detail"), number(m.detail)},
            {Words::tr("device time"), seconds(m.timestamp_us)},
            {Words::tr("excitation"),
             Words::tr("%1, number %2").arg(words(m.excitation)).arg(m.excitationNumber)}};
}

Fields fieldsOf(const ArmCommand& m)
{
    return {{Words::tr("token"),
             m.token == 0 ? Words::tr("none") : u"0x%1"_qs.arg(m.token, 8, 16, QLatin1Char('0'))}};
}

Fields fieldsOf(const SetLimitsCommand& m)
{
    return {{Words::tr("largest force"), Words::tr("%1 counts").arg(m.maxForce)},
            {Words::tr("longest travel"), Words::tr("%1 counts").arg(m.maxTravel)}};
}

Fields fieldsOf(const UploadCommand& m)
{
    QStringList forces;
    for (std::size_t i = 0; i < m.count; ++i)
        forces << number(m.forces[i]);
    return {{Words::tr("excitation"), number(m.excitationNumber)},
            {Words::tr("from index"), number(m.offset)},
            {Words::tr("forces"), Words::tr("%1 counts").arg(forces.join(u' '))}};
}

Fields fieldsOf(const StartCommand& m)
{
    return {{Words::tr("excitation"), number(m.excitationNumber)},
            {Words::tr("forces"), number(m.samples)},
            {Words::tr("their CRC"), u"0x%1"_qs.arg(m.forcesCrc, 4, 16, QLatin1Char('0'))}};
}

Fields fieldsOf(const FinishCommand& m)
{
    return {{Words::tr("excitation"), number(m.excitationNumber)}};
}

Fields fieldsOf(const Command& m)
{
    Fields fields{{Words::tr("number"), number(m.number)}};
    const Fields more = std::visit(
        [](const auto& body) -> Fields {
            if constexpr (requires { fieldsOf(body); })
                return fieldsOf(body);
            else
                return {};
        },
        m.body);
    fields.insert(fields.end(), more.begin(), more.end());
    return fields;
}

Fields fieldsOf(const IdentityFeature& m)
{
    return {{Words::tr("serial number"), QString::fromStdString(m.serial)},
            {Words::tr("firmware"), QString::fromStdString(m.firmware)},
            {Words::tr("name"), QString::fromStdString(m.name)},
            {Words::tr("protocol"), u"%1.%2"_qs.arg(versionMajor).arg(m.protocolMinor)}};
}

Fields fieldsOf(const MeasurementFeature& m)
{
    return {{Words::tr("one count of force"), u"%1 %2"_qs.arg(real(m.forcePerCount), words(m.forceUnit))},
            {Words::tr("one count of position"),
             u"%1 %2"_qs.arg(real(m.positionPerCount), words(m.positionUnit))},
            {Words::tr("sample time"), u"%1 s"_qs.arg(real(m.sampleTime_s))},
            {Words::tr("position later by"), u"%1 s"_qs.arg(real(m.forceLag_s))},
            {Words::tr("force between samples"),
             m.hold == ForceHold::Zero ? Words::tr("held") : Words::tr("a straight line")},
            {Words::tr("takes commands"), m.commandable ? Words::tr("yes") : Words::tr("no")},
            {Words::tr("watchdog"), m.watchdog_ms == 0 ? Words::tr("none") : u"%1 ms"_qs.arg(m.watchdog_ms)}};
}

Fields fieldsOf(const LimitsFeature& m)
{
    return {{Words::tr("largest force"), Words::tr("%1 counts").arg(m.maxForce)},
            {Words::tr("longest travel"), Words::tr("%1 counts").arg(m.maxTravel)},
            {Words::tr("longest excitation"), Words::tr("%1 samples").arg(m.maxSamples)}};
}

template <typename Message>
void fill(ReportWords& out, const Decoded<Message>& message)
{
    if (message)
        out.fields = fieldsOf(*message);
    else
        out.problem = describe(message.error());
}

} // namespace

QString statusWords(std::uint16_t status)
{
    const std::array names{
        Words::tr("armed"),        Words::tr("moving"),          Words::tr("force limit"),
        Words::tr("travel limit"), Words::tr("force saturated"), Words::tr("position saturated"),
        Words::tr("fault"),        Words::tr("watchdog"),        Words::tr("button")};
    QStringList set;
    for (std::size_t bit = 0; bit < 16; ++bit)
        if (status >> bit & 1)
            set << (bit < names.size() ? names[bit] : Words::tr("bit %1").arg(bit));
    return set.isEmpty() ? Words::tr("none") : set.join(u", "_qs);
}

QString reportName(std::uint8_t id)
{
    switch (static_cast<ReportId>(id)) {
    case ReportId::Stream:
        return Words::tr("Stream");
    case ReportId::Acknowledgement:
        return Words::tr("Acknowledgement");
    case ReportId::Identity:
        return Words::tr("Identity");
    case ReportId::Measurement:
        return Words::tr("Measurement");
    case ReportId::Limits:
        return Words::tr("Limits");
    case ReportId::Arm:
        return Words::tr("Arm");
    case ReportId::Disarm:
        return Words::tr("Disarm");
    case ReportId::Stop:
        return Words::tr("Stop");
    case ReportId::Heartbeat:
        return Words::tr("Heartbeat");
    case ReportId::SetLimits:
        return Words::tr("Set limits");
    case ReportId::Upload:
        return Words::tr("Upload");
    case ReportId::Start:
        return Words::tr("Start");
    case ReportId::Finish:
        return Words::tr("Finish");
    }
    return Words::tr("unknown report 0x%1").arg(id, 2, 16, QLatin1Char('0'));
}

QString hexDump(ReportView bytes)
{
    QString text;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        if (i > 0)
            text += i % 16 == 0 ? QLatin1Char('\n') : QLatin1Char(' ');
        text += u"%1"_qs.arg(bytes[i], 2, 16, QLatin1Char('0'));
    }
    return text;
}

ReportWords reportInWords(ReportView bytes)
{
    ReportWords out;
    if (bytes.empty()) {
        out.kind = Words::tr("empty report");
        out.problem = describe(DecodeError(DecodeError::Length));
        return out;
    }
    out.kind = reportName(bytes[0]);
    switch (static_cast<ReportId>(bytes[0])) {
    case ReportId::Identity:
        fill(out, decodeIdentity(bytes));
        return out;
    case ReportId::Measurement:
        fill(out, decodeMeasurement(bytes));
        return out;
    case ReportId::Limits:
        fill(out, decodeLimits(bytes));
        return out;
    case ReportId::Stream:
    case ReportId::Acknowledgement:
        if (const Decoded<InputMessage> message = decodeInput(bytes))
            out.fields = std::visit([](const auto& m) { return fieldsOf(m); }, *message);
        else
            out.problem = describe(message.error());
        return out;
    default:
        fill(out, decodeCommand(bytes));
        return out;
    }
}

} // namespace gripscope::protocol
