// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/migrations/migration.h"
#include "core/library/records/enrollment_draft.h"
#include "core/library/sql/database.h"
#include "core/recognition/types/type_model.h"
#include "tests/core/library/child_process.h"
#include "tests/core/library/earlier_schema.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QMap>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

const ChangeNote typesBecause{u"Ada"_s, u"asked by quality"_s};

/// A library with two approved types of three squeezes each.
struct TwoTypes {
    LibraryFolder folder;
    std::unique_ptr<Library> library = folder.open();
    TypeRecord a = enrolled(u"A"_s, 9000), b = enrolled(u"B"_s, 12000);

    TypeRecord enrolled(const QString& name, double k)
    {
        const TypeRecord type = valueOf(library->addType(name, {}, u"N"_s, u"m"_s));
        for (int i = 0; i < 3; ++i)
            valueOf(library->addGrasp(aGrasp(type.id, k + i)));
        valueOf(library->approveType(type.id, u"Ada"_s));
        return valueOf(library->findType(name)).value();
    }
    QStringList names() const
    {
        QStringList names;
        for (const TypeRecord& type : valueOf(library->types()))
            names += type.name;
        return names;
    }
    QStringList squeezesOf(const QString& typeId) const
    {
        QStringList ids;
        for (const GraspRecord& grasp : valueOf(library->grasps(typeId)))
            if (grasp.accepted)
                ids += grasp.id;
        return ids;
    }
    LibraryChange newest() const { return valueOf(library->changes(1)).at(0); }
};

} // namespace

