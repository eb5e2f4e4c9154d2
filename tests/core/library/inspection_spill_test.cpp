// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/spill/inspection_spill.h"
#include "core/library/spill/spill_file.h"
#include "core/library/spill/spilled_inspection.h"
#include "core/library/sql/time_ordered_id.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QTest>

#include <sys/stat.h>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// With a value of its own in every field that is stored.
NewInspection aFullInspection()
{
    NewInspection inspection = anInspection();
    inspection.id = newTimeOrderedId();
    inspection.expectedType = u"B"_s;
    inspection.seconds = 1.25;
    inspection.partNumber = u"SN 0042"_s;
    inspection.libraryVersion = 3;
    inspection.rates = {0.02, 0.003, false, 0.04, 0.95, true, InstrumentRange{{1, 2, 3}, {4, 5, 6}}, 0.07};
    Verdict& verdict = inspection.verdict;
    verdict.reasons = {u"Zoë."_s, u"Second."_s};
    verdict.rival = u"B"_s;
    PartLimits limits;
    limits.quantities[2] = ToleranceLimits{11500, {}};
    verdict.conformity = valueOf(
        judgeConformity(limits, {std::nullopt, std::nullopt, MeasuredValue{1.0 / 7e-4, 7, 5.5}}, 1.0));
    verdict.timesLonger = 2.5;
    verdict.heldForStranger = true;
    verdict.strangerPosterior = 1.0 / 7;
    verdict.strangerAccept = 0.011;
    verdict.validity = {ValidityVerdict::Suspect, {u"hold"_s, u"fit"_s}, {u"Why."_s}};
    NewGrasp& grasp = inspection.grasp;
    grasp.part = u"7"_s;
    grasp.recorded = QDateTime(QDate(2026, 1, 2), QTime(3, 4, 5, 678), Qt::UTC);
    grasp.utcOffset_s = -12'600;
    grasp.program = u"0.0.1"_s;
    grasp.determined = someQuantities();
    grasp.identification = {{u"recommended"_s, u"oe"_s}, {u"deep"_s, QJsonObject{{u"x"_s, 1e-300}}}};
    Estimate& first = grasp.estimates[0];
    first.message = u"Why."_s;
    first.nuisance = {1.0 / 3, -2e-9, 0.25};
    first.coefficients = ArxCoefficients{-1.5, 0.75, 1e-9, 2e-9, -0.125};
    first.fit.predictionPercent = 99.125;
    first.residuals.sse = 1.0 / 9;
    first.residuals.degreesOfFreedom = 493;
    first.residuals.whitenessP = 0.25;
    first.residuals.inputIndependenceP = 0.75;
    first.iterations = 9;
    Estimate& second = grasp.estimates[1];
    second.estimator = Estimator::Arx221;
    second.status = EstimateStatus::NoPhysicalMapping;
    second.parameters.reset();
    second.covariance.reset();
    return inspection;
}

/// All rows of a table, without the keys and times that each storing makes anew.
QString rowsOf(RawDatabase& raw, const QString& table)
{
    if (onServer()) // as text, the number of the row among the columns that do not count
        return raw
            .column(
                u"SELECT (to_jsonb(t) - '{id,grasp_id,created_utc,ledgered,rowid}'::text[])::text FROM %1 t "
                "ORDER BY rowid"_s.arg(table))
            .join(u'\n');
    const QString columns =
        raw.run(u"SELECT group_concat('quote(' || name || ')', ' || ''|'' || ') FROM pragma_table_info('%1') "
                "WHERE name NOT IN ('id', 'grasp_id', 'created_utc', 'ledgered')"_s.arg(table))
            .toString();
    return raw.column(u"SELECT %1 FROM %2 ORDER BY rowid"_s.arg(columns, table)).join(u'\n');
}

/// A place for a library, which need not be there, whose spill files go with it.
struct SpillPlace {
    LibraryFolder folder;
    QString library = folder.file();
    QString spill = InspectionSpill::file(library, 1);
    ChainEnd birth{u"station 0123"_s, 1, QByteArray(32, 'a')};

    ~SpillPlace()
    {
        for (const QString& name : left())
            QFile::remove(QFileInfo(spill).path() + u'/' + name);
    }
    [[nodiscard]] QStringList left() const
    {
        const QFileInfo info(spill);
        return QDir(info.path()).entryList({info.fileName().section(u'-', 0, 0) + u"-*"_s}, QDir::AllEntries);
    }
    [[nodiscard]] InspectionSpill::Opened open(InspectionSpill& into) const
    {
        return valueOf(into.open(library, birth));
    }
    /// So many wait there, of a program that is gone.
    QStringList leave(int count) const
    {
        InspectionSpill before;
        QStringList ids;
        for (const SpilledInspection& there : open(before).waiting)
            ids += there.inspection.id;
        for (int i = 0; i < count; ++i) {
            const NewInspection inspection = aFullInspection();
            valueOf(before.add(inspection).get());
            ids += inspection.id;
        }
        return ids;
    }
};

