// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output.h"
#include "app/cli/recognition_study_text.h"
#include "app/cli/study_commands.h"
#include "core/recognition/recognition_study_json.h"

namespace gripscope::cli {

using namespace Qt::StringLiterals;

int runRecognitionStudy(const QStringList& arguments)
{
    CommandLine line(u"study recognition"_qs,
                     u"Repeats enrolments and inspections of types with known scatter: the rates a verdict "
                     "states beside those that are found."_qs);
    RecognitionStudyOptions options;
    addStudyOptions(line, options.runs);
    if (const std::optional<int> exit = line.parse(arguments))
        return *exit;
    readStudyOptions(line, options);
    if (const std::optional<int> exit = line.finish())
        return *exit;
    options.progress = [](int done, int rows) { message(u"%1 of %2 rows"_qs.arg(done).arg(rows)); };
    const RecognitionStudy study = studyRecognition(options);
    if (line.isSet(u"json"_qs))
        printJson(toJson(study, options));
    else
        print(recognitionText(study));
    return 0;
}

} // namespace gripscope::cli
