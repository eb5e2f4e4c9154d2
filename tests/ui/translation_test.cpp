// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/table_lines.h"
#include "core/base/words.h"
#include "core/calibration/reference_check.h"
#include "devices/protocol/report_words.h"
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/context/language.h"
#include "ui/format/number_format.h"
#include "ui/settings/settings_dialog.h"
#include "ui/settings/values/setting.h"

#include <QDialogButtonBox>
#include <QLibraryInfo>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QTranslator>
#include <QXmlStreamReader>

using namespace Qt::StringLiterals;
using namespace gripscope;
using gripscope::test::WindowFixture;

namespace {

struct Message {
    QString context, source;
    QStringList translations; ///< several forms where it counts
    bool finished = true;
};

QString committedFile(const QString& language)
{
    return QStringLiteral(GRIPSCOPE_SOURCE_DIR "/resources/translations/gripscope_%1.ts").arg(language);
}

std::vector<Message> messagesIn(const QString& name)
{
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("%s cannot be read", qPrintable(name));
    std::vector<Message> messages;
    QString context;
    QXmlStreamReader xml(&file);
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement)
            continue;
        if (xml.name() == "name"_L1) {
            context = xml.readElementText();
        } else if (xml.name() == "message"_L1) {
            messages.push_back({context, {}, {}, true});
        } else if (xml.name() == "source"_L1) {
            messages.back().source = xml.readElementText();
        } else if (xml.name() == "translation"_L1) {
            messages.back().finished = !xml.attributes().hasAttribute(u"type"_s);
            const QString text = xml.readElementText(QXmlStreamReader::IncludeChildElements);
            messages.back().translations << text.trimmed();
        }
    }
    if (xml.hasError() || messages.empty())
        qFatal("%s is no list of translations: %s", qPrintable(name), qPrintable(xml.errorString()));
    return messages;
}

QSet<QString> keysOf(const std::vector<Message>& messages)
{
    QSet<QString> keys;
    for (const Message& one : messages)
        keys.insert(one.context + u" | "_s + one.source);
    return keys;
}

/// "%1", "%n", mnemonics: what has to be in the translation too. %L1 is %1 with the language's decimal sign.
QSet<QString> placeholders(const QString& text)
{
    static const QRegularExpression form(u"%L?(\\d|n)|&(?=\\w)"_s);
    QSet<QString> found;
    for (const QRegularExpressionMatch& match : form.globalMatch(text))
        found.insert(match.captured(0).remove(u'L'));
    return found;
}

/// Asks nothing of anybody, but notes which words of Gripscope it is asked for that are in no list.
class Recorder : public QTranslator {
public:
    explicit Recorder(const QSet<QString>& known) : m_known(known) {}
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char* context, const char* source, const char*, int) const override
    {
        const QString key = QString::fromUtf8(context) + u" | "_s + QString::fromUtf8(source);
        const bool own = *context != 'Q'; // Qt's own classes ask for theirs
        if (own && *source && !m_known.contains(key))
            unknown.insert(key);
        return {};
    }
    mutable QSet<QString> unknown;

private:
    QSet<QString> m_known;
};

} // namespace

/// The German words: all there, all in use, each in its place.
class TranslationTest : public QObject {
    Q_OBJECT
private slots:
    void cleanup() { QVERIFY(applyLanguage(u"en"_s)); }

    void everyWordOfTheSourceIsTranslatedAndNoOtherIs()
    {
        QTemporaryDir folder;
        const QString fresh = folder.filePath(u"gripscope_de.ts"_s);
        QVERIFY(QFile::copy(committedFile(u"de"_s), fresh));
        QVERIFY(QFile::setPermissions(fresh, QFile::ReadOwner | QFile::WriteOwner));
        QProcess update;
        update.setProcessChannelMode(QProcess::MergedChannels);
        update.start(QStringLiteral(GRIPSCOPE_SOURCE_DIR "/packaging/update_translations.sh"), {fresh});
        QVERIFY2(update.waitForFinished(120000) && update.exitCode() == 0, update.readAll().constData());
        const std::vector<Message> messages = messagesIn(fresh);
        for (const Message& one : messages)
            QVERIFY2(one.finished, qPrintable(u"not translated: %1: %2"_s.arg(one.context, one.source)));
        const QSet<QString> committed = keysOf(messagesIn(committedFile(u"de"_s)));
        const QSet<QString> current = keysOf(messages);
        QVERIFY2(committed == current,
                 qPrintable(u"run packaging/update_translations.sh; no longer in the source: "_s +
                            (committed - current).values().join(u"; "_s)));
    }

    void placeholdersAreTheSame()
    {
        for (const Message& one : messagesIn(committedFile(u"de"_s)))
            for (const QString& text : one.translations) {
                QVERIFY2(!text.isEmpty() || one.source.trimmed().isEmpty(), qPrintable(one.source));
                QVERIFY2(placeholders(one.source) == placeholders(text),
                         qPrintable(u"%1 => %2"_s.arg(one.source, text)));
            }
    }

