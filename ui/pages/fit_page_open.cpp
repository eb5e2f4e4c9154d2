// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/fit_page_open.h"

#include "ui/workbench.h"

namespace gripscope {

void openStoredSqueeze(Workbench& workbench, QObject* context, const QString& graspId, const QString& title)
{
    Workbench* bench = &workbench;
    workbench.ask<Recording>(
        context, [graspId](Library& library) { return library.recording(graspId); },
        [bench, context, title](Expected<Recording> recording) {
            if (!recording) {
                bench->report(recording.error().describe());
                return;
            }
            bench->compute<FitSubject>(
                context,
                [recording = std::move(*recording), title]() -> FitSubject {
                    Identification identification = identify(recording);
                    return {title, recording, std::move(identification)};
                },
                [bench](FitSubject subject) { bench->showInFit(std::move(subject)); });
        });
}

} // namespace gripscope
