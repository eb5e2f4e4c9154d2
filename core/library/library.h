// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/identification/identification.h"
#include "core/library/records/inspection_record.h"
#include "core/library/records/library_change.h"
#include "core/library/records/measuring_chain_record.h"
#include "core/library/records/squeeze_record.h"
#include "core/library/records/type_record.h"
#include "core/quality/conformity/limit_risks.h"
#include "core/recognition/types/type_model.h"
#include "core/recognition/verdict/verdict.h"
#include "core/signal/recording/recording.h"

#include <QDateTime>
#include <QJsonObject>
#include <QString>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace gripscope {

struct Acting;
struct ChainEnd;
struct ExchangeStep;
struct SensorCalibration;
class HistoryKeys;
struct HistoryList;
struct HistoryQuery;
struct HistoryEntry;
struct HistoryCounts;
struct HistoryPoints;
struct HistoryInForce;
struct HistoryChoices;
struct SqueezeDetails;
struct Reidentification;
struct CalibrationRecord;
struct CalibrationsInForce;
struct EnrollmentDraft;
struct DraftSqueeze;
struct PartPicture;
enum class DraftEnd;
struct NewStudy;
struct ProcessLimitsRecord;
struct ProcessPlace;
struct ProcessQuery;
struct ProcessValues;
struct StudyRecord;
struct NewStudyMeasurement;
struct StudyMeasurementRecord;
enum class StudyState;
struct ReferenceCheck;
struct ReferenceCheckRecord;
struct ReferenceObject;
struct NewBatch;
struct BatchRecord;
struct NewAdjustment;
struct AdjustmentRecord;
struct AdjustmentStanding;
struct MergeReport;
struct PlantConflict;
struct StationStanding;
class AuditTrail;
class Hangup;
class PeopleRegister;
class WaitingCount;
struct Waiting;

/// The library of types, squeezes and inspections, in one SQLite file or in a PostgreSQL database. Rows are
/// appended, never overwritten; keys are UUIDs in time order; every write is one transaction, so a squeeze is
/// stored whole or not at all. All types of a library have comparable units: channels that can be taken to
/// SI, or all the same units
/// ("1"). Several processes may use one at once. An object belongs to the thread that opened it.
///
/// Whatever changes the types is one version of the library, with who, when and why; any earlier version can
/// be looked at and restored, which is a new version again, so that nothing is ever lost.
///
/// Once people are in it (people_register.h), what needs a supervisor fails with Usage unless one acts
/// or has consented, and nothing is changed then; see permission.h. What was done is in the audit trail.
///
/// Every function may fail with StorageFailed (locked, disk full) or StorageCorrupt; nothing is changed then.
class Library {
public:
    /// Opens or creates the file, or opens the database on the server that is named
    /// (sql/library_location.h), and brings an older one up to date. `hangup` (sql/hangup.h) ends what waits
    /// for a server. StorageOpen, StorageNewer, StorageCorrupt.
    [[nodiscard]] static Expected<std::unique_ptr<Library>> open(const QString& place,
                                                                 const std::shared_ptr<Hangup>& hangup = {});
    /// The user's own library when no file is named.
    [[nodiscard]] static QString defaultFile();
    /// "postgresql://..." or "postgres://...".
    [[nodiscard]] static bool isOnServer(const QString& place);
    /// What was typed, as it is kept and shown. StorageOpen: an address that leads nowhere, or holds a
    /// password.
    [[nodiscard]] static Expected<QString> placeFrom(const QString& text);
    /// There is such a file; of a server only opening tells. StorageOpen: an address that cannot be one.
    [[nodiscard]] static Expected<bool> isThere(const QString& place);
    /// For a title: the file's name without its folder, or the database and its server.
    [[nodiscard]] static QString shortName(const QString& place);

    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    [[nodiscard]] QString file() const; ///< or the address, without a password
    [[nodiscard]] int schemaVersion() const;
    /// The server ended the connection; what is asked for next connects again.
    [[nodiscard]] bool hasLostServer() const;
    /// The first link of its ledger, by which a library is told from any other; nothing before its first row.
    [[nodiscard]] Expected<std::optional<ChainEnd>> birth() const;
    /// All that `work` asks of this library is one transaction: when it fails, nothing of it is stored.
    [[nodiscard]] Expected<void> atOnce(const std::function<Expected<void>()>& work);

