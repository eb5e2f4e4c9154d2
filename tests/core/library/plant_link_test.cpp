// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/library_service.h"
#include "core/library/link/plant_link.h"
#include "core/library/link/shared_link.h"
#include "core/library/sql/file_identity.h"
#include "tests/core/library/full_library.h"
#include "tests/core/library/plant_actions.h"
#include "tests/support/patience.h"
#include "tests/support/plant_server.h"
#include "tests/support/test_registry.h"
#include "tests/support/why_not.h"

using namespace gripscope;
using namespace gripscope::test;
using namespace std::chrono_literals;

namespace {

/// A station's file, and the link to its plant's server.
struct LinkedFile {
    explicit LinkedFile(QString server) : address(std::move(server)) { begin(); }
    void begin(std::chrono::milliseconds patience_ = patience)
    {
        link = std::make_unique<PlantLink>(PlantLinkOptions{file(), address, 20ms, 100ms, patience_});
    }
    [[nodiscard]] QString file() const { return folder.filePath(u"station.db"_s); }
    [[nodiscard]] bool becomes(const std::function<bool(const PlantStatus&)>& so) const
    {
        return QTest::qWaitFor([&] { return so(link->status()); }, int(patience.count()));
    }
    [[nodiscard]] bool comesInStep() const
    {
        return becomes([](const PlantStatus& now) { return now.reached && now.inStep && now.waiting == 0; });
    }
    void inspect(int count) const
    {
        for (int i = 0; i < count; ++i)
            valueOf(library->addInspection(anInspection()));
    }
    QTemporaryDir folder;
    QString address;
    std::unique_ptr<Library> library = valueOf(Library::open(file()));
    std::unique_ptr<PlantLink> link;
};

qint64 inspectionsAt(const QString& place)
{
    return valueOf(valueOf(Library::open(place))->inspectionCounts()).total;
}

} // namespace

class PlantLinkTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { m_server = std::make_unique<PlantServer>(); }
    void cleanupTestCase() { m_server.reset(); }

    void whatIsStoredGoesThereAndTypesComeByThemselves()
    {
        const LinkedFile one(m_server->address()), other(m_server->address());
        const QString cola = enrol(*one.library, u"Cola"_s, 3);
        one.inspect(20);
        QTRY_VERIFY_WITH_TIMEOUT(valueOf(other.library->findType(u"Cola"_s)), int(patience.count()));
        QVERIFY(other.becomes([](const PlantStatus& now) { return now.typesTaken > 0; }));
        valueOf(other.library->renameType(cola, u"Cola 330"_s, why));
        QTRY_VERIFY_WITH_TIMEOUT(valueOf(one.library->findType(u"Cola 330"_s)), int(patience.count()));
        QVERIFY(one.comesInStep());
        QCOMPARE(inspectionsAt(m_server->address()), 20);
        QVERIFY(!one.link->status().problem);
    }
    /// The count is right while the server is gone, and after a restart of the program.
    void whatWaitsIsCountedWhileTheServerIsGone()
    {
        LinkedFile station(m_server->address());
        QVERIFY(station.comesInStep());
        const qint64 before = inspectionsAt(m_server->address()) + 3;
        station.inspect(3);
        QTRY_COMPARE_WITH_TIMEOUT(inspectionsAt(m_server->address()), before, int(patience.count()));
        const QDateTime then = QDateTime::currentDateTimeUtc();
        QVERIFY(station.becomes([&](const PlantStatus& now) { return now.lastReached > then; })); // it knows
        m_server->halt();
        QVERIFY(station.becomes([](const PlantStatus& now) { return !now.reached && now.problem; }));
        station.inspect(7);
        QVERIFY(station.becomes([](const PlantStatus& now) { return now.waiting == 7; }));
        const QDateTime last = station.link->status().lastReached;
        QVERIFY(last.isValid());
        QVERIFY(station.link->end(patience));
        station.begin();
        QVERIFY(station.becomes([](const PlantStatus& now) { return now.waiting == 7 && now.problem; }));
        QCOMPARE(station.link->status().lastReached.toMSecsSinceEpoch(), last.toMSecsSinceEpoch());
        station.inspect(1);
        QVERIFY(station.becomes([](const PlantStatus& now) { return now.waiting == 8; }));
        m_server->go();
        QVERIFY(station.comesInStep()); // it was not while the server was gone
        QCOMPARE(inspectionsAt(m_server->address()), before + 8);
        QVERIFY(station.link->status().lastReached > last);
    }
    /// A server that takes what it is sent and never answers holds nobody up.
    void aServerThatHangsIsHungUpOn()
    {
        LinkedFile station(m_server->address());
        QVERIFY(station.comesInStep());
        QVERIFY(station.link->end(patience));
        station.begin(300ms);
        QVERIFY(station.comesInStep());
        m_server->pause();
        station.inspect(2); // the file is free
        QVERIFY(station.becomes([](const PlantStatus& now) { return !now.reached && now.waiting == 2; }));
        m_server->resume();
        QVERIFY(station.comesInStep());
        QVERIFY(station.link->end(patience));
        station.begin(); // patient
        QVERIFY(station.comesInStep());
        m_server->pause();
        QTest::qWait(100); // several steps: one hangs
        const bool ended = station.link->end(patience);
        m_server->resume();
        QVERIFY(ended);
    }
    void theFileIsLetGoWhereItIsNeededAlone()
    {
        LinkedFile station(m_server->address());
        QVERIFY(station.comesInStep());
        station.library.reset();
        LibraryService service(station.file());
        service.setGuest(station.link->guest());
        m_server->pause();
        QTest::qWait(100); // a step hangs
        bool alone = false;
        auto done = service.runClosed<void>([&](const Acting&) -> Expected<void> {
            FileInUse::unlessInUse(station.file(), [&] { alone = true; });
            return {};
        });
        QVERIFY(done.get());
        m_server->resume();
        QVERIFY(alone);
        QVERIFY(service.run<qint64>([](Library& library) { return library.version(); }).get());
        station.library = valueOf(Library::open(station.file()));
        station.inspect(1);
        QVERIFY(station.comesInStep());
    }
    void whatStationsDecidedApartIsToldUntilItIsSeen()
    {
        LinkedFile one(m_server->address()), other(m_server->address());
        const QString type = enrol(*one.library, u"Tin"_s, 2);
        QTRY_VERIFY_WITH_TIMEOUT(valueOf(other.library->findType(u"Tin"_s)), int(patience.count()));
        QVERIFY(one.link->end(patience) && other.link->end(patience));
        valueOf(one.library->renameType(type, u"Tin small"_s, why));
        valueOf(other.library->renameType(type, u"Tin 330"_s, why));
        one.begin();
        QVERIFY(one.comesInStep());
        other.begin();
        const auto told = [](const PlantStatus& now) { return now.conflicts.size() == 1; };
        QVERIFY(one.becomes(told) && other.becomes(told));
        const auto plant = valueOf(Library::open(m_server->address()));
        valueOf(plant->noteConflictsSeen(one.link->status().conflicts, why));
        const auto seen = [](const PlantStatus& now) { return now.conflicts.empty(); };
        QVERIFY(one.becomes(seen) && other.becomes(seen));
    }
    void whatIsNoServerIsTold()
    {
        const QString file = QStringLiteral("/nowhere/station.db");
        QVERIFY(!checkOptions({file, file}));
        QVERIFY(!checkOptions({m_server->address(), m_server->address()}));
        QVERIFY(!checkOptions({file, u"postgresql://a:secret@host/name"_s}));
        QVERIFY2(checkOptions({file, m_server->address()}), "");
        LinkedFile station(QString(m_server->address()).replace(u"/postgres?"_s, u"/nobody?"_s));
        station.inspect(1);
        QVERIFY(station.becomes([](const PlantStatus& now) { return now.problem.has_value(); }));
        const PlantStatus status = station.link->status();
        QVERIFY2(status.problem->describe().contains(u"nobody"_s), qPrintable(status.problem->describe()));
        QVERIFY(!status.waiting); // it is not known what another program brought there
        QVERIFY(!status.lastReached.isValid());
    }
    void aNoteThatCannotBeReadIsNone()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"note"_s), server = u"postgresql://a@b/c"_s;
        QVERIFY(!readLinkNote(file, server));
        const LinkNote note{server, QDateTime({2026, 11, 29}, {10, 42}, Qt::UTC), {{u"hall 1"_s, 4711}}};
        valueOf(writeLinkNote(file, note));
        QVERIFY(readLinkNote(file, server) == note);
        QVERIFY(!readLinkNote(file, u"postgresql://a@b/other"_s));
        for (const QByteArray& damaged : {QByteArray("{"), QByteArray("[1]"), QByteArray(2'000'000, '{')}) {
            QFile broken(file);
            QVERIFY(broken.open(QIODevice::WriteOnly));
            broken.write(damaged);
            broken.close();
            QVERIFY(!readLinkNote(file, server));
        }
        QVERIFY(!writeLinkNote(folder.filePath(u"no/folder"_s), note));
    }

private:
    std::unique_ptr<PlantServer> m_server;
};

GRIPSCOPE_TEST(PlantLinkTest)
#include "plant_link_test.moc"
