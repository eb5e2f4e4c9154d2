// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/person.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;
using std::chrono::seconds;

class AttemptLimitTest : public QObject {
    Q_OBJECT
private slots:
    void theWaitGrowsFromTheFifthWrongTry()
    {
        const std::pair<int, int> expected[] = {{0, 0},   {4, 0},   {5, 30},   {6, 60},   {7, 120},
                                                {8, 240}, {9, 480}, {10, 900}, {11, 900}, {1'000'000, 900}};
        for (const auto& [wrong, wait] : expected)
            QCOMPARE(SignInTries({wrong, {}}).wait(), seconds(wait));
    }
    void whatIsLeftEndsWithTheWait()
    {
        const QDateTime last(QDate(2026, 1, 1), QTime(12, 0), Qt::UTC);
        const SignInTries tries{6, last};
        QCOMPARE(tries.remaining(last), seconds(60));
        QCOMPARE(tries.remaining(last.addSecs(59)), seconds(1));
        QCOMPARE(tries.remaining(last.addSecs(60)), seconds(0));
        QCOMPARE(tries.remaining(last.addSecs(-3600)), seconds(60)); // the clock was set back
        QCOMPARE(SignInTries().remaining(last), seconds(0));
    }
    void theWaitIsToldInWords()
    {
        QCOMPARE(waitInWords(seconds(30)), u"30 s"_s);
        QCOMPARE(waitInWords(seconds(119)), u"119 s"_s);
        QCOMPARE(waitInWords(seconds(121)), u"3 min"_s);
    }
};

GRIPSCOPE_TEST(AttemptLimitTest)
#include "attempt_limit_test.moc"
