// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/enroll/enroll_session.h"
#include "tests/core/session/session_driver.h"

namespace gripscope::test {

/// One program run: a library on the disk, a gripper, an enrolment.
struct EnrollmentRun {
    explicit EnrollmentRun(const QString& file) : library(file), enrollment(connection.session, library) {}
    ArmedConnection connection;
    LibraryService library;
    EnrollSession enrollment;

    bool waitFor(EnrollSession::Activity activity)
    {
        return pollUntil(
            [this] {
                connection.session.poll();
                enrollment.poll();
            },
            [&] { return enrollment.activity() == activity; });
    }
    bool begin(const QString& name)
    {
        return enrollment.setName(name) && enrollment.setRecipe({}) &&
               waitFor(EnrollSession::Activity::Waiting) && enrollment.step() == EnrollSession::Step::Squeeze;
    }
    template <typename T>
    T ask(std::function<Expected<T>(Library&)> work)
    {
        return library.run<T>(std::move(work)).get().value();
    }
    std::vector<TypeRecord> types()
    {
        return ask<std::vector<TypeRecord>>([](Library& l) { return l.types(); });
    }
};

} // namespace gripscope::test
