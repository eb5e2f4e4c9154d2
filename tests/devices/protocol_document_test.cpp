// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/protocol/arming_obstacle.h"
#include "devices/protocol/codec.h"
#include "devices/protocol/report_descriptor.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QMap>
#include <QTest>

using namespace gripscope;
using namespace gripscope::protocol;
using namespace Qt::StringLiterals;

namespace {

using Fields = QMap<QString, QString>;

struct Example {
    QByteArray bytes;
    Fields fields;
};

QString document()
{
    QFile file(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/devices/PROTOCOL.md"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The ```example blocks: lines of hexadecimal bytes, then lines "name = value".
std::vector<Example> examplesIn(const QString& text)
{
    std::vector<Example> examples;
    const QStringList blocks = text.split(u"```example\n"_qs).mid(1);
    for (const QString& block : blocks) {
        Example example;
        for (const QString& line : block.section(u"```"_qs, 0, 0).split(u'\n', Qt::SkipEmptyParts)) {
            if (line.contains(u'='))
                example.fields[line.section(u" = "_qs, 0, 0)] = line.section(u" = "_qs, 1);
            else
                example.bytes += QByteArray::fromHex(line.toLatin1());
        }
        examples.push_back(example);
    }
    return examples;
}

QString hex(int value, int digits)
{
    return u"0x%1"_qs.arg(value, digits, 16, QLatin1Char('0'));
}

template <typename Number>
QString text(Number value)
{
    return QString::number(value);
}

Fields fieldsOf(const StreamReport& report)
{
    QStringList samples;
    for (std::size_t i = 0; i < report.count; ++i)
        samples << text(report.samples[i].force) + u',' + text(report.samples[i].position);
    return {{u"report"_qs, u"Stream"_qs},
            {u"status"_qs, hex(report.status, 4)},
            {u"report sequence"_qs, text(report.reportSequence)},
            {u"first sample"_qs, text(report.firstSample)},
            {u"time"_qs, text(report.timestamp_us)},
            {u"excitation state"_qs, text(static_cast<int>(report.excitation))},
            {u"excitation"_qs, text(report.excitationNumber)},
            {u"samples"_qs, samples.join(u' ')}};
}

Fields fieldsOf(const Acknowledgement& answer)
{
    return {{u"report"_qs, u"Acknowledgement"_qs},
            {u"status"_qs, hex(answer.status, 4)},
            {u"number"_qs, text(answer.commandNumber)},
            {u"command"_qs, hex(static_cast<int>(answer.command), 2)},
            {u"result"_qs, text(static_cast<int>(answer.result))},
            {u"detail"_qs, text(answer.detail)},
            {u"time"_qs, text(answer.timestamp_us)},
            {u"excitation state"_qs, text(static_cast<int>(answer.excitation))},
            {u"excitation"_qs, text(answer.excitationNumber)}};
}

Fields fieldsOf(const Command& command)
{
    static const QMap<ReportId, QString> names{
        {ReportId::Arm, u"Arm"_qs},       {ReportId::Disarm, u"Disarm"_qs},
        {ReportId::Stop, u"Stop"_qs},     {ReportId::Heartbeat, u"Heartbeat"_qs},
        {ReportId::Upload, u"Upload"_qs}, {ReportId::SetLimits, u"Set limits"_qs},
        {ReportId::Start, u"Start"_qs},   {ReportId::Finish, u"Finish"_qs}};
    Fields fields{{u"report"_qs, names.value(reportId(command.body))}, {u"number"_qs, text(command.number)}};
    if (const auto* arm = std::get_if<ArmCommand>(&command.body))
        fields[u"token"_qs] = u"0x%1"_qs.arg(arm->token, 8, 16, QLatin1Char('0'));
    if (const auto* limits = std::get_if<SetLimitsCommand>(&command.body)) {
        fields[u"force"_qs] = text(limits->maxForce);
        fields[u"travel"_qs] = text(limits->maxTravel);
    }
    if (const auto* upload = std::get_if<UploadCommand>(&command.body)) {
        QStringList forces;
        for (std::size_t i = 0; i < upload->count; ++i)
            forces << text(upload->forces[i]);
        fields[u"excitation"_qs] = text(upload->excitationNumber);
        fields[u"first"_qs] = text(upload->offset);
        fields[u"forces"_qs] = forces.join(u' ');
    }
    if (const auto* start = std::get_if<StartCommand>(&command.body)) {
        fields[u"excitation"_qs] = text(start->excitationNumber);
        fields[u"samples"_qs] = text(start->samples);
        fields[u"crc"_qs] = hex(start->forcesCrc, 4);
    }
    if (const auto* finish = std::get_if<FinishCommand>(&command.body))
        fields[u"excitation"_qs] = text(finish->excitationNumber);
    return fields;
}

Fields fieldsOf(const IdentityFeature& identity)
{
    return {{u"report"_qs, u"Identity"_qs},
            {u"serial"_qs, QString::fromStdString(identity.serial)},
            {u"firmware"_qs, QString::fromStdString(identity.firmware)},
            {u"name"_qs, QString::fromStdString(identity.name)}};
}

Fields fieldsOf(const MeasurementFeature& measurement)
{
    return {{u"report"_qs, u"Measurement"_qs},
            {u"force unit"_qs, text(static_cast<int>(measurement.forceUnit))},
            {u"position unit"_qs, text(static_cast<int>(measurement.positionUnit))},
            {u"hold"_qs, text(static_cast<int>(measurement.hold))},
            {u"commandable"_qs, text(measurement.commandable ? 1 : 0)},
            {u"watchdog"_qs, text(measurement.watchdog_ms)},
            {u"force in a count"_qs, text(measurement.forcePerCount)},
            {u"position in a count"_qs, text(measurement.positionPerCount)},
            {u"sample time"_qs, text(measurement.sampleTime_s)},
            {u"lag"_qs, text(measurement.forceLag_s)}};
}

Fields fieldsOf(const LimitsFeature& limits)
{
    return {{u"report"_qs, u"Limits"_qs},
            {u"force"_qs, text(limits.maxForce)},
            {u"travel"_qs, text(limits.maxTravel)},
            {u"samples"_qs, text(limits.maxSamples)}};
}

/// What the bytes say and what they become when written again; nothing when no decoder takes them.
struct Reading {
    Fields fields;
    Report again{};
};
template <typename Message>
std::optional<Reading> reading(const Decoded<Message>& message)
{
    if (!message)
        return std::nullopt;
    return Reading{fieldsOf(*message), encode(*message)};
}
std::optional<Reading> readAny(ReportView bytes)
{
    if (const Decoded<InputMessage> input = decodeInput(bytes))
        return std::visit(
            [](const auto& message) { return reading(Decoded<std::decay_t<decltype(message)>>(message)); },
            *input);
    if (auto found = reading(decodeCommand(bytes)))
        return found;
    if (auto found = reading(decodeIdentity(bytes)))
        return found;
    if (auto found = reading(decodeMeasurement(bytes)))
        return found;
    return reading(decodeLimits(bytes));
}

} // namespace

class ProtocolDocumentTest : public QObject {
    Q_OBJECT
private slots:
    void everyExampleSaysWhatItsBytesSay()
    {
        const std::vector<Example> examples = examplesIn(document());
        QStringList seen;
        for (const Example& example : examples) {
            QCOMPARE(example.bytes.size(), qsizetype(reportSize));
            const ReportView bytes(reinterpret_cast<const std::uint8_t*>(example.bytes.constData()),
                                   reportSize);
            const std::optional<Reading> found = readAny(bytes);
            QVERIFY2(found, qPrintable(example.fields.value(u"report"_qs)));
            QCOMPARE(found->fields, example.fields);
            Report again = found->again;
            seal(again, bytes[1] & 0x0F); // an example may be of an older version
            QVERIFY(std::equal(bytes.begin(), bytes.end(), again.begin(), again.end()));
            seen << example.fields.value(u"report"_qs);
        }
        seen.removeDuplicates();
        QCOMPARE(seen.size(), 13); // one of each report ID at least
    }

    void theStartIsThatOfTheForcesInTheUploads()
    {
        std::vector<std::int32_t> forces(15);
        std::optional<StartCommand> start;
        std::size_t uploaded = 0;
        for (const Example& example : examplesIn(document())) {
            const auto command = decodeCommand(
                ReportView(reinterpret_cast<const std::uint8_t*>(example.bytes.constData()), reportSize));
            if (!command)
                continue;
            if (const auto* upload = std::get_if<UploadCommand>(&command->body)) {
                QVERIFY(upload->offset + upload->count <= forces.size());
                std::copy_n(upload->forces.begin(), upload->count, forces.begin() + upload->offset);
                uploaded += upload->count;
            } else if (const auto* order = std::get_if<StartCommand>(&command->body)) {
                start = *order;
            }
        }
        QCOMPARE(uploaded, forces.size());
        QVERIFY(start);
        QCOMPARE(std::size_t(start->samples), forces.size());
        QCOMPARE(start->forcesCrc, forcesCrc(forces));
    }

    void theRangesArePrintedAsTheProgramKeepsThem()
    {
        const auto line = [](const char* begins) {
            for (const QString& text : document().split(u'\n'))
                if (text.startsWith(QString::fromUtf8(begins)))
                    return text;
            return QString();
        };
        const auto range = [](double least, double most) {
            return u"| %1 to %2 |"_qs.arg(QString::number(least), QString::number(most));
        };
        const QString perCount = range(leastPerCount, mostPerCount).replace(u"1e+06"_qs, u"1e6"_qs);
        QVERIFY(line("| 8 | f64 |").contains(perCount));
        QVERIFY(line("| 16 | f64 |").contains(perCount));
        QVERIFY(
            line("| 24 | f64 |")
                .endsWith(
                    u"| 1e-6 to %1 | 1e-6 to %2 |"_qs.arg(longestSampleTime_s).arg(longestReportPeriod_s)));
        QCOMPARE(shortestSampleTime_s, 1e-6);
        QVERIFY(line("| 32 | f64 |").endsWith(range(-longestLag_s, longestLag_s)));
        QVERIFY(line("| 6 | u16 | watchdog").endsWith(range(shortestWatchdog_ms, longestWatchdog_ms)));
        QVERIFY(document().startsWith(
            u"# The Gripscope protocol, version %1.%2\n"_qs.arg(versionMajor).arg(versionMinor)));
    }

    void theReportDescriptorIsTheOneThatIsPrinted()
    {
        const QString hex = document().section(u"```descriptor\n"_qs, 1).section(u"```"_qs, 0, 0);
        const std::vector<std::uint8_t> bytes = reportDescriptor();
        QCOMPARE(QByteArray::fromHex(hex.toLatin1()), QByteArray(reinterpret_cast<const char*>(bytes.data()),
                                                                 static_cast<qsizetype>(bytes.size())));
    }

    void theCrcIsTheOneThatIsNamed()
    {
        const QByteArray text("123456789");
        QCOMPARE(crc16({reinterpret_cast<const std::uint8_t*>(text.constData()), 9}), std::uint16_t(0x29B1));
    }
};

GRIPSCOPE_TEST(ProtocolDocumentTest)
#include "protocol_document_test.moc"
