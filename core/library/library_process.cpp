// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/library/history/process_view.h"
#include "core/library/ledger/merged_ledger.h"
#include "core/library/library_private.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/process_limits_table.h"
#include "core/library/tables/type_state_table.h"
#include "core/people/audit_entry.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// In the audit trail: which chart, from which inspections, and the limits themselves, of m, b and k centre
/// and sigma.
QJsonObject fixedDetails(const QString& limits)
{
    const QJsonObject fixed = QJsonDocument::fromJson(limits.toUtf8()).object();
    QJsonObject details;
    for (const auto& name :
         {std::pair(u"kind"_s, u"chart"_s), std::pair(u"first"_s, u"first_inspection"_s),
          std::pair(u"last"_s, u"last_fixed_inspection"_s), std::pair(u"count"_s, u"inspections"_s)})
        if (fixed.contains(name.first))
            details.insert(name.second, fixed[name.first]);
    for (const QString& quantity : {u"m"_s, u"b"_s, u"k"_s})
        if (const QJsonArray numbers = fixed[quantity].toArray(); numbers.size() == 2)
            details.insert(quantity, QJsonObject{{u"centre"_s, numbers[0]}, {u"sigma"_s, numbers[1]}});
    return details;
}

/// In the limits as they are stored: by which library's numbers they name inspections.
constexpr QStringView libraryKey = u"library";

QString withLibrary(const QString& limits, const QString& library)
{
    QJsonObject object = QJsonDocument::fromJson(limits.toUtf8()).object();
    if (object.isEmpty())
        return limits;
    object[libraryKey] = library;
    return QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

void takeLibrary(ProcessLimitsRecord& record, const QString& own)
{
    QJsonObject object = QJsonDocument::fromJson(record.limits.toUtf8()).object();
    if (!object.contains(libraryKey)) // of an earlier program, which had no others
        return;
    record.ofThisLibrary = object.take(libraryKey).toString() == own;
    record.limits = QString::fromUtf8(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

} // namespace

Expected<ProcessPlace> Library::processStretch(const ProcessQuery& query, ProcessPlace place,
                                               ProcessValues& values) const
{
    return process_view::read(*d->database, query, std::move(place), values);
}

Expected<QString> Library::inspectedSqueeze(qint64 number) const
{
    return process_view::squeezeKey(*d->database, number);
}

Expected<void> Library::fixProcessLimits(const QString& type, const QString& limits,
                                         const QString& operatorName)
{
    if (type.isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("The type needs a name.")});
    return d->writeIf<void>(
        Permission::ChangeTypes, Words::tr("fix the limits of the charts"), [&]() -> Expected<void> {
            ASSIGN_OR_RETURN(const QString own, libraryId(*d->database));
            RETURN_IF_ERROR(
                process_limits_table::insert(*d->database, type, withLibrary(limits, own), operatorName));
            const auto action = limits.isEmpty() ? audit_action::chartsReleased : audit_action::chartsFixed;
            return audit_table::append(
                *d->database, {QString::fromUtf16(action), type, {}, fixedDetails(limits), operatorName});
        });
}

Expected<std::optional<ProcessLimitsRecord>> Library::processLimits(const QString& type) const
{
    ASSIGN_OR_RETURN(const auto names, type_state_table::nameSpans(*d->database, type));
    ASSIGN_OR_RETURN(auto record, process_limits_table::newest(*d->database, names));
    if (record) {
        ASSIGN_OR_RETURN(const QString own, libraryId(*d->database));
        takeLibrary(*record, own);
    }
    return record;
}

Expected<QStringList> Library::typeNamesToday(const QStringList& names) const
{
    return type_state_table::namesToday(*d->database, names);
}

} // namespace gripscope
