// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/verification/library_verification.h"

namespace gripscope {

using namespace Qt::StringLiterals;

QString toString(WitnessState state)
{
    switch (state) {
    case WitnessState::Matched:
        return u"matched"_s;
    case WitnessState::Behind:
        return u"behind"_s;
    case WitnessState::Absent:
        return u"absent"_s;
    }
    return {};
}

void LibraryVerification::differs(const QString& table, const QString& row, const QString& what)
{
    if (differences.size() < mostDifferences)
        differences.push_back({table, row, what});
    else
        ++furtherDifferences;
}

QString inWords(const LibraryDifference& difference)
{
    QStringList parts{difference.table, difference.row, difference.what};
    parts.removeAll(QString());
    return parts.join(u' ');
}

namespace {

/// A rollback that was meant is no fault, and no secret.
QString restoreInWords(const LibraryVerification& verification)
{
    const RestoredBackup& last = verification.restores.back();
    return Words::tr("Put back from a backup, times: %1. The last on %2 (UTC), by %3, from %4, because: %5. "
                     "What had been stored after that backup is in the library that was kept aside.")
        .arg(verification.restores.size())
        .arg(last.utc, last.person.isEmpty() ? Words::tr("somebody not named") : last.person, last.backup,
             last.reason);
}

} // namespace

QString inWords(const LibraryVerification& verification)
{
    QStringList words;
    if (!verification.restores.empty())
        words += restoreInWords(verification);
    if (!verification.whole()) {
        const auto count =
            static_cast<qint64>(verification.differences.size()) + verification.furtherDifferences;
        words += Words::tr("Differences from what was written: %1.").arg(count);
        words += Words::tr("The first: %1.").arg(inWords(verification.differences.front()));
        words +=
            Words::tr("Keep a copy of the file, find out who could write it, and go on with a backup that "
                      "is whole.");
        return words.join(u' ');
    }
    words += Words::tr("All %1 rows are as they were written.").arg(verification.rows);
    if (verification.foundRows > 0)
        words +=
            Words::tr("Of these, %1 are from before the ledger: they are as they were found when it began.")
                .arg(verification.foundRows);
    switch (verification.witness) {
    case WitnessState::Matched:
        words += Words::tr("The second place on this computer knows the same end.");
        break;
    case WitnessState::Behind:
        words += Words::tr("The second place on this computer knows the beginning; what came after was not "
                           "witnessed by it.");
        break;
    case WitnessState::Absent:
        words += Words::tr("No second place on this computer knows this library: whether its end is missing "
                           "cannot be told. Verify it where it is written.");
        break;
    }
    return words.join(u' ');
}

} // namespace gripscope
