// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/words.h"
#include "core/identification/identification.h"
#include "core/recognition/types/paper_appendix.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"
#include "ui/context/language.h"

#include <QJsonArray>

using namespace Qt::StringLiterals;
using namespace gripscope;
using namespace gripscope::test;

namespace {

/// A squeeze that does not tell m from k, with what the numerics have to say to that.
Identification poorSqueeze()
{
    Recording recording;
    recording.sampleTime_s = 0.001;
    for (int i = 0; i < 400; ++i) {
        recording.time_s.push_back(0.001 * i);
        recording.force.push_back(20);
        recording.position.push_back(1e-3 + 1e-6 * (i % 7));
    }
    recording.forceUnit = u"N"_s;
    recording.positionUnit = u"m"_s;
    return identify(recording);
}

QStringList messagesOf(const Identification& identification)
{
    QStringList words;
    for (const ValidityCheck& check : identification.validity.checks)
        words << check.message.describe();
    return words;
}

} // namespace

/// What was found and stored in one language is read in another.
class StoredLanguageTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { QVERIFY(applyLanguage(u"en"_s)); }

    void aVerdictStoredInGermanReadsInEnglishAfterTheLanguageChanges()
    {
        const LibraryFolder folder;
        QVERIFY(applyLanguage(u"de"_s));
        const TypeModels types = fitTypeModels(paperSqueezesInSi());
        NewInspection inspection = anInspection();
        inspection.verdict = judge(types, {0.04, 40, 5000.5});
        inspection.verdict.validity.verdict = ValidityVerdict::Suspect;
        inspection.verdict.validity.reasons = {Words::say("no sample is missing, though").asSentence()};
        const QString german = described(inspection.verdict.allReasons()).join(u' ');
        {
            const std::unique_ptr<Library> library = folder.open();
            QVERIFY(library->addInspection(inspection));
            const auto stored = valueOf(library->inspections({}));
            QCOMPARE(stored.front().reason.describe(), german);
        }
        QVERIFY2(german.contains(u"Messung"_s) && german.contains(u','), qPrintable(german));
        QVERIFY(applyLanguage(u"en"_s));
        const std::unique_ptr<Library> library = folder.open();
        const QString english = valueOf(library->inspections({})).front().reason.describe();
        QVERIFY2(english.contains(u"Suspect measurement: No sample is missing, though."_s),
                 qPrintable(english));
        QCOMPARE(english, described(inspection.verdict.allReasons()).join(u' '));
    }
    void theNumericsSayTheSameInEveryLanguage()
    {
        const Identification english = poorSqueeze();
        const QStringList inEnglish = messagesOf(english);
        QVERIFY(applyLanguage(u"de"_s));
        const Identification german = poorSqueeze();
        QCOMPARE(english.validity.checks.size(), german.validity.checks.size());
        for (std::size_t i = 0; i < english.validity.checks.size(); ++i)
            QVERIFY(english.validity.checks[i].message == german.validity.checks[i].message);
        QVERIFY(messagesOf(english) == messagesOf(german)); // worded now, whenever it was found
        QVERIFY(messagesOf(german) != inEnglish);
        for (const QString& words : messagesOf(german))
            QVERIFY2(!inEnglish.contains(words), qPrintable(words + u": is not translated"_s));
    }
};

GRIPSCOPE_TEST(StoredLanguageTest)
#include "stored_language_test.moc"
