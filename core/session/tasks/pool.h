// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/pending.h"
#include "core/base/vector_registers.h"

#include <QThreadPool>

#include <type_traits>
#include <utility>

namespace gripscope {

/// Runs `work`, which owns all that it reads, in a thread pool: the sessions' own one, which nothing long may
/// hold up, unless another is named.
template <typename Work>
[[nodiscard]] auto inPool(Work work, QThreadPool& pool = *QThreadPool::globalInstance())
    -> Pending<std::invoke_result_t<Work>>
{
    const Promise<std::invoke_result_t<Work>> answer;
    pool.start([answer, work = std::move(work)] {
        releaseVectorRegisters();
        answer.give(work());
    });
    return answer.pending();
}

} // namespace gripscope
