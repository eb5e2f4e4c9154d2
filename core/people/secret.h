// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QByteArrayView>

#include <memory>
#include <optional>

namespace gripscope {

/// A PIN or password in memory that is neither swapped out nor dumped, and wiped when it goes. The text it
/// was taken from is the caller's to wipe.
class Secret {
public:
    static constexpr int leastDigits = 6;      ///< of a PIN
    static constexpr int leastCharacters = 8;  ///< of a password
    static constexpr int mostCharacters = 128; ///< argon2id takes any length; a form needs a limit

    explicit Secret(const QString& text);
    ~Secret();
    Secret(Secret&&) noexcept;
    Secret& operator=(Secret&&) noexcept;

    [[nodiscard]] QByteArrayView bytes() const; ///< UTF-8
    /// Why it will not do, in words; nothing when it will.
    [[nodiscard]] std::optional<QString> problem() const;

private:
    struct Memory;
    std::unique_ptr<Memory> m_memory;
};

/// Overwrites the characters of `text`, also where they are shared, and empties it.
void wipe(QString& text);

/// The hash to be stored, with its salt and cost: argon2id, 64 MiB and 2 passes (libsodium's "interactive":
/// a tenth of a second, above the least that OWASP asks for). Takes too long for the screen's thread.
/// StorageFailed when there is not enough memory.
[[nodiscard]] Expected<QString> hashOf(const Secret& secret);
[[nodiscard]] bool matches(const Secret& secret, const QString& hash);

} // namespace gripscope
