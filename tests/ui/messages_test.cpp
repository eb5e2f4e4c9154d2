// SPDX-License-Identifier: GPL-3.0-or-later
// What the window tells goes by itself once it is no longer true, and only then.
#include "tests/support/test_registry.h"
#include "ui/context/messages.h"
#include "ui/widgets/message_bar.h"

#include <QSignalSpy>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class MessagesTest : public QObject {
    Q_OBJECT
private slots:
    void aMessageStaysAsLongAsItIsTrue()
    {
        Messages messages;
        QSignalSpy reported(&messages, &Messages::reported);
        QSignalSpy withdrawn(&messages, &Messages::withdrawn);
        bool away = true;
        messages.report(u"The gripper is away."_s, [&] { return away; });
        messages.report(u"Not saved."_s); // for good: whoever read it closes it
        QCOMPARE(reported.size(), 2);
        messages.poll();
        QCOMPARE(withdrawn.size(), 0);
        away = false;
        messages.poll();
        messages.poll();
        QCOMPARE(withdrawn.size(), 1);
        QCOMPARE(withdrawn.at(0).at(0).toString(), u"The gripper is away."_s);
    }
    void theNewerConditionOfTheSameMessageHolds()
    {
        Messages messages;
        QSignalSpy withdrawn(&messages, &Messages::withdrawn);
        messages.report(u"Busy."_s, [] { return false; });
        messages.report(u"Busy."_s, [] { return true; });
        messages.poll();
        QCOMPARE(withdrawn.size(), 0);
        messages.report(u"Busy."_s); // now it stays
        messages.poll();
        QCOMPARE(withdrawn.size(), 0);
    }
    void successIsNoWarning()
    {
        MessageBar bar;
        Messages messages;
        connect(&messages, &Messages::reported, &bar, &MessageBar::show);
        connect(&messages, &Messages::told, &bar, &MessageBar::tell);
        messages.tell(u"Saved."_s);
        QCOMPARE(bar.message(), u"Saved."_s);
        QVERIFY(bar.isGood(bar.message()));
        const QImage good = bar.grab().toImage();
        messages.report(u"Not saved."_s);
        QVERIFY(!bar.isGood(bar.message()));
        bar.dismiss();
        QVERIFY(bar.isGood(bar.message())); // the one behind it is what it was
        messages.report(u"Saved."_s);
        QVERIFY(!bar.isGood(bar.message()));
        QVERIFY(bar.grab().toImage() != good); // another sign at the same words
    }
    void whoIsToldMayReportAgain()
    {
        Messages messages;
        bool first = true;
        messages.report(u"first"_s, [&] { return first; });
        QStringList told;
        connect(&messages, &Messages::withdrawn, this, [&](const QString& message) {
            told << message;
            if (message == u"first")
                messages.report(u"second"_s, [] { return false; });
        });
        first = false;
        messages.poll();
        QCOMPARE(told, QStringList{u"first"_s});
        messages.poll();
        QCOMPARE(told, (QStringList{u"first"_s, u"second"_s}));
    }
};

GRIPSCOPE_TEST(MessagesTest)
#include "messages_test.moc"
