// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/library/ledger/station_key.h"

#include "core/base/brief_lock.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

#include <algorithm>
#include <sodium.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype seedSize = crypto_sign_SEEDBYTES;

QByteArray storedSeed()
{
    QFile file(StationKey::file());
    if (!file.open(QIODevice::ReadOnly))
        return {};
    QByteArray seed = file.read(seedSize + 1);
    return seed.size() == seedSize ? seed : QByteArray();
}

/// Another process may do the same at the same time: the first one's counts.
QByteArray makeSeed()
{
    const QString name = StationKey::file();
    QDir().mkpath(QFileInfo(name).path());
    BriefLock lock(name + u".lock"_s);
    if (!lock.take())
        return {};
    if (QFileInfo::exists(name))
        return storedSeed();
    QByteArray seed(seedSize, Qt::Uninitialized);
    randombytes_buf(seed.data(), static_cast<std::size_t>(seedSize));
    QSaveFile file(name);
    if (!file.open(QIODevice::WriteOnly) ||
        !file.setPermissions(QFileDevice::ReadOwner | QFileDevice::WriteOwner) ||
        file.write(seed) != seedSize || !file.commit())
        return {};
    return seed;
}

} // namespace

QString StationKey::file()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
           u"/gripscope/station.key"_s;
}

std::optional<StationKey> StationKey::own()
{
    if (sodium_init() < 0)
        return {};
    QByteArray stored = QFileInfo::exists(file()) ? storedSeed() : makeSeed();
    if (stored.size() != seedSize)
        return {};
    std::array<unsigned char, seedSize> seed{};
    std::copy_n(stored.cbegin(), seedSize, seed.begin());
    const StationKey key(seed);
    sodium_memzero(stored.data(), static_cast<std::size_t>(seedSize));
    sodium_memzero(seed.data(), seed.size());
    return key;
}

StationKey::StationKey(const std::array<unsigned char, 32>& seed)
    : m_public(crypto_sign_PUBLICKEYBYTES, Qt::Uninitialized)
{
    static_assert(std::tuple_size_v<decltype(m_secret)> == crypto_sign_SECRETKEYBYTES);
    crypto_sign_seed_keypair(reinterpret_cast<unsigned char*>(m_public.data()), m_secret.data(), seed.data());
}

StationKey::~StationKey()
{
    sodium_memzero(m_secret.data(), m_secret.size());
}

QByteArray StationKey::sign(const QByteArray& message) const
{
    QByteArray signature(crypto_sign_BYTES, Qt::Uninitialized);
    crypto_sign_detached(reinterpret_cast<unsigned char*>(signature.data()), nullptr,
                         reinterpret_cast<const unsigned char*>(message.constData()),
                         static_cast<unsigned long long>(message.size()), m_secret.data());
    return signature;
}

bool isSignedBy(const QByteArray& publicKey, const QByteArray& message, const QByteArray& signature)
{
    return publicKey.size() == crypto_sign_PUBLICKEYBYTES && signature.size() == crypto_sign_BYTES &&
           crypto_sign_verify_detached(reinterpret_cast<const unsigned char*>(signature.constData()),
                                       reinterpret_cast<const unsigned char*>(message.constData()),
                                       static_cast<unsigned long long>(message.size()),
                                       reinterpret_cast<const unsigned char*>(publicKey.constData())) == 0;
}

} // namespace gripscope
