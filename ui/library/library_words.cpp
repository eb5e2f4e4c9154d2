// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/library/library_words.h"

#include "ui/format/number_format.h"

#include <QLocale>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// "Inspections: 12, squeezes: 12", of what there is more of in the library than in the backup.
QString missing(const LibraryContents& present, const LibraryContents& holds)
{
    QStringList parts;
    const auto add = [&](const QString& words, qint64 now, qint64 then) {
        if (now > then)
            parts += words.arg(formatCount(now - then));
    };
    add(LibraryWords::tr("inspections: %1"), present.inspections, holds.inspections);
    add(LibraryWords::tr("squeezes: %1"), present.squeezes, holds.squeezes);
    add(LibraryWords::tr("types: %1"), present.types, holds.types);
    add(LibraryWords::tr("calibrations: %1"), present.calibrations, holds.calibrations);
    add(LibraryWords::tr("changes of types: %1"), present.version, holds.version);
    add(LibraryWords::tr("entries of the audit trail: %1"), present.entries, holds.entries);
    return parts.join(u", "_s);
}

} // namespace

QString LibraryWords::newest(const LibraryContents& contents)
{
    return contents.newest.isValid()
               ? QLocale().toString(contents.newest.toLocalTime(), u"yyyy-MM-dd HH:mm:ss"_s)
               : tr("nothing yet");
}

QString LibraryWords::contents(const LibraryContents& contents)
{
    return tr("Types: %1, squeezes: %2, inspections: %3, calibrations: %4. Stored last: %5.")
        .arg(formatCount(contents.types), formatCount(contents.squeezes), formatCount(contents.inspections),
             formatCount(contents.calibrations), newest(contents));
}

QString LibraryWords::consequence(const RestorePlan& plan)
{
    if (!plan.present)
        return tr("The library of now cannot be read. It is kept aside as it is.");
    switch (plan.kinship) {
    case Kinship::Same:
        return tr("Nothing was stored since this backup was made.");
    case Kinship::Earlier:
        return tr("What was stored since this backup was made goes out of use (%1). It stays in the library "
                  "that is kept aside.")
            .arg(missing(*plan.present, plan.holds));
    case Kinship::Apart:
        return tr("The backup and the library have gone different ways: each holds something that the other "
                  "does not. All of the library of now goes out of use, and is kept aside.");
    case Kinship::Other:
        return tr("This is a copy of another library. All of the library of now goes out of use, and is kept "
                  "aside.");
    }
    return {};
}

} // namespace gripscope
