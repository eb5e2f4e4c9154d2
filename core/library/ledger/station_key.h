// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include <array>
#include <optional>

namespace gripscope {

/// What this user's links are signed with at this computer (Ed25519, RFC 8032): a file that only the user may
/// read, made when it is first needed. It never enters a library.
class StationKey {
public:
    /// Nothing where it can neither be read nor made: links stay unsigned then.
    [[nodiscard]] static std::optional<StationKey> own();
    [[nodiscard]] static QString file();

    explicit StationKey(const std::array<unsigned char, 32>& seed);
    ~StationKey();
    StationKey(const StationKey&) = default;
    StationKey& operator=(const StationKey&) = default;

    [[nodiscard]] const QByteArray& publicKey() const { return m_public; }
    [[nodiscard]] QByteArray sign(const QByteArray& message) const;

private:
    QByteArray m_public;
    std::array<unsigned char, 64> m_secret{};
};

[[nodiscard]] bool isSignedBy(const QByteArray& publicKey, const QByteArray& message,
                              const QByteArray& signature);

} // namespace gripscope
