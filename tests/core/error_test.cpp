// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "tests/support/test_registry.h"

#include <QSet>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class ErrorTest : public QObject {
    Q_OBJECT
private slots:
    void aSentenceTakesItsArguments()
    {
        const Error error{ErrorCode::BadInput,
                          {u"a.csv:3:2"_s, u"found \"x\""_s, u"a number was expected"_s}};
        QCOMPARE(error.describe(), u"a.csv:3:2: found \"x\"; a number was expected"_s);
        QCOMPARE(error.name(), u"bad_input"_s);
    }
    void aPlaceholderInsideAnArgumentStaysAsItIs()
    {
        const Error error{ErrorCode::FileUnreadable, {u"100%2.csv"_s, u"%1"_s}};
        QVERIFY(error.describe().startsWith(u"100%2.csv: the file cannot be read (%1)."_s));
    }
    void missingArgumentsLeaveNoPlaceholder()
    {
        QVERIFY(!Error({ErrorCode::BadInput, {}}).describe().contains(u'%'));
    }
    void everyCodeHasANameOfItsOwnAndWords()
    {
        QSet<QString> names;
        const int last = static_cast<int>(ErrorCode::Cancelled);
        for (int code = 0; code <= last; ++code) {
            const Error error{static_cast<ErrorCode>(code), {u"one"_s, u"two"_s, u"three"_s, u"four"_s}};
            names << error.name();
            const bool takesNone = error.code == ErrorCode::StopNotObeyed; // there is nothing to add
            QVERIFY(error.describe().contains(u"one"_s) != takesNone);
            QVERIFY(!error.describe().isEmpty());
        }
        QCOMPARE(names.size(), last + 1);
    }
    void failuresTravelAsValues()
    {
        const auto divide = [](int a, int b) -> Expected<int> {
            if (b == 0)
                return failure(ErrorCode::Usage, {u"by zero"_s});
            return a / b;
        };
        QCOMPARE(divide(6, 3).value(), 2);
        QCOMPARE(divide(1, 0).error(), (Error{ErrorCode::Usage, {u"by zero"_s}}));
    }
};

GRIPSCOPE_TEST(ErrorTest)
#include "error_test.moc"
