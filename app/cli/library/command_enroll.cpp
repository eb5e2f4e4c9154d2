// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/authorization.h"
#include "app/cli/library/chain_library.h"
#include "app/cli/library/enrollment.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/drive.h"
#include "app/cli/line/exit_code.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/session/enroll/enroll_session.h"
#include "devices/factory/gripper_factory.h"

#include <QJsonArray>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

/// Longer than any identification or commit takes.
constexpr double enrollPatience_s = 600;

/// What became of one file.
struct FileOutcome {
    bool added = false;
    QString reason; ///< when it was rejected
    Exit exit = Exit::Done;
};

FileOutcome rejected(const Error& error)
{
    return {false, error.describe(), exitFor(error)};
}

class Enrollment {
public:
    Enrollment(const QString& library, const Acting& acting, const IdentificationOptions& options)
        : m_operator(acting.operatorName), m_chains(library), m_library(library), m_connection(m_devices),
          m_session(m_connection, m_library)
    {
        m_library.actAs(acting);
        m_session.setOperator(acting.operatorName);
        m_session.setIdentificationOptions(options);
    }

    /// Opens the library and finds the type in it.
    std::optional<Error> begin(const QString& type)
    {
        if (const Expected<void> named = m_session.setName(type); !named)
            return named.error();
        if (const Expected<void> asked = m_session.setRecipe(recipeOfNewTypes()); !asked)
            return asked.error();
        return waitFor(EnrollSession::Activity::Storing);
    }

    FileOutcome add(const QString& file, const CsvReadOptions& reading)
    {
        Expected<Recording> recording = readRecordingCsv(file, reading);
        if (!recording)
            return rejected(recording.error());
        m_chains.complete(*recording, file);
        if (const Expected<void> taken = m_session.addRecording(std::move(*recording), file); !taken)
            return rejected(taken.error());
        if (const std::optional<Error> error = waitFor(EnrollSession::Activity::Identifying))
            return rejected(*error);
        const QString advice = m_session.squeezes().back().reason;
        if (!advice.isEmpty()) {
            (void)m_session.reject(advice);
            return {false, advice, Exit::NotAType};
        }
        const Expected<void> accepted = m_session.accept();
        const std::optional<Error> error =
            accepted ? waitFor(EnrollSession::Activity::Storing) : std::optional(accepted.error());
        if (!error)
            return {true, {}, Exit::Done};
        (void)m_session.reject(error->describe());
        return rejected(*error);
    }

    [[nodiscard]] Expected<bool> approve()
    {
        return m_library
            .run<bool>([type = typeName(), who = m_operator](Library& library) {
                return approveEnrolled(library, type, who);
            })
            .get();
    }
    [[nodiscard]] int squeezes() const { return m_session.acceptedCount(); }
    [[nodiscard]] QString typeName() const { return m_session.typeName(); }

private:
    std::optional<Error> waitFor(EnrollSession::Activity activity)
    {
        const bool done = drive([this] { m_session.poll(); },
                                [&] { return m_session.activity() != activity; }, enrollPatience_s);
        if (!done)
            return Error{ErrorCode::Cancelled, {u"The enrolment"_qs}};
        return m_session.lastError();
    }

    QString m_operator;
    ChainLibrary m_chains;
    DeviceFactory m_devices;
    LibraryService m_library;
    ConnectSession m_connection; // stays unconnected: the squeezes come from files
    EnrollSession m_session;
};

void addEnrollmentTableOptions(CommandLine& line)
{
    line.option(
        u"table"_qs, u"TABLE.csv"_qs,
        u"Instead of recordings a table of m, b and k, a row a squeeze, in the units of --force-unit and "
        "--position-unit (without them: 1, as printed)."_qs);
    line.option(u"type-column"_qs, u"NAME"_qs, u"Column of the table with the types, instead of --type."_qs);
    line.option(u"columns"_qs, u"LIST"_qs, u"Columns with m, b and k."_qs, u"m,b,k"_qs);
    line.option(u"error-columns"_qs, u"LIST"_qs, u"Columns with the standard errors of m, b and k."_qs);
}