    /// Who works through this object from now on: what may be done, and whom the audit trail names.
    void actAs(const Acting& acting);
    [[nodiscard]] PeopleRegister people(); ///< lives no longer than the library
    [[nodiscard]] AuditTrail auditTrail(); ///< lives no longer than the library
    /// Tells the audit trail that so many rows of it left the library, as "csv" into `file`.
    [[nodiscard]] Expected<void> tellExport(const QString& file, const QString& format, qint64 rows);
    /// Tells the audit trail of a copy of it (backup/library_backup.h) that was verified.
    [[nodiscard]] Expected<void> tellBackup(const QString& copy, qint64 rows);

    /// Tells the audit trail that kept sessions in `folder` made room for newer ones by themselves.
    [[nodiscard]] Expected<void> tellPruning(const QString& folder, const QStringList& parts, qint64 bytes,
                                             qint64 squeezes);

    // Types. NotFound: there is no such type. Usage: what is asked for makes no sense; says why.
    /// Usage: no name, or one that is taken. UnitsDiffer: not comparable with the types that are there.
    [[nodiscard]] Expected<TypeRecord> addType(const QString& name, const Recipe& recipe,
                                               const QString& forceUnit, const QString& positionUnit,
                                               const QString& operatorName = {});
    /// Another recipe for the type; the old one stays on record.
    [[nodiscard]] Expected<TypeRecord> reviseType(const QString& typeId, const Recipe& recipe,
                                                  const ChangeNote& note = {});
    /// Its parts are recognised from now on, until its squeezes change. Usage: the library's policy asks for
    /// another person than those who enrolled it.
    [[nodiscard]] Expected<void> approveType(const QString& typeId, const QString& operatorName,
                                             const QString& reason = {});
    [[nodiscard]] Expected<std::vector<TypeRecord>> types() const;        ///< those in use, by name
    [[nodiscard]] Expected<std::vector<TypeRecord>> retiredTypes() const; ///< by name
    /// In use or retired, see TypeRecord::status.
    [[nodiscard]] Expected<std::optional<TypeRecord>> findType(const QString& name) const;

    // Changing types. Each asks for a reason.
    /// Inspections that were made keep the old name.
    [[nodiscard]] Expected<TypeRecord> renameType(const QString& typeId, const QString& name,
                                                  const ChangeNote& note);
    /// The accepted squeezes of `typeId` go to `intoId`, which then needs approval again; the first type is
    /// gone.
    [[nodiscard]] Expected<TypeRecord> mergeTypes(const QString& typeId, const QString& intoId,
                                                  const ChangeNote& note);
    /// These accepted squeezes of the type, not all of them, become a new type with its recipe. Both need
    /// approval then. Returns the new one.
    [[nodiscard]] Expected<TypeRecord> splitType(const QString& typeId, const QStringList& graspIds,
                                                 const QString& name, const ChangeNote& note);
    /// No longer recognised; kept.
    [[nodiscard]] Expected<void> retireType(const QString& typeId, const ChangeNote& note);
    /// A retired type is in use again; it is recognised once it is approved.
    [[nodiscard]] Expected<void> reinstateType(const QString& typeId, const ChangeNote& note);
    /// What a scanner reads on its parts; empty: no longer any. Usage: another type has that code.
    [[nodiscard]] Expected<TypeRecord> setTypeCode(const QString& typeId, const QString& code,
                                                   const ChangeNote& note);

