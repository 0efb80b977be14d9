# SPDX-License-Identifier: Apache-2.0
# A record as a data frame: Rscript read_record.R FOLDER_OR_RECORD
# Prints the mean over views of each variant's frame time, fetches a pixel and SSIM. Needs jsonlite (Debian: r-cran-jsonlite).
library(jsonlite)

path <- commandArgs(trailingOnly = TRUE)[1]
if (dir.exists(path)) path <- file.path(path, "record.jsonl")
lines <- lapply(readLines(path, warn = FALSE), fromJSON, simplifyVector = FALSE)
run <- lines[[1]]
cat(sprintf("%s: lamina %s, commit %s, build %s\n", run$command, run$lamina, run$commit, run$build))

or_na <- function(value) if (is.null(value)) NA else value
cells <- do.call(rbind, lapply(Filter(function(line) line$kind == "cell" && line$status == "ok", lines), function(cell) {
  data.frame(effect = cell$effect, variant = cell$variant, backend = cell$backend, view = cell$view,
             median_ms = or_na(cell$median_ms), fetches_per_pixel = or_na(cell$fetches_per_pixel),
             ssim = or_na(cell$error$baseline$ssim))
}))
if (is.null(cells)) stop(path, ": holds no cells")
print(aggregate(cells[c("median_ms", "fetches_per_pixel", "ssim")], cells[c("effect", "variant", "backend")], mean), digits = 4,
      row.names = FALSE)
