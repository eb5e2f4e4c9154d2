// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/acquisition/device_port.h"
#include "devices/emergency/end_signals.h"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <map>
#include <optional>
#include <poll.h>
#include <thread>
#include <unistd.h>

namespace gripscope {

namespace {

constexpr int mayTake_ms = 3000;
constexpr std::uint8_t noSignal = 0; ///< ends the thread

std::array<int, 2> pipeEnds{-1, -1};

void note(int signal)
{
    const auto byte = static_cast<std::uint8_t>(signal);
    static_cast<void>(!write(pipeEnds[1], &byte, 1));
}

/// The next signal; noSignal when the program ends by itself; nothing within `atMost_ms` (below 0: no limit).
std::optional<std::uint8_t> nextSignal(int atMost_ms)
{
    pollfd wait{pipeEnds[0], POLLIN, 0};
    std::uint8_t byte = noSignal;
    while (poll(&wait, 1, atMost_ms) < 0) {
    }
    if (!(wait.revents & POLLIN))
        return {};
    return read(pipeEnds[0], &byte, 1) == 1 ? byte : noSignal;
}

} // namespace

struct EndSignals::Private {
    std::map<int, struct sigaction> former;
    std::thread thread;
};

EndSignals::EndSignals(std::function<void()> then) : d(std::make_unique<Private>())
{
    if (pipe2(pipeEnds.data(), O_CLOEXEC) != 0)
        return;
    d->thread = std::thread([then = std::move(then)] {
        const std::uint8_t first = nextSignal(-1).value_or(noSignal);
        if (first == noSignal)
            return;
        stopOpenLinks();
        then();
        if (nextSignal(mayTake_ms) == noSignal)
            return;
        stopOpenLinks();
        constexpr int byASignal = 128;
        _exit(byASignal + first);
    });
    struct sigaction action = {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        sigaction(signal, &action, &d->former[signal]);
}

EndSignals::~EndSignals()
{
    for (const auto& [signal, action] : d->former)
        sigaction(signal, &action, nullptr);
    if (d->thread.joinable()) {
        note(noSignal);
        d->thread.join();
    }
    for (int& end : pipeEnds) {
        close(end);
        end = -1;
    }
}

} // namespace gripscope
