// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/gripper/lost_samples.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/drive.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "app/cli/options/recording_output.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/recordings/classification.h"
#include "core/base/json_value.h"
#include "core/recognition/verdict/rates_json.h"
#include "devices/replay/captured_session.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

struct ReplayRequest {
    bool squeezes = false;
    QString folder;     ///< for recordings; empty: none are written
    bool force = false; ///< other files that are there are replaced
    bool ratesGiven = false;
    VerdictOptions rates; ///< those that were given
    /// The inspections of a session tell together how its gripper holds the force; they are judged apart from
    /// the other squeezes, as they were.
    std::unique_ptr<Classification> inspections, others;
    bool json = false;
};

QJsonObject ratesJson(const VerdictOptions& rates, const QString& from)
{
    QJsonObject document = toJson(rates);
    document.insert(u"from"_qs, from);
    return document;
}

/// Squeeze `number` of the capture, in a document and in a line of text; its recording written where asked.
class SqueezeTeller {
public:
    SqueezeTeller(const ReplayRequest& request, const QString& file, ExitCode& exit)
        : m_request(request), m_stem(QFileInfo(file).completeBaseName()), m_exit(exit)
    {
    }

    QJsonObject tell(int number, const CapturedSqueeze& squeeze)
    {
        const Recording& recording = squeeze.recording;
        QJsonObject document{{u"number"_qs, number},
                             {u"begins_s"_qs, squeeze.begins_s},
                             {u"samples"_qs, static_cast<qint64>(recording.size())},
                             {u"lost_samples"_qs, lostSamples(recording)},
                             {u"missing_samples"_qs, static_cast<qint64>(squeeze.missingSamples)},
                             {u"noted"_qs, squeeze.noted}};
        QString text = u"%1  %2 s  %3 samples, %4 lost"_qs.arg(QString::number(number), 3)
                           .arg(squeeze.begins_s, 0, 'f', 3)
                           .arg(recording.size())
                           .arg(lostSamples(recording));
        if (squeeze.failure) {
            document[u"failure"_qs] = *squeeze.failure;
            text += u"  no recording: "_qs + *squeeze.failure;
        } else {
            document[u"failure"_qs] = QJsonValue::Null;
            write(number, recording, document, text);
            judge(number, squeeze, document, text);
        }
        if (squeeze.missingSamples > 0)
            message(u"Squeeze %1: the capture lost %2 samples that the program had."_qs.arg(number).arg(
                squeeze.missingSamples));
        if (m_request.squeezes && !m_request.json)
            print(text);
        return document;
    }

private:
    void write(int number, const Recording& recording, QJsonObject& document, QString& text)
    {
        if (m_request.folder.isEmpty())
            return;
        const QString file =
            QDir(m_request.folder)
                .filePath(u"%1-squeeze%2.csv"_qs.arg(m_stem).arg(number, 3, 10, QLatin1Char('0')));
        Expected<void> written = mayReplace(file, m_request.force);
        if (written)
            written = writeRecordingCsv(recording, file);
        if (!written)
            return refuse(written.error(), document);
        document[u"file"_qs] = file;
        text += u"  "_qs + file;
    }
    void judge(int number, const CapturedSqueeze& squeeze, QJsonObject& document, QString& text)
    {
        if (!m_request.inspections)
            return;
        const QString source = u"%1, squeeze %2"_qs.arg(m_stem).arg(number);
        const std::optional<SqueezeJudged> before = squeezeJudged(squeeze.judged);
        SqueezeJudged how = before.value_or(SqueezeJudged{m_request.rates, {}});
        if (m_request.ratesGiven)
            how.rates = m_request.rates;
        Classification& session = before ? *m_request.inspections : *m_request.others;
        Recording recording = squeeze.recording;
        if (!squeeze.noted) // else it has what was known of its gripper then, and that is what was judged
            session.complete(recording, source);
        const Expected<InspectSession::Result> result = session.judgeAgain(
            std::move(recording), source, how,
            before ? Classification::Adjusting::AsThen : Classification::Adjusting::AsTheLibrary);
        if (!result)
            return refuse(result.error(), document);
        document[u"rates"_qs] = ratesJson(how.rates, m_request.ratesGiven ? u"given"_qs
                                                     : before             ? u"capture"_qs
                                                                          : u"default"_qs);
        document[u"verdict"_qs] = verdictJson(source, result->verdict);
        text += u'\n' + verdictText(source, result->verdict);
        if (result->verdict.kind != VerdictKind::Type)
            m_exit.add(Exit::NotAType);
    }
    void refuse(const Error& error, QJsonObject& document)
    {
        message(u"gripscope-cli: "_qs + error.describe());
        document[u"error"_qs] = errorDocument(error)[u"error"_qs];
        m_exit.add(exitFor(error));
    }