/// Renaming, merging, splitting and retiring types; each is one change with who and why.
class LibraryTypesTest : public QObject {
    Q_OBJECT
private slots:
    void aTypesPlaceIsForLife()
    {
        TwoTypes f;
        QCOMPARE(f.a.place, 0);
        QCOMPARE(f.b.place, 1);
        const TypeRecord early = f.enrolled(u"0 before A"_s, 15000); // by its name it would come first
        QCOMPARE(early.place, 2);
        valueOf(f.library->renameType(f.b.id, u"00"_s, typesBecause));
        QVERIFY(f.library->retireType(f.a.id, typesBecause));
        QVERIFY(f.library->reinstateType(f.a.id, typesBecause));
        const TypeRecord last = f.enrolled(u"1"_s, 18000);
        QVERIFY(f.library->retireType(early.id, typesBecause)); // its place stays taken
        QMap<QString, int> places;
        for (const TypeRecord& type : valueOf(f.library->types()))
            places[type.name] = type.place;
        QCOMPARE(places, (QMap<QString, int>{{u"A"_s, 0}, {u"00"_s, 1}, {u"1"_s, 3}}));
        QCOMPARE(last.place, 3);
        const TypeModels models = fitTypeModels(valueOf(f.library->enrolledSqueezes()));
        QVERIFY(models.find(u"00"_s) && models.find(u"1"_s));
        QCOMPARE(models.find(u"00"_s)->place, 1);
        QCOMPARE(models.find(u"1"_s)->place, 3);
    }
    void howTheForceGoesIsKept()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        for (const ExcitationKind kind : {ExcitationKind::Prbs, ExcitationKind::FourLevel,
                                          ExcitationKind::InverseRepeat, ExcitationKind::Multisine}) {
            Recipe recipe;
            recipe.kind = kind;
            valueOf(library->addType(toString(kind), recipe, u"N"_s, u"m"_s));
            QVERIFY(valueOf(library->findType(toString(kind)))->recipe == recipe);
            EnrollmentDraft draft;
            draft.name = u"draft "_s + toString(kind);
            draft.recipe = recipe;
            QVERIFY(library->saveDraft(draft));
            QVERIFY(valueOf(library->draft(draft.name))->recipe == recipe);
        }
    }
    void theLevelsOfAForceAreKeptToTheLastBit()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        Recipe recipe;
        recipe.kind = ExcitationKind::Levels;
        recipe.levels = {-1, 1.0 / 3, 0.1, 1, -1e-17};
        const TypeRecord type = valueOf(library->addType(u"A"_s, recipe, u"N"_s, u"m"_s));
        QVERIFY(valueOf(library->findType(u"A"_s))->recipe == recipe);
        EnrollmentDraft draft;
        draft.name = u"draft"_s;
        draft.recipe = recipe;
        QVERIFY(library->saveDraft(draft));
        QVERIFY(valueOf(library->draft(draft.name))->recipe == recipe);
        for (const std::vector<double>& bad : {std::vector(mostLevels + 1, 0.5), {std::nan("")}}) {
            recipe.levels = bad;
            QCOMPARE(library->addType(u"B"_s, recipe, u"N"_s, u"m"_s).error().code, ErrorCode::Usage);
        }
    }
    /// What was enrolled before squeezes on two levels as ever.
    void aLibraryOfTheStepBeforeHasTwoLevels()
    {
        const LibraryFolder folder;
        {
            const std::vector<Migration> before = migrationsUpTo(19);
            const auto database = valueOf(Database::open(folder.file()));
            valueOf(migrate(*database, before));
            for (const QString& statement :
                 {u"INSERT INTO types (id, station, created_utc, name) VALUES ('t', 's', "
                  "'2026-01-02T08:30:00.000Z', 'A')"_s,
                  u"INSERT INTO type_states (id, station, created_utc, type_id, version, name, status, "
                  "recipe_version, code) VALUES ('u', 's', '2026-01-02T08:30:00.000Z', 't', 1, 'A', "
                  "'enrolled', 1, '')"_s,
                  u"INSERT INTO type_versions (id, station, created_utc, type_id, version, recipe_name, "
                  "peak_n, bias_n, bit_s, seconds, max_force_n, max_travel_m, force_unit, position_unit) "
                  "VALUES ('v', 's', '2026-01-02T08:30:00.000Z', 't', 1, 'squeeze-8N', 8, 20, 0.005, 1, 40, "
                  "0.02, 'N', 'm')"_s})
                valueOf(database->execute(statement, u"prepare"_s));
        }
        const auto library = folder.open();
        QCOMPARE(library->schemaVersion(), migrations().back().version);
        const auto type = valueOf(library->findType(u"A"_s));
        QVERIFY(type);
        QVERIFY(type->recipe.kind == ExcitationKind::Prbs);
        QCOMPARE(type->recipe.peak_N, 8.0);
        QVERIFY(type->recipe.levels.empty());
    }
    void aRenamedTypeKeepsItsSqueezesAndItsApproval()
    {
        TwoTypes f;
        const TypeRecord renamed = valueOf(f.library->renameType(f.a.id, u" Cola "_s, typesBecause));
        QCOMPARE(renamed.name, u"Cola"_s);
        QVERIFY(renamed.approved);
        QCOMPARE(renamed.squeezes, 3);
        QCOMPARE(f.names(), QStringList({u"B"_s, u"Cola"_s}));
        QVERIFY(!valueOf(f.library->findType(u"A"_s)));
        QCOMPARE(valueOf(f.library->enrolledSqueezes()).back().type, u"Cola"_s);
        const LibraryChange change = f.newest();
        QVERIFY(change.kind == ChangeKind::Rename);
        QCOMPARE(change.type, u"A"_s);
        QCOMPARE(change.other, u"Cola"_s);
        QCOMPARE(change.operatorName, u"Ada"_s);
        QCOMPARE(change.reason, u"asked by quality"_s);
        QCOMPARE(change.version, valueOf(f.library->version()));
        QCOMPARE(inWords(change), u"A was renamed Cola."_s);
    }
    void otherSqueezesVoidTheApproval()
    {
        TwoTypes f;
        const auto judged = [&] {
            QStringList types;
            for (const TypeSqueeze& squeeze : valueOf(f.library->approvedSqueezes()))
                if (!types.contains(squeeze.type))
                    types += squeeze.type;
            return types;
        };
        const auto isApproved = [&] { return valueOf(f.library->findType(u"A"_s))->approved; };
        QCOMPARE(judged(), QStringList({u"A"_s, u"B"_s}));
        const GraspRecord added = valueOf(f.library->addGrasp(aGrasp(f.a.id)));
        QVERIFY(!isApproved());
        QCOMPARE(judged(), QStringList({u"B"_s}));
        QCOMPARE(valueOf(f.library->enrolledSqueezes()).size(), std::size_t(7));
        QCOMPARE(f.newest().version, valueOf(f.library->version()));
        QCOMPARE(inWords(f.newest()), u"A was enrolled with 1 squeeze more. Its approval is void."_s);
        valueOf(f.library->addGrasp(aGrasp(f.a.id))); // it is void already
        QCOMPARE(inWords(f.newest()), u"A was enrolled with 1 squeeze more."_s);
        valueOf(f.library->approveType(f.a.id, u"Ada"_s));
        QCOMPARE(judged(), QStringList({u"A"_s, u"B"_s}));
        valueOf(f.library->dropGrasp(added.id, u"slipped"_s, u"Ada"_s));
        QVERIFY(!isApproved());
        QCOMPARE(inWords(f.newest()), u"1 squeeze of A was dropped. Its approval is void."_s);
        valueOf(f.library->approveType(f.a.id, u"Ada"_s));
        valueOf(f.library->undropGrasp(added.id, u"Ada"_s));
        QVERIFY(!isApproved());
        const AuditEntry entry = valueOf(f.library->auditTrail().entries({{}, {}, 1, 0})).front();
        QCOMPARE(entry.action, u"type.undrop"_s);
        QVERIFY2(entry.details.contains(u"approval_void"_s), qPrintable(entry.details));
    }
    void aNameThatIsFreeAgainCanBeUsed()
    {
        TwoTypes f;
        QCOMPARE(f.library->renameType(f.a.id, u"B"_s, typesBecause).error().code, ErrorCode::Usage);
        valueOf(f.library->renameType(f.a.id, u"Cola"_s, typesBecause));
        const TypeRecord again = f.enrolled(u"A"_s, 5000);
        QVERIFY(again.id != f.a.id);
        QCOMPARE(again.name, u"A"_s);
        QCOMPARE(f.names(), QStringList({u"A"_s, u"B"_s, u"Cola"_s}));
        QCOMPARE(f.library->addType(u"Cola"_s, {}, u"N"_s, u"m"_s).error().code, ErrorCode::Usage);
    }
    void aMergedTypesSqueezesCountInTheOther()
    {
        TwoTypes f;
        valueOf(f.library->dropGrasp(f.squeezesOf(f.a.id).at(0), u"slipped"_s, u"Ada"_s));
        const TypeRecord merged = valueOf(f.library->mergeTypes(f.a.id, f.b.id, typesBecause));
        QCOMPARE(merged.squeezes, 5); // the dropped one stays dropped
        QVERIFY(!merged.approved);    // with other squeezes it needs approval again
        QCOMPARE(f.names(), QStringList({u"B"_s}));
        for (const TypeSqueeze& squeeze : valueOf(f.library->enrolledSqueezes()))
            QCOMPARE(squeeze.type, u"B"_s);
        QCOMPARE(f.newest().squeezes, 2);
        QCOMPARE(f.library->mergeTypes(f.a.id, f.b.id, typesBecause).error().code, ErrorCode::NotFound);
        QCOMPARE(f.library->mergeTypes(f.b.id, f.b.id, typesBecause).error().code, ErrorCode::Usage);
        QCOMPARE(f.library->addGrasp(aGrasp(f.a.id)).error().code, ErrorCode::NotFound);
    }
    void partsOfMergedTypesStayApart()
    {
        TwoTypes f;
        const auto add = [&f](const QString& typeId, const QString& part) {
            NewGrasp grasp = aGrasp(typeId);
            grasp.part = part;
            return valueOf(f.library->addGrasp(grasp));
        };
        QCOMPARE(add(f.a.id, u"1"_s).part, u"1"_s);
        add(f.a.id, u"1"_s);
        add(f.b.id, u"1"_s);
        valueOf(f.library->mergeTypes(f.a.id, f.b.id, typesBecause));
        QMap<QString, int> parts;
        for (const TypeSqueeze& squeeze : valueOf(f.library->enrolledSqueezes()))
            ++parts[squeeze.part];
        QCOMPARE(parts.size(), 3);
        QCOMPARE(parts[{}], 6);
        QCOMPARE(parts[u"1"_s], 1);
        QCOMPARE(parts[f.a.id + u"/1"_s], 2);
    }
    void splitSqueezesBecomeATypeWithTheSameRecipe()
    {
        TwoTypes f;
        const QStringList squeezes = f.squeezesOf(f.a.id);
        const TypeRecord added = valueOf(f.library->splitType(f.a.id, {squeezes[0], squeezes[2], squeezes[0]},
                                                              u"A light"_s, typesBecause));
        QCOMPARE(added.squeezes, 2);
        QVERIFY(added.recipe == f.a.recipe);
        QVERIFY(!added.approved);
        QCOMPARE(f.squeezesOf(f.a.id), QStringList({squeezes[1]}));
        QCOMPARE(f.squeezesOf(added.id), QStringList({squeezes[0], squeezes[2]}));
        QVERIFY(!valueOf(f.library->findType(u"A"_s))->approved);
        QVERIFY(valueOf(f.library->recording(squeezes[0])) == awkwardRecording());
    }
    void aSplitThatMakesNoSenseChangesNothing_data()
    {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("count");
        QTest::addColumn<QString>("name");
        QTest::newRow("no squeeze") << 0 << 0 << u"C"_s;
        QTest::newRow("all squeezes") << 0 << 3 << u"C"_s;
        QTest::newRow("another type's squeeze") << 2 << 2 << u"C"_s;
        QTest::newRow("a name that is taken") << 0 << 1 << u"B"_s;
        QTest::newRow("no name") << 0 << 1 << u"  "_s;
    }
    void aSplitThatMakesNoSenseChangesNothing()
    {
        QFETCH(int, first);
        QFETCH(int, count);
        QFETCH(QString, name);
        TwoTypes f;
        const qint64 version = valueOf(f.library->version());
        const QStringList all = f.squeezesOf(f.a.id) + f.squeezesOf(f.b.id);
        QCOMPARE(f.library->splitType(f.a.id, all.mid(first, count), name, typesBecause).error().code,
                 ErrorCode::Usage);
        QCOMPARE(valueOf(f.library->version()), version);
        QCOMPARE(f.names(), QStringList({u"A"_s, u"B"_s}));
    }
    void aRetiredTypeIsKeptButNotRecognised()
    {
        TwoTypes f;
        valueOf(f.library->retireType(f.a.id, typesBecause));
        QCOMPARE(f.names(), QStringList({u"B"_s}));
        QCOMPARE(valueOf(f.library->enrolledSqueezes()).size(), std::size_t(3));
        QCOMPARE(valueOf(f.library->retiredTypes()).at(0).name, u"A"_s);
        QVERIFY(valueOf(f.library->findType(u"A"_s))->status == TypeStatus::Retired);
        QCOMPARE(f.library->addGrasp(aGrasp(f.a.id)).error().code, ErrorCode::Usage);
        QCOMPARE(f.library->approveType(f.a.id, u"Ada"_s).error().code, ErrorCode::Usage);
        QCOMPARE(f.library->addType(u"A"_s, {}, u"N"_s, u"m"_s).error().code, ErrorCode::Usage);
        valueOf(f.library->reinstateType(f.a.id, typesBecause));
        QCOMPARE(valueOf(f.library->enrolledSqueezes()).size(), std::size_t(6));
        QVERIFY(!valueOf(f.library->findType(u"A"_s))->approved);
        QCOMPARE(f.library->reinstateType(f.a.id, typesBecause).error().code, ErrorCode::Usage);
    }
    void everyChangeAsksWhy()
    {
        TwoTypes f;
        const ChangeNote silent{u"Ada"_s, u"  "_s};
        QCOMPARE(f.library->renameType(f.a.id, u"C"_s, silent).error().code, ErrorCode::Usage);
        QCOMPARE(f.library->mergeTypes(f.a.id, f.b.id, silent).error().code, ErrorCode::Usage);
        QCOMPARE(f.library->splitType(f.a.id, f.squeezesOf(f.a.id).mid(1), u"C"_s, silent).error().code,
                 ErrorCode::Usage);
        QCOMPARE(f.library->retireType(f.a.id, silent).error().code, ErrorCode::Usage);
        QCOMPARE(f.library->restoreVersion(0, silent).error().code, ErrorCode::Usage);
        QCOMPARE(f.names(), QStringList({u"A"_s, u"B"_s}));
    }
    void everyChangeIsARowInTheOrderItWasMade()
    {
        const TwoTypes f;
        QStringList kinds;
        qint64 version = valueOf(f.library->version());
        for (const LibraryChange& change : valueOf(f.library->changes(100))) {
            QCOMPARE(change.version, version--);
            QVERIFY(!change.station.isEmpty() && !inWords(change).isEmpty());
            QVERIFY(changeKindFromString(toString(change.kind)) == change.kind);
            kinds.prepend(toString(change.kind));
        }
        const QStringList one{u"new_type"_s, u"squeeze"_s, u"squeeze"_s, u"squeeze"_s, u"approve"_s};
        QCOMPARE(kinds, one + one);
        QCOMPARE(valueOf(f.library->changes(2, 1)).at(0).version, 9);
    }
    void whoeverIsKilledInTheMiddleChangesNothing()
    {
        TwoTypes f;
        const QString file = f.folder.file();
        const qint64 version = valueOf(f.library->version());
        // Another process holds the half merge in the file when it ends.
        QVERIFY(endedWell(startChild([&] {
            auto database = valueOf(Database::open(file));
            if (!onServer())
                valueOf(database->execute(u"PRAGMA cache_size=1"_s, u"test"_s));
            const auto transaction = valueOf(Transaction::begin(*database, u"test"_s));
            for (int i = 1; i <= 300; ++i)
                valueOf(database->execute(
                    u"INSERT INTO placements SELECT 'half%1' || id, station, '', id, %2, '%3', 1 FROM grasps"_s
                        .arg(i)
                        .arg(100 + i)
                        .arg(f.b.id),
                    u"test"_s));
            valueOf(database->execute(u"UPDATE type_states SET status = 'gone'"_s, u"test"_s));
            _exit(0);
        })));
        const auto again = f.folder.open();
        QCOMPARE(valueOf(again->version()), version);
        QCOMPARE(valueOf(again->findType(u"A"_s))->squeezes, 3);
        QCOMPARE(RawDatabase(file).count(u"placements"_s), 0);
    }
    void aMergeThatFailsHalfWayLeavesNothingOfIt()
    {
        TwoTypes f;
        const qint64 version = valueOf(f.library->version());
        // The third of the three squeezes cannot be placed: the table itself refuses it.
        takeNoMoreThan(2, u"placements"_s, f.folder.file());
        QCOMPARE(f.library->mergeTypes(f.a.id, f.b.id, typesBecause).error().code, ErrorCode::StorageFailed);
        QCOMPARE(valueOf(f.library->version()), version);
        QCOMPARE(f.names(), QStringList({u"A"_s, u"B"_s}));
        QCOMPARE(valueOf(f.library->findType(u"A"_s))->squeezes, 3);
        QVERIFY(valueOf(f.library->findType(u"B"_s))->approved);
    }
    void aCodeBelongsToOneTypeAndIsAVersion()
    {
        TwoTypes f;
        const qint64 before = valueOf(f.library->version());
        const TypeRecord coded = valueOf(f.library->setTypeCode(f.a.id, u" 4006381333931 "_s, typesBecause));
        QCOMPARE(coded.code, u"4006381333931"_s);
        QVERIFY(coded.approved);
        QCOMPARE(inWords(f.newest()), u"A got the code 4006381333931 for scanners."_s);
        QCOMPARE(f.newest().reason, typesBecause.reason);
        // Another type cannot have it, not even while the first is retired.
        valueOf(f.library->retireType(f.a.id, typesBecause));
        const auto taken = f.library->setTypeCode(f.b.id, u"4006381333931"_s, typesBecause);
        QCOMPARE(taken.error().code, ErrorCode::Usage);
        QVERIFY(taken.error().describe().contains(u"A has the code"_s));
        valueOf(f.library->reinstateType(f.a.id, typesBecause));
        QCOMPARE(valueOf(f.library->findType(u"A"_s))->code, u"4006381333931"_s);
        // A new name keeps it; the version before had none.
        valueOf(f.library->renameType(f.a.id, u"Cola"_s, typesBecause));
        QCOMPARE(valueOf(f.library->findType(u"Cola"_s))->code, u"4006381333931"_s);
        valueOf(f.library->restoreVersion(before, typesBecause));
        QCOMPARE(valueOf(f.library->findType(u"A"_s))->code, QString());
    }
    void aCodeIsTakenAwayAgain()
    {
        TwoTypes f;
        valueOf(f.library->setTypeCode(f.a.id, u"12"_s, typesBecause));
        QCOMPARE(f.library->setTypeCode(f.a.id, {}, {u"Ada"_s, {}}).error().code, ErrorCode::Usage); // why?
        QCOMPARE(valueOf(f.library->setTypeCode(f.a.id, {}, typesBecause)).code, QString());
        QCOMPARE(inWords(f.newest()), u"A no longer has a code for scanners."_s);
        valueOf(f.library->setTypeCode(f.b.id, u"12"_s, typesBecause));
    }
};

GRIPSCOPE_TEST(LibraryTypesTest)
#include "library_types_test.moc"
