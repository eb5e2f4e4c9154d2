// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/audit/audit_trail.h"
#include "core/library/library.h"
#include "core/library/people/people_register.h"
#include "tests/end_to_end/program_run.h"
#include "tests/support/test_registry.h"

#include <QDir>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;

namespace {

const QByteArray pin = "2468135790";
const QByteArray ollisSecret = "ein langes Wort";

/// A terminal of the test's own, for a program to ask on.
class Terminal {
public:
    Terminal() : m_own(posix_openpt(O_RDWR | O_NOCTTY))
    {
        if (m_own < 0 || grantpt(m_own) != 0 || unlockpt(m_own) != 0)
            qFatal("no terminal");
        m_name = ptsname(m_own);
        m_far =
            open(m_name.constData(), O_RDWR | O_NOCTTY); // so that it is not closed before the program comes
    }
    ~Terminal()
    {
        close(m_far);
        close(m_own);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    [[nodiscard]] const char* name() const { return m_name.constData(); }
    /// What a person types when asked; what was asked.
    [[nodiscard]] QByteArray answer(const QByteArray& line) const
    {
        pollfd waiting{m_own, POLLIN, 0};
        poll(&waiting, 1, 60'000);
        QByteArray asked(1024, '\0');
        asked.resize(qMax<qsizetype>(0, read(m_own, asked.data(), 1024)));
        const QByteArray typed = line + '\n';
        if (write(m_own, typed.constData(), std::size_t(typed.size())) != typed.size())
            qFatal("the terminal is closed");
        return asked;
    }
    /// What was shown since.
    [[nodiscard]] QByteArray rest() const
    {
        fcntl(m_own, F_SETFL, O_NONBLOCK);
        QByteArray shown(4096, '\0');
        shown.resize(qMax<qsizetype>(0, read(m_own, shown.data(), 4096)));
        return shown;
    }

private:
    int m_own;
    int m_far = -1;
    QByteArray m_name;
};

} // namespace

/// The command line where roles are in force, and `gripscope-cli audit`.
class PeopleCommandTest : public QObject {
    Q_OBJECT
    Workplace m_work;

    [[nodiscard]] QString file() const { return m_work.path(u"lib.db"_s); }