    const ReplayRequest& m_request;
    const QString m_stem;
    ExitCode& m_exit;
};

QString inWords(const QString& file, const CapturedSession& session)
{
    const LinkCounters& counters = session.counters;
    return u"%1: %2 (%3), %4 s, %5 reports, %6 samples, %7 lost, %8 reports twice, %9 damaged"_qs.arg(
               file, session.identity.name, session.identity.serial, QString::number(session.seconds, 'f', 1),
               QString::number(counters.reports), QString::number(counters.samples),
               QString::number(counters.lostSamples), QString::number(counters.duplicateReports),
               QString::number(counters.badReports)) +
           u"; %1 squeezes"_qs.arg(session.squeezes.size()) +
           (session.droppedRecords > 0
                ? u". The capture itself did not keep %1 records."_qs.arg(session.droppedRecords)
                : QString());
}

QJsonObject sessionJson(const QString& file, const CapturedSession& session)
{
    const LinkCounters& counters = session.counters;
    return {{u"file"_qs, file},
            {u"session"_qs, session.name},
            {u"address"_qs, session.address},
            {u"serial"_qs, session.identity.serial},
            {u"device"_qs, session.identity.name},
            {u"seconds"_qs, session.seconds},
            {u"reports"_qs, static_cast<qint64>(counters.reports)},
            {u"samples"_qs, static_cast<qint64>(counters.samples)},
            {u"lost_samples"_qs, static_cast<qint64>(counters.lostSamples)},
            {u"duplicate_reports"_qs, static_cast<qint64>(counters.duplicateReports)},
            {u"bad_reports"_qs, static_cast<qint64>(counters.badReports)},
            {u"dropped_records"_qs, static_cast<qint64>(session.droppedRecords)}};
}

void replay(const QString& file, const ReplayRequest& request, ExitCode& exit)
{
    const Expected<CapturedSession> session = readCapturedSession(file);
    if (!session) {
        message(u"gripscope-cli: "_qs + session.error().describe());
        if (request.json)
            printJson(errorDocument(file, session.error()));
        exit.add(exitFor(session.error()));
        return;
    }
    if (!request.json)
        print(inWords(file, *session));
    SqueezeTeller teller(request, file, exit);
    QJsonArray squeezes;
    int number = 0;
    for (const CapturedSqueeze& squeeze : session->squeezes) {
        squeezes.append(teller.tell(++number, squeeze));
        if (interrupted())
            return;
    }
    QJsonObject document = sessionJson(file, *session);
    document[u"squeezes"_qs] = squeezes;
    if (request.json)
        printJson(document);
}

} // namespace

int runReplay(const QStringList& arguments)
{
    CommandLine line(
        u"replay"_qs,
        u"Reads captured sessions (.gscap) and cuts out the squeezes that were made, bit for bit; "
        "of a session in parts name the first. With a library they are judged, inspections at the rates that "
        "they were judged at, unless others are given, and refused where they were."_qs,
        u"FILE..."_qs, CommandLine::Json::OneAFile);
    line.flag(u"squeezes"_qs, u"Lists the squeezes."_qs);
    line.shortOption(u'o', u"output"_qs, u"FOLDER"_qs, u"Writes a recording (CSV) of each squeeze there."_qs);
    addForceOption(line);
    addLibraryOption(line);
    addRateOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    ReplayRequest request;
    request.json = line.isSet(u"json"_qs);
    request.squeezes = line.isSet(u"squeezes"_qs) || line.isSet(u"library"_qs);
    request.folder = line.text(u"output"_qs);
    request.force = line.isSet(u"force"_qs);
    request.ratesGiven = ratesAreGiven(line);
    request.rates = verdictRates(line);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    if (const std::optional<Error> error = request.rates.validate())
        return fail(*error, request.json);
    if (!request.folder.isEmpty() && !QDir().mkpath(request.folder))
        return fail({ErrorCode::FileUnwritable, {request.folder, u"the folder cannot be made"_qs}},
                    request.json);
    catchInterrupts();
    if (line.isSet(u"library"_qs)) {
        const Expected<QString> library = existingLibrary(line);
        if (!library)
            return fail(library.error(), request.json);
        for (auto* session : {&request.inspections, &request.others})
            *session = std::make_unique<Classification>(*library, IdentificationOptions{}, request.rates);
        if (const std::optional<Error> error = request.inspections->begin())
            return fail(*error, request.json);
        if (const std::optional<Error> error = request.others->begin(Classification::Telling::Nothing))
            return fail(*error, request.json);
    }
    ExitCode exit;
    for (const QString& file : line.files())
        replay(file, request, exit);
    return exit.value();
}

} // namespace gripscope::cli
