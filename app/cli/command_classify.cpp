// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/chain_library.h"
#include "app/cli/commands.h"
#include "app/cli/drive.h"
#include "app/cli/exit_code.h"
#include "app/cli/measured_transfer.h"
#include "app/cli/output.h"
#include "app/cli/shared_options.h"
#include "app/cli/verdict_output.h"
#include "core/session/inspect_session.h"
#include "devices/gripper_factory.h"

#include <QFileInfo>
#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Longer than any identification takes.
constexpr double patience_s = 600;

class Classification {
public:
    Classification(const QString& library, const IdentificationOptions& options, const VerdictOptions& rates,
                   const std::optional<CommonShift>& transfer)
        : m_chains(library), m_library(library), m_connection(m_devices), m_session(m_connection, m_library)
    {
        m_session.setStoring(false);
        m_session.setIdentificationOptions(options);
        m_session.setRates(rates);
        m_session.setTransfer(transfer);
    }

    /// Reads the types.
    std::optional<Error> begin()
    {
        return waitFor(
            [this] { return m_session.state() == InspectSession::State::Ready || m_session.lastError(); });
    }

    Expected<Verdict> judge(const QString& file, const CsvReadOptions& reading)
    {
        Expected<Recording> recording = readRecordingCsv(file, reading);
        if (!recording)
            return tl::unexpected<Error>(recording.error());
        m_chains.complete(*recording, file);
        if (const Expected<void> taken = m_session.judgeRecording(std::move(*recording), file); !taken)
            return tl::unexpected<Error>(taken.error());
        if (const std::optional<Error> error =
                waitFor([this] { return m_session.state() == InspectSession::State::Ready; }))
            return tl::unexpected<Error>(*error);
        return m_session.result()->verdict;
    }

private:
    std::optional<Error> waitFor(const std::function<bool()>& done)
    {
        if (!drive([this] { m_session.poll(); }, done, patience_s))
            return Error{ErrorCode::Cancelled, {u"The classification"_qs}};
        return m_session.lastError();
    }

    ChainLibrary m_chains;
    DeviceFactory m_devices;
    LibraryService m_library;
    ConnectSession m_connection; // stays unconnected: the squeezes come from files
    InspectSession m_session;
};

/// The adjustment for the gripper whose squeezes `other` holds; none without a library of that kind, or where
/// it would not help.
Expected<std::optional<CommonShift>> transferFrom(const QString& other, const QString& library)
{
    if (other.isEmpty())
        return std::optional<CommonShift>();
    const Expected<TransferReport> report = measuredTransfer(library, other);
    if (!report)
        return tl::unexpected<Error>(report.error());
    for (const QString& sentence : report->words)
        message(sentence);
    return report->adjust ? report->error : std::nullopt;
}

Expected<QString> existingLibrary(const CommandLine& line)
{
    Expected<QString> file = libraryFile(line);
    // Opening would make an empty one, and every part would be unknown to it.
    if (file && !QFileInfo::exists(*file))
        return failure(ErrorCode::StorageOpen, {*file, u"there is no such file; enrol types first"_qs});
    return file;
}

} // namespace

int runClassify(const QStringList& arguments)
{
    CommandLine line(u"classify"_qs,
                     u"Says for each recording which enrolled type it shows, or that it is none."_qs,
                     u"FILE..."_qs);
    addLibraryOption(line);
    line.option(u"false-reject"_qs, u"RATE"_qs, u"Share of known parts that may be called unknown."_qs,
                u"0.01"_qs);
    line.option(u"wrong-type"_qs, u"RATE"_qs, u"Share of known parts that may be named another type."_qs,
                u"0.001"_qs);
    line.option(u"stranger-accept"_qs, u"RATE"_qs,
                u"Share of strangers, spread evenly over the instrument's range in logarithms, that may be "
                "named a type."_qs,
                u"0.01"_qs);
    line.option(
        u"confidence"_qs, u"SHARE"_qs,
        u"The false-reject rate holds for this library with this confidence, 0.95 say; without it, on "
        "average over libraries."_qs);
    line.option(u"transfer"_qs, u"OTHER"_qs,
                u"Library with squeezes of the gripper that these recordings are from, where the types were "
                "enrolled on another: see transfer."_qs);
    line.flag(u"robust"_qs, u"For types that spread unlike and heavier tails than a Gaussian's."_qs);
    addReadingOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const CsvReadOptions reading = csvReadOptions(line);
    const IdentificationOptions options = identificationOptions(line);
    VerdictOptions rates;
    rates.falseReject = line.number(u"false-reject"_qs);
    rates.wrongType = line.number(u"wrong-type"_qs);
    rates.strangerAccept = line.number(u"stranger-accept"_qs);
    if (line.isSet(u"confidence"_qs))
        rates.confidence = line.number(u"confidence"_qs);
    rates.robust = line.isSet(u"robust"_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    if (const std::optional<Error> error = rates.validate())
        return fail(*error, json);
    const Expected<QString> library = existingLibrary(line);
    if (!library)
        return fail(library.error(), json);

    const Expected<std::optional<CommonShift>> transfer = transferFrom(line.text(u"transfer"_qs), *library);
    if (!transfer)
        return fail(transfer.error(), json);
    Classification classification(*library, options, rates, *transfer);
    if (const std::optional<Error> error = classification.begin())
        return fail(*error, json);
    ExitCode exit;
    QJsonArray results;
    for (const QString& file : line.files()) {
        const Expected<Verdict> verdict = classification.judge(file, reading);
        if (!verdict) {
            message(u"gripscope-cli: %1"_qs.arg(verdict.error().describe()));
            results.append(errorDocument(file, verdict.error()));
            exit.add(exitFor(verdict.error()));
            continue;
        }
        if (verdict->kind != VerdictKind::Type)
            exit.add(Exit::NotAType);
        results.append(verdictJson(file, *verdict));
        if (!json)
            print(verdictText(file, *verdict));
    }
    if (json)
        printJson({{u"results"_qs, results}});
    return exit.value();
}

} // namespace gripscope::cli
