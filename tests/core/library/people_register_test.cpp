// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/people/people_register.h"
#include "core/people/person.h"
#include "tests/core/library/library_fixture.h"
#include "tests/core/library/people_fixture.h"
#include "tests/core/library/raw_database.h"
#include "tests/support/test_registry.h"

#include <QTest>

using namespace gripscope;
using namespace gripscope::test;

namespace {

QStringList actions(Library& library)
{
    QStringList found;
    for (const AuditEntry& entry : valueOf(library.auditTrail().entries({})))
        found.prepend(entry.action + u' ' + entry.subject);
    return found;
}

QString refusal(const Expected<void>& done)
{
    return done ? QString() : done.error().describe();
}

} // namespace

/// Who may sign in, and what roles in force mean.
class PeopleRegisterTest : public QObject {
    Q_OBJECT
private slots:
    void theFirstPersonMustBeASupervisor()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        QVERIFY(!valueOf(library->people().inForce()));
        const auto refused = library->people().add(u"Olli"_s, Role::Operator, Secret(pin));
        QVERIFY(refused.error().describe().contains(u"must be a supervisor"_s));
        QVERIFY(!valueOf(library->people().inForce()));
        valueOf(library->people().add(u"  Sam   Vimes "_s, Role::Supervisor, Secret(pin)));
        QVERIFY(valueOf(library->people().inForce()));
        QCOMPARE(valueOf(library->people().all()).front().name, u"Sam Vimes"_s);
    }
    void noSecretIsInTheFile()
    {
        const LibraryFolder folder;
        {
            const auto library = folder.open();
            const People people(*library);
            valueOf(library->people().signIn(people.operatorId, Secret(password)));
            static_cast<void>(library->people().signIn(people.operatorId, Secret(u"a wrong password"_s)));
        }
        for (const QString& name : QDir(folder.folder.path()).entryList(QDir::Files)) {
            const QByteArray bytes = bytesOf(folder.folder.filePath(name));
            QVERIFY(!bytes.contains(password.toUtf8()) && !bytes.contains(pin.toUtf8()));
            QVERIFY(!bytes.contains("a wrong password"));
        }
        RawDatabase raw(folder.file());
        for (const QString& hash : raw.column(u"SELECT secret_hash FROM people"_s))
            QVERIFY(hash.startsWith(u"$argon2id$"_s));
    }
    void namesAreOnePersonsOnly()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        library->actAs(people.supervisor(*library));
        QVERIFY(library->people()
                    .add(u"SAM"_s, Role::Operator, Secret(pin))
                    .error()
                    .describe()
                    .contains(u"already somebody"_s));
        QVERIFY(!library->people().add(u"  "_s, Role::Operator, Secret(pin)));
        QVERIFY(!library->people().add(u"Ada"_s, Role::Operator, Secret(u"12345"_s)));
        valueOf(library->people().setActive(people.operatorId, false));
        valueOf(library->people().add(u"Olli"_s, Role::Operator, Secret(pin))); // another one
        QVERIFY(!library->people().setActive(people.operatorId, true));         // the name is taken now
    }
    void theLastSupervisorStays()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        library->actAs(people.supervisor(*library));
        QVERIFY(
            refusal(library->people().setActive(people.supervisorId, false)).contains(u"last supervisor"_s));
        QVERIFY(refusal(library->people().setRole(people.supervisorId, Role::Operator))
                    .contains(u"last supervisor"_s));
        valueOf(library->people().setRole(people.operatorId, Role::Supervisor));
        valueOf(library->people().setRole(people.supervisorId, Role::Operator));
        // What was a supervisor when it signed in is one no more.
        QVERIFY(refusal(library->people().setRole(people.supervisorId, Role::Supervisor))
                    .contains(u"needs a supervisor"_s));
    }
    void wrongTriesMakeTheNextOnesWaitAlsoAfterAReopen()
    {
        const LibraryFolder folder;
        const People people(*folder.open());
        QString said;
        for (int i = 0; i < SignInTries::free; ++i) {
            const auto library = folder.open(); // each time a new process
            said = library->people().signIn(people.operatorId, Secret(u"wrong one"_s)).error().describe();
        }
        QVERIFY2(said.contains(u"Wait 30 s"_s), qPrintable(said));
        const auto library = folder.open();
        const auto right = library->people().signIn(people.operatorId, Secret(password));
        QVERIFY(!right && right.error().describe().contains(u"too many wrong tries for Olli"_s));
        valueOf(library->people().signIn(people.supervisorId, Secret(pin))); // others are not concerned
        RawDatabase raw(folder.file());
        raw.run(
            u"UPDATE sign_in_tries SET created_utc = '2020-01-01T00:00:00.000Z' WHERE person_id = '%1'"_s.arg(
                people.operatorId));
        valueOf(library->people().signIn(people.operatorId, Secret(password)));
        // The right one ends the count.
        said = library->people().signIn(people.operatorId, Secret(u"wrong one"_s)).error().describe();
        QVERIFY2(said.contains(u"Tries left before there is a wait: 4"_s), qPrintable(said));
    }
    void aTryThatWasNotFinishedCounts()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        RawDatabase raw(folder.file());
        for (int i = 0; i < SignInTries::free; ++i) // as processes leave it that end while they hash
            raw.run(
                u"INSERT INTO sign_in_tries (id, station, created_utc, person_id, secret_version, outcome, serial) VALUES ('%1', '', '%2', '%3', 1, 'tried', 100 + %1)"_s
                    .arg(i)
                    .arg(QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs), people.operatorId));
        QVERIFY(!library->people().signIn(people.operatorId, Secret(password)));
    }
    void aClockThatIsSetBackMakesNoTryFree()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        valueOf(library->people().signIn(people.operatorId, Secret(password)));
        // As though that had been while the clock was ahead.
        RawDatabase(folder.file())
            .run(u"UPDATE sign_in_tries SET created_utc = '2099-01-01T00:00:00.000Z'"_s);
        QString said;
        for (int i = 0; i <= SignInTries::free; ++i)
            said = library->people().signIn(people.operatorId, Secret(u"wrong one"_s)).error().describe();
        QVERIFY2(said.contains(u"too many wrong tries"_s), qPrintable(said));
    }
    void aNewSecretEndsTheWait()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        for (int i = 0; i < SignInTries::free; ++i)
            static_cast<void>(library->people().signIn(people.operatorId, Secret(u"wrong one"_s)));
        QVERIFY(!library->people().setSecret(people.operatorId, Secret(u"654321"_s))); // nobody has signed in
        library->actAs(people.supervisor(*library));
        valueOf(library->people().setSecret(people.operatorId, Secret(u"654321"_s)));
        QVERIFY(!library->people().signIn(people.operatorId, Secret(password)));
        valueOf(library->people().signIn(people.operatorId, Secret(u"654321"_s)));
    }
    void onesOwnSecretNeedsNoSupervisor()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        library->actAs({{}, valueOf(library->people().signIn(people.operatorId, Secret(password))), {}});
        valueOf(library->people().setSecret(people.operatorId, Secret(u"another password"_s)));
        QVERIFY(!library->people().setSecret(people.supervisorId, Secret(u"another password"_s)));
    }
    void whoIsDeactivatedCannotSignInAndMayNothingFromThenOn()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        library->actAs(people.supervisor(*library));
        const auto second = valueOf(library->people().add(u"Ada"_s, Role::Supervisor, Secret(pin)));
        const Acting ada{{}, valueOf(library->people().signIn(second.id, Secret(pin))), {}};
        valueOf(library->people().setActive(second.id, false));
        QVERIFY(!library->people().signIn(second.id, Secret(pin)));
        library->actAs(ada); // another station, where she is still signed in
        QVERIFY(!library->people().require(Permission::ApproveTypes));
        QVERIFY(!library->people().setActive(second.id, true));
    }
    void aConsentIsForOnePermissionAndBySupervisorsOnly()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        QVERIFY(library->people()
                    .authorise(people.operatorId, Secret(password), Permission::ApproveTypes)
                    .error()
                    .describe()
                    .contains(u"A supervisor is needed"_s));
        const Authority olli = valueOf(library->people().signIn(people.operatorId, Secret(password)));
        library->actAs({{}, olli, {}});
        QVERIFY(!library->people().require(Permission::ApproveTypes));
        const Grant grant =
            valueOf(library->people().authorise(people.supervisorId, Secret(pin), Permission::ApproveTypes));
        library->actAs({{}, olli, grant});
        valueOf(library->people().require(Permission::ApproveTypes));
        QVERIFY(!library->people().require(Permission::DropSqueezes));
    }
    void everythingIsInTheAuditTrail()
    {
        const LibraryFolder folder;
        const auto library = folder.open();
        const People people(*library);
        static_cast<void>(library->people().signIn(people.operatorId, Secret(u"wrong one"_s)));
        const Authority olli = valueOf(library->people().signIn(people.operatorId, Secret(password)));
        valueOf(library->people().signedOut(olli, true));
        library->actAs(people.supervisor(*library));
        valueOf(library->people().setRole(people.operatorId, Role::Supervisor));
        valueOf(library->people().setActive(people.operatorId, false));
        QCOMPARE(actions(*library),
                 QStringList({u"person.added Sam"_s, u"authorised manage_people"_s, u"person.added Olli"_s,
                              u"sign_in.failed Olli"_s, u"sign_in Olli"_s, u"sign_out Olli"_s,
                              u"sign_in Sam"_s, u"person.role Olli"_s, u"person.deactivated Olli"_s}));
        const auto entries = valueOf(library->auditTrail().entries({}));
        QCOMPARE(entries.front().person, u"Sam"_s);
        QCOMPARE(entries.front().role, u"supervisor"_s);
        QVERIFY(valueOf(library->auditTrail().verify()).whole());
    }
};

GRIPSCOPE_TEST(PeopleRegisterTest)
#include "people_register_test.moc"
