// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/inspect_tour.h"

#include "ui/tour_script.h"
#include "ui/workbench.h"

using namespace Qt::StringLiterals;

namespace gripscope {

void addInspections(TourScript& tour, Workbench& workbench, const std::function<void()>& expect,
                    const std::function<void()>& squeeze)
{
    const auto inspect = [&tour, &workbench, squeeze](int times) {
        for (int i = 0; i < times; ++i)
            tour.add(squeeze, [&workbench, squeeze] {
                const InspectSession& session = workbench.inspection();
                if (session.state() != InspectSession::State::Ready)
                    return false;
                // A busy machine may have starved the gripper's heartbeat: as a person would, once more.
                if (!session.result() && !workbench.connection().armed())
                    workbench.arm();
                else if (!session.result())
                    squeeze();
                return session.result() && session.result()->number != 0;
            });
    };
    tour.add(expect, [&workbench] { return workbench.inspection().state() == InspectSession::State::Ready; });
    tour.connectTo(workbench, u"virtual:?object=A&seed=21"_s);
    inspect(3);
    tour.connectTo(workbench, u"virtual:?object=B&seed=22"_s);
    inspect(1);
    // A can that nobody enrolled: between the others in stiffness, with a damping of its own.
    tour.connectTo(workbench, u"virtual:?object=0.05,80,7000&seed=23"_s);
    inspect(1);
    tour.connectTo(workbench, u"virtual:?object=A&seed=24"_s);
    inspect(1);
    tour.wait(300);
}

} // namespace gripscope
