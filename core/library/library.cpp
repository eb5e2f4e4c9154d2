// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library.h"

#include "core/base/printable.h"
#include "core/base/words.h"
#include "core/library/audit/audit_trail.h"
#include "core/library/audit_details.h"
#include "core/library/backup/library_swap.h"
#include "core/library/ledger/ledger_table.h"
#include "core/library/library_private.h"
#include "core/library/migrations/migration.h"
#include "core/library/migrations/schema_check.h"
#include "core/library/people/people_register.h"
#include "core/library/tables/adjustment_table.h"
#include "core/library/tables/audit_table.h"
#include "core/library/tables/calibration_tables.h"
#include "core/library/tables/document_table.h"
#include "core/library/tables/grasp_table.h"
#include "core/library/tables/grasp_writer.h"
#include "core/library/tables/inspection_tables.h"
#include "core/library/tables/placement_table.h"
#include "core/library/tables/recording_table.h"
#include "core/library/tables/tally_table.h"
#include "core/library/tables/type_tables.h"
#include "core/library/tables/type_writer.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QScopedValueRollback>
#include <QStandardPaths>

#include <algorithm>
#include <cmath>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A type is not enrolled on a gripper whose squeezes are adjusted to another.
Expected<void> refuseAdjusted(Database& database, const NewGrasp& grasp)
{
    const QString serial = grasp.recording ? grasp.recording->provenance.value(u"serial"_s) : QString();
    if (serial.isEmpty())
        return {};
    ASSIGN_OR_RETURN(const auto adjustment, adjustment_table::inForce(database, serial));
    if (!adjustment)
        return {};
    return failure(ErrorCode::Usage,
                   {Words::tr("The squeezes of gripper %1 are adjusted to types that were "
                              "enrolled on another; a type that is enrolled here would be "
                              "judged wrongly. Enrol it on the other gripper, or withdraw the "
                              "adjustment.")
                        .arg(serial)});
}

/// One more squeeze of a type is a new version of the library.
Expected<qint64> recordSqueeze(Database& database, const NewGrasp& grasp)
{
    ASSIGN_OR_RETURN(const auto type, requireType(database, grasp.typeId));
    LibraryChange change;
    change.kind = ChangeKind::Squeeze;
    change.operatorName = grasp.operatorName;
    return recordSqueezeChange(database, type, change);
}

/// A library whose tables hold rows to something else, or that does something by itself, is no longer one.
Expected<void> refuseForeignSchema(Database& database)
{
    ASSIGN_OR_RETURN(const auto differences, schemaDifferences(database));
    if (differences.empty())
        return {};
    const SchemaDifference& first = differences.front();
    return failure(ErrorCode::StorageOpen,
                   {database.file(),
                    Words::tr("it is not as this program makes it: the %1 %2 %3. Go on with a backup, or ask "
                              "who changed it")
                        .arg(first.type, printable(first.name, longestQuote), inWords(first.what))});
}

/// Its folder, where that is the program's to make, and a backup that is to take its place.
Expected<void> prepareFile(const QString& file)
{
    if (file == Library::defaultFile()) // any other folder is the user's to make: a typing error must not
        QDir().mkpath(QFileInfo(file).absolutePath());
    if (!finishSwap(file) && QFileInfo::exists(nextInPlace(file))) // none is made in its stead
        return failure(
            ErrorCode::StorageOpen,
            {file,
             Words::tr("the backup that was put back, %1, cannot take its place").arg(nextInPlace(file))});
    return {};
}

} // namespace

Library::Library(std::unique_ptr<Private> p) : d(std::move(p)) {}
Library::~Library() = default;

QString Library::defaultFile()
{
    // Not by the application's name: desktop and command line are to find the same one.
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + u"/gripscope/library.db"_s;
}

bool Library::isOnServer(const QString& place)
{
    return LibraryLocation::isOnServer(place);
}

Expected<QString> Library::placeFrom(const QString& text)
{
    return LibraryLocation::parse(text.trimmed()).map([&text](const LibraryLocation& location) {
        return location.server() ? location.text() : text; // a file's name may end with a blank
    });
}

Expected<bool> Library::isThere(const QString& place)
{
    ASSIGN_OR_RETURN(const LibraryLocation location, LibraryLocation::parse(place));
    return location.server() || QFileInfo::exists(place);
}

QString Library::shortName(const QString& place)
{
    return shortLibraryName(place);
}

Expected<std::unique_ptr<Library>> Library::open(const QString& place, const std::shared_ptr<Hangup>& hangup)
{
    if (!isOnServer(place))
        RETURN_IF_ERROR(prepareFile(place));
    ASSIGN_OR_RETURN(auto database, Database::open(place, hangup));
    RETURN_IF_ERROR(migrate(*database));
    RETURN_IF_ERROR(refuseForeignSchema(*database));
    return std::unique_ptr<Library>(new Library(std::make_unique<Private>(std::move(database))));
}

bool Library::hasLostServer() const
{
    return d->database->isLost();
}

