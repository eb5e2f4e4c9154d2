// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/identification.h"
#include "core/session/pool_task.h"

namespace gripscope {

/// identify() in the thread pool, on a copy of its own.
class IdentificationTask : public PoolTask<Identification> {
public:
    void start(Recording recording, IdentificationOptions options)
    {
        PoolTask::start([recording = std::move(recording), options = std::move(options)] {
            return identify(recording, options);
        });
    }
};

} // namespace gripscope
