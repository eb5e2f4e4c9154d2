// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/line/modbus_server.h"

#include "core/base/words.h"
#include "devices/line/modbus_registers.h"

#include <QAbstractEventDispatcher>
#include <QEventLoop>
#include <QHostAddress>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>

#include <algorithm>
#include <atomic>
#include <list>
#include <mutex>
#include <thread>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

using SteadyClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds refillEvery{10};
constexpr std::chrono::seconds listenAgainAfter{3};
/// A client that was silent for so long gives its place to a new one.
constexpr std::chrono::seconds silentClient{10};
constexpr qint64 mostUnread = 4096;     ///< bytes of requests: some fifteen of the longest
constexpr qint64 mostUnfetched = 65536; ///< bytes of answers that a client leaves lying

QString whereFrom(const QHostAddress& address)
{
    bool isVersion4 = false;
    const quint32 plain = address.toIPv4Address(&isVersion4);
    return isVersion4 ? QHostAddress(plain).toString() : address.toString();
}

bool mayConnect(const QHostAddress& peer, const QStringList& peers)
{
    if (peer.isLoopback())
        return true;
    const QHostAddress plain(whereFrom(peer));
    return std::ranges::any_of(peers, [&plain](const QString& allowed) {
        return allowed.contains(u'/') ? plain.isInSubnet(QHostAddress::parseSubnet(allowed))
                                      : plain == QHostAddress(allowed);
    });
}

} // namespace

Expected<void> checkOptions(const ModbusServerOptions& options)
{
    if (QHostAddress(options.host).isNull())
        return failure(ErrorCode::Usage,
                       {Words::say("\"%1\" is no network address; 127.0.0.1 listens to this "
                                   "computer alone, 0.0.0.0 to all networks.")
                            .arg(options.host)});
    for (const QString& peer : options.peers) {
        const bool known =
            peer.contains(u'/') ? QHostAddress::parseSubnet(peer).second >= 0 : !QHostAddress(peer).isNull();
        if (!known)
            return failure(ErrorCode::Usage,
                           {Words::say("\"%1\" is neither a network address nor a network such as "
                                       "10.1.2.0/24.")
                                .arg(peer)});
    }
    return {};
}

Expected<ModbusServerOptions> parseListenAddress(const QString& text)
{
    const qsizetype colon = text.lastIndexOf(u':');
    bool isPort = false;
    const unsigned port = colon < 0 ? 0 : text.mid(colon + 1).toUInt(&isPort);
    ModbusServerOptions options;
    options.host = text.left(std::max<qsizetype>(colon, 0));
    if (options.host.startsWith(u'[') && options.host.endsWith(u']'))
        options.host = options.host.mid(1, options.host.size() - 2);
    if (!isPort || port > 65535)
        return failure(ErrorCode::Usage,
                       {Words::say("\"%1\" is no HOST:PORT such as 127.0.0.1:1502.").arg(text)});
    options.port = static_cast<std::uint16_t>(port);
    RETURN_IF_ERROR(checkOptions(options));
    return options;
}

namespace {

/// All that lives on the server's thread.
class ModbusListener {
public:
    ModbusListener(ModbusServerOptions options, std::shared_ptr<SharedJobDesk> desk, std::mutex& mutex,
                   LineLink& link)
        : m_options(std::move(options)), m_registers(std::move(desk)), m_mutex(mutex), m_link(link)
    {
        QObject::connect(&m_server, &QTcpServer::newConnection, &m_server, [this] { accept(); });
        QObject::connect(&m_again, &QTimer::timeout, &m_server, [this] { listen(); });
        m_again.setInterval(listenAgainAfter);
        QObject::connect(&m_refill, &QTimer::timeout, &m_server, [this] { refill(); });
        m_refill.setSingleShot(true);
        m_refill.setInterval(refillEvery);
        listen();
    }
    ~ModbusListener()
    {
        for (const Client& client : m_clients)
            client.socket->disconnect(); // a socket that goes tells that it was connected
    }
    ModbusListener(const ModbusListener&) = delete;
    ModbusListener& operator=(const ModbusListener&) = delete;

private:
    struct Client {
        explicit Client(QTcpSocket* accepted) : socket(accepted) {}
        std::unique_ptr<QTcpSocket> socket;
        QByteArray unread;
        int budget = ModbusServer::requestsOfOne;
        SteadyClock::time_point lastHeard = SteadyClock::now();
        bool gone = false;
    };

    void listen()
    {
        const bool listens = m_server.listen(QHostAddress(m_options.host), m_options.port);
        const std::lock_guard lock(m_mutex);
        m_link.failed.reset();
        if (listens) {
            m_again.stop();
            const QString host = m_server.serverAddress().toString();
            m_link.listening =
                (host.contains(u':') ? u"[%1]:%2"_s : u"%1:%2"_s).arg(host).arg(m_server.serverPort());
            m_link.clientsChanged = QDateTime::currentDateTimeUtc();
            return;
        }
        m_link.failed = Error{ErrorCode::Usage,
                              {Words::say("Nothing can listen on %1:%2 (%3). Choose another address or port.")
                                   .arg(m_options.host)
                                   .arg(QString::number(m_options.port))
                                   .arg(m_server.errorString())}};
        m_again.start();
    }

