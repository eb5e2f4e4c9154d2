// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/inspect/squeeze_judged.h"
#include "core/session/squeeze/squeeze_notes.h"
#include "core/signal/recording/recording_csv.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class SqueezeNotesTest : public QObject {
    Q_OBJECT
private slots:
    void aBeginningIsReadAsItWasWritten()
    {
        for (const auto mode : {SqueezeRecorder::Mode::Movement, SqueezeRecorder::Mode::Everything}) {
            const QString note = toNote(SqueezeBegins{mode, 2000, {}});
            const std::optional<SqueezeBegins> read = squeezeBegins(note);
            QVERIFY(read && read->mode == mode && !read->after);
            QCOMPARE(read->samples, std::size_t(2000));
            QCOMPARE(squeezeBegins(note + u"after: 17\n"_s)->after, std::optional<std::uint64_t>(17));
            QVERIFY(!squeezeEnded(note));
        }
    }

    void anEndHasTheRecordingsHead()
    {
        Recording recording;
        recording.sampleTime_s = 0.0005;
        recording.forceUnit = u"N"_s;
        recording.positionUnit = u"mm"_s;
        recording.hold = ForceHold::Zero;
        recording.forceLag_s = 0.0001;
        recording.time_s = {1, 2};
        recording.force = {3, 4};
        recording.position = {5, 6};
        recording.sequence = {7, 8};
        recording.status = {0, 1};
        recording.provenance = {{u"operator"_s, u"Ada: Lovelace"_s}, {u"samples"_s, u"99"_s}};
        const QString note = toNote(SqueezeEnded{{}, recording.size(), recording}) + u"after: 8\n"_s;
        const std::optional<SqueezeEnded> read = squeezeEnded(note);
        QVERIFY(read && !read->failure);
        QCOMPARE(read->samples, std::size_t(2));
        Recording again = read->head;
        again.time_s = recording.time_s;
        again.force = recording.force;
        again.position = recording.position;
        again.sequence = recording.sequence;
        again.status = recording.status;
        QVERIFY(again == recording);
        QCOMPARE(toCsv(again), toCsv(recording));
    }

    void aFailureIsTold()
    {
        Recording head;
        head.sampleTime_s = 0.001;
        const auto read = squeezeEnded(toNote(SqueezeEnded{u"It was\nstopped."_s, 0, head}));
        QVERIFY(read.has_value());
        QCOMPARE(read->failure, std::optional<QString>(u"It was stopped."_s));
    }

    void whatIsNoNoteOfASqueezeIsPassedOver_data()
    {
        QTest::addColumn<QString>("note");
        QTest::newRow("empty") << QString();
        QTest::newRow("another") << u"session\nname: x\n"_s;
        QTest::newRow("no count") << u"squeeze begins\nmode: movement\n"_s;
        QTest::newRow("more than there can be")
            << u"squeeze begins\nmode: movement\nsamples: 9999999999999999999\n"_s;
        QTest::newRow("no head") << u"squeeze ended\nsamples: 3\n"_s;
        QTest::newRow("a damaged head")
            << u"squeeze ended\nsamples: 3\n# gripscope-recording: 9\ntime_s,force,position\n"_s;
    }
    void whatIsNoNoteOfASqueezeIsPassedOver()
    {
        QFETCH(QString, note);
        QVERIFY(!squeezeBegins(note));
        QVERIFY(!squeezeEnded(note));
    }
    void whatASqueezeWasJudgedByComesBackToTheBit()
    {
        SqueezeJudged judged;
        judged.rates.falseReject = 0.1 / 3;
        judged.rates.wrongType = 1e-6;
        judged.rates.strangerAccept = 0.007;
        judged.rates.confidence = 0.95;
        judged.rates.robust = true;
        judged.earlyEnd = EarlyEnd{VerdictKind::Type, QStringLiteral("can: a\nb"), 0.999, 321};
        const auto back = squeezeJudged(toNote(judged));
        QVERIFY(back && back->rates == judged.rates && back->earlyEnd);
        QCOMPARE(back->earlyEnd->samples, std::size_t(321));
        QCOMPARE(back->earlyEnd->posterior, 0.999);
        QCOMPARE(back->earlyEnd->type, QStringLiteral("can: a b")); // a name has no line's end
        QVERIFY(back->policy == JudgingPolicy());                   // as notes of before have it
        for (const JudgingPolicy& policy :
             {JudgingPolicy{true, 0, false}, JudgingPolicy{false, 0.1 / 3, true},
              JudgingPolicy{true, 0.02, true}}) {
            judged.policy = policy;
            QVERIFY(squeezeJudged(toNote(judged))->policy == policy);
        }
        judged.earlyEnd.reset();
        judged.rates.confidence.reset();
        const auto plain = squeezeJudged(toNote(judged));
        QVERIFY(plain && plain->rates == judged.rates && !plain->earlyEnd);
        for (const QString& bad : {QStringLiteral("squeeze ended\n"), QStringLiteral("squeeze judged\n"),
                                   toNote(judged).replace(QStringLiteral("0.007"), QStringLiteral("7")),
                                   toNote(judged).replace(QStringLiteral("wrong_type"), QStringLiteral("x"))})
            QVERIFY(!squeezeJudged(bad));
    }
};

GRIPSCOPE_TEST(SqueezeNotesTest)
#include "squeeze_notes_test.moc"
