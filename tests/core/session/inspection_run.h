// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/enroll/enrollment_storage.h"
#include "core/session/inspect/inspect_session.h"
#include "tests/core/session/session_driver.h"
#include "tests/core/session/session_recordings.h"

#include <QTest>

#include <utility>
#include <vector>

namespace gripscope::test {

/// Inspections on a fake gripper with a library of their own.
struct InspectionRun {
    explicit InspectionRun(const QString& file) : library(file), inspection(connection.session, library) {}
    ArmedConnection connection;
    LibraryService library;
    InspectSession inspection;

    bool until(const std::function<bool()>& done)
    {
        return pollUntil(
            [this] {
                connection.session.poll();
                inspection.poll();
            },
            done);
    }
    bool ready()
    {
        return until(
            [this] { return inspection.state() == InspectSession::State::Ready && !inspection.storing(); });
    }
};

/// Types with so many squeezes each, enrolled and approved without a session.
inline void enrolTypes(const QString& file,
                       const std::vector<std::pair<QString, MassDampingStiffness>>& types,
                       std::uint64_t squeezes)
{
    std::unique_ptr<Library> library = std::move(*Library::open(file));
    for (const auto& type : types) {
        QString typeId;
        for (std::uint64_t seed = 1; seed <= squeezes; ++seed) {
            const Recording recording = scatteredSqueezeOf(type.second, seed);
            const NewGrasp grasp = makeGrasp(recording, identify(recording), QStringLiteral("file.csv"), {});
            const Expected<StoredSqueeze> stored = storeSqueeze(*library, {type.first, {}, grasp});
            QVERIFY(stored.has_value());
            typeId = stored->type.id;
        }
        QVERIFY(library->approveType(typeId, {}));
    }
}

} // namespace gripscope::test
