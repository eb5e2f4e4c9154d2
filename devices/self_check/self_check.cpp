// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/self_check/self_check.h"

#include "core/library/ledger/station_key.h"
#include "core/library/migrations/migration.h"
#include "core/library/sql/sql_dialect.h"
#include "core/library/sql/statement.h"
#include "core/library/tables/calibration_tables.h"
#include "devices/hid/hid_transport.h"

#include <QFileInfo>
#include <QProcess>
#include <QSqlDatabase>
#include <QStandardPaths>
#include <QStorageInfo>
#include <QSysInfo>

#include <set>
#include <sodium.h>
#include <unistd.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// What one look into the library gave.
struct LibraryLook {
    LibraryFacts facts;
    QDateTime newestEntry;
    std::vector<CalibratedChannel> channels;
};

QString asking()
{
    return u"be checked"_s;
}

QDateTime newestEntryOf(Database& database)
{
    QDateTime newest;
    Statement query(database, asking(), u"SELECT MAX(created_utc) FROM ledger"_s);
    (void)query.forEach([&](Statement& row) { newest = row.takeUtc(); });
    return newest;
}

/// Grippers that were calibrated, and those that are plugged in.
std::vector<CalibratedChannel> channelsOf(Database& database, const std::vector<HidNode>& grippers)
{
    constexpr int most = 10'000;
    std::set<QString> serials;
    for (const HidNode& node : grippers)
        if (!node.serial.isEmpty())
            serials.insert(node.serial);
    if (const auto all = calibration_table::read(database, {}, most))
        for (const CalibrationRecord& record : *all)
            serials.insert(record.gripperSerial);
    std::vector<CalibratedChannel> channels;
    for (const QString& serial : serials) {
        const Expected<CalibrationsInForce> inForce = calibration_table::inForce(database, serial);
        if (!inForce)
            continue;
        const auto add = [&](SensorChannel channel, const std::optional<CalibrationRecord>& record) {
            channels.push_back(
                {serial, toString(channel), record ? std::optional(record->due) : std::nullopt});
        };
        add(SensorChannel::Force, inForce->force);
        add(SensorChannel::Position, inForce->position);
    }
    return channels;
}

Expected<void> readLibrary(LibraryLook& look, const std::vector<HidNode>& grippers)
{
    ASSIGN_OR_RETURN(const auto database, Database::openToRead(look.facts.file));
    ASSIGN_OR_RETURN(look.facts.version, schemaVersion(*database));
    if (look.facts.version != look.facts.newestVersion)
        return {};
    look.newestEntry = newestEntryOf(*database);
    look.channels = channelsOf(*database, grippers);
    return {};
}

LibraryLook lookAt(const SelfCheckSubject& subject, const std::vector<HidNode>& grippers)
{
    LibraryLook look;
    look.facts.file = subject.libraryFile;
    const bool onServer = LibraryLocation::isOnServer(subject.libraryFile);
    look.facts.exists = onServer || QFileInfo::exists(subject.libraryFile);
    const SqlDialect& dialect = onServer ? SqlDialect::postgresql() : SqlDialect::sqlite();
    if (!QSqlDatabase::isDriverAvailable(dialect.driver()))
        look.facts.missingPackage = dialect.driverPackage();
    look.facts.newestVersion = migrations().back().version;
    if (look.facts.exists && look.facts.missingPackage.isEmpty()) {
        if (const auto read = readLibrary(look, grippers); !read)
            look.facts.error = read.error();
        else if (subject.verified && look.facts.version == look.facts.newestVersion) {
            if (auto verified = verifyLibrary(subject.libraryFile))
                look.facts.verified = std::move(*verified);
            else
                look.facts.error = verified.error();
        }
    }
    if (!look.facts.verified && look.channels.empty()) // nothing is known of them
        for (const HidNode& node : grippers)
            for (const SensorChannel channel : {SensorChannel::Force, SensorChannel::Position})
                look.channels.push_back({node.serial, toString(channel), std::nullopt});
    return look;
}

