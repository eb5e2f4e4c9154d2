// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/existing_library.h"
#include "app/cli/line/command_line.h"
#include "app/cli/line/commands.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "core/session/library/history_document.h"

#include <QSaveFile>

#include <cstdio>
#include <utility>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 rowsAtOnce = 500;

const QStringList& outcomeNames()
{
    static const QStringList names{u"any"_qs,     u"as_expected"_qs,  u"other_type"_qs,
                                   u"unknown"_qs, u"inconclusive"_qs, u"not_valid"_qs};
    return names;
}

const QStringList& validityNames()
{
    static const QStringList names{u"any"_qs, u"valid"_qs, u"suspect"_qs, u"invalid"_qs};
    return names;
}

void addFilters(CommandLine& line)
{
    line.option(u"text"_qs, u"TEXT"_qs,
                u"Contained in number, type, operator, gripper, batch, source or part."_qs);
    line.option(u"kind"_qs, u"KIND"_qs, u"any, inspection or enrollment."_qs, u"any"_qs);
    line.option(u"outcome"_qs, u"OUTCOME"_qs, outcomeNames().join(u", "_qs) + u'.', u"any"_qs);
    line.option(u"validity"_qs, u"VALIDITY"_qs,
                u"Of an inspection's measurement: "_qs + validityNames().join(u", "_qs) + u'.', u"any"_qs);
    line.option(u"type"_qs, u"NAME"_qs, u"Named, or enrolled in."_qs);
    line.option(u"expected"_qs, u"NAME"_qs, u"The type that was expected."_qs);
    line.option(u"operator"_qs, u"NAME"_qs, u"Who squeezed."_qs);
    line.option(u"batch"_qs, u"NAME"_qs, u"The batch that was inspected."_qs);
    line.option(u"from"_qs, u"DAY"_qs, u"From this day on, as 2024-05-31."_qs);
    line.option(u"to"_qs, u"DAY"_qs, u"Up to this day."_qs);
}

QDateTime startOf(CommandLine& line, const QString& name, int later)
{
    if (!line.isSet(name))
        return {};
    const QDate day = QDate::fromString(line.text(name), Qt::ISODate);
    if (!day.isValid())
        line.reject(u"--%1 takes a day such as 2024-05-31, not \"%2\"."_qs.arg(name, line.text(name)));
    return day.addDays(later).startOfDay().toUTC();
}

HistoryQuery queryOf(CommandLine& line)
{
    HistoryQuery query;
    query.text = line.text(u"text"_qs);
    const QStringList kinds{u"any"_qs, toString(SqueezeKind::Inspection), toString(SqueezeKind::Enrollment)};
    if (const int kind = line.choice(u"kind"_qs, kinds); kind > 0)
        query.kind = static_cast<SqueezeKind>(kind - 1);
    if (const int outcome = line.choice(u"outcome"_qs, outcomeNames()); outcome > 0)
        query.outcome = static_cast<InspectionOutcome>(outcome - 1);
    if (const int validity = line.choice(u"validity"_qs, validityNames()); validity > 0)
        query.validity = static_cast<ValidityVerdict>(validity - 1);
    query.type = line.text(u"type"_qs);
    query.expected = line.text(u"expected"_qs);
    query.operatorName = line.text(u"operator"_qs);
    query.batch = line.text(u"batch"_qs);
    query.from = startOf(line, u"from"_qs, 0);
    query.to = startOf(line, u"to"_qs, 1);
    return query;
}

/// Nothing: as a table.
std::optional<HistoryFormat> formatOf(CommandLine& line)
{
    static const QStringList names{u"table"_qs, toString(HistoryFormat::Csv), toString(HistoryFormat::Json),
                                   toString(HistoryFormat::Aqdef)};
    const int chosen = line.choice(u"format"_qs, names);
    const bool json = line.isSet(u"json"_qs), csv = line.isSet(u"csv"_qs);
    if (json && csv)
        line.reject(u"--csv and --json exclude each other."_qs);
    if (line.isSet(u"format"_qs) && (json || csv))
        line.reject(u"--format stands for --csv and --json; give one of them."_qs);
    if (json)
        return HistoryFormat::Json;
    if (csv)
        return HistoryFormat::Csv;
    return chosen > 0 ? std::optional(static_cast<HistoryFormat>(chosen - 1)) : std::nullopt;
}

