// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/settings/values/settings.h"
#include "ui/settings/values/settings_exchange.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;
using namespace gripscope;

/// The settings as values: declared, limited, stored, taken from station to station.
class SettingsTest : public QObject {
    Q_OBJECT
    QTemporaryDir m_folder;
    int m_files = 0;

    /// An INI file with one stored value.
    QString fileWith(const QString& key, const QVariant& value)
    {
        const QString file = m_folder.filePath(u"%1.ini"_s.arg(++m_files));
        QSettings(file, QSettings::IniFormat).setValue(key, value);
        return file;
    }

private slots:
    void everySettingAcceptsItsDefaultAndHasWords()
    {
        QSet<QString> keys;
        for (const Setting& one : allSettings()) {
            QVERIFY2(one.accepted(one.fallback), one.key);
            QCOMPARE(*one.accepted(one.fallback), one.fallback);
            QVERIFY2(!one.shownName().isEmpty(), one.key);
            QVERIFY2(!one.shown || !one.shownExplanation().isEmpty(), one.key);
            QVERIFY2(one.kind != SettingKind::Choice || one.choices.size() > 1, one.key);
            QVERIFY2(!keys.contains(QString::fromLatin1(one.key)), one.key);
            keys.insert(QString::fromLatin1(one.key));
        }
    }

    void whatIsSetIsThereAtTheNextStart()
    {
        const QString file = m_folder.filePath(u"kept.ini"_s);
        {
            Settings settings(file);
            settings.set(setting::theme, u"dark"_s);
            settings.set(setting::soundOnVerdict, false);
            settings.set(setting::falseReject, 0.002);
        }
        Settings settings(file);
        QCOMPARE(settings.get(setting::theme), u"dark"_s);
        QCOMPARE(settings.get(setting::soundOnVerdict), false);
        QCOMPARE(settings.get(setting::falseReject), 0.002);
        QVERIFY(settings.takeProblems().isEmpty());
    }

    void aDamagedValueFallsBackAndIsToldOnce_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QVariant>("stored");
        QTest::newRow("no such choice") << u"theme"_s << QVariant(u"purple"_s);
        QTest::newRow("not a switch") << u"soundOnVerdict"_s << QVariant(u"perhaps"_s);
        QTest::newRow("not a number") << u"rates/falseReject"_s << QVariant(u"plenty"_s);
        QTest::newRow("above the limit") << u"rates/wrongType"_s << QVariant(u"0.7"_s);
        QTest::newRow("not finite") << u"rates/wrongType"_s << QVariant(u"nan"_s);
        QTest::newRow("below the limit") << u"captures/megabytes"_s << QVariant(u"-5"_s);
        QTest::newRow("no text") << u"operator"_s << QVariant(u"a\nb"_s);
    }
    void aDamagedValueFallsBackAndIsToldOnce()
    {
        QFETCH(QString, key);
        QFETCH(QVariant, stored);
        const QString file = fileWith(key, stored);
        {
            Settings settings(file);
            QCOMPARE(settings.value(key), findSetting(key)->fallback);
            const QStringList told = settings.takeProblems();
            QCOMPARE(told.size(), 1);
            QVERIFY2(told.first().contains(findSetting(key)->shownName()), qPrintable(told.first()));
            QVERIFY(settings.takeProblems().isEmpty());
        }
        QVERIFY(Settings(file).takeProblems().isEmpty());
    }

    void theCommandLineHoldsForItsRunOnly()
    {
        const QString file = fileWith(u"theme"_s, u"dark"_s);
        {
            Settings settings(file);
            QVERIFY(settings.setForThisRun(u"theme"_s, u"contrast"_s));
            QCOMPARE(settings.get(setting::theme), u"contrast"_s);
            QVERIFY(!settings.setForThisRun(u"theme"_s, u"purple"_s));
        }
        QCOMPARE(Settings(file).get(setting::theme), u"dark"_s);
    }

    void changesAreToldAndResetGoesBack()
    {
        Settings settings;
        const QSignalSpy changed(&settings, &Settings::changed);
        settings.set(setting::theme, u"dark"_s);
        settings.set(setting::theme, u"dark"_s);
        QCOMPARE(changed.count(), 1);
        QVERIFY(!settings.setValue(u"theme"_s, u"purple"_s));
        QVERIFY(!settings.setValue(u"noSuchSetting"_s, 1));
        QCOMPARE(changed.count(), 1);
        QVERIFY(!settings.isDefault(u"theme"_s));
        settings.set(setting::operatorName, u"Mai"_s);
        settings.resetAll();
        QVERIFY(settings.isDefault(u"theme"_s));
        QCOMPARE(settings.get(setting::operatorName), u"Mai"_s); // set elsewhere, not in the window
    }

    void whatIsExportedIsImportedOnAnotherStation()
    {
        Settings here, there;
        here.set(setting::theme, u"dark"_s);
        here.set(setting::earlyEnd, false);
        here.set(setting::wrongType, 0.0005);
        here.set(setting::captureFolder, u"/only/here"_s);
        const auto import = readSettings(exportedSettings(here), u"a.json"_s, there);
        QVERIFY(import);
        QVERIFY(import->errors.isEmpty() && import->notes.isEmpty());
        QCOMPARE(import->changes.size(), std::size_t(3));
        applyImport(there, *import);
        QCOMPARE(there.get(setting::theme), u"dark"_s);
        QCOMPARE(there.get(setting::earlyEnd), false);
        QCOMPARE(there.get(setting::wrongType), 0.0005);
        QVERIFY(there.get(setting::captureFolder).isEmpty());
    }

    void oneBadValueAndNothingIsTaken()
    {
        Settings settings;
        const QByteArray document =
            R"({"format": "gripscope-settings", "version": 1, "settings": {"theme": "dark",
                "soundOnVerdict": "maybe", "rates/wrongType": [1], "colour": 3, "captures/folder": "/x"}})";
        const auto import = readSettings(document, u"a.json"_s, settings);
        QVERIFY(import);
        QCOMPARE(import->errors.size(), 2);
        QVERIFY(import->errors.join(u' ').contains("soundOnVerdict"_L1));
        QVERIFY(import->errors.join(u' ').contains("rates/wrongType"_L1));
        QCOMPARE(import->notes.size(), 2);
        QVERIFY(import->notes.join(u' ').contains("colour"_L1));
        applyImport(settings, *import);
        QVERIFY(settings.isDefault(u"theme"_s));
    }

    void aDocumentOfAnotherKindIsRefused_data()
    {
        QTest::addColumn<QByteArray>("document");
        QTest::newRow("no JSON") << QByteArray("theme=dark");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("another kind") << QByteArray(R"({"format": "gripscope-profile", "version": 1})");
        QTest::newRow("a newer version")
            << QByteArray(R"({"format": "gripscope-settings", "version": 2, "settings": {}})");
    }
    void aDocumentOfAnotherKindIsRefused()
    {
        QFETCH(QByteArray, document);
        const auto import = readSettings(document, u"a.json"_s, Settings());
        QVERIFY(!import);
        QCOMPARE(import.error().code, ErrorCode::BadInput);
        QVERIFY(import.error().describe().contains("a.json"_L1));
    }
};

GRIPSCOPE_TEST(SettingsTest)
#include "settings_test.moc"
