// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/reference_check.h"
#include "core/library/audit/audit_trail.h"
#include "core/people/audit_entry.h"
#include "tests/core/library/library_fixture.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

AuditEntry newestEntry(Library& library)
{
    return valueOf(library.auditTrail().entries({{}, {}, 1, 0})).at(0);
}

QJsonObject detailsOf(const AuditEntry& entry)
{
    return QJsonDocument::fromJson(entry.details.toUtf8()).object();
}

QJsonObject change(const QJsonValue& from, const QJsonValue& to)
{
    return {{u"from"_s, from}, {u"to"_s, to}};
}

} // namespace

/// What is changed about a gripper is told with why, and what it was before.
class AuditDetailsTest : public QObject {
    Q_OBJECT
private slots:
    void aMeasuredChainIsToldWithWhatItChanges()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        NewMeasuringChain measured{u"0001"_s, 1e-4, {}, u"Ada"_s, u"lag from 5 squeezes"_s};
        measured.chain.frameCompliance = 1e-5;
        valueOf(library->addMeasuringChain(measured));
        QCOMPARE(newestEntry(*library).reason, QString()); // the command line gives none
        measured.chain.frameCompliance = 2e-5;
        measured.chain.baseline = GripperBaseline{{0.01, 2, 300}, {0.001, 0.2, 30}};
        measured.reason = u"new fingers"_s;
        valueOf(library->addMeasuringChain(measured));
        const AuditEntry entry = newestEntry(*library);
        QCOMPARE(entry.action, u"chain.measured"_s);
        QCOMPARE(entry.reason, u"new fingers"_s);
        const QJsonObject details = detailsOf(entry);
        QCOMPARE(details[u"frame_compliance"].toObject(), change(1e-5, 2e-5));
        QCOMPARE(details[u"baseline"].toObject(), change(QJsonValue(), QJsonArray({0.01, 2.0, 300.0})));
        QCOMPARE(details[u"basis"].toString(), u"lag from 5 squeezes"_s);
        QVERIFY(!details.contains(u"force_lag_s"_s) && !details.contains(u"force_noise"_s)); // as before
        QVERIFY2(!detailsInWords(entry).contains(u'{') && !detailsInWords(entry).contains(u'_'),
                 qPrintable(detailsInWords(entry)));
    }
    void anotherGrippersChainIsNotWhatWasBefore()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->addMeasuringChain({u"0001"_s, 1e-4, {}, {}, u"x"_s}));
        valueOf(library->addMeasuringChain({u"0002"_s, 1e-4, {}, {}, u"x"_s}));
        QCOMPARE(detailsOf(newestEntry(*library))[u"force_lag_s"].toObject(), change(0.0, 1e-4));
    }
    void aPruningIsOneEntryHoweverManyFilesWent()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        library->actAs({u"Mai"_s, {}, {}});
        QStringList parts;
        for (int i = 0; i < 500; ++i)
            parts << u"%1.gscap"_s.arg(i);
        valueOf(library->tellPruning(u"/captures"_s, parts, 64'000, 3));
        QCOMPARE(valueOf(library->auditTrail().count({})), 1);
        const AuditEntry entry = newestEntry(*library);
        QCOMPARE(entry.action, u"captures.pruned"_s);
        QCOMPARE(entry.subject, u"/captures"_s);
        QCOMPARE(entry.person, u"Mai"_s);
        QVERIFY(detailsOf(entry)[u"by_itself"].toBool());
        QCOMPARE(detailsOf(entry)[u"files"].toInt(), 500);
        QVERIFY(entry.details.size() < 1000);
    }
    void aReferenceObjectIsToldWithWhatItChanges()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        ReferenceObject spring;
        spring.gripperSerial = u"0001"_s;
        spring.name = u"Spring S-12"_s;
        spring.stated[2] = ReferenceQuantity{10000, 20, 300};
        valueOf(library->addReferenceObject(spring));
        QCOMPARE(detailsOf(newestEntry(*library))[u"reference"].toString(), u"Spring S-12"_s);
        spring.stated[2]->tolerance = 500;
        valueOf(library->addReferenceObject(spring, u"as the manual says"_s));
        const AuditEntry entry = newestEntry(*library);
        QCOMPARE(entry.reason, u"as the manual says"_s);
        QCOMPARE(detailsOf(entry)[u"k"].toObject(), QJsonObject({{u"tolerance"_s, change(300.0, 500.0)}}));
        QVERIFY(detailsInWords(entry).contains(u"300 before, 500 now"_s));
    }
};

GRIPSCOPE_TEST(AuditDetailsTest)
#include "audit_details_test.moc"
