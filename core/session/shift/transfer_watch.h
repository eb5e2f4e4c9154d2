// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/library/library_service.h"
#include "core/session/shift/transfer_look.h"

#include <optional>
#include <vector>

namespace gripscope {

/// Looks at a transfer while its squeezes are made, and at one of an earlier run of the program: each
/// recording is read from the library and identified once, in the thread pool, one after another; after the
/// last the transfer is looked at anew. Taken back, a squeeze counts no longer.
class TransferWatch {
public:
    explicit TransferWatch(LibraryService& library) : m_library(library) {}

    void setIdentificationOptions(const IdentificationOptions& options) { m_options = options; }
    /// The study as it is now; another one than before begins anew. The types are read once a study.
    void follow(const KeptStudy& study);
    void forget(); ///< no study is looked at
    bool poll();   ///< true when there is a new look, or an error

    [[nodiscard]] bool busy() const; ///< squeezes are still to be looked at
    /// Of the last look; nothing before the first.
    [[nodiscard]] const std::optional<TransferLook>& look() const { return m_look; }
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }

private:
    struct Wanted {
        QString measurementId, type, squeezeId;
    };
    struct Known {
        QString measurementId;
        std::optional<TypeSqueeze> squeeze; ///< nothing: not valid
    };
    void loadModels();
    void next();
    void take(const Wanted& wanted, Expected<Recording> recording);
    [[nodiscard]] const Known* known(const QString& measurementId) const;
    void lookAgain();

    LibraryService& m_library;
    IdentificationOptions m_options;
    QString m_study;
    QStringList m_planned;
    std::vector<Wanted> m_wanted; ///< those that count, in their order
    std::vector<Known> m_known;
    std::optional<TypeModels> m_models;
    PendingCall m_loading, m_reading, m_identifying, m_looking;
    bool m_changed = false;
    std::optional<TransferLook> m_look;
    std::optional<Error> m_error;
};

} // namespace gripscope
