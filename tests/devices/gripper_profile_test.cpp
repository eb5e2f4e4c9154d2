// SPDX-License-Identifier: GPL-3.0-or-later
// A profile as a JSON document: what is read out of it, and what is said of one that is wrong.
#include "devices/profile/profile_json.h"
#include "devices/profile/profile_library.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

QByteArray shipped(const QString& name)
{
    QFile file(u":/profiles/"_s + name + u".json"_s);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray changed(const QByteArray& json, const QByteArray& before, const QByteArray& after)
{
    QByteArray copy = json;
    Q_ASSERT(copy.contains(before));
    return copy.replace(before, after);
}

} // namespace

class GripperProfileTest : public QObject {
    Q_OBJECT
private slots:
    void theExamplesAreProfiles_data()
    {
        QTest::addColumn<QString>("name");
        for (const QString& name : QDir(u":/profiles"_s).entryList({u"example_*"_s}))
            QTest::newRow(qPrintable(name)) << name.chopped(5);
        QCOMPARE(QDir(u":/profiles"_s).entryList({u"example_*"_s}).size(), 3);
    }
    void theExamplesAreProfiles()
    {
        QFETCH(QString, name);
        const ProfileReading reading = readProfile(shipped(name));
        QVERIFY2(reading.profile, reading.problems.empty()
                                      ? ""
                                      : qPrintable(toError(reading.problems.front(), name).describe()));
        QVERIFY2(reading.profile->maker.contains(u"no such maker"), "an example says that it is one");
        QCOMPARE(reading.profile->vendor, 0x1209); // the range that pid.codes keeps for tests
        QVERIFY(reading.profile->product >= 2 && reading.profile->product <= 0x10);
    }
    void whatIsWrittenIsReadAgain_data() { theExamplesAreProfiles_data(); }
    void whatIsWrittenIsReadAgain()
    {
        QFETCH(QString, name);
        GripperProfile profile = readProfile(shipped(name)).profile.value();
        profile.forceLag_s = 0.00025;
        if (profile.status)
            profile.status->flags[0].whenSet = false;
        const ProfileReading again = readProfile(writeProfile(profile));
        QVERIFY(again.profile);
        QCOMPARE(*again.profile, profile);
    }
    void everyFieldOfTheDocumentCounts()
    {
        const GripperProfile profile = readProfile(shipped(u"example_big_endian"_s)).profile.value();
        QCOMPARE(profile.reportId.value(), 4);
        QCOMPARE(profile.reportLength, std::size_t(8));
        QCOMPARE(profile.samplesPerSecond, 500.0);
        QVERIFY(profile.hold == ForceHold::Zero);
        QCOMPARE(profile.force.field.byte, std::size_t(4));
        QVERIFY(profile.force.field.type == FieldType::I16);
        QVERIFY(profile.force.field.bigEndian);
        QCOMPARE(profile.position.offset, 20.0);
        QCOMPARE(profile.force.saturatesAbove.value(), 12000.0);
        QVERIFY(!profile.sequence->countsSamples);
        QVERIFY(!profile.time);
        QCOMPARE(profile.status->flags.size(), std::size_t(4));
        QCOMPARE(profile.status->flags[1].meaning, std::uint16_t(StatusForceSaturated));
        QCOMPARE(profile.lossEvidence(), LossEvidence::SequenceNumber);
        QCOMPARE(readProfile(shipped(u"example_float_stream"_s)).profile->lossEvidence(),
                 LossEvidence::Clock);
        QCOMPARE(readProfile(shipped(u"example_bare"_s)).profile->lossEvidence(), LossEvidence::None);
    }
    void aMistakeIsToldWithItsPlace_data()
    {
        QTest::addColumn<QByteArray>("before");
        QTest::addColumn<QByteArray>("after");
        QTest::addColumn<QString>("pointer");
        QTest::addColumn<QString>("found");
        QTest::addColumn<QString>("expected");
        const auto row = [](const char* name, const char* before, const char* after, const char16_t* pointer,
                            const char16_t* found, const char16_t* expected) {
            QTest::newRow(name) << QByteArray(before) << QByteArray(after) << QString::fromUtf16(pointer)
                                << QString::fromUtf16(found) << QString::fromUtf16(expected);
        };
        row("a type that does not exist", R"("type": "i16", "endian": "big", "scale": 0.01)",
            R"("type": "i17", "endian": "big", "scale": 0.01)", u"/fields/force/type", u"\"i17\"",
            u"one of \"u8\"");
        row("a name that is not known", R"("counts": )", R"("count": )", u"/fields/sequence/count",
            u"the unknown name \"count\"", u"byte, counts");
        row("something missing", R"("byte": 1, "type": "u8", "counts")", R"("type": "u8", "counts")",
            u"/fields/sequence", u"no \"byte\"", u"a whole number from 0 to 63");
        row("no rate", "\"samples_per_second\": 500", "\"samples_per_second\": 0",
            u"/report/samples_per_second", u"0", u"a number above 0");
        row("a flag within the list", "\"position_saturated\"", "\"tired\"", u"/fields/status/flags/2/means",
            u"\"tired\"", u"one of \"moving\"");
        row("commands", "\"commandable\": false", "\"commandable\": true", u"/commandable", u"true",
            u"listening only");
        row("a later format", "\"gripscope_profile\": 1", "\"gripscope_profile\": 2", u"/gripscope_profile",
            u"2", u"the number 1");
        row("a field behind the report's end", R"("byte": 6)", R"("byte": 7)", u"/fields/position/byte",
            u"7, so that the field ends behind byte 8", u"byte 7 at the latest");
        row("a field over another", R"("byte": 6)", R"("byte": 5)", u"/fields/position/byte",
            u"5, where force has bits already", u"shares_bytes");
        row("a field over the report ID", R"("byte": 1, "type")", R"("byte": 0, "type")",
            u"/fields/sequence/byte", u"0", u"byte 0 is the report ID");
        row("a unit that is not one of force", R"("unit": "N")", R"("unit": "mm")", u"/fields/force/unit",
            u"\"mm\"", u"uN, mN, N or kN");
        row("a scale of zero", R"("scale": 0.01)", R"("scale": 0)", u"/fields/force/scale", u"0",
            u"a number other than 0");
        row("a flag beyond its byte", R"("bit": 7)", R"("bit": 8)", u"/fields/status/flags/3/bit", u"8",
            u"0 to 7");
        row("Gripscope's own gripper", R"("product": "0002")", R"("product": "0001")", u"/device",
            u"1209:0001", u"needs no profile");
        row("no JSON", R"("device": {)", R"("device" {)", u":7:12", u"missing name separator",
            u"a JSON document");
    }
    void aMistakeIsToldWithItsPlace()
    {
        QFETCH(QByteArray, before);
        QFETCH(QByteArray, after);
        QFETCH(QString, pointer);
        QFETCH(QString, found);
        QFETCH(QString, expected);
        const ProfileReading reading = readProfile(changed(shipped(u"example_big_endian"_s), before, after));
        QVERIFY(!reading.profile);
        QCOMPARE(reading.problems.size(), std::size_t(1));
        const ProfileProblem& problem = reading.problems.front();
        QCOMPARE(problem.pointer, pointer);
        QVERIFY2(problem.found.contains(found), qPrintable(problem.found));
        QVERIFY2(problem.expected.contains(expected), qPrintable(problem.expected));
    }
    void allMistakesAreToldAtOnce()
    {
        QByteArray json = changed(shipped(u"example_bare"_s), "\"byte\": 0", "\"byte\": -1");
        json = changed(json, "\"force_hold\": \"zoh\"", "\"force_hold\": \"none\"");
        QCOMPARE(readProfile(json).problems.size(), std::size_t(2));
    }
    void severalSamplesNeedAStrideThatKeepsThemApart()
    {
        const QByteArray json = shipped(u"example_float_stream"_s);
        QCOMPARE(readProfile(changed(json, ", \"stride\": 8", "")).problems.front().found,
                 u"4 samples without a stride"_s);
        const ProfileReading narrow = readProfile(changed(json, "\"stride\": 8", "\"stride\": 4"));
        QVERIFY(narrow.problems.front().expected.contains(u"shares_bytes"));
        const ProfileReading wide = readProfile(changed(json, "\"stride\": 8", "\"stride\": 9"));
        QVERIFY(wide.problems.front().expected.contains(u"byte 39 at the latest"));
    }
    void bitsOfOneNumberMayBelongToSeveralFields()
    {
        GripperProfile profile = readProfile(shipped(u"example_bare"_s)).profile.value();
        ProfileStatus status;
        status.field = {0, FieldType::U16, false, 12, 4, false};
        status.flags = {{0, StatusMoving, true}};
        profile.status = status;
        QVERIFY(findProfileProblems(profile).empty());
        profile.status->field.firstBit = 11;
        QCOMPARE(findProfileProblems(profile).size(), std::size_t(1));
        profile.status->field.sharesBytes = true;
        QVERIFY(findProfileProblems(profile).empty());
    }
    void aClockThatComesRoundTooSoonIsRefused()
    {
        GripperProfile profile = readProfile(shipped(u"example_float_stream"_s)).profile.value();
        profile.time->field.type = FieldType::U8; // 256 us beside 2 ms a report
        QCOMPARE(findProfileProblems(profile).front().pointer, u"/fields/time/type"_s);
    }
    void theUsersProfileGoesBeforeTheShippedOne()
    {
        const QTemporaryDir folder;
        qputenv("GRIPSCOPE_PROFILES", folder.path().toUtf8());
        QCOMPARE(profileFor(0x1209, 2)->name, u"Fictional F-500 gripper"_s);
        const Expected<QString> file =
            installProfile(changed(shipped(u"example_big_endian"_s), "Fictional F-500", "My own"));
        QVERIFY(file);
        QCOMPARE(*file, folder.path() + u"/1209_0002.json"_s);
        QCOMPARE(profileFor(0x1209, 2)->name, u"My own gripper"_s);
        QVERIFY(!loadProfiles().find(0x1209, 2)->shipped);
        QCOMPARE(profileFor(0x1209, 0x77).error().code, ErrorCode::NotFound);
        qunsetenv("GRIPSCOPE_PROFILES");
    }
    void aBrokenFileOfTheUserIsNamed()
    {
        const QTemporaryDir folder;
        qputenv("GRIPSCOPE_PROFILES", folder.path().toUtf8());
        QVERIFY(!installProfile("{}"));
        QVERIFY(QDir(folder.path()).isEmpty());
        QVERIFY(writeWholeFile(folder.filePath(u"mine.json"_s), "{}"));
        QCOMPARE(loadProfiles().errors.size(), std::size_t(1));
        QVERIFY(profileFor(0x1209, 2)); // others are not in its way
        const Error error = profileFor(0x1209, 0x77).error();
        QVERIFY2(error.describe().contains(u"mine.json#: found no \""), qPrintable(error.describe()));
        qunsetenv("GRIPSCOPE_PROFILES");
    }
    void everyDescriptionOfTheSchemaSaysWhatIsExpected()
    {
        const QJsonObject definitions =
            QJsonDocument::fromJson(profileSchema()).object()[u"definitions"_s].toObject();
        QVERIFY(definitions.size() >= 8);
        for (const QJsonValue& definition : definitions)
            if (definition[u"type"_s].toString() != u"object")
                QVERIFY(!definition[u"description"_s].toString().isEmpty());
    }
};

GRIPSCOPE_TEST(GripperProfileTest)
#include "gripper_profile_test.moc"
