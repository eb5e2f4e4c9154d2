// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "tests/support/test_registry.h"
#include "tests/ui/workbench_fixture.h"
#include "ui/people/authorize.h"
#include "ui/settings/values/setting.h"

#include <QPushButton>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

TextQuestion* whyQuestion(const WindowFixture& f)
{
    return f.window->findChild<TextQuestion*>(u"whyQuestion"_s);
}

AuditEntry newestEntry(const WindowFixture& f)
{
    using Entries = std::vector<AuditEntry>;
    std::optional<Entries> found;
    f.bench->background().ask<Entries>(
        nullptr,
        [](Library& library) {
            return library.auditTrail().entries({{}, {}, 1, 0});
        },
        [&](Expected<Entries> entries) { found = entries.value(); });
    if (!QTest::qWaitFor([&] { return found.has_value(); }, longEnough_ms))
        qFatal("the library did not answer");
    return found->empty() ? AuditEntry() : found->front();
}

SettingChange toOn(const char* key)
{
    return {QString::fromLatin1(key), false, true};
}

} // namespace

/// Whoever changes what verdicts depend on says why, also in a library without people.
class WhyTest : public QObject {
    Q_OBJECT
private slots:
    void theRatesAreChangedWithAReason()
    {
        WindowFixture f(false, QString());
        StoredRates rates = f.bench->rates();
        const double before = rates.rates.falseReject;
        rates.rates.falseReject = 0.02;
        changeRates(*f.bench, f.window.get(), rates);
        QVERIFY(whyQuestion(f));
        QCOMPARE(f.bench->rates().rates.falseReject, before);
        whyQuestion(f)->reject();
        QTRY_VERIFY(!whyQuestion(f));
        QCOMPARE(f.bench->rates().rates.falseReject, before);
        changeRates(*f.bench, f.window.get(), rates);
        f.sayWhy(u"  the customer's drawing "_s);
        QCOMPARE(f.bench->rates().rates.falseReject, 0.02);
        QTRY_COMPARE_WITH_TIMEOUT(newestEntry(f).action, u"rates.changed"_s, longEnough_ms);
        const AuditEntry entry = newestEntry(f);
        QCOMPARE(entry.reason, u"the customer's drawing"_s);
        QVERIFY(entry.details.contains(u"\"to\":0.02"_s));
    }
    void blanksAreNoReason()
    {
        WindowFixture f(false, QString());
        bool done = false;
        askWhy(f.window.get(), u"Change it"_s, [&done](const QString&) { done = true; });
        auto* accept = whyQuestion(f)->findChild<QPushButton*>(u"answerAccept"_s);
        QVERIFY(!accept->isEnabled());
        QTest::keyClicks(whyQuestion(f)->field(), u"   "_s);
        QVERIFY(!accept->isEnabled());
        QTest::keyClick(whyQuestion(f)->field(), Qt::Key_Return);
        QVERIFY(whyQuestion(f)->isVisible() && !done);
        QTest::keyClicks(whyQuestion(f)->field(), u"x"_s);
        QVERIFY(accept->isEnabled());
    }
    void settingsAskWhereVerdictsDependOnThem_data()
    {
        QTest::addColumn<QByteArray>("key");
        QTest::addColumn<bool>("asks");
        QTest::newRow("policy") << QByteArray(setting::refuseOverdue.key) << true;
        QTest::newRow("robust gates") << QByteArray(setting::robust.key) << true;
        QTest::newRow("early end") << QByteArray(setting::earlyEnd.key) << true;
        QTest::newRow("kept sessions") << QByteArray(setting::keepSessions.key) << false;
        QTest::newRow("sound") << QByteArray(setting::soundOnVerdict.key) << false;
    }
    void settingsAskWhereVerdictsDependOnThem()
    {
        QFETCH(QByteArray, key);
        QFETCH(bool, asks);
        WindowFixture f(false, QString());
        bool done = false;
        changeSettings(*f.bench, f.window.get(), {toOn(key.constData())}, [&done] { done = true; });
        QCOMPARE(whyQuestion(f) != nullptr, asks);
        QCOMPARE(done, !asks);
        if (!asks)
            return;
        f.sayWhy(u"audit of May"_s);
        QVERIFY(done);
        QTRY_COMPARE_WITH_TIMEOUT(newestEntry(f).reason, u"audit of May"_s, longEnough_ms);
    }
    /// What binds a station to its plant: each change is on record, with its reason.
    void everySettingOfTheLineBrokerAndPlantIsOnRecord()
    {
        WindowFixture f(false, QString());
        int changed = 0;
        for (const Setting& one : allSettings()) {
            if (one.group != SettingGroup::Line && one.group != SettingGroup::Broker &&
                one.group != SettingGroup::Plant)
                continue;
            QVERIFY2(one.needsSupervisor && one.needsReason && !one.shownName().isEmpty(), one.key);
            const QString key = QString::fromLatin1(one.key), reason = u"line 3, %1"_s.arg(++changed);
            changeSettings(*f.bench, f.window.get(), {{key, one.fallback, u"another"_s}}, [] {});
            f.sayWhy(reason);
            QTRY_COMPARE_WITH_TIMEOUT(newestEntry(f).reason, reason, longEnough_ms);
            const AuditEntry entry = newestEntry(f);
            QCOMPARE(entry.action, u"setting.changed"_s);
            QCOMPARE(entry.subject, key);
            QVERIFY(entry.details.contains(u"another"_s));
        }
        QVERIFY(changed >= 16);
    }
};

GRIPSCOPE_TEST(WhyTest)
#include "why_test.moc"
