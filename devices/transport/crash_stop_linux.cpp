// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/transport/crash_stop.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <unistd.h>
#include <utility>

namespace gripscope {

namespace {

enum class Use : int { Free, BeingFilled, Ready };

struct Place {
    std::atomic<Use> use{Use::Free};
    int descriptor = -1;
    protocol::Report report{};
};
static_assert(std::atomic<Use>::is_always_lock_free, "a signal handler may take no lock");

std::array<Place, 16> places; // grippers of one program; more are not protected
constexpr std::array fatal{SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGSYS};
std::array<struct sigaction, 65> formerActions;

// The handler itself: write() and sigaction() are safe in one.
void stopAndGoOn(int signal)
{
    constexpr int times = 3; // as a Stop by hand is sent
    for (int i = 0; i < times; ++i)
        for (const Place& place : places)
            if (place.use.load() == Use::Ready)
                static_cast<void>(!write(place.descriptor, place.report.data(), place.report.size()));
    sigaction(signal, &formerActions[static_cast<std::size_t>(signal)], nullptr);
    raise(signal); // comes when this handler has returned
}

constexpr std::size_t stackSize = std::size_t(64) * 1024;

} // namespace

CrashStop::CrashStop(int descriptor, const protocol::Report& report)
{
    for (std::size_t i = 0; i < places.size(); ++i) {
        Use expected = Use::Free;
        if (!places[i].use.compare_exchange_strong(expected, Use::BeingFilled))
            continue;
        places[i].descriptor = descriptor;
        places[i].report = report;
        places[i].use = Use::Ready;
        m_place = static_cast<int>(i);
        return;
    }
}

CrashStop::CrashStop(CrashStop&& other) noexcept : m_place(std::exchange(other.m_place, -1)) {}

CrashStop& CrashStop::operator=(CrashStop&& other) noexcept
{
    std::swap(m_place, other.m_place);
    return *this;
}

CrashStop::~CrashStop()
{
    if (m_place >= 0)
        places[static_cast<std::size_t>(m_place)].use = Use::Free;
}

void CrashStop::installHandler()
{
    static const Stack ofTheMainThread;
    struct sigaction action = {};
    action.sa_handler = stopAndGoOn;
    action.sa_flags = SA_ONSTACK;
    sigemptyset(&action.sa_mask);
    for (const int signal : fatal)
        sigaction(signal, &action, &formerActions[static_cast<std::size_t>(signal)]);
}

CrashStop::Stack::Stack() : m_memory(std::malloc(stackSize))
{
    if (!m_memory)
        return;
    stack_t stack = {};
    stack.ss_sp = m_memory;
    stack.ss_size = stackSize;
    sigaltstack(&stack, nullptr);
}

CrashStop::Stack::~Stack()
{
    stack_t none = {};
    none.ss_flags = SS_DISABLE;
    sigaltstack(&none, nullptr);
    std::free(m_memory);
}

} // namespace gripscope
