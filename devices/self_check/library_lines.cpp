// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "devices/self_check/self_check.h"

#include <QFileInfo>
#include <QStringList>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

CheckLine libraryQuestion(const QString& id, const QString& name)
{
    return {id, name, CheckOutcome::Ok, {}, {}};
}

CheckLine withOutcome(CheckLine line, CheckOutcome outcome, const QString& found, const QString& advice)
{
    line.outcome = outcome;
    line.found = found;
    line.advice = advice;
    return line;
}

/// Why there is nothing to say of what is in it.
QString notRead(const LibraryFacts& facts)
{
    return facts.exists ? Words::tr("not looked at") : Words::tr("there is none yet");
}

QString backupAdvice(const QString& file)
{
    return Words::tr("Keep the file as it is and go on with a backup: gripscope-cli library restore. "
                     "gripscope-cli library verify --library %1 tells all.")
        .arg(file);
}

} // namespace

QString toString(CheckOutcome outcome)
{
    switch (outcome) {
    case CheckOutcome::Ok:
        return u"ok"_s;
    case CheckOutcome::Look:
        return u"look"_s;
    case CheckOutcome::Broken:
        return u"broken"_s;
    }
    return {};
}

CheckLine libraryLine(const LibraryFacts& facts)
{
    const CheckLine line = libraryQuestion(u"library"_s, Words::tr("Library"));
    if (!facts.missingPackage.isEmpty())
        return withOutcome(
            line, CheckOutcome::Broken, Words::tr("Qt's driver for %1 is missing").arg(facts.file),
            Words::tr("Type this in a terminal: sudo apt install %1").arg(facts.missingPackage));
    if (!facts.exists)
        return withOutcome(
            line, CheckOutcome::Ok,
            Words::tr("%1 is not there yet; it is made when it is first needed").arg(facts.file), {});
    if (facts.error)
        return withOutcome(line, CheckOutcome::Broken, facts.error->describe(), backupAdvice(facts.file));
    const QString found =
        Words::tr("%1, version %2 of the schema").arg(facts.file, QString::number(facts.version));
    if (facts.version > facts.newestVersion)
        return withOutcome(
            line, CheckOutcome::Broken, found,
            Words::tr("A newer program wrote it; this one knows version %1. Install the newer one.")
                .arg(facts.newestVersion));
    if (facts.version < facts.newestVersion)
        return withOutcome(
            line, CheckOutcome::Look, found,
            Words::tr("The program brings it to version %1 when it opens it; make a copy before: "
                      "gripscope-cli library backup.")
                .arg(facts.newestVersion));
    return withOutcome(line, CheckOutcome::Ok, found, {});
}

CheckLine integrityLine(const LibraryFacts& facts)
{
    const CheckLine line = libraryQuestion(u"integrity"_s, Words::tr("Integrity"));
    if (!facts.verified)
        return withOutcome(line, CheckOutcome::Ok, notRead(facts), {});
    const LibraryVerification& verified = *facts.verified;
    if (verified.whole())
        return withOutcome(line, CheckOutcome::Ok,
                           Words::tr("%1 rows are as they were written").arg(verified.rows), {});
    return withOutcome(line, CheckOutcome::Broken,
                       Words::tr("%1 differences; the first: %2")
                           .arg(qint64(verified.differences.size()) + verified.furtherDifferences)
                           .arg(inWords(verified.differences.front())),
                       backupAdvice(facts.file));
}

CheckLine chainLine(const LibraryFacts& facts)
{
    const CheckLine line = libraryQuestion(u"chain"_s, Words::tr("Ledger"));
    if (!facts.verified)
        return withOutcome(line, CheckOutcome::Ok, notRead(facts), {});
    QStringList chains;
    bool isSigned = true;
    for (const LedgerChain& chain : facts.verified->chains) {
        chains << Words::tr("%1: %2 links").arg(chain.name).arg(chain.links);
        isSigned = isSigned && chain.hasSignatures;
    }
    if (chains.isEmpty())
        return withOutcome(line, CheckOutcome::Ok, Words::tr("nothing has been written yet"), {});
    const QString found = chains.join(u", "_s);
    if (facts.verified->witness == WitnessState::Absent)
        return withOutcome(
            line, CheckOutcome::Look, Words::tr("%1; this computer does not know them").arg(found),
            Words::tr("That is so when the library came from elsewhere. Otherwise ask who changed it: "
                      "its end may be missing."));
    if (!isSigned)
        return withOutcome(line, CheckOutcome::Look, Words::tr("%1; not all signed").arg(found),
                           Words::tr("See to the key of this station, the line below."));
    return withOutcome(line, CheckOutcome::Ok,
                       Words::tr("%1; their ends are those that this computer knows").arg(found), {});
}

CheckLine keyLine(const KeyFacts& facts)
{
    const CheckLine line = libraryQuestion(u"keys"_s, Words::tr("Key of this station"));
    if (!facts.exists)
        return withOutcome(
            line, CheckOutcome::Ok,
            Words::tr("%1 is not there yet; it is made when it is first needed").arg(facts.file), {});
    if (!facts.isReadable)
        return withOutcome(
            line, CheckOutcome::Broken, Words::tr("%1 may not be read by this user").arg(facts.file),
            Words::tr("Type this in a terminal: %1").arg(u"sudo chown \"$USER\" '%1'"_s.arg(facts.file)));
    const QFileDevice::Permissions others =
        QFileDevice::ReadGroup | QFileDevice::WriteGroup | QFileDevice::ReadOther | QFileDevice::WriteOther;
    if (facts.permissions & others)
        return withOutcome(line, CheckOutcome::Broken,
                           Words::tr("others may read or change %1").arg(facts.file),
                           Words::tr("Type this in a terminal: %1").arg(u"chmod 600 '%1'"_s.arg(facts.file)));
    return withOutcome(line, CheckOutcome::Ok, Words::tr("%1, this user's alone").arg(facts.file), {});
}

CheckLine diskLine(const DiskFacts& facts)
{
    constexpr qint64 megabyte = 1'000'000;
    // An inspection takes some tens of kilobytes: enough for an hour of them, and for some weeks.
    constexpr qint64 least = 200 * megabyte, comfortable = 2'000 * megabyte;
    const CheckLine line = libraryQuestion(u"disk"_s, Words::tr("Disk"));
    if (!facts.isWritable)
        return withOutcome(line, CheckOutcome::Broken,
                           Words::tr("nothing may be written in %1").arg(facts.folder),
                           Words::tr("Type this in a terminal: %1")
                               .arg(u"sudo chown -R \"$USER\" '%1'"_s.arg(facts.folder)));
    if (facts.freeBytes < 0)
        return withOutcome(line, CheckOutcome::Look,
                           Words::tr("how much is free in %1 is not known").arg(facts.folder),
                           Words::tr("See to it that its disk is there."));
    const QString found =
        Words::tr("%1 GB free in %2")
            .arg(Words::number(double(facts.freeBytes) / (1000.0 * double(megabyte)), 'f', 1), facts.folder);
    const QString advice = Words::tr("Make room, or move the library to a larger disk.");
    if (facts.freeBytes < least)
        return withOutcome(line, CheckOutcome::Broken, found, advice);
    return facts.freeBytes < comfortable ? withOutcome(line, CheckOutcome::Look, found, advice)
                                         : withOutcome(line, CheckOutcome::Ok, found, {});
}

} // namespace gripscope
