// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/calibrate/measuring_sessions.h"
#include "ui/pages/shared/guided_squeezes.h"

#include <QWidget>

class QVBoxLayout;

namespace gripscope {

class EnrollRecipeForm;
class Workbench;

/// One thing that a gripper is characterised by: what to put between the fingers, the squeezes, what came out
/// and whether to use it.
class GripperStep : public QWidget {
    Q_OBJECT
public:
    [[nodiscard]] GuidedSqueezes* guide() const { return m_guide; }
    void act(); ///< what Space does
    /// Squeezes are, or a person looks at what they found and has not taken it yet.
    [[nodiscard]] bool underWay() const;
    [[nodiscard]] SeriesSession::State state() const { return m_session->state(); }
    [[nodiscard]] bool busy() const { return m_session->busy(); }

signals:
    void changed(); ///< the session did

protected:
    GripperStep(Workbench& bench, SeriesSession& session, QWidget* parent);
    /// What to do, the forces where they can be chosen, and the squeezes.
    void build(const QString& what, GuidedSqueezes::Script script);
    EnrollRecipeForm* addForces(); ///< before build(); changed forces are looked at by Script::obstacle
    [[nodiscard]] Workbench& bench() const { return *m_bench; }
    [[nodiscard]] QString serial() const; ///< of the connected gripper
    /// Why nothing was found; empty where nothing is wrong.
    [[nodiscard]] static QString refused(const QString& problem);

private:
    Workbench* m_bench;
    SeriesSession* m_session;
    EnrollRecipeForm* m_forces = nullptr;
    GuidedSqueezes* m_guide = nullptr;
    std::function<bool()> m_usable;
};

/// Squeezes of nothing: m, b, k and friction of the gripper itself.
class EmptyGripperStep : public GripperStep {
    Q_OBJECT
public:
    explicit EmptyGripperStep(Workbench& bench, QWidget* parent = nullptr);
    [[nodiscard]] BaselineSession& session() { return m_session; }

private:
    [[nodiscard]] QString found() const;
    [[nodiscard]] QString outcome() const;

    BaselineSession m_session;
};

/// Squeezes of a rigid block: how far frame and fingers give way.
class FrameStep : public GripperStep {
    Q_OBJECT
public:
    explicit FrameStep(Workbench& bench, QWidget* parent = nullptr);

private:
    [[nodiscard]] QString found() const;
    [[nodiscard]] QString outcome() const;

    FrameSession m_session;
};

/// Squeezes of something firm: how much later the position is sampled than the force.
class LagStep : public GripperStep {
    Q_OBJECT
public:
    explicit LagStep(Workbench& bench, QWidget* parent = nullptr);

private:
    [[nodiscard]] QString found() const;
    [[nodiscard]] QString outcome() const;

    LagSession m_session;
    Recipe m_recipe;
};

} // namespace gripscope
