// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/mqtt/mqtt_connection.h"

#include "devices/line/mqtt/mqtt_words.h"

#include <QFile>

#include <array>
#include <cerrno>
#include <mosquitto.h>
#include <mutex>
#include <poll.h>
#include <sys/socket.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

/// A network that swallows all of it is given up after so long.
constexpr std::chrono::seconds connackWithin{10};
constexpr const char* trustedAuthorities = "/etc/ssl/certs";
constexpr int subscribeQos = 1;

void initMosquitto()
{
    static std::once_flag once;
    std::call_once(once, [] { mosquitto_lib_init(); });
}

int socketError(int descriptor)
{
    int problem = 0;
    socklen_t size = sizeof problem;
    return getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &problem, &size) == 0 ? problem : errno;
}

} // namespace

struct MqttConnection::Private {
    MqttOptions options;
    mosquitto* client = nullptr;
    MqttSession* session = nullptr;
    bool answered = false;      ///< by a CONNACK
    std::optional<int> refusal; ///< its code
    QByteArray complaint;       ///< all that TLS said
    std::chrono::steady_clock::time_point begun;

    static Private& of(void* self) { return *static_cast<Private*>(self); }
    static void onConnect(mosquitto*, void* self, int code)
    {
        of(self).answered = true;
        if (code != 0)
            of(self).refusal = code;
        else
            of(self).session->connected();
    }
    static void onSubscribe(mosquitto*, void* self, int packet, int, const int*)
    {
        of(self).session->subscribed(packet);
    }
    static void onAnswer(mosquitto*, void* self, int packet) { of(self).session->acknowledged(packet); }
    static void onMessage(mosquitto*, void* self, const mosquitto_message* message)
    {
        of(self).session->heard(QString::fromUtf8(message->topic),
                                QByteArray(static_cast<const char*>(message->payload), message->payloadlen));
    }
    static void onLog(mosquitto*, void* self, int, const char* text)
    {
        const QByteArrayView line(text);
        if (line.contains("OpenSSL") || line.contains("certificate") || line.contains("host name"))
            of(self).complaint += line.toByteArray() + ' ';
    }
    [[nodiscard]] tl::unexpected<Error> failed(int code, int systemError) const
    {
        return tl::make_unexpected(connectionProblem(options, {code, systemError, refusal, complaint}));
    }
    [[nodiscard]] int prepare(const QByteArray& password) const;
    [[nodiscard]] int advance(short events);
};

MqttConnection::MqttConnection(const MqttOptions& options) : d(std::make_unique<Private>())
{
    initMosquitto();
    d->options = options;
}

MqttConnection::~MqttConnection()
{
    mosquitto_destroy(d->client);
}

int MqttConnection::Private::prepare(const QByteArray& password) const
{
    mosquitto_connect_callback_set(client, &onConnect);
    mosquitto_subscribe_callback_set(client, &onSubscribe);
    mosquitto_unsubscribe_callback_set(client, &onAnswer);
    mosquitto_publish_callback_set(client,
                                   [](mosquitto* of, void* self, int packet) { onAnswer(of, self, packet); });
    mosquitto_message_callback_set(client, &onMessage);
    mosquitto_log_callback_set(client, &onLog);
    mosquitto_int_option(client, MOSQ_OPT_TCP_NODELAY,
                         1); // a result is small, and is not to wait for the next
    if (!options.user.isEmpty()) {
        const QByteArray user = options.user.toUtf8();
        if (const int code = mosquitto_username_pw_set(client, user.constData(), password.constData());
            code != 0)
            return code;
    }
    if (options.tls) {
        const QByteArray authority = QFile::encodeName(options.caFile);
        const bool own = !authority.isEmpty();
        if (const int code = mosquitto_tls_set(client, own ? authority.constData() : nullptr,
                                               own ? nullptr : trustedAuthorities, nullptr, nullptr, nullptr);
            code != 0)
            return code;
    }
    const std::optional<MqttMessage> will = session->will();
    if (!will)
        return 0;
    return mosquitto_will_set(client, will->topic.toUtf8().constData(), int(will->payload.size()),
                              will->payload.constData(), will->qos, will->retain);
}

Expected<void> MqttConnection::open(MqttSession& session)
{
    d->session = &session;
    ASSIGN_OR_RETURN(QByteArray password, readPassword(d->options));
    d->client = mosquitto_new(clientId(d->options).constData(), true, d.get());
    if (d->client == nullptr)
        return d->failed(MOSQ_ERR_NOMEM, errno);
    const int prepared = d->prepare(password);
    password.fill('\0');
    if (prepared != 0)
        return d->failed(prepared, errno);
    d->begun = std::chrono::steady_clock::now();
    errno = 0;
    const int code = mosquitto_connect_async(d->client, d->options.host.toUtf8().constData(), d->options.port,
                                             d->options.keepAlive_s);
    if (code > 0)
        return d->failed(code, errno);
    return {};
}

int MqttConnection::Private::advance(short events)
{
    constexpr int manyPackets = 1; // libmosquitto reads all there are
    int code = 0;
    if ((events & (POLLIN | POLLHUP | POLLERR)) != 0)
        code = mosquitto_loop_read(client, manyPackets);
    if (code == 0 && mosquitto_want_write(client))
        code = mosquitto_loop_write(client, manyPackets);
    if (code == 0)
        code = mosquitto_loop_misc(client);
    return code;
}

Expected<void> MqttConnection::turn(int wakeDescriptor, std::chrono::milliseconds most)
{
    const int descriptor = mosquitto_socket(d->client);
    if (descriptor < 0)
        return d->failed(MOSQ_ERR_CONN_LOST, 0);
    const auto wanted = static_cast<short>(POLLIN | (mosquitto_want_write(d->client) ? POLLOUT : 0));
    std::array<pollfd, 2> watched{pollfd{descriptor, wanted, 0}, pollfd{wakeDescriptor, POLLIN, 0}};
    poll(watched.data(), watched.size(), static_cast<int>(most.count()));
    if ((watched[0].revents & (POLLERR | POLLHUP)) != 0 && !d->answered)
        if (const int problem = socketError(descriptor); problem != 0)
            return d->failed(MOSQ_ERR_ERRNO, problem);
    errno = 0;
    const int code = d->advance(watched[0].revents);
    if (d->refusal || code != 0)
        return d->failed(code, errno);
    if (!d->answered && std::chrono::steady_clock::now() - d->begun > connackWithin)
        return d->failed(MOSQ_ERR_ERRNO, ETIMEDOUT);
    return {};
}

void MqttConnection::close()
{
    mosquitto_disconnect(d->client);
}

int MqttConnection::publish(const MqttMessage& message)
{
    int packet = -1;
    const int code =
        mosquitto_publish(d->client, &packet, message.topic.toUtf8().constData(), int(message.payload.size()),
                          message.payload.constData(), message.qos, message.retain);
    return code == 0 ? packet : -1;
}

int MqttConnection::subscribe(const QString& topic)
{
    int packet = -1;
    return mosquitto_subscribe(d->client, &packet, topic.toUtf8().constData(), subscribeQos) == 0 ? packet
                                                                                                  : -1;
}

int MqttConnection::askForReceipt()
{
    // Nothing is subscribed by that name, so that its end changes nothing.
    int packet = -1;
    return mosquitto_unsubscribe(d->client, &packet, "gripscope/receipt") == 0 ? packet : -1;
}

} // namespace gripscope
