// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

namespace gripscope::test {

/// What went wrong, or nothing. `QVERIFY2(file, qPrintable(whyNot(file)))`: Qt Test works out the message of
/// a check that holds too, so a message must not ask a good result for its error.
template <typename T>
[[nodiscard]] QString whyNot(const Expected<T>& result)
{
    const Error* error = detail::errorOf(result);
    return error ? error->describe() : QString();
}
[[nodiscard]] inline QString whyNot(const std::optional<Error>& problem)
{
    return problem ? problem->describe() : QString();
}

} // namespace gripscope::test
