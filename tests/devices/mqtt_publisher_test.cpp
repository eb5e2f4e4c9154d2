// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/mqtt_publisher.h"
#include "tests/devices/mqtt_broker.h"
#include "tests/support/mqtt_reader.h"
#include "tests/support/test_registry.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace {

MqttOptions optionsFor(const Broker& broker)
{
    MqttOptions options;
    options.host = QStringLiteral("127.0.0.1");
    options.port = broker.port();
    options.jsonTopic = QStringLiteral("plant/results");
    options.retryFirst = 20ms;
    options.retryMost = 100ms;
    return options;
}

MqttOptions everythingFor(const Broker& broker)
{
    MqttOptions options = optionsFor(broker);
    options.group = QStringLiteral("plant");
    options.node = QStringLiteral("station");
    options.primaryHost = QStringLiteral("scada");
    return options;
}

/// The n-th result of a test is of part Pn.
LineReport reportOfPart(int number)
{
    LineReport report;
    report.gripper = QStringLiteral("G1");
    report.part = QStringLiteral("P%1").arg(number);
    report.result.state = ResultState::Completed;
    report.result.evaluation = ResultEvaluation::Ok;
    report.result.reason = ResultReason::AsExpected;
    report.result.quantities[0] = LineQuantity{0.5, 0.01};
    report.result.utc = QDateTime::currentDateTimeUtc();
    return report;
}

struct Sender {
    explicit Sender(const MqttOptions& options) : publisher(std::make_unique<MqttPublisher>(options, outbox))
    {
        publisher->setGripper(QStringLiteral("G1"));
    }
    bool becomes(const std::function<bool(const MqttLink&)>& so) const
    {
        return QTest::qWaitFor([&] { return so(publisher->link()); }, int(patience.count()));
    }
    QTemporaryDir folder;
    std::shared_ptr<MqttOutbox> outbox =
        std::make_shared<MqttOutbox>(folder.filePath(QStringLiteral("mqtt")));
    std::unique_ptr<MqttPublisher> publisher;
};

QString problemWith(const MqttOptions& options)
{
    const Sender sender(options);
    if (!sender.becomes([](const MqttLink& link) { return link.problem.has_value(); }))
        return QStringLiteral("nothing is said");
    return sender.publisher->link().problem->describe();
}

} // namespace

