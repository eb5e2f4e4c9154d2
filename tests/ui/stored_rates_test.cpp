// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/settings/values/settings.h"
#include "ui/settings/values/stored_rates.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace gripscope;
using namespace Qt::StringLiterals;

class StoredRatesTest : public QObject {
    Q_OBJECT
private slots:
    void whatIsWrittenIsReadAgain()
    {
        const QTemporaryDir folder;
        StoredRates stored;
        stored.rates.falseReject = 0.002;
        stored.rates.wrongType = 1e-4;
        stored.rates.strangerAccept = 0.05;
        stored.rates.confidence = 0.95;
        stored.rates.robust = true;
        stored.earlyEnd = false;
        {
            Settings settings(folder.filePath(u"rates.ini"_s));
            writeRates(settings, stored);
        }
        const Settings settings(folder.filePath(u"rates.ini"_s));
        const StoredRates read = readRates(settings);
        QVERIFY(read.rates == stored.rates);
        QCOMPARE(read.earlyEnd, false);
    }

    void nothingStoredIsTheDefault()
    {
        const QTemporaryDir folder;
        const Settings settings(folder.filePath(u"none.ini"_s));
        QVERIFY(readRates(settings).rates == VerdictOptions{});
        QVERIFY(readRates(settings).earlyEnd);
    }

    void aRateThatIsNoneIsNotTaken()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"bad.ini"_s);
        QSettings(file, QSettings::IniFormat).setValue(u"rates/falseReject"_s, u"plenty"_s);
        const Settings settings(file);
        QVERIFY(readRates(settings).rates == VerdictOptions{});
    }
};

GRIPSCOPE_TEST(StoredRatesTest)
#include "stored_rates_test.moc"
