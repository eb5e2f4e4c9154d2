// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/library/existing_library.h"
#include "app/cli/line/output.h"
#include "app/cli/options/shared_options.h"
#include "app/cli/quality/quality_commands.h"
#include "core/base/words.h"
#include "core/identification/result/identification_result.h"
#include "core/library/library.h"
#include "core/library/records/history.h"
#include "core/library/records/history_list.h"
#include "core/recognition/verdict/verdict.h"
#include "core/signal/recording/units.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace gripscope::cli {

using namespace Qt::StringLiterals;

namespace {

struct LibraryTable {
    StudyTable table;
    QStringList notes; ///< sentences for a person: what was left out, and what stands for what is not there
};

constexpr qint64 tableRowsAtOnce = 500;

Expected<std::vector<HistoryEntry>> entriesOf(Library& library, const QString& batch)
{
    HistoryQuery query;
    query.batch = batch;
    query.descending = false;
    ASSIGN_OR_RETURN(HistoryList list, library.historyList(query));
    while (!list.through) {
        ASSIGN_OR_RETURN(list, library.historyStretch(std::move(list)));
    }
    std::vector<HistoryEntry> entries;
    for (qint64 first = 0; first < list.rows; first += tableRowsAtOnce) {
        ASSIGN_OR_RETURN(const auto page, library.historyPage(list, first, tableRowsAtOnce));
        entries.insert(entries.end(), page.begin(), page.end());
    }
    return entries;
}

bool counts(const HistoryEntry& entry)
{
    const bool isInvalid =
        entry.verdict == VerdictKind::Invalid || entry.validity == ValidityVerdict::Invalid;
    return entry.parameters && entry.voided.isEmpty() && entry.accepted && !isInvalid;
}

QString typeOf(const HistoryEntry& entry)
{
    return entry.expectedType.isEmpty() ? entry.type : entry.expectedType;
}

bool hasPart(const HistoryEntry& entry)
{
    return !entry.partNumber.isEmpty() || !entry.part.isEmpty();
}

/// A part's name is one within its type, a number that was scanned is one of its own.
QString partOf(const HistoryEntry& entry)
{
    if (!entry.partNumber.isEmpty())
        return entry.partNumber;
    return entry.part.isEmpty() ? typeOf(entry) : u"%1 %2"_qs.arg(typeOf(entry), entry.part).trimmed();
}

QString cell(double value)
{
    return std::isfinite(value) ? QLocale::c().toString(value, 'g', QLocale::FloatingPointShortest)
                                : QString();
}

QStringList rowOf(const HistoryEntry& entry)
{
    const double factor = siFactor(entry.forceUnit, entry.positionUnit).value_or(1);
    QStringList row{partOf(entry), entry.operatorName, entry.station};
    for (int i = 0; i < 3; ++i)
        row << cell(factor * entry.parameters->vector()(i));
    for (int i = 0; i < 3; ++i)
        row << (entry.standardErrors ? cell(factor * (*entry.standardErrors)(i)) : QString());
    row << entry.type << entry.expectedType << entry.outcomeName()
        << (entry.validity ? toString(*entry.validity) : QString())
        << entry.time.toUTC().toString(Qt::ISODateWithMs)
        << (entry.serial.isEmpty() ? entry.device : entry.serial)
        << (entry.number > 0 ? QString::number(entry.number) : QString());
    return row;
}

/// Units that m, b and k can be compared in: SI, or all the same.
Expected<void> checkUnits(const std::vector<HistoryEntry>& entries)
{
    QString first;
    for (const HistoryEntry& entry : entries) {
        const QString units = siFactor(entry.forceUnit, entry.positionUnit)
                                  ? u"SI"_qs
                                  : u"%1 and %2"_qs.arg(entry.forceUnit, entry.positionUnit);
        if (first.isEmpty())
            first = units;
        if (units != first)
            return failure(ErrorCode::UnitsDiffer, {units, first});
    }
    return {};
}

Expected<void> checkBatch(Library& library, const QString& batch)
{
    if (batch.isEmpty())
        return {};
    ASSIGN_OR_RETURN(const HistoryChoices choices, library.historyChoices());
    if (choices.batches.contains(batch))
        return {};
    const QString known = choices.batches.isEmpty()
                              ? u"the library has no inspected batch"_qs
                              : u"the library has %1"_qs.arg(choices.batches.join(u", "_qs));
    return failure(ErrorCode::NotFound, {u"batch %1 (%2)"_qs.arg(batch, known)});
}

QStringList notesOn(const std::vector<HistoryEntry>& entries, std::size_t leftOut)
{
    QStringList notes;
    if (leftOut > 0)
        notes << u"%1 squeezes are left out: without m, b and k, not valid, voided or dropped."_qs.arg(
            leftOut);
    const auto nameless = std::count_if(entries.begin(), entries.end(),
                                        [](const HistoryEntry& entry) { return !hasPart(entry); });
    if (nameless > 0)
        notes
            << u"No part is named for %1 of %2 squeezes: their type stands for it, as if all of a type were "
               "one part. Scan part numbers to tell them apart."_qs.arg(nameless)
                   .arg(entries.size());
    return notes;
}

/// part, operator, station, m, b, k, u_m, u_b, u_k, type, expected, verdict, validity, time, gripper, number.
QStringList libraryTableColumns()
{
    return {u"part"_qs,     u"operator"_qs, u"station"_qs, u"m"_qs,     u"b"_qs,        u"k"_qs,
            u"u_m"_qs,      u"u_b"_qs,      u"u_k"_qs,     u"type"_qs,  u"expected"_qs, u"verdict"_qs,
            u"validity"_qs, u"time"_qs,     u"gripper"_qs, u"number"_qs};
}

/// The squeezes of a library as a table, oldest first, a squeeze a row: of the batch with that name, or,
/// where that is empty, all of them, enrolled ones too. m, b and k and their standard uncertainties are in SI
/// where the channels' units are known, else as they were measured.
///
/// `part` is the number that was scanned; else the type with the part's own name within it; else the type
/// alone (expected, or else named), which a note tells: parts of a type are then taken for one. A cell of
/// what the library does not know is empty, which the table refuses where that column is asked for.
///
/// Left out, and told in a note: squeezes without m, b and k, of measurements that are not valid, voided
/// ones, and enrolled ones that were dropped.
///
/// Errors: NotFound for a batch that is not there, or where no squeeze is left; UnitsDiffer where m, b and k
/// cannot be compared; those of the library.
Expected<LibraryTable> libraryTable(Library& library, const QString& batch)
{
    RETURN_IF_ERROR(checkBatch(library, batch));
    ASSIGN_OR_RETURN(std::vector<HistoryEntry> entries, entriesOf(library, batch));
    const std::size_t leftOut =
        std::erase_if(entries, [](const HistoryEntry& entry) { return !counts(entry); });
    const QString name = batch.isEmpty() ? library.file() : u"batch %1 of %2"_qs.arg(batch, library.file());
    if (entries.empty())
        return failure(ErrorCode::NotFound, {u"a squeeze with m, b and k in %1"_qs.arg(name)});
    RETURN_IF_ERROR(checkUnits(entries));
    std::vector<QStringList> rows;
    rows.reserve(entries.size());
    for (const HistoryEntry& entry : entries)
        rows.push_back(rowOf(entry));
    return LibraryTable{StudyTable::of(name, libraryTableColumns(), rows), notesOn(entries, leftOut)};
}

Expected<StudyTable> tableOfLibrary(const CommandLine& line)
{
    if (line.isSet(u"batch"_qs) && line.text(u"batch"_qs).trimmed().isEmpty())
        return failure(ErrorCode::Usage, {Words::say("--batch needs the name of a batch")});
    ASSIGN_OR_RETURN(const std::unique_ptr<Library> library, libraryFile(line).and_then(openExistingLibrary));
    ASSIGN_OR_RETURN(const LibraryTable found, libraryTable(*library, line.text(u"batch"_qs).trimmed()));
    for (const QString& note : found.notes)
        message(note);
    return found.table;
}

} // namespace

void addTableOptions(CommandLine& line)
{
    line.option(u"library"_qs, u"DB"_qs,
                u"In place of TABLE.csv the squeezes of a library, with the columns %1."_qs.arg(
                    libraryTableColumns().join(u", "_qs)));
    line.option(u"batch"_qs, u"NAME"_qs,
                u"Only the batch of that name (without --library: of the user's own library)."_qs);
}

Expected<StudyTable> studyTable(const CommandLine& line)
{
    const QStringList files = line.files();
    const bool isOfLibrary = line.isSet(u"library"_qs) || line.isSet(u"batch"_qs);
    if (isOfLibrary && !files.isEmpty())
        return failure(
            ErrorCode::Usage,
            {Words::say("a table comes from TABLE.csv or from --library and --batch, not from both")});
    if (isOfLibrary)
        return tableOfLibrary(line);
    if (files.size() != 1)
        return failure(ErrorCode::Usage,
                       {Words::say("one table was expected: TABLE.csv, or --library DB --batch NAME")});
    return StudyTable::read(files.front());
}

} // namespace gripscope::cli
