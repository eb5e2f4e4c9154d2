// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/people/people_register.h"
#include "tests/core/library/full_library.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/people_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

constexpr auto ignoreValue = [](const auto&) {};

using Change = std::function<Expected<void>(Library&)>;

QString typeA(Library& library)
{
    return valueOf(library.findType(u"A"_s))->id;
}

} // namespace

/// What asks for a supervisor is refused next to the data, and done with one.
class PermissionTest : public QObject {
    Q_OBJECT
private slots:
    void everyChangeAsksForASupervisorOncePeopleAreThere_data()
    {
        QTest::addColumn<Change>("change");
        QTest::addColumn<QString>("action");
        const ChangeNote note{u"x"_s, u"why"_s};
        QTest::newRow("approve") << Change([](Library& l) { return l.approveType(typeA(l), {}); })
                                 << u"type.approve"_s;
        QTest::newRow("recipe") << Change([](Library& l) {
            Recipe recipe;
            recipe.maxForce_N = 50;
            return l.reviseType(typeA(l), recipe).map(ignoreValue);
        }) << u"type.recipe"_s;
        QTest::newRow("rename") << Change([=](Library& l) {
            return l.renameType(typeA(l), u"Cola"_s, note).map(ignoreValue);
        }) << u"type.rename"_s;
        QTest::newRow("merge") << Change([=](Library& l) {
            return l.mergeTypes(typeA(l), valueOf(l.findType(u"B"_s))->id, note).map(ignoreValue);
        }) << u"type.merge"_s;
        QTest::newRow("split") << Change([=](Library& l) {
            const auto grasps = valueOf(l.grasps(typeA(l)));
            return l.splitType(typeA(l), {grasps[0].id}, u"Light"_s, note).map(ignoreValue);
        }) << u"type.split"_s;
        QTest::newRow("retire") << Change([=](Library& l) { return l.retireType(typeA(l), note); })
                                << u"type.retire"_s;
        QTest::newRow("restore") << Change([=](Library& l) {
            return l.restoreVersion(0, note).map(ignoreValue);
        }) << u"type.restore"_s;
        QTest::newRow("drop") << Change([](Library& l) {
            return l.dropGrasp(valueOf(l.grasps(typeA(l)))[0].id, u"slipped"_s, {});
        }) << u"type.drop"_s;
        QTest::newRow("calibration") << Change([](Library& l) { return l.addCalibration(aCalibration()); })
                                     << u"calibration.accepted"_s;
        QTest::newRow("chain") << Change([](Library& l) {
            return l.addMeasuringChain({u"0001"_s, 1e-4, {}, {}, u"measured"_s});
        }) << u"chain.measured"_s;
        QTest::newRow("rates") << Change([](Library& l) {
            return l.auditTrail().record(Permission::ChangeRates,
                                         QString::fromUtf16(audit_action::ratesChanged), {},
                                         {{u"false_reject"_s, 0.02}});
        }) << u"rates.changed"_s;
        QTest::newRow("who may arm") << Change([](Library& l) {
            return l.people().setArming(ArmingPolicy::Supervisors);
        }) << u"policy.arming"_s;
        QTest::newRow("who may approve")
            << Change([](Library& l) { return l.people().setApproval(ApprovalPolicy::SecondPerson); })
            << u"policy.approval"_s;
        QTest::newRow("limits of charts")
            << Change([](Library& l) { return l.fixProcessLimits(u"A"_s, u"{}"_s, u"Sam"_s); })
            << u"charts.fixed"_s;
        QTest::newRow("no limits of charts")
            << Change([](Library& l) { return l.fixProcessLimits(u"A"_s, {}, u"Sam"_s); })
            << u"charts.released"_s;
        QTest::newRow("person") << Change([](Library& l) {
            return l.people().add(u"Ada"_s, Role::Operator, Secret(pin)).map(ignoreValue);
        }) << u"person.added"_s;
    }
    void everyChangeAsksForASupervisorOncePeopleAreThere()
    {
        QFETCH(Change, change);
        QFETCH(QString, action);
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->loadExampleTypes());
        const People people(*library);
        const auto version = valueOf(library->version());
        for (const Acting& acting : {Acting{u"Sam"_s, {}, {}}, people.operatorOf(*library)}) {
            library->actAs(acting);
            const auto before = valueOf(library->auditTrail().count({}));
            const auto refused = change(*library);
            QVERIFY(!refused);
            QVERIFY2(refused.error().describe().contains(u"needs a supervisor"_s),
                     qPrintable(refused.error().describe()));
            QCOMPARE(valueOf(library->version()), version); // nothing was changed
            QCOMPARE(valueOf(library->auditTrail().count({})), before);
        }
        library->actAs(people.supervisor(*library));
        valueOf(change(*library));
        const AuditEntry entry = valueOf(library->auditTrail().entries({{}, {}, 1, 0})).front();
        QCOMPARE(entry.action, action);
        QCOMPARE(entry.person, u"Sam"_s);
        QCOMPARE(entry.role, u"supervisor"_s);
        QVERIFY(valueOf(library->auditTrail().verify()).whole());
    }
    void enrollingAndInspectingAreEverybodys()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        const auto type = valueOf(library->addType(u"Can"_s, {}, u"N"_s, u"m"_s, u"Olli"_s));
        valueOf(library->addGrasp(aGrasp(type.id)));
        valueOf(library->addInspection(anInspection()));
    }
    void armingIsForWhoTheLibrarysPolicySays()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const auto arm = [&] {
            return library->auditTrail().record(Permission::Arm,
                                                QString::fromUtf16(audit_action::gripperArmed), u"VG-1"_s,
                                                {{u"from"_s, u"window"_s}});
        };
        valueOf(arm()); // nobody is in the library
        QCOMPARE(valueOf(library->auditTrail().entries({{}, {}, 1, 0})).front().subject, u"VG-1"_s);
        const People people(*library);
        library->actAs({u"Olli"_s, {}, {}}); // typed by anybody
        const auto nobody = arm();
        QVERIFY(!nobody && nobody.error().describe().contains(u"signed in"_s));
        const Acting olli = people.operatorOf(*library);
        library->actAs(olli);
        valueOf(arm());
        const AuditEntry entry = valueOf(library->auditTrail().entries({{}, {}, 1, 0})).front();
        QCOMPARE(entry.action, u"gripper.armed"_s);
        QCOMPARE(entry.person, u"Olli"_s);
        QCOMPARE(entry.role, u"operator"_s);

        library->actAs(people.supervisor(*library));
        valueOf(library->people().setArming(ArmingPolicy::Supervisors));
        QVERIFY(valueOf(library->people().arming()) == ArmingPolicy::Supervisors);
        valueOf(arm());
        library->actAs(olli);
        const auto refused = arm();
        QVERIFY(!refused && refused.error().describe().contains(u"needs a supervisor"_s));
        QVERIFY(!library->people().authorise(people.operatorId, Secret(password), Permission::Arm));
        Acting consented = olli;
        consented.granted =
            valueOf(library->people().authorise(people.supervisorId, Secret(pin), Permission::Arm));
        library->actAs(consented);
        valueOf(arm());

        library->actAs(people.supervisor(*library));
        const qint64 before = valueOf(library->auditTrail().count({}));
        valueOf(library->people().setArming(ArmingPolicy::Supervisors)); // it is so already
        QCOMPARE(valueOf(library->auditTrail().count({})), before);
        valueOf(library->people().setArming(ArmingPolicy::SignedIn)); // the newest is in force
        library->actAs(olli);
        valueOf(arm());
    }
    void aSecondPersonApprovesWhereThePolicySaysSo()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        const Acting sam = people.supervisor(*library);
        library->actAs(sam);
        const QString idOfAda =
            valueOf(library->people().add(u"Ada"_s, Role::Supervisor, Secret(u"1357924680"_s))).id;
        const Acting ada{{}, valueOf(library->people().signIn(idOfAda, Secret(u"1357924680"_s))), {}};
        QVERIFY(valueOf(library->people().approval()) == ApprovalPolicy::OnePerson);
        const auto enroll = [&](const QString& type, const QString& operatorName) {
            const QString id = valueOf(library->addType(type, {}, u"N"_s, u"m"_s, operatorName)).id;
            NewGrasp grasp = aGrasp(id);
            grasp.operatorName = operatorName;
            valueOf(library->addGrasp(grasp));
            return id;
        };
        valueOf(library->approveType(enroll(u"One"_s, u"Sam"_s), u"Sam"_s)); // no policy yet
        valueOf(library->people().setApproval(ApprovalPolicy::SecondPerson));
        const QString own = enroll(u"Two"_s, u" sam "_s);
        const QString hidden = enroll(u"Three"_s, u"somebody"_s); // Sam had signed in all the same
        library->actAs(people.operatorOf(*library));
        const QString ollis = enroll(u"Four"_s, u"Olli"_s);
        library->actAs(sam);
        for (const QString& id : {own, hidden}) {
            const auto refused = library->approveType(id, u"Sam"_s);
            QVERIFY(!refused);
            QVERIFY2(refused.error().describe().contains(u"second person"_s),
                     qPrintable(refused.error().describe()));
            QVERIFY(valueOf(library->approvedSqueezes()).size() == 1);
        }
        valueOf(library->approveType(ollis, u"Sam"_s));
        library->actAs(ada);
        valueOf(library->approveType(own, u"Ada"_s));
        valueOf(library->approveType(hidden, u"Ada"_s));
        QCOMPARE(valueOf(library->approvedSqueezes()).size(), std::size_t(4));
        QCOMPARE(valueOf(library->auditTrail().entries({{}, {}, 1, 0})).front().person, u"Ada"_s);
        // A version that is put back approves as well: what Sam enrolled is for Ada there, too.
        const qint64 approved = valueOf(library->version());
        valueOf(library->retireType(own, {{}, u"a test"_s}));
        library->actAs(sam);
        const auto back = library->restoreVersion(approved, {{}, u"it was right"_s});
        QVERIFY(!back && back.error().describe().contains(u"second person"_s));
        QCOMPARE(valueOf(library->approvedSqueezes()).size(), std::size_t(3));
        library->actAs(ada);
        valueOf(library->restoreVersion(approved, {{}, u"it was right"_s}));
        QCOMPARE(valueOf(library->approvedSqueezes()).size(), std::size_t(4));
    }
    void policiesRolesAndRecipesAreToldWithTheirReason()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        library->actAs(people.supervisor(*library));
        const auto reason = [&](const QString& action) {
            const AuditEntry entry = valueOf(library->auditTrail().entries({{}, {}, 1, 0})).front();
            return entry.action == action ? entry.reason : u"another entry"_s;
        };
        valueOf(library->people().setArming(ArmingPolicy::Supervisors, u"an accident"_s));
        QCOMPARE(reason(u"policy.arming"_s), u"an accident"_s);
        valueOf(library->people().setApproval(ApprovalPolicy::SecondPerson, u"the customer"_s));
        QCOMPARE(reason(u"policy.approval"_s), u"the customer"_s);
        const QString olli = valueOf(library->people().named(u"Olli"_s)).id;
        valueOf(library->people().setRole(olli, Role::Supervisor, u"the night shift"_s));
        QCOMPARE(reason(u"person.role"_s), u"the night shift"_s);
        const QString type = valueOf(library->addType(u"A"_s, {}, u"N"_s, u"m"_s, {})).id;
        Recipe firmer;
        firmer.maxForce_N = 50;
        valueOf(library->reviseType(type, firmer, {u"Sam"_s, u"a firmer part"_s}));
        QCOMPARE(reason(u"type.recipe"_s), u"a firmer part"_s);
    }
    void examplesThatAreThereNeedNobodyAndNewOnesASupervisor()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        QVERIFY(!library->loadExampleTypes());
        library->actAs(people.supervisor(*library));
        valueOf(library->loadExampleTypes());
        library->actAs({});
        valueOf(library->loadExampleTypes());
    }
    void aConsentIsToldWithBothNames()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        valueOf(library->loadExampleTypes());
        const People people(*library);
        Acting acting = people.operatorOf(*library);
        acting.granted =
            valueOf(library->people().authorise(people.supervisorId, Secret(pin), Permission::ChangeTypes));
        library->actAs(acting);
        valueOf(library->retireType(typeA(*library), {u"Olli"_s, u"out of production"_s}));
        const AuditEntry entry = valueOf(library->auditTrail().entries({{}, {}, 1, 0})).front();
        QCOMPARE(entry.person, u"Sam"_s);
        QCOMPARE(entry.reason, u"out of production"_s);
        QVERIFY(entry.details.contains(u"\"operator\":\"Olli\""_s));
        QVERIFY(!library->approveType(typeA(*library), {})); // that was not consented to
    }
};

GRIPSCOPE_TEST(PermissionTest)
#include "permission_test.moc"
