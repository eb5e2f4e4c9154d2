// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

class QObject;

namespace gripscope {

/// Rung on any thread, answered on the screen's: soon, and once for all that rang meanwhile. A button may
/// outlive the bell; then it does nothing.
class Doorbell {
public:
    /// `answer` runs on the thread of `owner`, which outlives this.
    Doorbell(QObject* owner, std::function<void()> answer);
    ~Doorbell();
    Doorbell(const Doorbell&) = delete;
    Doorbell& operator=(const Doorbell&) = delete;

    [[nodiscard]] std::function<void()> button() const;

private:
    struct Wire;
    std::shared_ptr<Wire> m_wire;
};

} // namespace gripscope
