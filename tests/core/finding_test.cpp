// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/words.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QTranslator>

using namespace gripscope;
using namespace Qt::StringLiterals;

namespace {

/// Knows two sentences, the places of one the other way round.
class Reversed : public QTranslator {
public:
    QString translate(const char*, const char* source, const char*, int) const override
    {
        if (qstrcmp(source, "%1 is %2 heavy") == 0)
            return u"%2 wiegt %1"_s;
        if (qstrcmp(source, "%1 of %2 s") == 0)
            return u"%L1 von %L2 s, 5 %L, %"_s;
        if (qstrcmp(source, "There is no %1.") == 0)
            return u"Nicht vorhanden: %L1."_s;
        return qstrcmp(source, "the lid") == 0 ? u"der Deckel"_s : QString();
    }
    bool isEmpty() const override { return false; }
};

struct GermanReader {
    GermanReader()
    {
        QCoreApplication::installTranslator(&translator);
        QLocale::setDefault(QLocale(QLocale::German));
    }
    ~GermanReader()
    {
        QCoreApplication::removeTranslator(&translator);
        QLocale::setDefault(QLocale::c());
    }
    Q_DISABLE_COPY_MOVE(GermanReader)
    Reversed translator;
};

Finding heavy()
{
    return Words::say("%1 is %2 heavy").arg(Words::say("the lid"), Finding::number(1.25, 'f', 2) + u" kg"_s);
}

QJsonValue parsed(const char* json)
{
    return QJsonDocument::fromJson(QByteArray("[") + json + "]").array().first();
}

} // namespace

/// What is to be said, as a value.
class FindingTest : public QObject {
    Q_OBJECT
private slots:
    void itIsWordedByWhoReadsIt()
    {
        const Finding finding = heavy();
        QCOMPARE(finding.describe(), u"the lid is 1.25 kg heavy"_s);
        const GermanReader reader;
        QCOMPARE(finding.describe(), u"1,25 kg wiegt der Deckel"_s);
        QCOMPARE(finding.english(), u"the lid is 1.25 kg heavy"_s);
        QCOMPARE(heavy(), finding); // made in another language, it is the same
    }
    void whatFillsAPlaceIsNotLookedInto()
    {
        QCOMPARE(Words::say("%1, %2").arg(u"%2"_s, u"100%1"_s).describe(), u"%2, 100%1"_s);
        QCOMPARE(Words::say("%1 and %2").arg(3).describe(), u"3 and "_s);
        QCOMPARE(Words::say("%1 % of %2").arg(std::size_t(12)).arg(0.5).describe(), u"12 % of 0.5"_s);
    }
    /// A translator may write %L1, as in words that QString::arg() fills: it is the same place.
    void aPlaceOfTheLocaleIsAPlace()
    {
        const Finding finding = Words::say("%1 of %2 s").arg(0.5).arg(u"%L1"_s);
        QCOMPARE(finding.describe(), u"0.5 of %L1 s"_s);
        const GermanReader reader;
        QCOMPARE(finding.describe(), u"0,5 von %L1 s, 5 %L, %"_s);
        QCOMPARE((Error{ErrorCode::NotFound, {u"%L1"_s}}).describe(), u"Nicht vorhanden: %L1."_s);
    }
    void sentencesAreJoinedAndBegun()
    {
        Finding all;
        QVERIFY(all.isEmpty());
        all += Words::say("a loose grip");
        all += u", "_s;
        all += Words::say("too far");
        QCOMPARE(all.describe(), u"a loose grip, too far"_s);
        QCOMPARE(all.capitalized().describe(), u"A loose grip, too far"_s);
        QCOMPARE(Words::say("the lid").asSentence().describe(), u"The lid."_s);
        QCOMPARE(Words::say("m is off.").asSentence().describe(), u"m is off."_s);
        QCOMPARE(Finding::joined({u"a"_s, u"b"_s}, u"; "_s).describe(), u"a; b"_s);
        QVERIFY(Finding().asSentence().isEmpty() && Finding().capitalized().isEmpty());
    }
    void itIsStoredAsAValue()
    {
        const Finding finding = Finding::joined(
            {heavy().asSentence(), Words::say("k of %1").arg(u"A %1"_s).capitalized()}, u" "_s);
        const QJsonValue stored = finding.toJson();
        const std::optional<Finding> read = Finding::fromJson(
            QJsonDocument::fromJson(QJsonDocument(QJsonArray{stored}).toJson()).array().first());
        QVERIFY(read && *read == finding);
        const GermanReader reader;
        QCOMPARE(read->describe(), u"1,25 kg wiegt der Deckel. K of A %1"_s);
    }
    void aSentenceOfAnEarlierVersionIsText()
    {
        const std::optional<Finding> read = Finding::fromJson(u"Die Masse ist %1 zu groß."_s);
        QVERIFY(read);
        QCOMPARE(read->describe(), u"Die Masse ist %1 zu groß."_s);
        QCOMPARE(read->toJson(), QJsonValue(u"Die Masse ist %1 zu groß."_s));
    }
    void whatIsNoneIsRefused_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::newRow("number") << QByteArray("3");
        QTest::newRow("empty object") << QByteArray("{}");
        QTest::newRow("no sentence") << QByteArray(R"({"say": 3, "with": []})");
        QTest::newRow("a part that is none") << QByteArray(R"({"say": "%1", "with": [null]})");
        QTest::newRow("format") << QByteArray(R"({"number": 1, "format": "s", "digits": 3})");
        QTest::newRow("digits") << QByteArray(R"({"number": 1, "format": "f", "digits": 2000000000})");
        QByteArray deep("\"x\"");
        for (int level = 0; level < 100; ++level)
            deep = R"({"sentence": )" + deep + "}";
        QTest::newRow("deep") << deep;
        QTest::newRow("many") << QByteArray(R"({"between": "", "parts": [)" +
                                            QByteArray(R"("x",)").repeated(5000) + R"("x"]})");
        QTest::newRow("long") << QByteArray('"' + QByteArray(200'000, 'x') + '"');
    }
    void whatIsNoneIsRefused()
    {
        QFETCH(QByteArray, json);
        QVERIFY(!Finding::fromJson(parsed(json.constData())));
    }
    void anEnglishSentenceInAFileIsHeard()
    {
        const Finding sentence = Words::say("%1 is %2 heavy");
        const Finding heard =
            Words::heard({Words::say("nothing of %1"), sentence}, u"a (lid) is 3 kg heavy"_s);
        QCOMPARE(heard, sentence.arg(u"a (lid)"_s, u"3 kg"_s));
        const Finding other = Words::heard({sentence}, u"something else"_s);
        QCOMPARE(other, Finding(u"something else"_s));
    }
};

GRIPSCOPE_TEST(FindingTest)
#include "finding_test.moc"