    /// As `person` (none: not named), on a terminal where `secret` is typed (none: without a terminal).
    ProgramRun run(const QStringList& arguments, const QString& person = {},
                   const std::optional<QByteArray>& secret = {}, QByteArray* shown = nullptr) const
    {
        QProcess process;
        m_work.prepare(process, arguments + QStringList{u"--library"_s, u"lib.db"_s, u"--json"_s});
        QProcessEnvironment environment = process.processEnvironment();
        environment.insert(u"GRIPSCOPE_PERSON"_s, person);
        process.setProcessEnvironment(environment);
        const Terminal terminal;
        const char* name = secret ? terminal.name() : nullptr;
        process.setChildProcessModifier([name] {
            setsid(); // off the terminal that the test runs on
            if (name)
                open(name, O_RDWR); // the first one a session opens becomes its own
        });
        process.start();
        QByteArray onTerminal;
        if (secret)
            onTerminal = terminal.answer(*secret);
        const bool ended = process.waitForFinished(300'000) && process.exitStatus() == QProcess::NormalExit;
        if (shown)
            *shown = onTerminal + (secret ? terminal.rest() : QByteArray());
        return {ended ? process.exitCode() : -1, process.readAllStandardOutput(),
                process.readAllStandardError()};
    }

    /// The audit trail, newest first.
    [[nodiscard]] QJsonArray entries() const
    {
        return run({u"audit"_s, u"--limit"_s, u"100"_s}).json()[u"entries"_s].toArray();
    }
    static void actAsSam(Library& library)
    {
        const auto sam = library.people().named(u"Sam"_s);
        const auto authority = library.people().signIn(sam->id, Secret(QString::fromLatin1(pin)));
        QVERIFY(authority);
        library.actAs({{}, *authority, {}});
    }
    void addOlli() const
    {
        const auto library = Library::open(file());
        QVERIFY(library);
        actAsSam(**library);
        QVERIFY(
            (*library)->people().add(u"Olli"_s, Role::Operator, Secret(QString::fromLatin1(ollisSecret))));
    }

private slots:
    void init()
    {
        QFile::remove(file());
        QDir(m_work.path(u"gripscope"_s)).removeRecursively(); // what is known of the one before
        auto library = Library::open(file());
        QVERIFY(library && (*library)->loadExampleTypes());
        QVERIFY((*library)->people().add(u"Sam"_s, Role::Supervisor, Secret(QString::fromLatin1(pin))));
    }
    void changesNeedASupervisorAndReadingDoesNot()
    {
        const QStringList retire{u"types"_s,    u"retire"_s, u"--type"_s,     u"A"_s,
                                 u"--reason"_s, u"asked"_s,  u"--operator"_s, u"Mai"_s};
        const ProgramRun unnamed = run(retire);
        QCOMPARE(unnamed.exit, 2);
        QVERIFY(unnamed.json()[u"error"_s][u"message"_s].toString().contains(u"GRIPSCOPE_PERSON"_s));
        QCOMPARE(run(retire, u"Sam"_s).exit, 2); // no terminal to ask on
        QCOMPARE(run(retire, u"Nobody"_s).exit, 3);
        QByteArray shown;
        QCOMPARE(run(retire, u"Sam"_s, "wrong one", &shown).exit, 2);
        QVERIFY2(shown.contains("PIN or password of Sam"), shown.constData());
        QVERIFY2(!shown.contains("wrong one"), shown.constData()); // it is not shown
        QCOMPARE(run({u"types"_s, u"list"_s}).json()[u"types"_s].toArray().size(), 4);
        const ProgramRun done = run(retire, u"Sam"_s, pin);
        QVERIFY2(done.exit == 0, done.err.constData());
        const QJsonArray entries = run({u"audit"_s}).json()[u"entries"_s].toArray();
        QCOMPARE(entries[0][u"action"_s].toString(), u"type.retire"_s);
        QCOMPARE(entries[0][u"person"_s].toString(), u"Sam"_s);
        QCOMPARE(entries[0][u"role"_s].toString(), u"supervisor"_s);
        QCOMPARE(entries[0][u"reason"_s].toString(), u"asked"_s);
        QCOMPARE(entries[0][u"details"_s][u"operator"_s].toString(), u"Mai"_s);
        QCOMPARE(entries[1][u"action"_s].toString(), u"authorised"_s);
        QCOMPARE(entries[2][u"action"_s].toString(), u"sign_in.failed"_s);
    }
    void enrollingFilesNeedsASupervisorAndClassifyingDoesNot()
    {
        QCOMPARE(m_work
                     .cli({u"simulate"_s, u"--object"_s, u"0.04,43,9990"_s, u"--sample-time"_s, u"0.0005"_s,
                           u"--bit"_s, u"0.005"_s, u"--samples"_s, u"2000"_s, u"--noise-sd"_s, u"1e-5"_s,
                           u"--excitation"_s, u"prbs"_s, u"-o"_s, u"a.csv"_s})
                     .exit,
                 0);
        const QStringList units{u"--force-unit"_s, u"N"_s, u"--position-unit"_s, u"m"_s};
        const QStringList enroll = QStringList{u"enroll"_s, u"--type"_s, u"A"_s, u"a.csv"_s} + units;
        QCOMPARE(run(enroll).exit, 2);
        const auto classified = run(QStringList{u"classify"_s, u"a.csv"_s} + units);
        QVERIFY(classified.exit == 0 || classified.exit == 6);
        const ProgramRun done = run(enroll + QStringList{u"--operator"_s, u"Mai"_s}, u"Sam"_s, pin);
        QVERIFY2(done.exit == 0, done.out + done.err);
        QCOMPARE(done.json()[u"squeezes"_s].toInt(), 11);
        // With it the approval of A is void, and no part is held against it until a supervisor approves it.
        QCOMPARE(done.json()[u"approved"_s], QJsonValue(false));
        const auto judged = run(QStringList{u"classify"_s, u"a.csv"_s} + units);
        QVERIFY2(judged.err.contains("Not approved, and so not recognised: A."), judged.err.constData());
        const QJsonObject posterior = judged.json()[u"results"_s][0][u"posterior"_s].toObject();
        QVERIFY(!posterior.contains(u"A"_s) && posterior.contains(u"B"_s));
        const QStringList approve{u"types"_s, u"approve"_s, u"--type"_s, u"A"_s};
        QCOMPARE(run(approve).exit, 2);
        QCOMPARE(run(approve, u"Sam"_s, pin).exit, 0);
        const auto again = run(QStringList{u"classify"_s, u"a.csv"_s} + units);
        QVERIFY(again.json()[u"results"_s][0][u"posterior"_s].toObject().contains(u"A"_s));
    }
    void aSecondPersonIsAskedForByThePolicyAlone()
    {
        {
            const auto library = Library::open(file());
            actAsSam(**library);
            QVERIFY((*library)->people().setApproval(ApprovalPolicy::SecondPerson));
            const auto a = (*library)->findType(u"A"_s);
            const auto grasps = (*library)->grasps((*a)->id);
            NewGrasp grasp; // one more, by Sam
            grasp.typeId = (*a)->id;
            grasp.forceUnit = u"N"_s;
            grasp.positionUnit = u"m"_s;
            Estimate estimate;
            estimate.status = EstimateStatus::Converged;
            estimate.parameters = grasps->front().parameters;
            grasp.estimates = {estimate};
            QVERIFY((*library)->addGrasp(grasp));
        }
        const ProgramRun refused = run({u"types"_s, u"approve"_s, u"--type"_s, u"A"_s}, u"Sam"_s, pin);
        QCOMPARE(refused.exit, 2);
        QVERIFY2(refused.json()[u"error"_s][u"message"_s].toString().contains(u"second person"_s),
                 refused.out);
    }
    void installingAProfileNeedsASupervisorAndIsTold()
    {
        const QStringList install{
            u"profile"_s, u"install"_s,
            QStringLiteral(GRIPSCOPE_SOURCE_DIR "/resources/profiles/example_bare.json"), u"--reason"_s,
            u"the new gripper"_s};
        QCOMPARE(run(install).exit, 2);
        const ProgramRun done = run(install, u"Sam"_s, pin);
        QVERIFY2(done.exit == 0, done.out + done.err);
        const QJsonObject told = entries()[0].toObject();
        QCOMPARE(told[u"action"_s].toString(), u"profile.installed"_s);
        QCOMPARE(told[u"person"_s].toString(), u"Sam"_s);
        QCOMPARE(told[u"reason"_s].toString(), u"the new gripper"_s);
    }
    void armingNeedsOneOfThePeopleAndIsKept()
    {
        const QStringList record{u"record"_s,    u"--device"_s,   u"virtual:?object=A&seed=9&speed=0"_s,
                                 u"--seconds"_s, u"0.2"_s,        u"--arm"_s,
                                 u"-o"_s,        u"squeeze.csv"_s};
        addOlli();
        const qint64 before = entries().size();
        const ProgramRun unnamed = run(record);
        QCOMPARE(unnamed.exit, 2);
        QVERIFY(unnamed.json()[u"error"_s][u"message"_s].toString().contains(u"GRIPSCOPE_PERSON"_s));
        QCOMPARE(run(record, u"Olli"_s).exit, 2);      // no terminal to ask on
        QCOMPARE(run(record, u"Olli"_s, pin).exit, 2); // that is Sam's
        QCOMPARE(entries().size(), before + 1);        // the wrong try
        QVERIFY(!QFile::exists(m_work.path(u"squeeze.csv"_s)));

        const ProgramRun done = run(record, u"Olli"_s, ollisSecret);
        QVERIFY2(done.exit == 0, done.out + done.err);
        QVERIFY(QFile::exists(m_work.path(u"squeeze.csv"_s)));
        const QJsonObject armed = entries()[0].toObject();
        QCOMPARE(armed[u"action"_s].toString(), u"gripper.armed"_s);
        QCOMPARE(armed[u"person"_s].toString(), u"Olli"_s);
        QCOMPARE(armed[u"role"_s].toString(), u"operator"_s);
        QCOMPARE(armed[u"subject"_s].toString(), u"VG-9"_s);
        QCOMPARE(armed[u"details"_s][u"from"_s].toString(), u"command line"_s);
        QCOMPARE(armed[u"details"_s][u"largest_force_N"_s].toDouble(), 30.0);
        QCOMPARE(armed[u"details"_s][u"force_limit_N"_s].toDouble(), 33.0);
        QFile recording(m_work.path(u"squeeze.csv"_s));
        QVERIFY(recording.open(QIODevice::ReadOnly));
        QVERIFY(recording.readAll().contains("# operator: Olli\n"));

        // Listening moves nothing and needs nobody.
        QStringList listen = record;
        listen.removeAll(u"--arm"_s);
        listen[2] = u"virtual:?object=A&seed=9"_s; // which streams all the time
        QCOMPARE(run(listen).exit, 0);
    }
    void armingIsTheSupervisorsWhereThePolicySaysSo()
    {
        const QStringList record{u"record"_s,    u"--device"_s,   u"virtual:?object=A&seed=9&speed=0"_s,
                                 u"--seconds"_s, u"0.2"_s,        u"--arm"_s,
                                 u"-o"_s,        u"squeeze.csv"_s};
        addOlli();
        {
            const auto library = Library::open(file());
            actAsSam(**library);
            QVERIFY((*library)->people().setArming(ArmingPolicy::Supervisors));
        }
        const ProgramRun refused = run(record, u"Olli"_s, ollisSecret);
        QCOMPARE(refused.exit, 2);
        QVERIFY2(refused.json()[u"error"_s][u"message"_s].toString().contains(u"supervisor"_s), refused.out);
        QVERIFY(run(record).json()[u"error"_s][u"message"_s].toString().contains(u"a supervisor"_s));
        QCOMPARE(run(record, u"Sam"_s, pin).exit, 0);
        QCOMPARE(entries()[0][u"action"_s].toString(), u"gripper.armed"_s);
        QCOMPARE(entries()[0][u"role"_s].toString(), u"supervisor"_s);
    }
    void anotherLibraryIsNoWayRoundThePeopleInTheUsersOwn()
    {
        const QStringList record{u"record"_s,    u"--device"_s,    u"virtual:?object=A&seed=9&speed=0"_s,
                                 u"--seconds"_s, u"0.2"_s,         u"--arm"_s,
                                 u"-o"_s,        u"squeeze.csv"_s, u"--json"_s};
        // Nobody is in either: nobody is asked, and it is kept where a library is.
        QFile::rename(file(), m_work.path(u"people.db"_s));
        QCOMPARE(m_work.cli(record).exit, 0); // there is no library at all
        QVERIFY(Library::open(file()));
        QCOMPARE(m_work.cli(record + QStringList{u"--library"_s, u"lib.db"_s}).exit, 0);
        const QJsonObject armed = entries()[0].toObject();
        QCOMPARE(armed[u"action"_s].toString(), u"gripper.armed"_s);
        QCOMPARE(armed[u"person"_s].toString(), u"tester"_s); // of this computer
        QCOMPARE(armed[u"role"_s].toString(), QString());
        // The user's own library has people now: the other one does not help.
        QVERIFY(QDir().mkpath(m_work.path(u"gripscope"_s)));
        QVERIFY(QFile::copy(m_work.path(u"people.db"_s), m_work.path(u"gripscope/library.db"_s)));
        QFile::remove(m_work.path(u"squeeze.csv"_s));
        const ProgramRun round = m_work.cli(record + QStringList{u"--library"_s, u"lib.db"_s});
        QCOMPARE(round.exit, 2);
        QVERIFY(!QFile::exists(m_work.path(u"squeeze.csv"_s)));
        QCOMPARE(m_work.cli(record).exit, 2);
        // Nor is it for what decides about verdicts beside the library.
        const QStringList other{u"--library"_s, u"lib.db"_s, u"--json"_s};
        const ProgramRun install = m_work.cli(
            QStringList{u"profile"_s, u"install"_s,
                        QStringLiteral(GRIPSCOPE_SOURCE_DIR "/resources/profiles/example_bare.json")} +
            other);
        QCOMPARE(install.exit, 2);
        QVERIFY(install.json()[u"error"_s][u"message"_s].toString().contains(u"GRIPSCOPE_PERSON"_s));
        QVERIFY(QDir().mkpath(m_work.path(u"kept"_s)));
        const QString part = u"kept/2026-01-01T000000Z-VG-9.part0001.gscap"_s;
        m_work.write(part, QByteArray(4096, 'x'));
        const ProgramRun prune = m_work.cli(QStringList{u"captures"_s, u"prune"_s, u"--folder"_s, u"kept"_s,
                                                        u"--limit"_s, u"0"_s, u"--yes"_s} +
                                            other);
        QCOMPARE(prune.exit, 2);
        QVERIFY(QFile::exists(m_work.path(part)));
    }
    void theTrailIsListedAndVerified()
    {
        const ProgramRun listed = run({u"audit"_s, u"--limit"_s, u"1"_s});
        QCOMPARE(listed.exit, 0);
        QCOMPARE(listed.json()[u"total"_s].toInt(), 2);
        QCOMPARE(listed.json()[u"entries"_s].toArray().size(), 1);
        QCOMPARE(run({u"audit"_s, u"--text"_s, u"nobody"_s}).json()[u"total"_s].toInt(), 0);
        const ProgramRun whole = run({u"audit"_s, u"--verify"_s});
        QCOMPARE(whole.exit, 0);
        QVERIFY(whole.json()[u"whole"_s].toBool() && whole.json()[u"fault"_s].isNull());
        QCOMPARE(whole.json()[u"entries"_s].toInt(), 2);
        QCOMPARE(whole.json()[u"head"_s].toString().size(), 64);
    }
    void aTrailThatIsNotInOrderEndsWithFive()
    {
        // One byte of the first entry's text: its station.
        QFile raw(file());
        {
            auto library = Library::open(file());
            QVERIFY(library); // closing it brings the log into the file
        }
        QVERIFY(raw.open(QIODevice::ReadWrite));
        QByteArray bytes = raw.readAll();
        const qsizetype place = bytes.indexOf("type.examples");
        QVERIFY(place > 0);
        raw.seek(place);
        raw.write("type.exampled");
        raw.close();
        const ProgramRun broken = run({u"audit"_s, u"--verify"_s});
        QCOMPARE(broken.exit, 5);
        QCOMPARE(broken.json()[u"fault"_s].toString(), u"changed"_s);
        QCOMPARE(broken.json()[u"at"_s].toInt(), 1);
        QVERIFY(broken.json()[u"message"_s].toString().contains(u"Entry 1 was changed"_s));
    }
};

GRIPSCOPE_TEST(PeopleCommandTest)
#include "people_command_test.moc"