QString Library::file() const
{
    return d->database->file();
}

void Library::actAs(const Acting& acting)
{
    d->database->actAs(acting);
}

PeopleRegister Library::people()
{
    return PeopleRegister(*d->database);
}

AuditTrail Library::auditTrail()
{
    return AuditTrail(*d->database);
}

Expected<void> Library::tellExport(const QString& file, const QString& format, qint64 rows)
{
    return d->write<void>(Words::tr("continue the audit trail"), [&] {
        return audit_table::append(*d->database, {QString::fromUtf16(audit_action::exported),
                                                  file,
                                                  {},
                                                  {{u"format"_s, format}, {u"rows"_s, rows}}});
    });
}

Expected<void> Library::tellBackup(const QString& copy, qint64 rows)
{
    return d->write<void>(Words::tr("continue the audit trail"), [&] {
        return audit_table::append(
            *d->database, {QString::fromUtf16(audit_action::libraryBackedUp), copy, {}, {{u"rows"_s, rows}}});
    });
}

Expected<void> Library::tellPruning(const QString& folder, const QStringList& parts, qint64 bytes,
                                    qint64 squeezes)
{
    constexpr qsizetype mostNamed = 20; // of some hundred that a folder may hold
    return d->write<void>(Words::tr("continue the audit trail"), [&] {
        return audit_table::append(*d->database,
                                   {QString::fromUtf16(audit_action::capturesPruned),
                                    folder,
                                    {},
                                    {{u"by_itself"_s, true},
                                     {u"files"_s, parts.size()},
                                     {u"names"_s, QJsonArray::fromStringList(parts.mid(0, mostNamed))},
                                     {u"bytes"_s, bytes},
                                     {u"squeezes"_s, squeezes}}});
    });
}

int Library::schemaVersion() const
{
    return migrations().back().version; // open() brought it there
}

Expected<std::optional<ChainEnd>> Library::birth() const
{
    return ledger_table::birth(*d->database);
}

Expected<GraspRecord> Library::addGrasp(const NewGrasp& grasp)
{
    return d->write<GraspRecord>(Words::tr("store the squeeze"), [&]() -> Expected<GraspRecord> {
        if (!grasp.typeId.isEmpty())
            RETURN_IF_ERROR(refuseAdjusted(*d->database, grasp));
        ASSIGN_OR_RETURN(const auto version,
                         grasp.typeId.isEmpty() ? Expected<qint64>(0) : recordSqueeze(*d->database, grasp));
        const auto id = storeGrasp(*d->database, grasp, version);
        return id ? requireGrasp(*d->database, *id) : tl::unexpected(id.error());
    });
}

Expected<void> Library::atOnce(const std::function<Expected<void>()>& work)
{
    return d->write<void>(Words::tr("store what belongs together"), [&] {
        const QScopedValueRollback<bool> within(d->atOnce, true);
        return work();
    });
}

Expected<void> Library::Private::place(const QString& graspId, ChangeKind kind, const QString& reason,
                                       const QString& operatorName)
{
    const bool accepted = kind == ChangeKind::Undrop;
    return writeIf<void>(
        Permission::DropSqueezes,
        accepted ? Words::tr("put the squeeze back") : Words::tr("drop the squeeze"),
        [&]() -> Expected<void> {
            ASSIGN_OR_RETURN(const auto grasp, requireGrasp(*database, graspId));
            if (grasp.typeId.isEmpty())
                return failure(ErrorCode::Usage,
                               {Words::tr("The squeeze of an inspection belongs to no type.")});
            if (grasp.accepted == accepted)
                return {};
            ASSIGN_OR_RETURN(const auto type, type_table::findById(*database, grasp.typeId)); // or gone
            if (!type)
                return failure(ErrorCode::NotFound, {Words::tr("type with the key %1").arg(grasp.typeId)});
            LibraryChange change;
            change.kind = kind;
            change.operatorName = operatorName;
            change.reason = reason;
            ASSIGN_OR_RETURN(const auto version, recordSqueezeChange(*database, *type, change));
            return placement_table::insert(*database, version, graspId, {grasp.typeId, accepted});
        });
}

Expected<void> Library::dropGrasp(const QString& graspId, const QString& reason, const QString& operatorName)
{
    return d->place(graspId, ChangeKind::Drop, reason, operatorName);
}

Expected<void> Library::undropGrasp(const QString& graspId, const QString& operatorName)
{
    return d->place(graspId, ChangeKind::Undrop, {}, operatorName);
}

Expected<std::vector<GraspRecord>> Library::grasps(const QString& typeId) const
{
    return grasp_table::ofType(*d->database, typeId);
}

Expected<std::optional<GraspRecord>> Library::grasp(const QString& graspId) const
{
    return grasp_table::find(*d->database, graspId);
}

Expected<Recording> Library::recording(const QString& graspId) const
{
    return recording_table::read(*d->database, graspId);
}

Expected<QJsonObject> Library::identificationDocument(const QString& graspId) const
{
    return document_table::read(*d->database, graspId);
}

