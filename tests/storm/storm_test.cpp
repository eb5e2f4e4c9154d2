// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/sql/statement.h"
#include "tests/core/library/plant_actions.h"
#include "tests/support/patience.h"
#include "tests/support/plant_server.h"
#include "tests/support/test_registry.h"

#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

#include <algorithm>
#include <map>

using namespace gripscope;
using namespace gripscope::test;

namespace {

/// The storm that every run of the tests has, unless another is asked for.
struct StormSize {
    int stations = 8, seconds = 120, outages = 4, kills = 8;
    int period_ms = 500;   ///< between two inspections of a station
    int change_every = 25; ///< inspections: then it changes a type

    [[nodiscard]] static StormSize asked()
    {
        StormSize size;
        const std::map<QString, int*> known{
            {u"stations"_s, &size.stations},   {u"seconds"_s, &size.seconds},
            {u"outages"_s, &size.outages},     {u"kills"_s, &size.kills},
            {u"period_ms"_s, &size.period_ms}, {u"change_every"_s, &size.change_every}};
        for (const QString& part : qEnvironmentVariable("GRIPSCOPE_STORM").split(u',', Qt::SkipEmptyParts))
            if (const auto found = known.find(part.section(u'=', 0, 0)); found != known.end())
                *found->second = part.section(u'=', 1).toInt();
        return size;
    }
};

/// One station: its file, and the program that is started on it again and again.
class StationProcess {
public:
    StationProcess(QString file, QString server, const StormSize& size, unsigned seed)
        : m_file(std::move(file)), m_server(std::move(server)), m_size(size), m_seed(seed)
    {
    }
    ~StationProcess() { static_cast<void>(end()); }
    StationProcess(const StationProcess&) = delete;
    StationProcess& operator=(const StationProcess&) = delete;

    void begin()
    {
        m_process = std::make_unique<QProcess>();
        m_process->setProcessChannelMode(QProcess::ForwardedErrorChannel);
        m_process->start(QStringLiteral(GRIPSCOPE_BIN_DIR "/storm_station"),
                         {m_file, m_server, QString::number(m_size.period_ms), QString::number(++m_seed),
                          QString::number(m_size.change_every)});
        m_process->waitForStarted();
    }
    void kill()
    {
        m_process->kill();
        m_process->waitForFinished(int(patience.count()));
        read();
    }
    [[nodiscard]] bool end()
    {
        if (!m_process)
            return true;
        m_process->closeWriteChannel();
        const bool ended = m_process->waitForFinished(int(patience.count()));
        read();
        const bool well = ended && m_process->exitStatus() == QProcess::NormalExit;
        m_process.reset();
        return well;
    }
    void ask(const char* what)
    {
        m_process->write(what);
        m_process->write("\n");
    }
    /// Takes what it has said.
    void read()
    {
        m_rest += m_process->readAllStandardOutput();
        for (qsizetype end = m_rest.indexOf('\n'); end >= 0; end = m_rest.indexOf('\n')) {
            const QByteArray line = m_rest.left(end);
            m_rest.remove(0, end + 1);
            if (line.startsWith("stored "))
                m_acknowledged.push_back(QString::fromLatin1(line.split(' ')[1]));
            if (line.startsWith("status "))
                m_status = QJsonDocument::fromJson(line.mid(7)).object();
        }
    }
    [[nodiscard]] bool runs() const { return m_process && m_process->state() == QProcess::Running; }
    /// Asked now, and waited for.
    [[nodiscard]] QJsonObject status()
    {
        m_status = {};
        ask("status");
        static_cast<void>(
            QTest::qWaitFor([this] { return read(), !m_status.isEmpty(); }, int(patience.count())));
        return m_status;
    }
    [[nodiscard]] const std::vector<QString>& acknowledged() const { return m_acknowledged; }
    [[nodiscard]] const QString& file() const { return m_file; }

private:
    QString m_file, m_server;
    StormSize m_size;
    unsigned m_seed;
    std::unique_ptr<QProcess> m_process;
    QByteArray m_rest;
    QJsonObject m_status;
    std::vector<QString> m_acknowledged;
};

/// Each inspection as often as it is there.
std::map<QString, int> inspectionsIn(const QString& place)
{
    std::map<QString, int> found;
    const auto database = valueOf(Database::open(place));
    Statement query(*database, u"be read"_s, u"SELECT id FROM inspections"_s);
    valueOf(query.forEach([&](Statement& row) { ++found[row.takeText()]; }));
    return found;
}

} // namespace

