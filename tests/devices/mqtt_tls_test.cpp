// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/mqtt_publisher.h"
#include "tests/devices/mqtt_broker.h"
#include "tests/support/test_registry.h"

using namespace gripscope;
using namespace gripscope::test;
using namespace Qt::StringLiterals;
using namespace std::chrono_literals;

namespace {

/// An authority of its own, and certificates that it issues, made by openssl.
class CertificateAuthority {
public:
    explicit CertificateAuthority(const QString& name)
    {
        m_made = openssl({u"req"_s, u"-x509"_s, u"-newkey"_s, u"ec"_s, u"-pkeyopt"_s,
                          u"ec_paramgen_curve:prime256v1"_s, u"-nodes"_s, u"-days"_s, u"2"_s, u"-subj"_s,
                          u"/CN="_s + name, u"-keyout"_s, path(u"ca.key"_s), u"-out"_s, certificate()});
    }
    [[nodiscard]] QString certificate() const { return path(u"ca.pem"_s); }
    [[nodiscard]] bool made() const { return m_made; }
    /// What a broker needs to be `name` ("IP:127.0.0.1", "DNS:broker"); nothing where openssl fails.
    [[nodiscard]] QByteArray brokerCalled(const QString& name)
    {
        QFile extensions(path(u"names"_s));
        if (!extensions.open(QIODevice::WriteOnly))
            return {};
        extensions.write("subjectAltName=" + name.toLatin1() + '\n');
        extensions.close();
        const QString key = path(u"broker.key"_s), request = path(u"broker.csr"_s),
                      issued = path(u"broker.pem"_s);
        const bool done =
            openssl({u"req"_s, u"-newkey"_s, u"ec"_s, u"-pkeyopt"_s, u"ec_paramgen_curve:prime256v1"_s,
                     u"-nodes"_s, u"-subj"_s, u"/CN=broker"_s, u"-keyout"_s, key, u"-out"_s, request}) &&
            openssl({u"x509"_s, u"-req"_s, u"-in"_s, request, u"-CA"_s, certificate(), u"-CAkey"_s,
                     path(u"ca.key"_s), u"-CAcreateserial"_s, u"-days"_s, u"2"_s, u"-extfile"_s,
                     path(u"names"_s), u"-out"_s, issued});
        return done ? "allow_anonymous true\ncertfile " + issued.toLocal8Bit() + "\nkeyfile " +
                          key.toLocal8Bit() + '\n'
                    : QByteArray();
    }

private:
    [[nodiscard]] QString path(const QString& name) const { return m_folder.filePath(name); }
    [[nodiscard]] static bool openssl(const QStringList& arguments)
    {
        QProcess process;
        process.start(u"openssl"_s, arguments);
        return process.waitForFinished(int(patience.count())) && process.exitCode() == 0;
    }
    QTemporaryDir m_folder;
    bool m_made = false;
};

/// How a station fares with a broker over TLS: it is connected, or what is said.
QString outcome(const Broker& broker, const QString& caFile)
{
    MqttOptions options;
    options.host = u"127.0.0.1"_s;
    options.port = broker.port();
    options.tls = true;
    options.caFile = caFile;
    options.jsonTopic = u"plant/results"_s;
    options.retryFirst = 20ms;
    const QTemporaryDir folder;
    const MqttPublisher publisher(options, std::make_shared<MqttOutbox>(folder.filePath(u"mqtt"_s)));
    MqttLink link;
    static_cast<void>(QTest::qWaitFor(
        [&] {
            link = publisher.link();
            return link.connected || link.problem;
        },
        int(patience.count())));
    return link.connected ? u"connected"_s : link.problem ? link.problem->describe() : u"nothing is said"_s;
}

} // namespace

/// A real broker over TLS.
class MqttTlsTest : public QObject {
    Q_OBJECT
private slots:
    void aCertificateOfTheNamedAuthorityIsTrustedAndNoOther()
    {
        CertificateAuthority plant(u"Plant"_s), other(u"Other"_s);
        QVERIFY2(plant.made() && other.made(), "openssl is missing, or does not do what it should");
        Broker broker(plant.brokerCalled(u"IP:127.0.0.1"_s));
        QVERIFY(broker.start());
        QCOMPARE(outcome(broker, plant.certificate()), u"connected"_s);
        const QString ofAnother = outcome(broker, other.certificate());
        QVERIFY2(ofAnother.contains(u"is not trusted"_s), qPrintable(ofAnother));
        const QString ofTheComputer = outcome(broker, {});
        QVERIFY2(ofTheComputer.contains(u"is not trusted"_s), qPrintable(ofTheComputer));
        const QString ofNone = outcome(broker, u"/no/such/file.pem"_s);
        QVERIFY2(ofNone.contains(u"/no/such/file.pem"_s), qPrintable(ofNone));
    }
    void aCertificateForAnotherNameIsRefused()
    {
        CertificateAuthority plant(u"Plant"_s);
        Broker broker(plant.brokerCalled(u"DNS:broker.example"_s));
        QVERIFY(broker.start());
        const QString said = outcome(broker, plant.certificate());
        QVERIFY2(said.contains(u"is for another name"_s), qPrintable(said));
    }
    void aBrokerWithoutTlsIsTold()
    {
        CertificateAuthority plant(u"Plant"_s);
        Broker broker;
        QVERIFY(broker.start());
        const QString said = outcome(broker, plant.certificate());
        QVERIFY2(said != u"connected"_s && said != u"nothing is said"_s, qPrintable(said));
    }
};

GRIPSCOPE_TEST(MqttTlsTest)
#include "mqtt_tls_test.moc"
