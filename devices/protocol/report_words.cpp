// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/report_words.h"

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
    return QString::number(value, 'g', 12);
}

QString seconds(std::uint32_t time_us)
{
    return u"%1 s"_qs.arg(1e-6 * time_us, 0, 'f', 6);
}

QString words(ExcitationState state)
{
    static const std::array names{u"none"_qs, u"loading"_qs, u"running"_qs, u"finished"_qs, u"stopped"_qs};
    const auto index = static_cast<std::size_t>(state);
    return index < names.size() ? names[index] : number(static_cast<int>(state));
}

QString words(ForceUnit unit)
{
    static const std::array names{u"not known"_qs, u"N"_qs, u"mN"_qs, u"kN"_qs};
    return names.at(static_cast<std::size_t>(unit));
}

QString words(PositionUnit unit)
{
    static const std::array names{u"not known"_qs, u"m"_qs, u"mm"_qs, u"um"_qs};
    return names.at(static_cast<std::size_t>(unit));
}

Fields fieldsOf(const StreamReport& m)
{
    Fields fields{{u"status"_qs, statusWords(m.status)},
                  {u"report sequence"_qs, number(m.reportSequence)},
                  {u"first sample"_qs, number(m.firstSample)},
                  {u"device time"_qs, seconds(m.timestamp_us)},
                  {u"excitation"_qs, u"%1, number %2"_qs.arg(words(m.excitation)).arg(m.excitationNumber)},
                  {u"samples"_qs, number(m.count)}};
    for (std::size_t i = 0; i < m.count; ++i)
        fields.push_back(
            {u"sample %1"_qs.arg(i + 1),
             u"force %1, position %2 counts"_qs.arg(m.samples[i].force).arg(m.samples[i].position)});
    return fields;
}

Fields fieldsOf(const Acknowledgement& m)
{
    return {{u"status"_qs, statusWords(m.status)},
            {u"command"_qs,
             u"%1, number %2"_qs.arg(reportName(static_cast<std::uint8_t>(m.command))).arg(m.commandNumber)},
            {u"result"_qs, QString::fromUtf8(describe(m.result))},
            {u"detail"_qs, number(m.detail)},
            {u"device time"_qs, seconds(m.timestamp_us)},
            {u"excitation"_qs, u"%1, number %2"_qs.arg(words(m.excitation)).arg(m.excitationNumber)}};
}

Fields fieldsOf(const SetLimitsCommand& m)
{
    return {{u"largest force"_qs, u"%1 counts"_qs.arg(m.maxForce)},
            {u"longest travel"_qs, u"%1 counts"_qs.arg(m.maxTravel)}};
}

Fields fieldsOf(const UploadCommand& m)
{
    QStringList forces;
    for (std::size_t i = 0; i < m.count; ++i)
        forces << number(m.forces[i]);
    return {{u"excitation"_qs, number(m.excitationNumber)},
            {u"from index"_qs, number(m.offset)},
            {u"forces"_qs, forces.join(u' ') + u" counts"_qs}};
}

Fields fieldsOf(const StartCommand& m)
{
    return {{u"excitation"_qs, number(m.excitationNumber)},
            {u"forces"_qs, number(m.samples)},
            {u"their CRC"_qs, u"0x%1"_qs.arg(m.forcesCrc, 4, 16, QLatin1Char('0'))}};
}

Fields fieldsOf(const FinishCommand& m)
{
    return {{u"excitation"_qs, number(m.excitationNumber)}};
}

Fields fieldsOf(const Command& m)
{
    Fields fields{{u"number"_qs, number(m.number)}};
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
    return {{u"serial number"_qs, QString::fromStdString(m.serial)},
            {u"firmware"_qs, QString::fromStdString(m.firmware)},
            {u"name"_qs, QString::fromStdString(m.name)},
            {u"protocol"_qs, u"%1.%2"_qs.arg(versionMajor).arg(m.protocolMinor)}};
}

Fields fieldsOf(const MeasurementFeature& m)
{
    return {{u"one count of force"_qs, u"%1 %2"_qs.arg(real(m.forcePerCount), words(m.forceUnit))},
            {u"one count of position"_qs, u"%1 %2"_qs.arg(real(m.positionPerCount), words(m.positionUnit))},
            {u"sample time"_qs, u"%1 s"_qs.arg(real(m.sampleTime_s))},
            {u"position later by"_qs, u"%1 s"_qs.arg(real(m.forceLag_s))},
            {u"force between samples"_qs, m.hold == ForceHold::Zero ? u"held"_qs : u"a straight line"_qs},
            {u"takes commands"_qs, m.commandable ? u"yes"_qs : u"no"_qs},
            {u"watchdog"_qs, m.watchdog_ms == 0 ? u"none"_qs : u"%1 ms"_qs.arg(m.watchdog_ms)}};
}

Fields fieldsOf(const LimitsFeature& m)
{
    return {{u"largest force"_qs, u"%1 counts"_qs.arg(m.maxForce)},
            {u"longest travel"_qs, u"%1 counts"_qs.arg(m.maxTravel)},
            {u"longest excitation"_qs, u"%1 samples"_qs.arg(m.maxSamples)}};
}

template <typename Message>
void fill(ReportWords& out, const Decoded<Message>& message)
{
    if (message)
        out.fields = fieldsOf(*message);
    else
        out.problem = QString::fromUtf8(describe(message.error()));
}

} // namespace

QString statusWords(std::uint16_t status)
{
    static const std::array names{u"armed"_qs,        u"moving"_qs,          u"force limit"_qs,
                                  u"travel limit"_qs, u"force saturated"_qs, u"position saturated"_qs,
                                  u"fault"_qs,        u"watchdog"_qs};
    QStringList set;
    for (std::size_t bit = 0; bit < 16; ++bit)
        if (status >> bit & 1)
            set << (bit < names.size() ? names[bit] : u"bit %1"_qs.arg(bit));
    return set.isEmpty() ? u"none"_qs : set.join(u", "_qs);
}

QString reportName(std::uint8_t id)
{
    switch (static_cast<ReportId>(id)) {
    case ReportId::Stream:
        return u"Stream"_qs;
    case ReportId::Acknowledgement:
        return u"Acknowledgement"_qs;
    case ReportId::Identity:
        return u"Identity"_qs;
    case ReportId::Measurement:
        return u"Measurement"_qs;
    case ReportId::Limits:
        return u"Limits"_qs;
    case ReportId::Arm:
        return u"Arm"_qs;
    case ReportId::Disarm:
        return u"Disarm"_qs;
    case ReportId::Stop:
        return u"Stop"_qs;
    case ReportId::Heartbeat:
        return u"Heartbeat"_qs;
    case ReportId::SetLimits:
        return u"Set limits"_qs;
    case ReportId::Upload:
        return u"Upload"_qs;
    case ReportId::Start:
        return u"Start"_qs;
    case ReportId::Finish:
        return u"Finish"_qs;
    }
    return u"unknown report 0x%1"_qs.arg(id, 2, 16, QLatin1Char('0'));
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

ReportWords inWords(ReportView bytes)
{
    ReportWords out;
    if (bytes.empty()) {
        out.kind = u"empty report"_qs;
        out.problem = QString::fromUtf8(describe(DecodeError::Length));
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
            out.problem = QString::fromUtf8(describe(message.error()));
        return out;
    default:
        fill(out, decodeCommand(bytes));
        return out;
    }
}

} // namespace gripscope::protocol
