# SPDX-License-Identifier: GPL-3.0-or-later
# Average run lengths by R's package spc (Knoth), one a line: chart,first,second,shift,limits,points. By hand:
# Rscript tests/peers/run_lengths.R (Debian: apt-get install r-cran-spc). RunLengthPeerTest holds its own against them.
suppressWarnings(suppressMessages(library(spc)))
tell <- function(chart, first, second, shift, limits, points)
  cat(sprintf("%s,%g,%g,%g,%s,%.10g\n", chart, first, second, shift, limits, points))
for (shift in c(0, 0.5, 1, 2)) {
  for (design in list(c(0.5, 5), c(0.5, 4), c(0.25, 8), c(1, 2.5)))
    tell("cusum", design[1], design[2], shift, "fixed",
         xcusum.arl(design[1], design[2], shift, sided = "two", r = 80))
  for (design in list(c(0.1, 2.703), c(0.1, 2.814), c(0.2, 3), c(0.05, 2.615), c(0.4, 3.054)))
    for (limits in c("fix", "vacl"))
      tell("ewma", design[1], design[2], shift, limits,
           xewma.arl(design[1], design[2], shift, sided = "two", limits = limits, r = 80))
}