QStringList idsOf(const InspectionSpill::Opened& opened)
{
    QStringList ids;
    for (const SpilledInspection& waiting : opened.waiting)
        ids += waiting.inspection.id;
    return ids;
}

NewInspection unpacked(const QByteArray& bytes)
{
    qint64 memory = mostOfOneFile;
    return valueOf(unpackInspection(bytes, memory));
}

} // namespace

class InspectionSpillTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsKeptIsStoredAsIfItHadNeverWaited()
    {
        const LibraryFolder atOnce, later;
        const NewInspection inspection = aFullInspection();
        valueOf(atOnce.open()->addInspection(inspection));
        const NewInspection back = unpacked(valueOf(packInspection(inspection)));
        valueOf(later.open()->addInspection(back));
        RawDatabase one(atOnce.file()), two(later.file());
        for (const QString& table : {u"inspections"_s, u"grasps"_s, u"estimates"_s, u"recordings"_s,
                                     u"documents"_s, u"determined_quantities"_s}) {
            QVERIFY2(one.count(table) > 0, qPrintable(table));
            QCOMPARE(rowsOf(two, table), rowsOf(one, table));
        }
        QCOMPARE(back.id, inspection.id);
        QVERIFY(back.rates == inspection.rates);
        QVERIFY(back.verdict.validity.reasons == inspection.verdict.validity.reasons);
        QCOMPARE(back.verdict.heldForStranger, inspection.verdict.heldForStranger);
        QCOMPARE(back.verdict.strangerPosterior, inspection.verdict.strangerPosterior);
        QCOMPARE(back.verdict.timesLonger, inspection.verdict.timesLonger);
        QCOMPARE(*back.grasp.recording, *inspection.grasp.recording);
    }
    void whatWaitsOutlivesTheProgramInItsOrder()
    {
        const SpillPlace place;
        const QStringList ids = place.leave(3);
        {
            InspectionSpill next;
            const auto opened = place.open(next);
            QVERIFY(!opened.lost);
            QCOMPARE(idsOf(opened), ids);
            next.remove(opened.waiting[0].place);
        }
        QCOMPARE(place.leave(0), ids.mid(1));
        const QStringList more = place.leave(1); // goes on behind
        QCOMPARE(more.size(), 3);
        QCOMPARE(more.mid(0, 2), ids.mid(1));
        InspectionSpill last;
        const auto opened = place.open(last);
        QCOMPARE(idsOf(opened), more);
        for (const SpilledInspection& waiting : opened.waiting)
            last.remove(waiting.place);
        QVERIFY(last.hasRoom());
    }
    void allRoomIsThereFromTheStartAndGoneWithTheProgram()
    {
        const SpillPlace place;
        {
            InspectionSpill spill;
            QVERIFY(!spill.hasRoom());
            static_cast<void>(place.open(spill));
            struct stat found {};
            QCOMPARE(stat(qPrintable(place.spill), &found), 0);
            QVERIFY(found.st_size >= SpillFile::size);
            QVERIFY(found.st_blocks * 512 >= SpillFile::size); // not a hole
        }
        QVERIFY(place.left().isEmpty());
        place.leave(1);
        QVERIFY(QFileInfo(place.spill).size() < 100'000); // as much as is needed
    }
    void aFullFileSaysSo()
    {
        const SpillPlace place;
        InspectionSpill spill;
        static_cast<void>(place.open(spill));
        NewInspection large = aFullInspection();
        Recording& recording = *large.grasp.recording;
        recording = awkwardRecording(50'000);
        QRandomGenerator random(1); // which nothing packs
        for (double& value : recording.force)
            value = random.generateDouble();
        qint64 last = 0;
        int kept = 0;
        for (; spill.hasRoom(); ++kept)
            last = valueOf(spill.add(large).get());
        QVERIFY(kept > 5);
        auto refused = spill.add(large).get();
        for (int more = 0; refused && more < 10; ++more)
            refused = spill.add(large).get();
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, ErrorCode::FileUnwritable);
        QVERIFY(last > 0);
    }
    void programsAtOnceHaveAFileEachAndOneInheritsFromTheOther()
    {
        const SpillPlace place;
        auto one = std::make_unique<InspectionSpill>();
        InspectionSpill two;
        static_cast<void>(place.open(*one));
        static_cast<void>(place.open(two));
        const NewInspection first = aFullInspection(), second = aFullInspection();
        valueOf(one->add(first).get());
        valueOf(two.add(second).get());
        {
            InspectionSpill three;
            QVERIFY(place.open(three).waiting.empty()); // nothing of those that run
        }
        one.reset();
        InspectionSpill four; // takes the place of the one that ended
        QCOMPARE(idsOf(place.open(four)), QStringList{first.id});
    }
    void whatEveryProgramLeftIsInherited()
    {
        const SpillPlace place;
        {
            InspectionSpill one, two;
            static_cast<void>(place.open(one));
            static_cast<void>(place.open(two));
            valueOf(one.add(aFullInspection()).get());
            valueOf(two.add(aFullInspection()).get());
        }
        InspectionSpill next;
        QCOMPARE(place.open(next).waiting.size(), std::size_t(2));
        QCOMPARE(place.left().size(), 1); // the other file is gone
    }
    void anotherLibraryAtThePlaceGetsNothingAndNothingIsLost()
    {
        SpillPlace place;
        place.leave(2);
        place.birth.hash = QByteArray(32, 'b');
        InspectionSpill spill;
        const auto opened = place.open(spill);
        QVERIFY(opened.waiting.empty());
        QVERIFY(opened.lost);
        const QStringList kept = place.left().filter(u".kept-"_s);
        QCOMPARE(kept.size(), 1);
        QVERIFY(opened.lost->describe().contains(kept[0]));
        QVERIFY(spill.hasRoom());
    }
    void aPlaceThatIsNoFileIsAnErrorInWords_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("a folder") << 0;
        QTest::newRow("a pipe") << 1;
        QTest::newRow("a link") << 2;
    }
    void aPlaceThatIsNoFileIsAnErrorInWords()
    {
        QFETCH(int, what);
        const SpillPlace place;
        QVERIFY(QDir().mkpath(QFileInfo(place.spill).path()));
        if (what == 0)
            QVERIFY(QDir().mkdir(place.spill));
        else if (what == 1)
            QCOMPARE(mkfifo(qPrintable(place.spill), 0600), 0);
        else
            QVERIFY(QFile::link(place.folder.folder.filePath(u"elsewhere"_s), place.spill));
        {
            InspectionSpill spill;
            const auto opened = spill.open(place.library, place.birth);
            QVERIFY(!opened);
            QCOMPARE(opened.error().code, ErrorCode::FileUnwritable);
            QVERIFY(!spill.hasRoom());
        }
        QVERIFY(what == 0 ? QDir().rmdir(place.spill) : QFile::remove(place.spill));
    }
    void hostileBytesAreAnErrorInWords()
    {
        const SpillPlace place;
        const QStringList ids = place.leave(3);
        const QByteArray good = bytesOf(place.spill);
        QRandomGenerator random(2);
        for (int round = 0; round < 60; ++round) {
            QByteArray bytes = good;
            if (round % 3 == 0)
                bytes.truncate(random.bounded(int(good.size())));
            else
                for (int change = 0; change < 1 + round / 10; ++change)
                    bytes[random.bounded(int(good.size()))] = char(random.bounded(256));
            if (round % 10 == 9) // a length that no file has, in the head of the first block
                bytes.replace(4096 + 8, 8, QByteArray(8, char(0xff)));
            writeBytes(place.spill, bytes);
            InspectionSpill spill;
            const auto opened = spill.open(place.library, place.birth);
            QVERIFY(opened);
            QVERIFY(opened->waiting.size() <= 3);
            // Whatever is read is what was put in.
            for (const QString& id : idsOf(*opened))
                QVERIFY(ids.contains(id));
            if (opened->lost)
                QVERIFY(opened->lost->describe().size() < 1000);
            for (const SpilledInspection& waiting : opened->waiting)
                spill.remove(waiting.place);
        }
    }
    void theProgramThatJudgedIsKnownThoughAnotherStores()
    {
        const LibraryFolder folder;
        valueOf(folder.open()->addInspection(unpacked(valueOf(packInspection(aFullInspection())))));
        RawDatabase raw(folder.file());
        QCOMPARE(raw.run(u"SELECT program FROM inspections"_s).toString(), u"0.0.1"_s);
        QCOMPARE(raw.column(u"SELECT DISTINCT program FROM estimates"_s), QStringList{u"0.0.1"_s});
    }
    void whatIsUnpackedOfAFileHasALimit()
    {
        const QByteArray bytes = valueOf(packInspection(aFullInspection()));
        qint64 memory = 1'000'000;
        valueOf(unpackInspection(bytes, memory));
        const qint64 one = 1'000'000 - memory;
        QVERIFY(one > 500 * 34); // its samples at least
        memory = 100;
        const auto refused = unpackInspection(bytes, memory);
        QVERIFY(!refused && refused.error().code == ErrorCode::StorageCorrupt);
    }
    void whatWasKeptAsideIsTakenBack()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        const auto birth = valueOf(library->birth());
        NewInspection inspection = aFullInspection();
        inspection.batchId = u"of a batch that a backup does not know"_s;
        const QString file = valueOf(InspectionSpill::keepAside(folder.file(), birth, inspection));
        {
            const auto kept = valueOf(KeptInspections::open(file, birth));
            QVERIFY(!kept->damaged());
            QCOMPARE(kept->waiting().size(), std::size_t(1));
        }
        QVERIFY(QFileInfo(file).size() <
                100'000); // nothing was taken, so it is there, and no larger than needed
        {
            const auto kept = valueOf(KeptInspections::open(file, birth));
            const auto known = valueOf(library->withKnownBatch(kept->waiting()[0].inspection));
            QCOMPARE(valueOf(library->addInspection(known)).id, inspection.id);
            kept->remove(kept->waiting()[0].place);
        }
        QVERIFY(!QFile::exists(file));
        const auto gone = KeptInspections::open(file, birth);
        QVERIFY(!gone && gone.error().code == ErrorCode::NotFound);
    }
    void whatWasKeptAsideGoesToItsOwnLibraryOnly()
    {
        SpillPlace place;
        const QString file =
            valueOf(InspectionSpill::keepAside(place.library, place.birth, aFullInspection()));
        place.birth.hash = QByteArray(32, 'b');
        const auto refused = KeptInspections::open(file, place.birth);
        QVERIFY(!refused && refused.error().code == ErrorCode::Usage);
        QVERIFY(QFile::exists(file));
    }
    void aDamagedFileThatWasKeptAsideStays()
    {
        const SpillPlace place;
        const QStringList ids = place.leave(2);
        QByteArray bytes = bytesOf(place.spill);
        bytes[bytes.size() - 200] = char(bytes[bytes.size() - 200] + 1); // in the second one
        writeBytes(place.spill, bytes);
        {
            InspectionSpill spill;
            const auto opened = place.open(spill);
            QVERIFY(opened.lost);
            QCOMPARE(idsOf(opened), ids.mid(0, 1));
        }
        const QString file = QFileInfo(place.spill).path() + u'/' + place.left().filter(u".kept-"_s).value(0);
        {
            const auto kept = valueOf(KeptInspections::open(file, place.birth));
            QVERIFY(kept->damaged());
            QCOMPARE(kept->waiting().size(), std::size_t(1));
            kept->remove(kept->waiting()[0].place);
        }
        QCOMPARE(bytesOf(file), bytes);
    }
    void aStationWhoseClockIsBehindMakesNoOtherLibrary()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s));
        const auto birth = valueOf(library->birth());
        QVERIFY(birth);
        RawDatabase(folder.file())
            .run(u"INSERT INTO ledger SELECT 'a first station', number, kind, format, "
                 "'1970-01-01T00:00:00.000Z', leaves, previous_hash, hash, signer, signature FROM ledger "
                 "WHERE number = 1"_s);
        QVERIFY(valueOf(library->birth()) == birth);
    }
    void aBlockThatIsNoInspectionIsKeptAside()
    {
        const SpillPlace place;
        const QByteArray json = R"({"id":"x"})";
        for (const QByteArray& bytes :
             {QByteArray(), QByteArray("\xff\xff\xff\xff", 4), qCompress(QByteArray(8, char(0xff))),
              qCompress(QByteArray(7, '\0') + char(json.size()) + json)}) {
            {
                const auto file = valueOf(SpillFile::open(place.spill, SpillFile::Missing::Make));
                valueOf(file->prepare(place.birth.chain.toUtf8() + ' ' + place.birth.hash.toHex(), {}));
                valueOf(file->add(bytes));
            }
            qint64 memory = mostOfOneFile;
            const auto refused = unpackInspection(bytes, memory);
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, ErrorCode::StorageCorrupt);
            InspectionSpill spill;
            const auto opened = place.open(spill);
            QVERIFY(opened.waiting.empty());
            QVERIFY(opened.lost);
        }
        QCOMPARE(place.left().filter(u".kept-"_s).size(), 4);
    }
};

GRIPSCOPE_TEST(InspectionSpillTest)
#include "inspection_spill_test.moc"