    /// What m, b and k of its parts may be, in the units of the type; empty: anything. The same again changes
    /// nothing. Where people are in force the type then needs approval again. Usage: PartLimits::validate().
    [[nodiscard]] Expected<TypeRecord> setTypeLimits(const QString& typeId, const PartLimits& limits,
                                                     const ChangeNote& note);
    /// What the limits of a type risk, by its own accepted squeezes (limitRisks()), of m, b, k: those that
    /// have limits. Their uncertainties are those of the budgets they were stored with, else of their
    /// estimates.
    [[nodiscard]] Expected<LimitRisks> typeRisks(const TypeRecord& type, const PartLimits& limits) const;
    /// The accepted squeezes of a type as its limits see them, in its units.
    [[nodiscard]] Expected<std::vector<MeasuredValues>> measuredSqueezes(const TypeRecord& type) const;

    // Versions
    [[nodiscard]] Expected<qint64> version() const;
    [[nodiscard]] Expected<std::vector<LibraryChange>> changes(int limit,
                                                               int offset = 0) const; ///< newest first
    /// Usage: there is no such version.
    [[nodiscard]] Expected<LibraryState> stateAt(qint64 version) const;
    /// Types and squeezes are again as they were at that version; returns the new version. Squeezes that came
    /// later stay on record. Usage: no such version, or nothing differs from it.
    [[nodiscard]] Expected<qint64> restoreVersion(qint64 version, const ChangeNote& note);

    // Other stations (merge/library_merge.h)
    /// Brings all that the library in `file` has and this one has not into it; that file is verified first
    /// and only read. Twice is the same as once. StorageOpen: it is not whole, or a copy that was gone on
    /// with.
    [[nodiscard]] Expected<MergeReport> mergeLibrary(const QString& file, const ChangeNote& note);
    /// One step of keeping this library, a station's, in step with its plant's on a server
    /// (exchange/library_exchange.h): at most `mostLinks` links go there, or, when all are there, what is new
    /// comes from there. `marks`: of the step before; empty: of none. A server that does not answer leaves
    /// this library free to be written to. StorageOpen: one of the two is an older copy, or another server's.
    [[nodiscard]] Expected<ExchangeStep> exchangeWith(Library& server, const QString& marks,
                                                      qint64 mostLinks);
    /// What this library, a station's, has written and its plant's server has not (exchange/waiting_count.h).
    [[nodiscard]] Expected<Waiting> countWaiting(WaitingCount& count,
                                                 const std::map<QString, qint64>& delivered) const;
    /// The stations whose inspections it has, by name.
    [[nodiscard]] Expected<std::vector<StationStanding>> stations() const;
    /// What stations decided apart, until somebody who may decide it has seen it.
    [[nodiscard]] Expected<std::vector<PlantConflict>> conflicts() const;
    [[nodiscard]] Expected<void> noteConflictsSeen(const std::vector<PlantConflict>& conflicts,
                                                   const ChangeNote& note);

    // Squeezes
    /// NotFound: no such type. UnitsDiffer: not comparable with the type's. Usage: no estimate for an
    /// enrolment, a retired type, a number that is not finite, channels of different length. A type that was
    /// approved needs approval again, as with each squeeze that is dropped or put back.
    [[nodiscard]] Expected<GraspRecord> addGrasp(const NewGrasp& grasp);
    /// Takes a squeeze out of its type; it stays on record. Dropping it again changes nothing. NotFound;
    /// Usage for the squeeze of an inspection.
    [[nodiscard]] Expected<void> dropGrasp(const QString& graspId, const QString& reason,
                                           const QString& operatorName);
    /// Undoes dropGrasp(). One that counts already stays as it is. Errors as there.
    [[nodiscard]] Expected<void> undropGrasp(const QString& graspId, const QString& operatorName);
    [[nodiscard]] Expected<std::vector<GraspRecord>>
    grasps(const QString& typeId) const; ///< in order of recording
    [[nodiscard]] Expected<std::optional<GraspRecord>> grasp(const QString& graspId) const;
    /// The raw recording, its SHA-256 checked: StorageCorrupt when the bytes are not those that were stored.
    [[nodiscard]] Expected<Recording> recording(const QString& graspId) const;
    /// The identify document that was stored with it; empty when there was none.
    [[nodiscard]] Expected<QJsonObject> identificationDocument(const QString& graspId) const;
    /// The accepted squeezes of all types in use, what fitTypeModels() takes: m, b, k of the recommended
    /// estimate and what it determines besides or instead, in SI where the channels' units are known, else
    /// in the units they have. Squeezes that determine nothing are left out.
    [[nodiscard]] Expected<std::vector<TypeSqueeze>> enrolledSqueezes() const;
    /// Those of approved types alone: what verdicts are made of.
    [[nodiscard]] Expected<std::vector<TypeSqueeze>> approvedSqueezes() const;

