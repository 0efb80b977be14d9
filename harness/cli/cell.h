// SPDX-License-Identifier: Apache-2.0
// One cell, filled in step by step: what is known before it runs, what its counting build counted, the errors of its picture,
// its times. For every command that leaves cells.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/cli/common.h"
#include "harness/graph/frame.h"
#include "harness/record/record.h"

namespace lamina {

// Difference pictures are |test - baseline| of display values times this; records and reports state it.
inline constexpr double difference_gain = 4;

CellRow blank_row(const std::string& backend, const std::string& device, const Scene& scene, const Library& library,
                  const View& view, const VariantManifest& variant, const CellOptions& options);
void fail(CellRow& row, const std::string& reason);
// Does a variant's work unless it has failed before; what the work throws becomes its failure, and that of its rows. The one
// place where a variant's failure is caught: the others go on. Returns whether the variant is still well.
bool attempt(std::string& failure, std::vector<CellRow>& rows, const std::function<void()>& work);
// A row that cannot be written as measured (a number that is none) becomes a failed one; the others go on.
void append_row(RecordWriter& record, const CellRow& row);

// Runs a frame of the counting build, whose once_counts() are `once`, and puts what it executed into the row. Returns the
// pixels that the variant's effect covers.
Mask count_cell(CellRow& row, Frame& counting, const std::vector<PassCounts>& once, const VariantManifest& variant,
                size_t view);

// Takes a picture, whose file's name ends in `suffix`, and returns its path for the record. Empty: pictures are not kept, nor
// made.
using KeepPicture = std::function<std::string(const std::string& suffix, const DisplayImage& image)>;
// The name of a cell's picture, "" of its own, made of what identifies the cell within a record of one point.
std::string picture_name(const CellRow& row, const std::string& suffix);

// The picture itself: its hash, its range over `covered`, its non-finite pixels, shown in magenta.
void fill_picture(CellRow& row, const Image& picture, const Mask& covered, const KeepPicture& keep);
// Its errors against the baseline's picture, over `covered` and the frame. None where either has a pixel that is not finite, or
// the effect covers nothing.
void fill_errors(CellRow& row, const Image& picture, const Image& baseline, const Mask& covered, const KeepPicture& keep);
// The same of a report that is there.
void fill_errors(CellRow& row, const ErrorReport& report, const Image& picture, const Image& baseline, const KeepPicture& keep);
// Those of a row of the same picture, pixels and baseline: its figures, and its pictures of the difference where they lie.
void copy_errors(CellRow& row, const CellRow& same);
Mask either(const Mask& a, const Mask& b);
uint64_t count_on(const Mask& mask);  // its pixels

// A pass that repeats until nothing is left, and was stopped before: said, for nothing in the picture shows it.
void note_unfinished(CellRow& row, const Frame& frame, size_t view);

}  // namespace lamina
