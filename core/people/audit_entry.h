// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QJsonObject>
#include <QString>

#include <optional>

namespace gripscope {

/// What the audit trail tells of. Changes of types are "type." and the kind of LibraryChange.
namespace audit_action {
inline constexpr char16_t signIn[] = u"sign_in";
inline constexpr char16_t signOut[] = u"sign_out";
inline constexpr char16_t signInFailed[] = u"sign_in.failed";
inline constexpr char16_t authorised[] = u"authorised"; ///< a supervisor's consent to one action of another
inline constexpr char16_t personAdded[] = u"person.added";
inline constexpr char16_t personRole[] = u"person.role";
inline constexpr char16_t personSecret[] = u"person.secret";
inline constexpr char16_t personDeactivated[] = u"person.deactivated";
inline constexpr char16_t personReactivated[] = u"person.reactivated";
inline constexpr char16_t personTaken[] = u"person.taken"; ///< from the plant
inline constexpr char16_t ratesChanged[] = u"rates.changed";
inline constexpr char16_t settingChanged[] = u"setting.changed";
inline constexpr char16_t calibrationAccepted[] = u"calibration.accepted";
inline constexpr char16_t referenceStated[] = u"calibration.reference"; ///< what checks are made on
inline constexpr char16_t referenceChecked[] = u"calibration.checked";
inline constexpr char16_t chainMeasured[] = u"chain.measured";
inline constexpr char16_t armingPolicy[] = u"policy.arming";         ///< who may arm
inline constexpr char16_t approvalPolicy[] = u"policy.approval";     ///< who may approve a type
inline constexpr char16_t gripperArmed[] = u"gripper.armed";         ///< the subject is its serial number
inline constexpr char16_t inspectionVoided[] = u"inspection.voided"; ///< the subject is its number
inline constexpr char16_t batchBegun[] = u"batch.begun";
inline constexpr char16_t batchEnded[] = u"batch.ended";
inline constexpr char16_t studyBegun[] = u"study.begun";
inline constexpr char16_t studyEnded[] = u"study.ended";
inline constexpr char16_t studyUndone[] = u"study.undone"; ///< of one measurement
/// That squeezes of a gripper, the subject, are adjusted to types that were enrolled on another; and no
/// longer.
inline constexpr char16_t adjustmentAccepted[] = u"adjustment.accepted";
inline constexpr char16_t adjustmentWithdrawn[] = u"adjustment.withdrawn";
inline constexpr char16_t exported[] = u"export.made";              ///< the subject is the file
inline constexpr char16_t libraryBackedUp[] = u"library.backed_up"; ///< the subject is the copy
/// The subject is the backup. In the library that it takes the place of, before it does; then in the other.
inline constexpr char16_t libraryRestoreBegun[] = u"library.restore_begun";
inline constexpr char16_t libraryRestored[] = u"library.restored";
inline constexpr char16_t libraryMerged[] = u"library.merged"; ///< the subject is the other one's file
inline constexpr char16_t conflictsSeen[] = u"conflicts.seen"; ///< by a supervisor, who was told of them
inline constexpr char16_t capturesPruned[] = u"captures.pruned";
inline constexpr char16_t profileInstalled[] = u"profile.installed";
inline constexpr char16_t clockBack[] = u"clock.back";     ///< of the station, since its last entry
inline constexpr char16_t chartsFixed[] = u"charts.fixed"; ///< limits of a type's control charts
inline constexpr char16_t chartsReleased[] = u"charts.released";
inline constexpr char16_t typePrefix[] = u"type.";
} // namespace audit_action

/// Who did what, when, to what and why.
///
/// The entries are a chain: each carries the SHA-256 of the one before and its own, in lower-case
/// hexadecimal. The bytes that are hashed are these texts in UTF-8, each behind its length in bytes as eight
/// bytes, the highest first: "gripscope-audit-1", previousHash, number (decimal), utc, station, person, role,
/// action, subject, reason, details. An entry that was changed has another hash, and one that was removed,
/// put in or exchanged breaks the link. There is no key: whoever can write the file can also make a new chain
/// from some entry on, which is seen only where the number and hash of a later entry are known from
/// elsewhere.
struct AuditEntry {
    qint64 number = 0;    ///< 1, 2, 3... in this library
    QString utc;          ///< "2024-05-31T12:00:00.000Z"
    QString station;      ///< where
    QString person;       ///< who signed in, or what was typed as the operator's name
    QString role;         ///< "operator", "supervisor"; empty: nobody had signed in
    QString action;       ///< see audit_action
    QString subject;      ///< the type, person, gripper...
    QString reason;       ///< as it was given
    QString details;      ///< a JSON object, byte for byte as it is hashed; or empty
    QString previousHash; ///< 64 zeros for the first
    QString hash;
    friend bool operator==(const AuditEntry&, const AuditEntry&) = default;
};

[[nodiscard]] QString firstPreviousHash(); ///< 64 zeros
/// The hash that belongs to the entry's other fields.
[[nodiscard]] QString auditHash(const AuditEntry& entry);

/// "Type approved"; the action itself where this program does not know it.
[[nodiscard]] QString actionInWords(const QString& action);
/// The details as text for a person, never JSON: "false reject: 1 % before, 2 % now"; empty when there are
/// none.
[[nodiscard]] QString detailsInWords(const AuditEntry& entry);

} // namespace gripscope
