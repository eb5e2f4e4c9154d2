// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/people/secret.h"

#include "core/base/words.h"

#include <algorithm>
#include <cstring>
#include <sodium.h>

namespace gripscope {

using namespace Qt::StringLiterals;

namespace {

void requireSodium()
{
    // Fails only where the system has no source of random numbers: nothing could be kept secret there.
    static const int ready = sodium_init();
    if (ready < 0)
        qFatal("libsodium finds no source of random numbers");
}

} // namespace

struct Secret::Memory {
    explicit Memory(std::size_t bytes) : size(bytes), data(static_cast<char*>(sodium_malloc(bytes)))
    {
        if (!data)
            qFatal("out of memory");
    }
    ~Memory() { sodium_free(data); } // wipes it
    Memory(const Memory&) = delete;
    Memory& operator=(const Memory&) = delete;
    std::size_t size;
    char* data;
};

Secret::Secret(const QString& text)
{
    requireSodium();
    QByteArray utf8 = text.toUtf8();
    m_memory = std::make_unique<Memory>(static_cast<std::size_t>(utf8.size()));
    std::memcpy(m_memory->data, utf8.constData(), m_memory->size);
    sodium_memzero(utf8.data(), m_memory->size);
}

Secret::~Secret() = default;
Secret::Secret(Secret&&) noexcept = default;
Secret& Secret::operator=(Secret&&) noexcept = default;

QByteArrayView Secret::bytes() const
{
    return {m_memory->data, static_cast<qsizetype>(m_memory->size)};
}

std::optional<QString> Secret::problem() const
{
    const QByteArrayView text = bytes();
    // Each character of UTF-8 begins with one byte that is no continuation (10xxxxxx).
    const auto characters =
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; });
    const bool digits = std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (characters > mostCharacters)
        return Words::tr("That is too long: at most %1 characters.").arg(mostCharacters);
    if (characters < (digits ? leastDigits : leastCharacters))
        return Words::tr("That is too short: a PIN has %1 digits or more, a password %2 characters or more.")
            .arg(leastDigits)
            .arg(leastCharacters);
    return {};
}

void wipe(QString& text)
{
    // Not data(): that would wipe a copy where the text is shared.
    sodium_memzero(const_cast<QChar*>(text.constData()),
                   static_cast<std::size_t>(text.size()) * sizeof(QChar));
    text.clear();
}

Expected<QString> hashOf(const Secret& secret)
{
    const QByteArrayView bytes = secret.bytes();
    char hash[crypto_pwhash_STRBYTES];
    if (crypto_pwhash_str(hash, bytes.data(), static_cast<unsigned long long>(bytes.size()),
                          crypto_pwhash_OPSLIMIT_INTERACTIVE, crypto_pwhash_MEMLIMIT_INTERACTIVE) != 0)
        return failure(ErrorCode::StorageFailed,
                       {Words::tr("store the PIN or password"), Words::tr("there is not enough memory")});
    return QString::fromLatin1(hash);
}

bool matches(const Secret& secret, const QString& hash)
{
    requireSodium();
    const QByteArrayView bytes = secret.bytes();
    return crypto_pwhash_str_verify(hash.toLatin1().constData(), bytes.data(),
                                    static_cast<unsigned long long>(bytes.size())) == 0;
}

} // namespace gripscope
