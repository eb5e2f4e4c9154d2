// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/shared/example_types_button.h"

#include "core/session/enroll/simulated_examples.h"
#include "ui/context/workbench.h"
#include "ui/people/authorize.h"

namespace gripscope {

namespace {

void store(Workbench& workbench, std::function<Expected<void>(Library&)> work)
{
    workbench.background().ask<void>(&workbench, std::move(work), [&workbench](const Expected<void>& done) {
        if (done)
            workbench.tellLibraryChanged();
        else
            workbench.messages().report(done.error().describe());
    });
}

} // namespace

ExampleTypesButton::ExampleTypesButton(Workbench& workbench, Examples examples, QWidget* parent)
    : QPushButton(parent)
{
    const bool cans = examples == Examples::Cans;
    setObjectName(cans ? "loadExampleTypes" : "loadSimulatedTypes");
    setText(cans ? tr("Load four example types") : tr("Load plastics, foams and fruit"));
    setProperty("large", true);
    setAccessibleName(text());
    setToolTip(
        cans ? tr("The four cans of the paper, ten squeezes each; retire them when they are no longer wanted")
             : tr("Six simulated parts that go on yielding, six squeezes each; a virtual gripper can hold "
                  "them"));
    const auto refresh = [this, &workbench] {
        const InspectSession& inspection = workbench.inspection();
        setVisible(inspection.state() != InspectSession::State::Loading && inspection.types().empty());
        setEnabled(true);
    };
    connect(&workbench, &Workbench::inspectionChanged, this, refresh);
    connect(this, &QPushButton::clicked, this, [this, &workbench, examples] {
        authorize(workbench, this, Permission::ApproveTypes, [this, &workbench, examples] {
            setEnabled(false); // until they are there
            loadExampleTypes(workbench, examples);
        });
    });
    refresh();
}

void loadExampleTypes(Workbench& workbench, Examples examples)
{
    if (examples == Examples::Cans) {
        store(workbench, [](Library& library) { return library.loadExampleTypes(); });
        return;
    }
    workbench.background().compute<std::vector<ExampleType>>(
        &workbench, [] { return simulatedExamples(); },
        [&workbench](const std::vector<ExampleType>& types) {
            store(workbench, [types](Library& library) { return library.loadExampleTypes(types); });
        });
}

} // namespace gripscope