Expected<std::vector<TypeSqueeze>> Library::enrolledSqueezes() const
{
    return grasp_table::enrolled(*d->database, grasp_table::Of::TypesInUse);
}

Expected<std::vector<TypeSqueeze>> Library::approvedSqueezes() const
{
    return grasp_table::enrolled(*d->database, grasp_table::Of::ApprovedTypes);
}

Expected<InspectionRecord> Library::addInspection(const NewInspection& inspection)
{
    return d->write<InspectionRecord>(Words::tr("store the inspection"), [&]() -> Expected<InspectionRecord> {
        if (!inspection.id.isEmpty()) {
            ASSIGN_OR_RETURN(const auto before, inspection_table::find(*d->database, inspection.id));
            if (before)
                return *before;
        }
        RETURN_IF_ERROR(audit_table::noteClock(*d->database));
        ASSIGN_OR_RETURN(const auto graspId, storeGrasp(*d->database, inspection.grasp));
        RowStamp stamp = RowStamp::now();
        if (!inspection.id.isEmpty())
            stamp.id = inspection.id;
        if (inspection.grasp.recorded.isValid())
            stamp.utc = utcText(inspection.grasp.recorded);
        RETURN_IF_ERROR(inspection_table::insert(*d->database, stamp, graspId, inspection));
        RETURN_IF_ERROR(tally_table::keepUp(*d->database));
        ASSIGN_OR_RETURN(const auto stored, inspection_table::find(*d->database, stamp.id));
        return stored.value();
    });
}

Expected<std::vector<InspectionRecord>> Library::inspections(const HistoryFilter& filter) const
{
    return inspection_table::page(*d->database, filter);
}

Expected<void> Library::voidInspection(qint64 number, const QString& reason, const QString& operatorName)
{
    const QString why = reason.trimmed();
    if (why.isEmpty())
        return failure(ErrorCode::Usage, {Words::tr("Say why: the reason is kept with the change.")});
    return d->write<void>(Words::tr("void the inspection"), [&]() -> Expected<void> {
        ASSIGN_OR_RETURN(const auto inspection, inspection_table::withNumber(*d->database, number));
        if (!inspection)
            return failure(ErrorCode::NotFound, {Words::tr("inspection %1").arg(number)});
        if (!inspection->voided.isEmpty())
            return {};
        RETURN_IF_ERROR(void_table::insert(*d->database, inspection->id, why, operatorName));
        return audit_table::append(*d->database, {QString::fromUtf16(audit_action::inspectionVoided),
                                                  QString::number(number),
                                                  why,
                                                  {},
                                                  operatorName});
    });
}

Expected<InspectionCounts> Library::inspectionCounts(qint64 after) const
{
    return inspection_table::counts(*d->database, {}, after);
}

Expected<void> Library::addMeasuringChain(const NewMeasuringChain& measured)
{
    if (measured.gripperSerial.isEmpty())
        return failure(ErrorCode::Usage,
                       {Words::tr("This gripper has no serial number to keep what was measured under.")});
    const MeasuringChain& chain = measured.chain;
    std::vector<double> numbers{measured.forceLag_s,
                                chain.forceLagUncertainty_s,
                                chain.forceNoiseDeviation,
                                chain.forceScaleUncertainty,
                                chain.positionScaleUncertainty,
                                chain.frameCompliance,
                                chain.frameComplianceUncertainty};
    if (chain.baseline) {
        numbers.insert(numbers.end(), chain.baseline->parameters.begin(), chain.baseline->parameters.end());
        numbers.insert(numbers.end(), chain.baseline->standardErrors.begin(),
                       chain.baseline->standardErrors.end());
    }
    if (chain.friction)
        numbers.insert(numbers.end(), {chain.friction->value, chain.friction->standardError});
    if (!std::all_of(numbers.begin(), numbers.end(), [](double value) { return std::isfinite(value); }))
        return failure(ErrorCode::Usage,
                       {Words::tr("A number that was measured of the gripper is not finite.")});
    return d->writeIf<void>(
        Permission::AcceptCalibrations, Words::tr("store what was measured of the gripper"),
        [&]() -> Expected<void> {
            ASSIGN_OR_RETURN(const auto before,
                             measuring_chain_table::newest(*d->database, measured.gripperSerial));
            RETURN_IF_ERROR(measuring_chain_table::insert(*d->database, RowStamp::now(), measured));
            return audit_table::append(*d->database, {QString::fromUtf16(audit_action::chainMeasured),
                                                      measured.gripperSerial, measured.reason,
                                                      auditDetails(before, measured), measured.operatorName});
        });
}

Expected<std::optional<MeasuringChainRecord>> Library::measuringChain(const QString& gripperSerial) const
{
    return measuring_chain_table::newest(*d->database, gripperSerial);
}

Expected<std::vector<MeasuringChainRecord>> Library::measuringChains(const QString& gripperSerial,
                                                                     int limit) const
{
    return measuring_chain_table::list(*d->database, gripperSerial, limit);
}

} // namespace gripscope