class MqttPublisherTest : public QObject {
    Q_OBJECT
private slots:
    /// An independent host (sparkplug_host.py) holds all of it to the specification meanwhile.
    void everyResultArrivesInOrderWhileTheBrokerIsRestartedTwentyTimes()
    {
        constexpr int restarts = 20, whileDown = 3, whileUp = 7, atTheEnd = 5;
        constexpr int all = restarts * (whileDown + whileUp) + atTheEnd;
        Broker broker;
        QVERIFY(broker.start());
        QProcess host;
        host.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        host.start(QStringLiteral("/usr/bin/python3"), // Debian's, which has its packages
                   {QStringLiteral(GRIPSCOPE_SOURCE_DIR "/tests/devices/sparkplug_host.py"),
                    QString::number(broker.port()), QString::number(all)});
        QVERIFY2(host.waitForReadyRead(int(patience.count())), "python3-paho-mqtt is missing, or see above");
        QCOMPARE(host.readLine().trimmed(), QByteArray("ready"));
        const Sender sender(everythingFor(broker));
        QVERIFY(sender.becomes([](const MqttLink& link) { return link.connected; }));
        int offered = 0;
        const auto offer = [&](int count) {
            for (int i = 0; i < count; ++i)
                sender.outbox->offer(reportOfPart(++offered));
        };
        QSet<int> waited;
        for (int i = 0; i < restarts; ++i) {
            QVERIFY(sender.becomes([](const MqttLink& link) { return link.connected; }));
            offer(whileUp);
            QTest::qWait(i % 5 * 40); // so that it is stopped now before, now behind they are sent
            broker.stop();
            for (int n = 1; n <= whileDown; ++n)
                waited << offered + n;
            offer(whileDown);
            QVERIFY(broker.start());
        }
        QVERIFY(sender.becomes([](const MqttLink& link) { return link.connected && link.waiting == 0; }));
        offer(atTheEnd);
        QVERIFY(host.waitForFinished(int(patience.count())));
        const QByteArray said = host.readAllStandardOutput();
        const QJsonObject seen = QJsonDocument::fromJson(said).object();
        QVERIFY2(seen[QStringLiteral("faults")].toArray().isEmpty(), said);
        for (const char* way : {"json", "sparkplug"}) {
            const QJsonArray results = seen[QLatin1StringView(way)].toArray();
            QCOMPARE(results.size(), all);
            for (int n = 1; n <= all; ++n) {
                QCOMPARE(results[n - 1][0].toInt(), n);
                if (waited.contains(n) || n > all - atTheEnd)
                    QCOMPARE(results[n - 1][1].toBool(), waited.contains(n));
            }
        }
        // What was in flight when a broker stopped is sent again, and no more than that.
        QVERIFY2(seen[QStringLiteral("doubled")].toInt() <= 2 * restarts * whileUp, said);
        QVERIFY2(seen[QStringLiteral("rebirths")].toInt() >= 1, said);
        QVERIFY2(seen[QStringLiteral("births")].toArray().size() > restarts / 2, said);
        QVERIFY(sender.becomes([](const MqttLink& link) { return link.waiting == 0; }));
    }
    void whatAProgramLeftBehindIsSentByTheNext()
    {
        Broker broker;
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("mqtt"));
        {
            MqttOutbox outbox(file); // of a program that ends before it gets through
            for (int n = 1; n <= 3; ++n)
                outbox.offer(reportOfPart(n));
        }
        QVERIFY(broker.start());
        const auto outbox = std::make_shared<MqttOutbox>(file);
        QVERIFY(QTest::qWaitFor([&] { return outbox->waiting(0, 9).size() == 3; }, int(patience.count())));
        MqttPublisher publisher(optionsFor(broker), outbox);
        QVERIFY(QTest::qWaitFor([&] { return publisher.link().connected && publisher.link().waiting == 0; },
                                int(patience.count())));
        QCOMPARE(outbox->newest(), 3u);
        QVERIFY(publisher.end(patience));
    }
    /// The file is read late, here since another program has it; what is in it has waited all the same.
    void whatWaitedIsHistoricalHoweverLateItIsRead()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(u"mqtt"_s);
        auto other = std::make_unique<MqttOutbox>(file);
        other->offer(reportOfPart(1));
        QTRY_COMPARE(other->waiting(0, 9).size(), 1u);
        Broker broker;
        QVERIFY(broker.start());
        MqttReader reader(broker.port(), optionsFor(broker).jsonTopic);
        QVERIFY(reader.subscribed());
        const auto outbox = std::make_shared<MqttOutbox>(file);
        MqttPublisher publisher(optionsFor(broker), outbox);
        QTRY_VERIFY(publisher.link().stored.has_value());
        QTest::qWait(200); // long enough for a session that does not heed it
        other.reset();
        const std::vector<QJsonObject> seen = reader.messages(1);
        QCOMPARE(seen.size(), std::size_t(1));
        QCOMPARE(seen[0][u"historical"_s].toBool(), true);
    }
    void aPrimaryHostThatIsNotThereIsWaitedFor()
    {
        Broker broker;
        QVERIFY(broker.start());
        const Sender sender(everythingFor(broker));
        sender.outbox->offer(reportOfPart(1));
        QVERIFY(sender.becomes([](const MqttLink& link) { return link.waitsForHost && link.waiting == 1; }));
        QVERIFY(!sender.publisher->link().connected);
        QVERIFY(mqttWords(sender.publisher->link()).problems[0].describe().contains(QStringLiteral("scada")));
    }
    void aRefusedPasswordIsTold()
    {
        Broker broker("allow_anonymous false\n");
        QVERIFY(broker.start());
        QVERIFY2(problemWith(optionsFor(broker)).contains(QStringLiteral("wants a user and a password")),
                 qPrintable(problemWith(optionsFor(broker))));
        QFile secret(broker.path(QStringLiteral("secret")));
        QVERIFY(secret.open(QIODevice::WriteOnly));
        secret.write("wrong\n");
        secret.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner);
        secret.close();
        MqttOptions options = optionsFor(broker);
        options.user = QStringLiteral("line");
        options.passwordFile = secret.fileName();
        QVERIFY2(problemWith(options).contains(QStringLiteral("refuses the password")),
                 qPrintable(problemWith(options)));
        QVERIFY(secret.setPermissions(QFileDevice::ReadOwner | QFileDevice::ReadOther));
        QVERIFY(problemWith(options).contains(QStringLiteral("chmod 600")));
    }
    void whereNobodyListensIsTold()
    {
        const Broker broker; // not started
        QVERIFY2(problemWith(optionsFor(broker)).contains(QStringLiteral("Nothing listens on 127.0.0.1")),
                 qPrintable(problemWith(optionsFor(broker))));
        MqttOptions options = optionsFor(broker);
        options.host = QStringLiteral("no-such-host.invalid");
        QVERIFY2(problemWith(options).contains(QStringLiteral("no host called")),
                 qPrintable(problemWith(options)));
    }
    void theNewestIsRefusedWhereThereIsNoRoom()
    {
        const QTemporaryDir folder;
        MqttOutbox outbox(folder.filePath(QStringLiteral("mqtt")), {3, 256});
        for (int n = 1; n <= 5; ++n)
            outbox.offer(reportOfPart(n));
        QTRY_COMPARE(outbox.status().refused, 2u);
        QCOMPARE(outbox.newest(), 5u); // the gap says how many are missing
        outbox.acknowledge(1);
        outbox.offer(reportOfPart(6));
        QTRY_COMPARE(outbox.waiting(0, 9).size(), 3u);
        QCOMPARE(outbox.newest(), 6u);
        QStringList parts;
        for (const LineReport& report : outbox.waiting(0, 9))
            parts << QStringLiteral("%1:%2").arg(report.sequence).arg(report.part);
        QCOMPARE(parts, (QStringList{u"2:P2"_s, u"3:P3"_s, u"6:P6"_s}));
    }
    void anotherProgramThatHasTheFileIsTold()
    {
        const QTemporaryDir folder;
        const QString file = folder.filePath(QStringLiteral("mqtt"));
        MqttOutbox first(file);
        QVERIFY(first.nextBirth().has_value());
        MqttOutbox second(file);
        QTRY_VERIFY(second.status().problem.has_value());
        QVERIFY(!second.nextBirth().has_value());
    }
    void optionsAreChecked()
    {
        MqttOptions options;
        options.host = QStringLiteral("broker");
        QVERIFY(!checkOptions(options)); // neither JSON nor Sparkplug
        options.group = QStringLiteral("plant");
        QVERIFY(!checkOptions(options)); // no edge node
        options.node = QStringLiteral("a/b");
        QVERIFY(!checkOptions(options));
        options.node = QStringLiteral("station");
        QVERIFY(checkOptions(options));
        options.jsonTopic = QStringLiteral("a/#");
        QVERIFY(!checkOptions(options));
        QVERIFY(parseBroker(QStringLiteral("broker"), options));
        QCOMPARE(options.broker(), QStringLiteral("broker:1883"));
        QVERIFY(parseBroker(QStringLiteral("[::1]:99"), options));
        QCOMPARE(options.broker(), QStringLiteral("[::1]:99"));
        QVERIFY(!parseBroker(QStringLiteral("broker:x"), options));
    }
};
GRIPSCOPE_TEST(MqttPublisherTest)
#include "mqtt_publisher_test.moc"