/// The folder that is, where the library's own is yet to be made.
DiskFacts lookAtDisk(const QString& libraryFile)
{
    // Of a library on a server: where this computer keeps what waits for it.
    QFileInfo folder(QFileInfo(fileWithLibrary(libraryFile, {})).absolutePath());
    while (!folder.exists() && !folder.isRoot())
        folder.setFile(folder.absolutePath());
    const QStorageInfo storage(folder.absoluteFilePath());
    return {folder.absoluteFilePath(), storage.isValid() ? storage.bytesAvailable() : -1,
            folder.isWritable()};
}

KeyFacts lookAtKey()
{
    const QFileInfo file(StationKey::file());
    return {file.filePath(), file.exists(), file.isReadable(), file.permissions()};
}

ClockFacts lookAtClock(const SelfCheckSubject& subject, const QDateTime& newestEntry)
{
    ClockFacts facts{QDateTime::currentDateTimeUtc(), newestEntry, {}, {}};
    if (const auto printed =
            subject.ask(u"timedatectl"_s, {u"show"_s, u"--property=NTPSynchronized"_s, u"--value"_s})) {
        facts.synchronised = synchronisedByTimedatectl(*printed);
        facts.askedOf = u"timedatectl"_s;
    }
    if (facts.synchronised.value_or(false))
        return facts;
    // Where chrony keeps the clock, it knows better.
    if (const auto printed = subject.ask(u"chronyc"_s, {u"-n"_s, u"tracking"_s}))
        if (const std::optional<bool> synchronised = synchronisedByChronyc(*printed)) {
            facts.synchronised = synchronised;
            facts.askedOf = u"chronyc"_s;
        }
    return facts;
}

std::vector<GripperNode> lookAtNodes(const SelfCheckSubject& subject, const std::vector<HidNode>& grippers)
{
    std::vector<GripperNode> nodes;
    nodes.reserve(grippers.size());
    for (const HidNode& node : grippers)
        nodes.push_back({node, permissionOf(node, subject.access), permissionCommand(node, subject.access)});
    return nodes;
}

QString sqliteVersion()
{
    QString version;
    if (const auto database = Database::inMemory()) {
        Statement query(**database, asking(), u"SELECT sqlite_version()"_s);
        (void)query.forEach([&](Statement& row) { version = row.takeText(); });
    }
    return version;
}

VersionFacts lookAtVersions()
{
    return {QStringLiteral(GRIPSCOPE_VERSION),
            QString::fromLatin1(qVersion()),
            QStringLiteral(QT_VERSION_STR),
            sqliteVersion(),
            hidapiVersion(),
            QString::fromLatin1(sodium_version_string()),
            u"%1 %2"_s.arg(QSysInfo::kernelType(), QSysInfo::kernelVersion()),
            QSysInfo::prettyProductName()};
}

} // namespace

std::optional<QString> SelfCheckSubject::askProgram(const QString& program, const QStringList& arguments)
{
    constexpr int patience_ms = 3000;
    const QString path = QStandardPaths::findExecutable(program);
    if (path.isEmpty())
        return std::nullopt;
    QProcess process;
    process.start(path, arguments, QIODevice::ReadOnly);
    if (!process.waitForFinished(patience_ms)) {
        process.kill();
        process.waitForFinished(patience_ms);
        return std::nullopt;
    }
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        return std::nullopt;
    return QString::fromUtf8(process.readAllStandardOutput());
}

std::vector<CheckLine> selfCheck(const SelfCheckSubject& subject)
{
    const std::vector<HidNode> grippers = grippersAmong(subject.nodes);
    const LibraryLook look = lookAt(subject, grippers);
    return {libraryLine(look.facts),
            integrityLine(look.facts),
            chainLine(look.facts),
            keyLine(lookAtKey()),
            diskLine(lookAtDisk(subject.libraryFile)),
            calibrationLine(look.channels, QDate::currentDate()),
            clockLine(lookAtClock(subject, look.newestEntry)),
            permissionLine(lookAtNodes(subject, grippers),
                           hasRule(subject.access.ruleFolders, protocol::vendorId, protocol::productId),
                           geteuid() == 0),
            versionLine(lookAtVersions())};
}

} // namespace gripscope