TableEnrollment tableEnrollment(CommandLine& line)
{
    TableEnrollment task;
    task.table = line.text(u"table"_qs);
    task.columns.parameters = line.list(u"columns"_qs);
    task.columns.deviations = line.list(u"error-columns"_qs);
    task.columns.type = line.text(u"type-column"_qs);
    task.columns.typeName = line.text(u"type"_qs);
    if (line.isSet(u"force-unit"_qs))
        task.forceUnit = line.text(u"force-unit"_qs);
    if (line.isSet(u"position-unit"_qs))
        task.positionUnit = line.text(u"position-unit"_qs);
    if (!line.files().isEmpty())
        line.reject(u"Either --table or recordings, not both."_qs);
    if (line.isSet(u"type"_qs) && line.isSet(u"type-column"_qs))
        line.reject(u"Either --type or --type-column, not both."_qs);
    return task;
}

} // namespace

int runEnroll(const QStringList& arguments)
{
    CommandLine line(
        u"enroll"_qs,
        u"Adds recordings as squeezes of a type; a type that is new comes into the library with its first "
        "squeeze. Each file is in the library before it is told as added. At the end the type is approved, "
        "unless people are in the library: then it waits for \"types approve\"."_qs,
        u"[FILE...]"_qs);
    addLibraryOption(line);
    line.option(u"type"_qs, u"NAME"_qs, u"Name of the type."_qs);
    line.option(u"operator"_qs, u"NAME"_qs, u"Who; kept with the squeezes."_qs);
    addReadingOptions(line);
    addEnrollmentTableOptions(line);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const CsvReadOptions reading = csvReadOptions(line);
    const IdentificationOptions options = identificationOptions(line);
    const bool isTable = line.isSet(u"table"_qs);
    TableEnrollment table = isTable ? tableEnrollment(line) : TableEnrollment{};
    if (line.text(u"type"_qs).trimmed().isEmpty() && !(isTable && line.isSet(u"type-column"_qs)))
        line.reject(isTable ? u"--type NAME or --type-column NAME is missing."_qs
                            : u"--type NAME is missing."_qs);
    if (!isTable && line.files().isEmpty())
        line.reject(u"FILE... is missing."_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const bool json = line.isSet(u"json"_qs);
    const Expected<QString> library = libraryFile(line);
    if (!library)
        return fail(library.error(), json);
    const Expected<Acting> acting =
        authorization(*library, line.text(u"operator"_qs), Permission::EnrollFiles);
    if (!acting)
        return fail(acting.error(), json);
    table.acting = *acting;
    if (isTable)
        return enrollTable(table, *library, json);

    Enrollment enrollment(*library, *acting, options);
    if (const std::optional<Error> error = enrollment.begin(line.text(u"type"_qs)))
        return fail(*error, json);
    ExitCode exit;
    QJsonArray added, refused;
    for (const QString& file : line.files()) {
        const FileOutcome outcome = enrollment.add(file, reading);
        exit.add(outcome.exit);
        if (outcome.added) {
            message(u"added "_qs + file);
            added.append(file);
        } else {
            message(u"rejected %1: %2"_qs.arg(file, outcome.reason));
            refused.append(QJsonObject{{u"file"_qs, file}, {u"reason"_qs, outcome.reason}});
        }
    }
    Expected<bool> approved = false;
    if (!added.isEmpty())
        approved = enrollment.approve();
    if (!approved) {
        message(u"gripscope-cli: "_qs + approved.error().describe());
        exit.add(exitFor(approved.error()));
    }
    if (json)
        printJson({{u"type"_qs, enrollment.typeName()},
                   {u"squeezes"_qs, enrollment.squeezes()},
                   {u"added"_qs, added},
                   {u"rejected"_qs, refused},
                   {u"approved"_qs, added.isEmpty() ? QJsonValue() : QJsonValue(approved.value_or(false))}});
    else
        print(u"%1 has %2 squeezes; %3 added, %4 rejected."_qs.arg(
            enrollment.typeName(), QString::number(enrollment.squeezes()), QString::number(added.size()),
            QString::number(refused.size())));
    return exit.value();
}

} // namespace gripscope::cli