    // Inspections
    /// Squeeze, estimates (there may be none) and verdict in one transaction. One whose key is there already
    /// is not stored again.
    [[nodiscard]] Expected<InspectionRecord> addInspection(const NewInspection& inspection);
    /// One that waited to be stored, as it can be: of no batch where the library does not know its own any
    /// more, since a backup was put back.
    [[nodiscard]] Expected<NewInspection> withKnownBatch(NewInspection inspection) const;
    [[nodiscard]] Expected<std::vector<InspectionRecord>>
    inspections(const HistoryFilter& filter) const; ///< newest first
    /// Those with a number behind `after`.
    [[nodiscard]] Expected<InspectionCounts> inspectionCounts(qint64 after = 0) const;
    /// It counts no longer, neither in the yield nor in its batch, and stays on record. Everybody who may
    /// inspect may do it; the audit trail tells of it. Voiding it again changes nothing. NotFound: no such
    /// number. Usage: no reason.
    [[nodiscard]] Expected<void> voidInspection(qint64 number, const QString& reason,
                                                const QString& operatorName);

    // History: every squeeze, inspected or enrolled (core/library/records/history.h)
    /// What a query finds, of which any page is read by itself; see HistoryList.
    [[nodiscard]] Expected<HistoryList> historyList(const HistoryQuery& query) const;
    /// Goes on with what a list does not know yet, one stretch; until it is `through`.
    [[nodiscard]] Expected<HistoryList> historyStretch(HistoryList list) const;
    [[nodiscard]] Expected<std::vector<HistoryEntry>> historyPage(const HistoryList& list, qint64 first,
                                                                  qint64 count) const;
    [[nodiscard]] Expected<std::vector<QString>> historyKeys(const HistoryList& list, qint64 first,
                                                             qint64 count) const;
    /// Which row of a list a squeeze is; nothing where it is none of them.
    [[nodiscard]] Expected<std::optional<qint64>> historyRow(const HistoryList& list,
                                                             const QString& graspId) const;
    /// The keys of all that a query finds, in its order, however long that takes.
    [[nodiscard]] Expected<HistoryKeys> historyKeys(const HistoryQuery& query) const;
    /// At most 1000 at once, in that order; those that are not there are left out.
    [[nodiscard]] Expected<std::vector<HistoryEntry>>
    historyEntries(const std::vector<QString>& graspIds) const;
    [[nodiscard]] Expected<HistoryCounts> historyCounts(const HistoryQuery& query) const;
    /// Of a list that is counted.
    [[nodiscard]] Expected<HistoryPoints> historyPoints(const HistoryList& list) const;
    [[nodiscard]] Expected<HistoryPoints> historyPoints(const HistoryQuery& query) const;
    [[nodiscard]] Expected<HistoryInForce> historyInForce(const HistoryQuery& query) const;
    [[nodiscard]] Expected<HistoryChoices> historyChoices() const;
    /// NotFound.
    [[nodiscard]] Expected<SqueezeDetails> squeezeDetails(const QString& graspId) const;
    /// One more estimate of a stored squeeze, kept beside those that are there: neither the estimate that
    /// stands for the squeeze nor a verdict changes. NotFound. Usage: a number that is not finite.
    [[nodiscard]] Expected<void> addReidentification(const QString& graspId, const Estimate& estimate,
                                                     const Reidentification& how);
    // Batches: parts that are inspected and counted together
    /// Usage: no name, a name or a number of parts out of range, or a batch is under way at this station.
    [[nodiscard]] Expected<BatchRecord> beginBatch(const NewBatch& batch);
    /// Ends it, whole or not; ending it again changes nothing. NotFound: there is no such batch.
    [[nodiscard]] Expected<BatchRecord> endBatch(const QString& batchId, const QString& operatorName);
    /// The one under way at this station.
    [[nodiscard]] Expected<std::optional<BatchRecord>> batchUnderWay() const;
    [[nodiscard]] Expected<std::vector<BatchRecord>> batches(int limit) const; ///< newest first
    [[nodiscard]] Expected<std::optional<BatchRecord>> batch(const QString& batchId) const;

