// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/virtual/virtual_load.h"

#include <atomic>

namespace gripscope::virtual_load {

namespace {
std::atomic<double> current_N{0};
}

void set(double load_N)
{
    current_N = load_N;
}

double load_N()
{
    return current_N.load(std::memory_order_relaxed);
}

} // namespace gripscope::virtual_load
