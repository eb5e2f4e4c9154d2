# SPDX-License-Identifier: GPL-3.0-or-later
# Variance components of tables with the columns part, operator and value by lme4 (restricted likelihood), a line a table:
#   FILE part operator part_operator repeatability
# Usage: Rscript gauge_reml.R TABLE.csv...    (apt-get install r-cran-lme4)
# GaugePeerTest writes ten unbalanced tables and compares.
suppressPackageStartupMessages(library(lme4))
control <- lmerControl(optimizer = "bobyqa", optCtrl = list(rhobeg = 0.1, rhoend = 1e-9, maxfun = 1e5),
                       check.conv.singular = "ignore", check.conv.grad = "ignore", check.conv.hess = "ignore")
for (file in commandArgs(trailingOnly = TRUE)) {
  table <- read.csv(file, colClasses = c(part = "factor", operator = "factor"))
  fit <- lmer(value ~ 1 + (1 | part) + (1 | operator) + (1 | part:operator), data = table, REML = TRUE, control = control)
  parts <- as.data.frame(VarCorr(fit))
  of <- function(group) parts$vcov[parts$grp == group]
  cat(file, sprintf("%.12g", c(of("part"), of("operator"), of("part:operator"), of("Residual"))), "\n")
}
