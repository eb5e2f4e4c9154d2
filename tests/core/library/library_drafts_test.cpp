// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/records/enrollment_draft.h"
#include "core/library/sql/time_ordered_id.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

EnrollmentDraft aDraft(const QString& name)
{
    EnrollmentDraft draft;
    draft.name = name;
    draft.recipe.name = u"squeeze-7N"_s;
    draft.recipe.peak_N = 7;
    draft.recipe.maxForce_N = 33.25;
    draft.recipe.maxTravel_m = 0.0125;
    draft.step = EnrollmentDraft::Step::Squeeze;
    draft.part = u"7"_s;
    draft.operatorName = u"Zoë"_s;
    draft.remark = u"recipe"_s;
    return draft;
}

PartPicture aPicture()
{
    return {newTimeOrderedId(), u"png"_s, 3, 2, QByteArray("\x89PNG\0bytes", 10)};
}

} // namespace

/// Enrolments under way and pictures of parts in the library.
class LibraryDraftsTest : public QObject {
    Q_OBJECT
private slots:
    void theNewestRowOfADraftIsInForceAndEveryRowStays()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        QVERIFY(valueOf(library->drafts()).empty());
        valueOf(library->saveDraft(aDraft(u"Cola"_s)));
        EnrollmentDraft later = aDraft(u"Cola"_s);
        later.step = EnrollmentDraft::Step::Review;
        later.recipe.peak_N = 8;
        valueOf(library->saveDraft(later));
        valueOf(library->saveDraft(aDraft(u"Pepsi"_s)));
        const auto drafts = valueOf(library->drafts());
        QCOMPARE(drafts.size(), std::size_t(2));
        QCOMPARE(drafts[0].name, u"Pepsi"_s); // newest first
        const EnrollmentDraft& cola = drafts[1];
        QCOMPARE(cola.step, EnrollmentDraft::Step::Review);
        QCOMPARE(cola.recipe, later.recipe);
        QCOMPARE(cola.part, u"7"_s);
        QCOMPARE(cola.operatorName, u"Zoë"_s);
        QVERIFY(cola.changed.isValid());
        QCOMPARE(RawDatabase(folder.file()).count(u"enrollment_drafts"_s), 3);
        QCOMPARE(library->saveDraft(aDraft(u" "_s)).error().code, ErrorCode::Usage);
    }
    void anEndedDraftIsOfferedNoMoreAndCanBeBegunAnew()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->saveDraft(aDraft(u"Cola"_s)));
        valueOf(library->endDraft(u"Cola"_s, DraftEnd::Discarded, u"Ada"_s));
        valueOf(library->endDraft(u"Cola"_s, DraftEnd::Approved, u"Ada"_s)); // it is over already
        valueOf(library->endDraft(u"Nobody"_s, DraftEnd::Approved, u"Ada"_s));
        QVERIFY(!valueOf(library->draft(u"Cola"_s)));
        RawDatabase raw(folder.file());
        QCOMPARE(raw.column(u"SELECT state FROM enrollment_drafts ORDER BY id"_s),
                 QStringList({u"open"_s, u"discarded"_s}));
        QCOMPARE(raw.run(u"SELECT peak_n FROM enrollment_drafts WHERE state = 'discarded'"_s).toDouble(),
                 7.0);
        valueOf(library->saveDraft(aDraft(u"Cola"_s)));
        QVERIFY(valueOf(library->draft(u"Cola"_s)));
    }
    void aDraftCountsTheSqueezesOfItsType()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->saveDraft(aDraft(u"Cola"_s)));
        QCOMPARE(valueOf(library->draft(u"Cola"_s))->squeezes, 0);
        const TypeRecord type = valueOf(library->addType(u"Cola"_s, {}, u"N"_s, u"m"_s));
        valueOf(library->addGrasp(aGrasp(type.id)));
        QCOMPARE(valueOf(library->draft(u"Cola"_s))->squeezes, 1);
    }
    void aRecordingThatADraftHasIsNotStoredAgain()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const QString typeId = valueOf(library->addType(u"Cola"_s, {}, u"N"_s, u"m"_s)).id;
        const DraftSqueeze squeeze{newTimeOrderedId(), u"Cola"_s, awkwardRecording(), u"virtual:"_s, u"3"_s};
        valueOf(library->addDraftSqueeze(squeeze));
        NewGrasp same = aGrasp(typeId), other = aGrasp(typeId), unknown = aGrasp(typeId);
        same.draftSqueezeId = other.draftSqueezeId = squeeze.id;
        other.recording = awkwardRecording(400);
        unknown.draftSqueezeId = u"none"_s;
        const QString shared = valueOf(library->addGrasp(same)).id;
        const QString own = valueOf(library->addGrasp(other)).id;
        const QString whole = valueOf(library->addGrasp(unknown)).id;
        RawDatabase raw(folder.file());
        const auto bytesAt = [&](const QString& id) {
            return raw.run(u"SELECT LENGTH(packed) FROM recordings WHERE grasp_id = '%1'"_s.arg(id)).toInt();
        };
        QCOMPARE(bytesAt(shared), 0);
        QVERIFY(bytesAt(own) > 0 && bytesAt(whole) > 0);
        QCOMPARE(valueOf(library->recording(shared)), *same.recording);
        QCOMPARE(valueOf(library->recording(own)), *other.recording);
        QCOMPARE(valueOf(library->recording(whole)), *unknown.recording);
        QVERIFY(valueOf(library->grasp(shared))->hasRecording);
        // What it shares is what it says.
        raw.run(u"UPDATE draft_squeezes SET packed = X'00000004'"_s);
        QCOMPARE(library->recording(shared).error().code, ErrorCode::StorageCorrupt);
    }
    void aSqueezeThatNobodyDecidedOnComesBackBitForBit()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const DraftSqueeze squeeze{newTimeOrderedId(), u"Cola"_s, awkwardRecording(), u"virtual:"_s, u"3"_s};
        valueOf(library->addDraftSqueeze(squeeze));
        EnrollmentDraft draft = aDraft(u"Cola"_s);
        draft.pendingId = squeeze.id;
        valueOf(library->saveDraft(draft));
        const DraftSqueeze back =
            valueOf(library->draftSqueeze(valueOf(library->draft(u"Cola"_s))->pendingId));
        QCOMPARE(back.recording, squeeze.recording);
        QCOMPARE(back.source, u"virtual:"_s);
        QCOMPARE(back.part, u"3"_s);
        QCOMPARE(library->draftSqueeze(u"none"_s).error().code, ErrorCode::NotFound);
        draft.pendingId = u"none"_s;
        QVERIFY(!library->saveDraft(draft)); // no row points into nothing
        RawDatabase(folder.file()).run(u"UPDATE draft_squeezes SET sha256 = 'another'"_s);
        QCOMPARE(library->draftSqueeze(squeeze.id).error().code, ErrorCode::StorageCorrupt);
    }
    void theNewestPictureOfATypeIsInForce()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"Cola"_s, {}, u"N"_s, u"m"_s));
        QVERIFY(!valueOf(library->typePicture(type.id)));
        const PartPicture first = aPicture();
        const PartPicture second = aPicture();
        for (const PartPicture& picture : {first, second}) {
            valueOf(library->addPicture(picture));
            valueOf(library->setTypePicture(type.id, picture.id, u"Ada"_s));
            QCOMPARE(*valueOf(library->typePicture(type.id)), picture);
        }
        valueOf(library->setTypePicture(type.id, {}, u"Ada"_s));
        QVERIFY(!valueOf(library->typePicture(type.id)));
        QCOMPARE(RawDatabase(folder.file()).count(u"type_pictures"_s), 3);
        QVERIFY(!library->setTypePicture(u"none"_s, first.id, {}));
        QVERIFY(!library->setTypePicture(type.id, u"none"_s, {}));
    }
    void aPictureWhoseBytesChangedIsNotShown()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const PartPicture picture = aPicture();
        valueOf(library->addPicture(picture));
        QCOMPARE(valueOf(library->picture(picture.id)), picture);
        RawDatabase(folder.file()).run(u"UPDATE pictures SET bytes = x'00'"_s);
        QCOMPARE(library->picture(picture.id).error().code, ErrorCode::StorageCorrupt);
        PartPicture other = aPicture();
        other.format = u"bmp"_s;
        QCOMPARE(library->addPicture(other).error().code, ErrorCode::Usage);
    }
    void aDroppedSqueezeCountsAgainAndBothChangesAreOnRecord()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const TypeRecord type = valueOf(library->addType(u"Cola"_s, {}, u"N"_s, u"m"_s));
        const QString id = valueOf(library->addGrasp(aGrasp(type.id))).id;
        valueOf(library->dropGrasp(id, u"slipped"_s, u"Ada"_s));
        QVERIFY(!valueOf(library->grasp(id))->accepted);
        valueOf(library->undropGrasp(id, u"Bo"_s));
        QVERIFY(valueOf(library->grasp(id))->accepted);
        valueOf(library->undropGrasp(id, u"Bo"_s)); // counts already
        QCOMPARE(valueOf(library->types())[0].squeezes, 1);
        const auto changes = valueOf(library->changes(10));
        QCOMPARE(changes.size(), std::size_t(4));
        QVERIFY(changes[0].kind == ChangeKind::Undrop);
        QCOMPARE(changes[0].operatorName, u"Bo"_s);
        QVERIFY(changeKindFromString(toString(ChangeKind::Undrop)) == ChangeKind::Undrop);
    }
    void whatBelongsTogetherIsStoredWholeOrNotAtAll()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const auto twoThen = [&](const Expected<void>& end) {
            return library->atOnce([&]() -> Expected<void> {
                valueOf(library->saveDraft(aDraft(u"Cola"_s)));
                valueOf(library->addType(u"Cola"_s, {}, u"N"_s, u"m"_s));
                return end;
            });
        };
        QVERIFY(!twoThen(failure(ErrorCode::Usage, {u"no"_s})));
        QVERIFY(valueOf(library->drafts()).empty() && valueOf(library->types()).empty());
        valueOf(twoThen({}));
        QVERIFY(valueOf(library->drafts()).size() == 1 && valueOf(library->types()).size() == 1);
        valueOf(library->saveDraft(aDraft(u"Pepsi"_s))); // and what comes after has its own transaction
        QCOMPARE(valueOf(folder.open()->drafts()).size(), std::size_t(2));
    }
};

GRIPSCOPE_TEST(LibraryDraftsTest)
#include "library_drafts_test.moc"
