// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/research/recognition_scenario.h"

#include <functional>
#include <optional>
#include <vector>

namespace gripscope {

struct RecognitionStudyOptions {
    int runs = 2000; ///< enrolments a row; a tenth of it, of 200 squeezes each, for the identified row
    std::uint64_t seed = 1;
    int threads = 0; ///< 0: as many as the machine has; no figure depends on it
    std::function<void(int done, int rows)> progress;
};

/// A figure of a row and what it is held to; absent sides are open, and without any it is only shown.
struct StudyLimit {
    QString figure; ///< in words: "unknown / stated"
    double value = 0, standardError = 0;
    std::optional<double> least, most;
    [[nodiscard]] bool met() const;
};

struct RecognitionRow {
    RecognitionScenario scenario;
    StudyTally tally;
    std::vector<StudyLimit> limits; ///< empty: shown, not bounded
};

/// The paper's appendix, 40 squeezes of 4 types.
struct PaperRecognition {
    int squeezes = 0;
    int leaveOneOutCorrect = 0; ///< named as themselves by models that have not seen them
    int leftOutTypeUnknown = 0; ///< called unknown by models without their type
    int rejectedInTraining = 0; ///< called unknown by models fitted to them
};

struct RecognitionStudy {
    std::vector<RecognitionRow> rows;
    PaperRecognition paper;
};

/// One row, `options.runs` enrolments of it.
[[nodiscard]] RecognitionRow studyRow(const RecognitionScenario& scenario,
                                      const RecognitionStudyOptions& options);
/// What rates are stated and what rates are found, over fresh enrolments. A run's numbers depend on the seed,
/// the row's name and the run alone.
[[nodiscard]] RecognitionStudy studyRecognition(const RecognitionStudyOptions& options);

} // namespace gripscope
