// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/people/acting.h"

#include <QElapsedTimer>
#include <QObject>

#include <chrono>
#include <functional>
#include <vector>

namespace gripscope {

class Secret;
class Workbench;

/// Who has signed in at this window, and who could. What is allowed is decided by the library, with every
/// change; this only knows whether to ask first. Signs out by itself when nobody has touched anything for a
/// while and nothing was squeezed.
class SignIn : public QObject {
    Q_OBJECT
public:
    explicit SignIn(Workbench& bench);

    /// Roles are in force: there are people in the library.
    [[nodiscard]] bool inForce() const { return !m_known.people.empty(); }
    [[nodiscard]] bool known() const { return m_read; } ///< the library was read once
    [[nodiscard]] const std::vector<Person>& people() const { return m_known.people; }
    [[nodiscard]] const std::optional<Authority>& current() const { return m_current; }
    /// Whether the library will allow it without somebody else's consent, as far as is known here.
    [[nodiscard]] bool may(Permission permission) const;
    [[nodiscard]] ArmingPolicy arming() const { return m_known.arming; }       ///< who may arm the gripper
    [[nodiscard]] ApprovalPolicy approval() const { return m_known.approval; } ///< who may approve a type
    /// Reads the people and the policies again.
    void reload();

    /// `done` has the reason why not, in words; nothing when it is done.
    using Done = std::function<void(const std::optional<QString>& problem)>;
    void signIn(QObject* context, const QString& personId, Secret secret, Done done);
    void signOut(bool idle = false);
    void authorise(QObject* context, const QString& personId, Secret secret, Permission permission,
                   std::function<void(Expected<Grant>)> done);
    /// Whatever `action` asks the library for has this consent.
    void withGrant(const Grant& grant, const std::function<void()>& action);

    /// Zero: never. From the settings, until it is set here.
    void setIdleLimit(std::chrono::milliseconds limit) { m_idleLimit = limit; }

signals:
    void changed(); ///< who has signed in, or who could

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void apply(std::optional<Grant> grant = std::nullopt);
    /// What the library says.
    struct Known {
        std::vector<Person> people;
        ArmingPolicy arming = ArmingPolicy::SignedIn;
        ApprovalPolicy approval = ApprovalPolicy::OnePerson;
        friend bool operator==(const Known&, const Known&) = default;
    };
    void take(Known known);
    void checkIdle();
    Workbench* m_bench;
    Known m_known;
    bool m_read = false;
    std::optional<Authority> m_current;
    std::chrono::milliseconds m_idleLimit{};
    QElapsedTimer m_sinceUse;
};

/// Calls `arm` where the one who works here may arm the connected gripper, by the policy of the library, and
/// tells its audit trail. Whom nobody knows is asked to sign in, and has to ask for it again then; who may
/// not, for a supervisor's consent. Where people are, it is told first and armed then; where none are, nobody
/// could refuse, and it need not wait for the disk. The questions are shown over the window in front; where
/// none is shown nobody is asked, and nothing is armed that somebody would have to allow.
void authorizeArming(Workbench& bench, std::function<void()> arm);

} // namespace gripscope
