// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/recognition/enrolment/enrollment_guidance.h"
#include "core/session/enroll/enroll_session.h"

#include <map>

namespace gripscope {

/// The squeezes of an enrolment as recognition takes them: all that advice is made of, a copy for the pool.
struct AdviceRequest {
    QString type;
    std::vector<TypeSqueeze> accepted;
    std::vector<int> rows; ///< their places among the squeezes of the session
    std::optional<TypeSqueeze> pending;
    int pendingRow = -1;
    bool siUnits = true;
    VerdictOptions rates; ///< that verdicts are held to
    friend bool operator==(const AdviceRequest&, const AdviceRequest&);
};
[[nodiscard]] AdviceRequest adviceRequest(const QString& type, const std::vector<EnrollSqueeze>& squeezes,
                                          const VerdictOptions& rates);

/// While squeezes come in.
struct EnrollmentAdvice {
    EnrollmentProgress progress;            ///< of the accepted ones
    std::map<int, SqueezeOutlier> outliers; ///< by row, the pending squeeze too
};
/// `library`: all enrolled squeezes; those of this type are taken from the request. Takes up to a second with
/// many squeezes: for the pool.
[[nodiscard]] EnrollmentAdvice advise(const AdviceRequest& request, const std::vector<TypeSqueeze>& library);

/// Before approval.
struct EnrollmentReview {
    EnrollmentAdvice advice;
    std::optional<TypeOverlap> overlap;
    HeldOutConfusion confusion;
    /// Scatter of this library's parts and grips in stiffness (one standard deviation, a share); where parts
    /// were squeezed again.
    std::optional<double> partDeviation, regripDeviation;
};
[[nodiscard]] EnrollmentReview reviewEnrollment(const AdviceRequest& request,
                                                const std::vector<TypeSqueeze>& library);

} // namespace gripscope