    // Grippers
    /// What is known of a gripper from now on. Usage: no serial number, or a number that is not finite.
    [[nodiscard]] Expected<void> addMeasuringChain(const NewMeasuringChain& measured);
    [[nodiscard]] Expected<std::optional<MeasuringChainRecord>>
    measuringChain(const QString& gripperSerial) const; ///< the newest
    /// Newest first.
    [[nodiscard]] Expected<std::vector<MeasuringChainRecord>> measuringChains(const QString& gripperSerial,
                                                                              int limit) const;

    /// A sensor against a reference, in force from now on. Usage: no serial number or unit, no due date, or
    /// points that evaluateCalibration() refuses.
    [[nodiscard]] Expected<void> addCalibration(const SensorCalibration& calibration);
    /// Newest first; of all grippers where the serial number is empty.
    [[nodiscard]] Expected<std::vector<CalibrationRecord>> calibrations(const QString& gripperSerial,
                                                                        int limit) const;
    /// With the reference object of the gripper and its newest check.
    [[nodiscard]] Expected<CalibrationsInForce> calibrationsInForce(const QString& gripperSerial) const;

    // Grippers adjusted to types that were enrolled on another (gripper_adjustment.h)
    /// From now on squeezes of that gripper are adjusted so; one that was in force before is replaced. Usage:
    /// no serial number or reason, a number that is not finite, a covariance that is none, or a type in use
    /// that was enrolled on this gripper, whose parts would be judged wrongly.
    [[nodiscard]] Expected<AdjustmentRecord> acceptAdjustment(const NewAdjustment& adjustment);
    /// Squeezes of its gripper are no longer adjusted. One that is not in force any more stays as it is.
    /// NotFound. Usage: no reason.
    [[nodiscard]] Expected<void> withdrawAdjustment(const QString& id, const QString& reason,
                                                    const QString& operatorName);
    [[nodiscard]] Expected<std::vector<AdjustmentRecord>> adjustments(int limit) const; ///< newest first
    /// Those in force, one a gripper, with what speaks against them by now.
    [[nodiscard]] Expected<std::vector<AdjustmentStanding>> adjustmentsInForce() const;
    /// The types in use, each with the serial numbers of the grippers that its accepted squeezes are from; an
    /// empty one where that is not known.
    [[nodiscard]] Expected<QMap<QString, QStringList>> grippersOfTypes() const;

    // Enrolments under way (enrollment_draft.h)
    /// In force for its name from now on.
    [[nodiscard]] Expected<void> saveDraft(const EnrollmentDraft& draft);
    /// It is no longer to be gone on with; its rows stay. Nothing when there is none.
    [[nodiscard]] Expected<void> endDraft(const QString& name, DraftEnd end, const QString& operatorName);
    [[nodiscard]] Expected<std::vector<EnrollmentDraft>> drafts() const; ///< open ones, newest first
    [[nodiscard]] Expected<std::optional<EnrollmentDraft>> draft(const QString& name) const;
    [[nodiscard]] Expected<void> addDraftSqueeze(const DraftSqueeze& squeeze);
    /// NotFound; StorageCorrupt when the bytes are not those that were stored.
    [[nodiscard]] Expected<DraftSqueeze> draftSqueeze(const QString& id) const;

