// SPDX-License-Identifier: GPL-3.0-or-later
// RETURN_IF_ERROR and ASSIGN_OR_RETURN: the value goes on, the error goes to the caller, each expression is
// worked out once.
#include "core/base/error.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <memory>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

Expected<std::unique_ptr<int>> boxed(int value, int& calls)
{
    ++calls;
    if (value < 0)
        return failure(ErrorCode::NotFound, {u"a box"_s});
    return std::make_unique<int>(value);
}

std::optional<Error> problemWith(int value)
{
    if (value > 100)
        return Error{ErrorCode::LimitExceeded, {u"value"_s}};
    return {};
}

Expected<int> sum(int a, int b, int& calls)
{
    ASSIGN_OR_RETURN(const std::unique_ptr<int> first, boxed(a, calls));
    ASSIGN_OR_RETURN(auto second, boxed(b, calls)); // two in one scope
    if (*first == 0)
        RETURN_IF_ERROR(boxed(-1, calls)); // one statement, so that an if without braces takes it whole
    RETURN_IF_ERROR(problemWith(*first + *second));
    return *first + *second;
}

} // namespace

class ErrorHandedOnTest : public QObject {
    Q_OBJECT
private slots:
    void theValueGoesOn()
    {
        int calls = 0;
        QCOMPARE(sum(2, 3, calls).value(), 5);
        QCOMPARE(calls, 2);
    }
    void theFirstErrorEndsTheFunction()
    {
        int calls = 0;
        QCOMPARE(sum(-1, 3, calls).error().code, ErrorCode::NotFound);
        QCOMPARE(calls, 1);
        QCOMPARE(sum(2, -1, calls).error().code, ErrorCode::NotFound);
        QCOMPARE(calls, 3);
        QCOMPARE(sum(0, 3, calls).error().code, ErrorCode::NotFound);
    }
    void aProblemIsAnError()
    {
        int calls = 0;
        QCOMPARE(sum(60, 60, calls).error().code, ErrorCode::LimitExceeded);
    }
};

GRIPSCOPE_TEST(ErrorHandedOnTest)
#include "error_handed_on_test.moc"
