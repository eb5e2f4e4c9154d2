// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/exchange/library_exchange.h"
#include "core/people/audit_entry.h"
#include "tests/core/library/linked_station.h"
#include "tests/core/library/people_fixture.h"
#include "tests/core/library/plant_actions.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <algorithm>

using namespace gripscope;
using namespace gripscope::test;

namespace {

Person personNamed(Library& library, const QString& name)
{
    for (const Person& person : valueOf(library.people().all()))
        if (person.name == name)
            return person;
    return {};
}

bool maySignIn(Library& library, const QString& id, const QString& secret)
{
    return library.people().signIn(id, Secret(secret)).has_value();
}

int activeSupervisors(Library& library)
{
    const auto people = valueOf(library.people().all());
    return int(std::ranges::count_if(
        people, [](const Person& one) { return one.active && one.role == Role::Supervisor; }));
}

/// A server's library with people, and a station that has come in step with it.
struct PlantOfOne {
    LibraryFolder server;
    std::unique_ptr<Library> plant = server.open();
    People people{*plant};
    LinkedStation station;
    PlantOfOne() { station.bringInStep(*plant); }
};

} // namespace

/// Who may do what at the stations of a plant, as the server's own library has it.
class PlantPeopleTest : public QObject {
    Q_OBJECT
private slots:
    void whoIsAtTheServerMaySignInAtEveryStation()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation one, other;
        one.bringInStep(*plant);
        QVERIFY(!valueOf(one.library->people().inForce()));
        const People people(*plant);
        for (LinkedStation* station : {&one, &other}) {
            station->bringInStep(*plant);
            QVERIFY(valueOf(station->library->people().inForce()));
            QCOMPARE(valueOf(station->library->people().all()).size(), std::size_t(2));
            QVERIFY(maySignIn(*station->library, people.supervisorId, pin));
            QVERIFY(!maySignIn(*station->library, people.operatorId, pin));
            QVERIFY(maySignIn(*station->library, people.operatorId, password));
            // Roles are in force: nobody adds anybody without a supervisor.
            station->library->actAs({});
            QVERIFY(!station->library->people().add(u"Eve"_s, Role::Supervisor, Secret(pin)));
            const auto told = valueOf(station->library->auditTrail().entries({}));
            QCOMPARE(std::ranges::count(told, u"person.taken"_s, &AuditEntry::action), 2);
            QVERIFY(isWhole(station->file()));
        }
        QVERIFY(isWhole(server.file()));
    }
    void whatIsChangedAtTheServerIsChangedAtTheStations()
    {
        PlantOfOne one;
        auto& [server, plant, people, station] = one;
        plant->actAs(people.supervisor(*plant));
        valueOf(plant->people().setSecret(people.operatorId, Secret(u"ein anderes Wort"_s)));
        valueOf(plant->people().setRole(people.operatorId, Role::Supervisor, u"trained"_s));
        station.bringInStep(*plant);
        QVERIFY(!maySignIn(*station.library, people.operatorId, password));
        QVERIFY(maySignIn(*station.library, people.operatorId, u"ein anderes Wort"_s));
        QVERIFY(personNamed(*station.library, u"Olli"_s).role == Role::Supervisor);
        valueOf(plant->people().setActive(people.operatorId, false));
        station.bringInStep(*plant);
        QVERIFY(!maySignIn(*station.library, people.operatorId, u"ein anderes Wort"_s));
        QVERIFY(station.step(*plant).inStep); // nothing comes twice
        QVERIFY(isWhole(station.file()));
    }
    void aStationsOwnPeopleStayAndGoNowhere()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation one, other;
        const QString sam =
            valueOf(one.library->people().add(u"Sam"_s, Role::Supervisor, Secret(u"13579246"_s))).id;
        const People people(*plant); // another Sam
        one.bringInStep(*plant);
        other.bringInStep(*plant);
        QVERIFY(maySignIn(*one.library, sam, u"13579246"_s));
        QCOMPARE(personNamed(*one.library, u"Sam"_s).id, sam);
        QCOMPARE(personNamed(*one.library, u"Sam (plant)"_s).id, people.supervisorId);
        QVERIFY(maySignIn(*one.library, people.supervisorId, pin));
        const auto told = valueOf(one.library->auditTrail().entries({}));
        const auto ofSam = std::ranges::find_if(told, [](const AuditEntry& entry) {
            return entry.action == u"person.taken" && entry.subject == u"Sam (plant)";
        });
        QVERIFY(ofSam != told.end());
        QVERIFY2(detailsInWords(*ofSam).contains(u"name at the plant: Sam"),
                 qPrintable(detailsInWords(*ofSam)));
        for (Library* library : {plant.get(), other.library.get()}) {
            QCOMPARE(valueOf(library->people().all()).size(), std::size_t(2));
            QVERIFY(!maySignIn(*library, sam, u"13579246"_s));
        }
        for (const QString& place : {server.file(), one.file(), other.file()})
            QVERIFY(isWhole(place));
    }
    void aStationsOwnChangeHoldsUntilThePlantsNext()
    {
        PlantOfOne one;
        auto& [server, plant, people, station] = one;
        station.library->actAs(people.supervisor(*station.library));
        valueOf(station.library->people().setActive(people.operatorId, false));
        valueOf(station.library->people().setSecret(people.operatorId, Secret(u"nur hier gültig"_s)));
        station.bringInStep(*plant);
        QVERIFY(!personNamed(*station.library, u"Olli"_s).active);
        QVERIFY(personNamed(*plant, u"Olli"_s).active);
        plant->actAs(people.supervisor(*plant));
        valueOf(plant->people().setRole(people.operatorId, Role::Supervisor, u"trained"_s));
        station.bringInStep(*plant);
        QVERIFY(personNamed(*station.library, u"Olli"_s).active);
        QVERIFY(maySignIn(*station.library, people.operatorId, password));
        QVERIFY(isWhole(station.file()));
        QVERIFY(isWhole(server.file()));
    }
    /// Here the one was deactivated, there the other becomes an operator: nobody could add anybody any more.
    void aSupervisorIsAlwaysLeft()
    {
        const LibraryFolder server;
        const auto plant = server.open();
        LinkedStation station;
        const People people(*plant);
        plant->actAs(people.supervisor(*plant));
        valueOf(plant->people().setRole(people.operatorId, Role::Supervisor));
        station.bringInStep(*plant);
        station.library->actAs(
            {{}, valueOf(station.library->people().signIn(people.operatorId, Secret(password))), {}});
        valueOf(station.library->people().setActive(people.supervisorId, false));
        QCOMPARE(activeSupervisors(*station.library), 1);
        valueOf(plant->people().setRole(people.operatorId, Role::Operator));
        station.bringInStep(*plant);
        QCOMPARE(activeSupervisors(*station.library), 1);
        QVERIFY(maySignIn(*station.library, people.supervisorId, pin));
        QVERIFY(personNamed(*station.library, u"Olli"_s).role == Role::Operator);
        QVERIFY(station.step(*plant).inStep);
        QVERIFY(isWhole(station.file()));
    }
    /// Wrong tries with the one secret are none with the next, wherever that was given.
    void aNewSecretHasItsTriesAnew()
    {
        PlantOfOne one;
        auto& [server, plant, people, station] = one;
        station.library->actAs(people.supervisor(*station.library));
        valueOf(station.library->people().setSecret(people.operatorId, Secret(u"nur hier gültig"_s)));
        for (int i = 0; i <= SignInTries::free; ++i)
            QVERIFY(!maySignIn(*station.library, people.operatorId, pin));
        QVERIFY(!maySignIn(*station.library, people.operatorId, u"nur hier gültig"_s)); // has to wait
        plant->actAs(people.supervisor(*plant));
        valueOf(plant->people().setSecret(people.operatorId, Secret(u"ein anderes Wort"_s)));
        station.bringInStep(*plant);
        QVERIFY(maySignIn(*station.library, people.operatorId, u"ein anderes Wort"_s));
    }
};

GRIPSCOPE_TEST(PlantPeopleTest)
#include "plant_people_test.moc"
