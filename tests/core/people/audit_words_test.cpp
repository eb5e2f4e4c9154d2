// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/audit_entry.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;

/// What a person reads of an entry is words, never the JSON that is hashed.
class AuditWordsTest : public QObject {
    Q_OBJECT
private slots:
    void detailsAreWords_data()
    {
        QTest::addColumn<QString>("details");
        QTest::addColumn<QString>("words");
        QTest::newRow("none") << QString() << QString();
        QTest::newRow("a number") << u"{\"version\":7}"_s << u"version: 7"_s;
        QTest::newRow("several") << u"{\"degree\":2,\"due\":\"2027-01-01\",\"channel\":\"force\"}"_s
                                 << u"channel: force; degree: 2; holds until: 2027-01-01"_s;
        QTest::newRow("a rate before and now") << u"{\"false_reject\":{\"from\":0.01,\"to\":0.02}}"_s
                                               << u"false reject: 1\u00A0% before, 2\u00A0% now"_s;
        QTest::newRow("nothing before")
            << u"{\"confidence\":{\"from\":null,\"to\":0.95}}"_s << u"confidence: – before, 95\u00A0% now"_s;
        QTest::newRow("yes and no") << u"{\"robust\":{\"from\":true,\"to\":false}}"_s
                                    << u"robust: yes before, no now"_s;
        QTest::newRow("all of it changed") << u"{\"from\":\"signed_in\",\"to\":\"supervisors\"}"_s
                                           << u"everybody who has signed in before, supervisors now"_s;
        QTest::newRow("who may approve") << u"{\"from\":\"one_person\",\"to\":\"second_person\"}"_s
                                         << u"one person before, a second person now"_s;
        QTest::newRow("approval void")
            << u"{\"approval_void\":true,\"version\":7}"_s << u"its approval is void: yes; version: 7"_s;
        QTest::newRow("a batch") << u"{\"as_expected\":8,\"known_type\":1,\"parts\":10,\"type\":\"A\"}"_s
                                 << u"as expected: 8; of a known type: 1; parts: 10; type: A"_s;
        QTest::newRow("an export") << u"{\"format\":\"csv\",\"rows\":3}"_s << u"format: csv; rows: 3"_s;
        QTest::newRow("a list") << u"{\"squeezes\":[1,2]}"_s << u"squeezes: 1, 2"_s;
        QTest::newRow("within") << u"{\"limits\":{\"peak_n\":10}}"_s << u"limits: peak n: 10"_s;
        QTest::newRow("unknown to this program") << u"{\"new_thing\":\"x\"}"_s << u"new thing: x"_s;
        QTest::newRow("not JSON") << u"half {"_s << QString();
    }
    void detailsAreWords()
    {
        QFETCH(QString, details);
        AuditEntry entry;
        entry.details = details;
        QTEST(detailsInWords(entry), "words");
        for (const QChar sign : u"{}[]\"_"_s)
            QVERIFY2(!detailsInWords(entry).contains(sign), qPrintable(detailsInWords(entry)));
    }
};

GRIPSCOPE_TEST(AuditWordsTest)
#include "audit_words_test.moc"