    /// Whether a sentence of core is filled by Finding or by QString::arg(), no place of it stays open.
    void everySentenceOfCoreIsFilledInWholly()
    {
        QVERIFY(applyLanguage(u"de"_s));
        static const QRegularExpression open(u"%L?\\d|%L"_s);
        for (const Message& one : messagesIn(committedFile(u"de"_s))) {
            if (one.context != "Words"_L1)
                continue;
            Finding finding = Words::say(one.source.toUtf8().constData());
            for (int place = 1; place <= 9; ++place)
                finding = finding.arg(place + 0.5);
            const QString text = finding.describe();
            QVERIFY2(!text.contains(open), qPrintable(text));
        }
    }

    /// What Words::say() says is looked for in one context; lupdate puts it into another where it does not
    /// see whose words they are.
    void sentencesOfCoreAreWhereTheyAreLookedFor()
    {
        for (const Message& one : messagesIn(committedFile(u"de"_s)))
            QVERIFY2(!one.context.endsWith("::Words"_L1), qPrintable(one.source));
    }

    void whatTheWindowAsksForIsInTheList()
    {
        Recorder recorder(keysOf(messagesIn(committedFile(u"de"_s))));
        QVERIFY(QCoreApplication::installTranslator(&recorder));
        {
            WindowFixture f;
            for (const Page* page : f.window->pages()) {
                f.window->showPage(page->id());
                QTest::qWait(50);
            }
            f.window->showHelp();
            f.window->showSettings();
            f.bench->connectTo(u"nonsense:"_s);
            QTest::qWait(50);
        }
        QVERIFY(QCoreApplication::removeTranslator(&recorder));
        QVERIFY2(recorder.unknown.isEmpty(), qPrintable(recorder.unknown.values().join(u"; "_s)));
    }

    void wordsAndNumbersFollowTheLanguage()
    {
        QVERIFY(applyLanguage(u"de"_s));
        QCOMPARE(currentLanguage(), u"de"_s);
        QCOMPARE(Words::tr("There is no squeeze to decide on."),
                 u"Über keinen Druckversuch ist zu entscheiden."_s);
        QCOMPARE((Error{ErrorCode::NotFound, {u"X"_s}}).describe(), u"Nicht vorhanden: X."_s);
        QCOMPARE(formatNumber(9984, 52, u"N/m"_s).text(), u"9,98 ± 0,05\u00A0kN/m"_s);
        QCOMPARE(Words::number(0.5), u"0,5"_s);
        QCOMPARE(findSetting(u"theme"_s)->shownValue(u"dark"_s), u"Dunkel"_s);
        QVERIFY(applyLanguage(u"en"_s));
        QCOMPARE(formatNumber(9984, 52, u"N/m"_s).text(), u"9.98 ± 0.05\u00A0kN/m"_s);
        QCOMPARE(Words::tr("There is no squeeze to decide on."), u"There is no squeeze to decide on."_s);
    }

    /// Of words that had stayed English: those of a refusal, of a damaged report, of a table that is misread.
    void whatWentWrongIsSaidInTheLanguage()
    {
        QVERIFY(applyLanguage(u"de"_s));
        QCOMPARE(problemOf(ReferenceObject()).describe(),
                 u"Das Referenzobjekt braucht einen Namen, etwa die Nummer darauf."_s);
        const std::vector<std::uint8_t> cut(3, 1);
        QCOMPARE(protocol::reportInWords(cut).problem, u"der Report hat 3 Bytes, nicht 64"_s);
        const Error misread =
            TablePlace{u"a.csv"_s, 2, 1}.error(u"\"x\""_s, Words::tr("a number above zero")).value();
        QCOMPARE(misread.describe(), u"a.csv:2:1: gefunden: \"x\"; erwartet: eine Zahl größer als null"_s);
    }

    void standardButtonsFollowWhereQtHasTheirWords()
    {
        QVERIFY2(QFile::exists(QLibraryInfo::path(QLibraryInfo::TranslationsPath) + u"/qtbase_de.qm"_s),
                 "the package qt6-translations-l10n is not installed");
        QVERIFY(applyLanguage(u"de"_s));
        const QDialogButtonBox box(QDialogButtonBox::Cancel);
        QCOMPARE(box.button(QDialogButtonBox::Cancel)->text().remove(u'&'), u"Abbrechen"_s);
    }

    void everyLanguageOfTheSettingIsThere()
    {
        for (const SettingChoice& choice : findSetting(QString::fromLatin1(setting::language.key))->choices)
            QVERIFY2(applyLanguage(QString::fromLatin1(choice.value)), choice.value);
        QVERIFY(!applyLanguage(u"tlh"_s));
        QCOMPARE(currentLanguage(), u"de"_s); // the last that was known
    }
};

GRIPSCOPE_TEST(TranslationTest)
#include "translation_test.moc"
