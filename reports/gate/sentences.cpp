// SPDX-License-Identifier: Apache-2.0
#include "reports/gate/sentences.h"

#include <fmt/format.h>

#include <limits>

#include "reports/gate/reading.h"

namespace lamina {
namespace {

// A record has null for what is infinite.
double value_of(const std::optional<double>& figure) { return figure.value_or(std::numeric_limits<double>::infinity()); }

// The ratio with its interval and margin.
std::string ratio_words(const VerdictRow& row) {
  const Interval ratio = row.ratio.value_or(Interval{});
  return fmt::format("{} [{}, {}], margin {:.1f}%", percent(ratio.median), percent(ratio.low), percent(ratio.high),
                     row.limit.value_or(0) * 100);
}

// `verdict`: on the figures alone.
std::string time_words(const VerdictRow& row, std::string_view verdict) {
  const char* words = verdict == "slower"   ? "is slower"
                      : verdict == "faster" ? "is faster"
                      : verdict == "same"   ? "takes as long as before"
                                            : "may or may not take as long as before";
  return fmt::format("{} on {}: {} {}: {}", row.variant, row.backend, row.pass.empty() ? "the frame" : "pass " + row.pass,
                     words, ratio_words(row));
}

std::string operation_words(const VerdictRow& row) {
  bool more = false, fewer = false;
  std::string words;
  for (const OperationChange& change : row.operations) {
    (change.after > change.before ? more : fewer) = true;
    words += fmt::format("{}{} {:.0f}, was {:.0f}", words.empty() ? "" : "; ", change.operation, change.after, change.before);
  }
  return fmt::format("pass {} executes {} operations: {}{}", row.pass,
                     more && fewer ? "other"
                     : more        ? "more"
                                   : "fewer",
                     words, row.verdict == Verdict::not_compared ? "; which of them cost more is for times to say" : "");
}

std::string figure_words(const VerdictRow& row) {
  if (row.what == "operations") return operation_words(row);
  if (row.what == "fetches" || row.what == "fragments" || row.what == "vertices")
    return fmt::format("pass {} makes {:.0f} {}{} where it made {:.0f}", row.pass, value_of(row.after),
                       row.what == "fetches" ? "fetches" : "invocations of its " + row.what,
                       row.texture.empty() ? "" : " of " + row.texture, value_of(row.before));
  return fmt::format("{} went from {:.6g} to {:.6g}", row.what, value_of(row.before), value_of(row.after));
}

// What the gate file bounds of a frame.
std::string work_words(const std::string& what) { return what == "target_bytes" ? "bytes of targets and buffers" : what; }

std::string bound_words(const VerdictRow& row) {
  const double now = value_of(row.after), bound = value_of(row.limit);
  if (row.what == "fetches" || row.what == "operations" || row.what == "target_bytes")
    return fmt::format("the frame {} {:.0f} {}, the gate file allows {:.0f}", row.what == "target_bytes" ? "takes" : "makes",
                       now, work_words(row.what), bound);
  return fmt::format("{} is {:.6g}, the gate file asks for {} {:.6g}", row.what, now, now < bound ? "at least" : "at most",
                     bound);
}

std::string change_words(const VerdictRow& row) {
  return "the picture changed" +
         (row.after ? fmt::format(" by up to {:.4g} in linear light", *row.after) : std::string(", as its hash did"));
}

// Why, for what the row is about: "light_map on vulkan, view front".
std::string words_for_cause(const VerdictRow& row) {
  const auto detail = [&](size_t i) { return i < row.details.size() ? row.details[i] : ""; };
  const auto side = [&](const char* before, const char* after) { return detail(0) == "before" ? before : after; };
  const std::string variant = fmt::format("{} on {}", row.variant, row.backend);
  const std::string cell = row.view.empty() ? variant : fmt::format("{}, view {}", variant, row.view);
  switch (*row.cause) {
    case Cause::figures:
      return row.ratio ? time_words(row, name_of(row.verdict)) : cell + ": " + figure_words(row);
    case Cause::against_record:
      return fmt::format("{}: {} {} against the record: {}", variant, row.pass.empty() ? row.what : "time of pass " + row.pass,
                         name_of(row.verdict == Verdict::time_open ? Verdict::ambiguous : row.verdict), ratio_words(row));
    case Cause::as_before:
      return fmt::format("{}: {} as before in {} views", cell, row.what, detail(0));
    case Cause::same_code:
      return cell + ": executes the same as before, so nothing can differ";
    case Cause::same_code_new_errors:
      return cell + ": executes the same as before, so only its errors, to what has changed, can differ";
    case Cause::new_variant:
      return cell + " is new: there is nothing to compare it with";
    case Cause::new_view:
      return cell + " is new, so there is nothing to compare it with";
    case Cause::failed_before:
      return cell + " could not be measured before, so there is nothing to compare it with";
    case Cause::gone:
      return cell + " is gone: it was there before";
    case Cause::cannot_be_measured:
      return cell + " cannot be measured: " + detail(0);
    case Cause::cannot_be_run:
      return cell + " cannot be run: " + detail(0);
    case Cause::not_measured:
      return cell + " was not measured";
    case Cause::process_failed:
      return row.backend + ": nothing could be measured: " + detail(0);
    case Cause::api_message:
      return row.backend + ": the API's checker says: " + detail(0);
    case Cause::certificate_holds:
      return row.backend + ": the timer's certificate holds";
    case Cause::certificate_failed:
      return fmt::format(
          "{}: the timer's certificate failed ({}), so no time is judged; run again on a quieter machine, "
          "or with a longer --budget",
          row.backend, detail(0));
    case Cause::error_lost:
      return fmt::format("{}: its error to the {} could be measured before, now it cannot", cell, detail(0));
    case Cause::beyond_bound:
      if (row.what == "frame_ms")
        return fmt::format("{}: the frame takes {:.4g} ms, the gate file allows {:.4g}", variant, value_of(row.after),
                           value_of(row.limit));
      return cell + ": " + bound_words(row);
    case Cause::not_counted:
      return fmt::format("{}: its {} were not counted, and the gate file bounds them", cell, work_words(row.what));
    case Cause::counted_once:
      return fmt::format("{}: the {} counted no operations, so they are not compared", cell,
                         side("state before", "newer state"));
    case Cause::not_finite:
      return fmt::format("{}: {:.0f} pixels are infinite or not a number", cell, value_of(row.after));
    case Cause::covers_nothing:
      return fmt::format("{}: the effect covers no pixel; before, it covered {}", cell, detail(0));
    case Cause::covers_nothing_anywhere:
      return cell + ": the effect covers no pixel in any view";
    case Cause::one_colour:
      return cell + ": the picture is blank: all pixels that the effect covers are of one colour";
    case Cause::another_hash:
      return cell + ": the picture's hash changed, and the gate file asks for the same picture";
    case Cause::baseline_changed:
      return fmt::format("{}: {}, and it is what other variants are held to", cell, change_words(row));
    case Cause::changed_for_nothing:
      return fmt::format("{}: {}, and no error got better by it", cell, change_words(row));
    case Cause::one_picture:
      return fmt::format("{}: views {} and {} show the same picture, which they did not before: a frame is not drawn again",
                         cell, detail(0), detail(1));
    case Cause::too_few_samples:
      return fmt::format("{}: {} {} has no times to compare ({} samples; {} are needed, and none may be 0)", variant,
                         side("the record's", "this run's"), row.pass.empty() ? "frame" : "pass " + row.pass, detail(1),
                         detail(2));
    case Cause::ratio_of_zero:
      return variant + ": a ratio to the baseline is 0, which is no measurement";
    case Cause::timed_once:
      return fmt::format("{}: only {} has times of view {}", variant, side("the record", "this run"), row.view);
    case Cause::another_machine:
      return fmt::format(
          "{}: times are compared as ratios to the baseline variant alone, since the record is from another machine: {}",
          row.backend, detail(0));
    case Cause::exact_failed:
      return "times were not measured, since counts or pictures fail the gate";
    case Cause::out_of_time:
      return fmt::format(
          "{}: no time was measured, since counts and pictures took the budget of {} s; two processes that time "
          "take about {} s more",
          variant, detail(0), detail(1));
    case Cause::stopped:
      return "stopped before everything was measured, so nothing is judged; the record holds what was measured";
    case Cause::arm_differs:
      return time_words(row, detail(0)) + "; but the A/A arm differs from itself in this run, so no time is believed";
  }
  return "";
}

// What counts add to a time.
std::string words_for_counts(const VerdictRow& row) {
  if (!row.counts_hold.value_or(false)) return "";
  if (row.verdict == Verdict::slower)
    return "; every count is equal or fewer, so access to memory, a format or the code's layout costs it";
  if (row.verdict != Verdict::time_open) return "";
  return fmt::format("; every count is equal or fewer and the pictures hold, so {}",
                     row.what == "timer" ? "times stay open" : "the time stays open");
}

}  // namespace

std::string sentence_of(const VerdictRow& row) {
  return row.cause ? words_for_cause(row) + words_for_counts(row) : row.sentence;
}

}  // namespace lamina
