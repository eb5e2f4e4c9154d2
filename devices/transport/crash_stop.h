// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/protocol/report.h"

namespace gripscope {

/// A report that is written when the program crashes (a fault of memory or arithmetic, an abort): by a
/// handler of its own stack that takes no lock and no memory, to a descriptor of its own. What ends a program
/// without any signal to it (kill -9, the power) is left to the gripper's watchdog.
///
/// `descriptor` belongs to the caller and must outlive this. A write may block as long as the system lets it.
class CrashStop {
public:
    CrashStop() = default;
    CrashStop(int descriptor, const protocol::Report& report);
    CrashStop(CrashStop&& other) noexcept;
    CrashStop& operator=(CrashStop&& other) noexcept;
    ~CrashStop();

    /// At the start of a program, once. The signals' former actions follow behind it.
    static void installHandler();
    /// For a thread of its own, so that one that used up its stack can still stop the gripper.
    class Stack {
    public:
        Stack();
        ~Stack();
        Stack(const Stack&) = delete;
        Stack& operator=(const Stack&) = delete;

    private:
        void* m_memory = nullptr;
    };

private:
    int m_place = -1; ///< in the handler's table; -1: none
};

} // namespace gripscope