class StormTest : public QObject {
    Q_OBJECT
private slots:
    void nothingIsLostOrDoubledAndAllEndInOneState()
    {
        const StormSize size = StormSize::asked();
        m_size = size;
        const PlantServer server;
        const QTemporaryDir folder;
        makeTypes(folder.filePath(u"0.db"_s));
        for (int i = 0; i < size.stations; ++i) {
            m_stations.push_back(std::make_unique<StationProcess>(
                folder.filePath(u"%1.db"_s.arg(i)), server.address(), size, 1000u * unsigned(i)));
            m_stations.back()->begin();
        }
        rage(server);
        for (const auto& station : m_stations)
            station->ask("rest");
        QVERIFY(allComeInStep());
        for (const auto& station : m_stations)
            QVERIFY(station->end());
        compare(server.address());
        m_stations.clear();
    }

private:
    static void makeTypes(const QString& file)
    {
        const auto library = valueOf(Library::open(file));
        for (const QString& name : {u"Cola"_s, u"Soup"_s})
            valueOf(library->approveType(enrol(*library, name, 5), u"Ada"_s));
    }
    /// Outages and kills at random moments.
    void rage(const PlantServer& server)
    {
        std::mt19937 random(17);
        std::vector<std::pair<qint64, bool>> events; // when; whether it is the server's
        const qint64 end = 1000LL * m_size.seconds;
        std::uniform_int_distribution<qint64> when(0, end);
        for (int i = 0; i < m_size.outages + m_size.kills; ++i)
            events.emplace_back(when(random), i < m_size.outages);
        std::ranges::sort(events);
        QElapsedTimer clock;
        clock.start();
        int outage = 0;
        for (const auto& [moment, ofServer] : events) {
            waitUntil(clock, moment);
            if (ofServer) {
                sufferOutage(server, outage++, random);
                continue;
            }
            StationProcess& victim = *m_stations[random() % m_stations.size()];
            victim.kill();
            victim.begin();
        }
        waitUntil(clock, end);
    }
    void waitUntil(const QElapsedTimer& clock, qint64 moment)
    {
        do {
            for (const auto& station : m_stations)
                station->read();
            QTest::qWait(int(std::clamp<qint64>(moment - clock.elapsed(), 0, 100)));
        } while (clock.elapsed() < moment);
    }
    static void sufferOutage(const PlantServer& server, int number, std::mt19937& random)
    {
        const int lasts_ms = 500 + int(random() % 5000);
        switch (number % 3) {
        case 0:
            server.halt();
            QTest::qWait(lasts_ms);
            return server.go();
        case 1:
            return server.crash();
        default:
            server.pause();
            QTest::qWait(lasts_ms);
            server.resume();
        }
    }
    /// What one brings another has to fetch: all have to be in step when asked twice, some steps apart.
    [[nodiscard]] bool allComeInStep()
    {
        QElapsedTimer clock;
        clock.start();
        int rounds = 0;
        while (rounds < 2 && clock.elapsed() < 20 * patience.count()) {
            QTest::qWait(5000); // two of a link's periods, and some
            const bool all = std::ranges::all_of(m_stations, [](const auto& station) {
                const QJsonObject status = station->status();
                return status[u"inStep"_s].toBool() && status[u"waiting"_s].toInt() == 0;
            });
            rounds = all ? rounds + 1 : 0;
        }
        if (rounds < 2)
            for (const auto& station : m_stations)
                qWarning("%s: %s", qPrintable(station->file()),
                         QJsonDocument(station->status()).toJson(QJsonDocument::Compact).constData());
        qInfo("in step %lld ms after the storm", static_cast<long long>(clock.elapsed()));
        return rounds == 2;
    }
    void compare(const QString& server)
    {
        const std::map<QString, int> there = inspectionsIn(server);
        const auto times = [&](const QString& key) {
            const auto found = there.find(key);
            return found == there.end() ? 0 : found->second;
        };
        std::size_t acknowledged = 0, stored = 0;
        for (const auto& station : m_stations) {
            const std::map<QString, int> here = inspectionsIn(station->file());
            for (const QString& key : station->acknowledged())
                QCOMPARE(times(key), 1);
            for (const auto& [key, count] : here) // also what was stored and not yet said
                QCOMPARE(times(key), 1);
            QVERIFY(!station->acknowledged().empty()); // or it was no storm
            acknowledged += station->acknowledged().size();
            stored += here.size();
        }
        QCOMPARE(there.size(), stored);
        const std::size_t wanted =
            std::size_t(m_size.stations) * std::size_t(m_size.seconds) * 1000 / std::size_t(m_size.period_ms);
        qInfo("%zu acknowledged, %zu stored, of at most %zu", acknowledged, stored, wanted);
        const QStringList state = inForce(*valueOf(Library::open(server)));
        QVERIFY(isWhole(server));
        for (const auto& station : m_stations) {
            QCOMPARE(inForce(*valueOf(Library::open(station->file()))), state);
            QVERIFY(isWhole(station->file()));
        }
    }
    StormSize m_size;
    std::vector<std::unique_ptr<StationProcess>> m_stations;
};

GRIPSCOPE_TEST(StormTest)
#include "storm_test.moc"
