// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/shared/example_types_button.h"

#include "ui/context/workbench.h"
#include "ui/people/authorize.h"

namespace gripscope {

ExampleTypesButton::ExampleTypesButton(Workbench& workbench, QWidget* parent)
    : QPushButton(tr("Load four example types"), parent)
{
    setObjectName("loadExampleTypes");
    setProperty("large", true);
    setAccessibleName(text());
    setToolTip(
        tr("The four cans of the paper, ten squeezes each; retire them when they are no longer wanted"));
    const auto refresh = [this, &workbench] {
        const InspectSession& inspection = workbench.inspection();
        setVisible(inspection.state() != InspectSession::State::Loading && inspection.types().empty());
    };
    connect(&workbench, &Workbench::inspectionChanged, this, refresh);
    connect(this, &QPushButton::clicked, this, [this, &workbench] {
        authorize(workbench, this, Permission::ApproveTypes, [&workbench] { loadExampleTypes(workbench); });
    });
    refresh();
}

void loadExampleTypes(Workbench& workbench)
{
    workbench.background().ask<void>(
        &workbench, [](Library& library) { return library.loadExampleTypes(); },
        [&workbench](const Expected<void>& done) {
            if (done)
                workbench.tellLibraryChanged();
            else
                workbench.messages().report(done.error().describe());
        });
}

} // namespace gripscope