QString lineOf(const HistoryEntry& entry)
{
    const auto& p = entry.parameters;
    const auto value = [&](int i) {
        return p ? withInterval(p->vector()(i), entry.standardErrors
                                                    ? std::optional((*entry.standardErrors)(i))
                                                    : std::nullopt)
                 : u"-"_qs;
    };
    return QStringList{entry.number > 0 ? entry.numberText() : u"-"_qs,
                       entry.time.toUTC().toString(Qt::ISODate),
                       entry.verdict ? entry.outcomeName() : toString(entry.kind),
                       entry.type.isEmpty() ? u"-"_qs : entry.type,
                       value(0),
                       value(1),
                       value(2),
                       entry.operatorName,
                       entry.validity ? toString(*entry.validity) : u"-"_qs}
        .join(u'\t');
}

Expected<void> printTable(Library& library, const HistoryQuery& query)
{
    ASSIGN_OR_RETURN(HistoryList list, library.historyList(query));
    while (!list.through) {
        ASSIGN_OR_RETURN(list, library.historyStretch(std::move(list)));
    }
    print(u"number\ttime (UTC)\toutcome\ttype\tm ± 95 %\tb ± 95 %\tk ± 95 %\toperator\tvalidity"_qs);
    for (qint64 first = 0; first < list.rows; first += rowsAtOnce) {
        ASSIGN_OR_RETURN(const auto entries, library.historyPage(list, first, rowsAtOnce));
        for (const HistoryEntry& entry : entries)
            print(lineOf(entry));
    }
    return {};
}

/// To standard output, or to a file that is there whole or not at all.
class HistoryOutput {
public:
    explicit HistoryOutput(const QString& file) : m_file(file) {}
    [[nodiscard]] QString name() const { return toFile() ? m_file.fileName() : u"standard output"_qs; }
    [[nodiscard]] Expected<void> open()
    {
        return !toFile() || m_file.open(QIODevice::WriteOnly) ? Expected<void>() : unwritable();
    }
    [[nodiscard]] Expected<void> write(const QByteArray& piece)
    {
        if (!toFile())
            std::fwrite(piece.constData(), 1, static_cast<std::size_t>(piece.size()), stdout);
        else if (m_file.write(piece) != piece.size())
            return unwritable();
        return {};
    }
    [[nodiscard]] Expected<void> close()
    {
        return !toFile() || m_file.commit() ? Expected<void>() : unwritable();
    }

private:
    [[nodiscard]] bool toFile() const { return !m_file.fileName().isEmpty(); }
    [[nodiscard]] Expected<void> unwritable() const
    {
        return failure(ErrorCode::FileUnwritable, {m_file.fileName(), m_file.errorString()});
    }
    QSaveFile m_file;
};

Expected<void> printDocument(Library& library, const HistoryQuery& query, HistoryFormat format,
                             const QString& file)
{
    HistoryOutput output(file);
    RETURN_IF_ERROR(output.open());
    HistoryDocument document(query, format);
    bool told = false;
    while (!document.ended()) {
        ASSIGN_OR_RETURN(const QByteArray piece, document.next(library));
        if (!piece.isEmpty() && !std::exchange(told, true)) // what cannot be told does not leave the library
            RETURN_IF_ERROR(
                library.tellExport(output.name(), toString(format), static_cast<qint64>(document.total())));
        RETURN_IF_ERROR(output.write(piece));
    }
    return output.close();
}

} // namespace

int runHistory(const QStringList& arguments)
{
    CommandLine line(u"history"_qs,
                     u"Lists the squeezes of a library, inspected or enrolled, newest first."_qs);
    addLibraryOption(line);
    addFilters(line);
    line.flag(u"csv"_qs, u"As CSV, with all that is known of each."_qs);
    line.option(u"format"_qs, u"FORMAT"_qs,
                u"table, csv, json or aqdef (for Q-DAS; the valid values of m, b and k)."_qs, u"table"_qs);
    line.shortOption(u'o', u"output"_qs, u"FILE"_qs, u"Where it is written, but for a table."_qs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    const HistoryQuery query = queryOf(line);
    const bool json = line.isSet(u"json"_qs);
    const std::optional<HistoryFormat> format = formatOf(line);
    const QString file = line.text(u"output"_qs);
    if (line.isSet(u"output"_qs) && (!format || file.isEmpty()))
        line.reject(u"-o takes the name of a file, and a format of --format csv, json or aqdef."_qs);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    const Expected<std::unique_ptr<Library>> library = libraryFile(line).and_then(openExistingLibrary);
    if (!library)
        return fail(library.error(), json);
    const Expected<void> done =
        format ? printDocument(**library, query, *format, file) : printTable(**library, query);
    return done ? 0 : fail(done.error(), json);
}

} // namespace gripscope::cli