    void accept()
    {
        while (QTcpSocket* socket = m_server.nextPendingConnection()) {
            std::unique_ptr<QTcpSocket> accepted(socket);
            const QHostAddress peer = socket->peerAddress();
            if (!mayConnect(peer, m_options.peers) || !makeRoom()) {
                const std::lock_guard lock(m_mutex);
                m_link.refusedPeer = whereFrom(peer);
                socket->abort();
                continue;
            }
            socket->setReadBufferSize(mostUnread);
            socket->setSocketOption(QAbstractSocket::KeepAliveOption, 1);
            socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
            Client& client = m_clients.emplace_back(accepted.release());
            QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, &client] { serve(client); });
            QObject::connect(socket, &QTcpSocket::disconnected, socket, [this, &client] { leave(client); });
            tellClients();
        }
    }

    /// One that was silent the longest goes, unless all of them speak.
    bool makeRoom()
    {
        if (living() < ModbusServer::mostClients)
            return true;
        Client* silent = nullptr;
        for (Client& client : m_clients)
            if (!client.gone && (silent == nullptr || client.lastHeard < silent->lastHeard))
                silent = &client;
        if (SteadyClock::now() - silent->lastHeard < silentClient)
            return false;
        silent->socket->abort();
        return true;
    }

    [[nodiscard]] int living() const
    {
        return static_cast<int>(
            std::ranges::count_if(m_clients, [](const Client& client) { return !client.gone; }));
    }

    void leave(Client& client)
    {
        client.gone = true;
        tellClients();
        if (!m_refill.isActive())
            m_refill.start(); // which clears it away, when none of its signals is under way
    }

    void tellClients()
    {
        const int clients = living();
        const std::lock_guard lock(m_mutex);
        if ((clients == 0) != (m_link.clients == 0))
            m_link.clientsChanged = QDateTime::currentDateTimeUtc();
        m_link.clients = clients;
    }

    void serve(Client& client)
    {
        const QByteArray news = client.socket->read(mostUnread - client.unread.size());
        if (!news.isEmpty())
            client.lastHeard = SteadyClock::now();
        client.unread += news;
        std::uint64_t answered = 0;
        qsizetype used = 0;
        while (!client.gone && client.budget > 0 && m_budget > 0) {
            ModbusFrame frame;
            const auto* begin = reinterpret_cast<const std::uint8_t*>(client.unread.constData()) + used;
            const FrameState state =
                nextFrame({begin, static_cast<std::size_t>(client.unread.size() - used)}, frame);
            if (state == FrameState::Broken)
                return drop(client, true);
            if (state == FrameState::Incomplete)
                break;
            const std::vector<std::uint8_t> answer = framed(frame, answerPdu(frame.pdu, m_registers));
            used += static_cast<qsizetype>(frame.bytes);
            client.socket->write(reinterpret_cast<const char*>(answer.data()),
                                 static_cast<qint64>(answer.size()));
            --client.budget;
            --m_budget;
            ++answered;
        }
        client.unread.remove(0, used);
        if (client.socket->bytesToWrite() > mostUnfetched)
            return drop(client, false);
        count(answered, 0);
        if (!m_refill.isActive() && (client.budget < ModbusServer::requestsOfOne))
            m_refill.start();
    }

    void drop(Client& client, bool malformed)
    {
        count(0, malformed ? 1 : 0);
        client.socket->abort();
    }

    void count(std::uint64_t requests, std::uint64_t malformed)
    {
        const std::lock_guard lock(m_mutex);
        m_link.requests += requests;
        m_link.malformed += malformed;
    }

    void refill()
    {
        m_budget = ModbusServer::requestsAtOnce;
        m_clients.remove_if([](const Client& client) { return client.gone; });
        for (Client& client : m_clients) {
            client.budget = ModbusServer::requestsOfOne;
            if (!client.gone && (!client.unread.isEmpty() || client.socket->bytesAvailable() > 0))
                serve(client);
        }
    }

    ModbusServerOptions m_options;
    LineRegisters m_registers;
    std::mutex& m_mutex;
    LineLink& m_link;
    QTcpServer m_server;
    QTimer m_again, m_refill;
    std::list<Client> m_clients; // before the server goes
    int m_budget = ModbusServer::requestsAtOnce;
};

} // namespace

struct ModbusServer::Private {
    mutable std::mutex mutex; ///< guards link and events
    LineLink link;
    QAbstractEventDispatcher* events = nullptr; ///< of the thread, while it waits for them
    std::atomic<bool> ending = false;
    std::thread thread;

    void tellEvents(QAbstractEventDispatcher* dispatcher)
    {
        const std::lock_guard lock(mutex);
        events = dispatcher;
    }
    /// An event loop of its own in which all of it is made and goes.
    void run(const ModbusServerOptions& options, const std::shared_ptr<SharedJobDesk>& desk)
    {
        QEventLoop loop;
        ModbusListener listener(options, desk, mutex, link);
        tellEvents(QAbstractEventDispatcher::instance());
        while (!ending)
            loop.processEvents(QEventLoop::WaitForMoreEvents);
        tellEvents(nullptr);
    }
};

ModbusServer::ModbusServer(const ModbusServerOptions& options, std::shared_ptr<SharedJobDesk> desk)
    : d(std::make_unique<Private>())
{
    d->link.on = true;
    d->link.clientsChanged = QDateTime::currentDateTimeUtc();
    d->thread = std::thread([p = d.get(), options, desk = std::move(desk)] { p->run(options, desk); });
}

ModbusServer::~ModbusServer()
{
    d->ending = true;
    {
        const std::lock_guard lock(d->mutex);
        if (d->events != nullptr)
            d->events->wakeUp();
    }
    d->thread.join();
}

LineLink ModbusServer::link() const
{
    const std::lock_guard lock(d->mutex);
    return d->link;
}

} // namespace gripscope