    // Studies of the gripper (study_record.h): kept squeeze by squeeze, taken back by a further row
    /// Usage: no name, kind or plan.
    [[nodiscard]] Expected<StudyRecord> beginStudy(const NewStudy& study);
    /// One try at a row of its plan, with its raw recording, whole or not at all. NotFound: no such study.
    /// Usage: it has ended, a number that is not finite, an uncertainty below zero.
    [[nodiscard]] Expected<StudyMeasurementRecord> addStudyMeasurement(const NewStudyMeasurement& measured);
    /// It counts no longer, and stays on record; again changes nothing. NotFound. Usage: its study has ended.
    [[nodiscard]] Expected<void> undoStudyMeasurement(const QString& measurementId, const QString& reason,
                                                      const QString& operatorName);
    /// Ending it again changes nothing. NotFound. Usage: Open is no end.
    [[nodiscard]] Expected<StudyRecord> endStudy(const QString& studyId, StudyState end,
                                                 const QString& reason, const QString& operatorName);
    [[nodiscard]] Expected<std::optional<StudyRecord>> study(const QString& studyId) const;
    [[nodiscard]] Expected<std::vector<StudyRecord>> studies(int limit) const; ///< newest first
    /// Those that can be gone on with, newest first.
    [[nodiscard]] Expected<std::vector<StudyRecord>> unfinishedStudies() const;
    /// All, those taken back too, in the order in which they were stored.
    [[nodiscard]] Expected<std::vector<StudyMeasurementRecord>>
    studyMeasurements(const QString& studyId) const;

    // Control charts of a type's inspections (core/library/records/process_values.h)
    /// Adds the next stretch of them to `values`, and says where to go on; until it is `through`.
    [[nodiscard]] Expected<ProcessPlace> processStretch(const ProcessQuery& query, ProcessPlace place,
                                                        ProcessValues& values) const;
    /// The key of the squeeze that was inspected as this number. NotFound.
    [[nodiscard]] Expected<QString> inspectedSqueeze(qint64 number) const;
    /// In force for the charts of this type from now on; none where the text is empty; told to the audit
    /// trail. Usage: no type, or not allowed to (ChangeTypes).
    [[nodiscard]] Expected<void> fixProcessLimits(const QString& type, const QString& limits,
                                                  const QString& operatorName);
    /// The last that were fixed, by whichever name the type had then; nothing where none ever were.
    [[nodiscard]] Expected<std::optional<ProcessLimitsRecord>> processLimits(const QString& type) const;
    /// As the types that have these names, or had them last, are called today; each once.
    [[nodiscard]] Expected<QStringList> typeNamesToday(const QStringList& names) const;

    // Pictures of parts
    /// Once; Usage when it is neither PNG nor JPEG.
    [[nodiscard]] Expected<void> addPicture(const PartPicture& picture);
    /// NotFound; StorageCorrupt when the bytes are not those that were stored.
    [[nodiscard]] Expected<PartPicture> picture(const QString& pictureId) const;
    /// From now on; no picture where the key is empty.
    [[nodiscard]] Expected<void> setTypePicture(const QString& typeId, const QString& pictureId,
                                                const QString& operatorName);
    [[nodiscard]] Expected<std::optional<PartPicture>> typePicture(const QString& typeId) const;
    /// What a gripper is checked on from now on. Usage: no serial number, or problemOf() has one.
    [[nodiscard]] Expected<void> addReferenceObject(const ReferenceObject& reference,
                                                    const QString& reason = {});
    /// A check as it was judged. NotFound: no such reference object. Usage: a number that is not finite.
    [[nodiscard]] Expected<void> addReferenceCheck(const ReferenceCheck& check);
    [[nodiscard]] Expected<std::vector<ReferenceCheckRecord>>
    referenceChecks(const QString& gripperSerial, int limit) const; ///< newest first

    /// Adds the paper's four cans in SI as types A to D with 10 squeezes each, once: nothing when they are
    /// there.
    [[nodiscard]] Expected<void> loadExampleTypes();
    /// The same of these: approved types with their squeezes, in one version; none whose name is taken.
    [[nodiscard]] Expected<void> loadExampleTypes(const std::vector<ExampleType>& examples);

private:
    struct Private;
    explicit Library(std::unique_ptr<Private> d);
    std::unique_ptr<Private> d;
};

} // namespace gripscope
