// SPDX-License-Identifier: Apache-2.0
#include "harness/gate/limits.h"

#include <algorithm>
#include <charconv>
#include <functional>

#include "harness/core/text.h"
#include "harness/core/toml_table.h"

namespace lamina {
namespace {

constexpr double largest_psnr_db = 1000, largest_linear = 65504, max_pixels = 1e9, max_count = 1e15;

enum class LimitKind : uint8_t { number, share, flag, times };  // share: "3%", or 0.03

struct LimitKey {
  const char* name;
  LimitKind kind;
  double low, high;
  std::function<void(Limits&, double)> set;
};

template <class Member>
std::function<void(Limits&, double)> in(ErrorLimits Limits::*group, Member member) {
  return [=](Limits& limits, double value) { limits.*group.*member = value; };
}
std::function<void(Limits&, double)> in(double ErrorTolerance::*member) {
  return [=](Limits& limits, double value) { limits.tolerance.*member = value; };
}

const std::vector<LimitKey>& known_keys() {
  static const std::vector<LimitKey> keys = {
      {"max_slowdown", LimitKind::share, 1e-4, 10, [](Limits& l, double v) { l.max_slowdown = v; }},
      {"min_pass_share", LimitKind::share, 0, 1, [](Limits& l, double v) { l.min_pass_share = v; }},
      {"max_drift", LimitKind::share, 1e-4, 10, [](Limits& l, double v) { l.max_drift = v; }},
      {"max_ratio_drift", LimitKind::share, 1e-4, 10, [](Limits& l, double v) { l.max_ratio_drift = v; }},
      {"max_extra_fetches", LimitKind::share, 0, 1000, [](Limits& l, double v) { l.max_extra_fetches = v; }},
      {"max_extra_operations", LimitKind::share, 0, 1000, [](Limits& l, double v) { l.max_extra_operations = v; }},
      {"max_frame_ms", LimitKind::number, 0, max_count, [](Limits& l, double v) { l.max_frame_ms = v; }},
      {"max_frame_fetches", LimitKind::number, 0, max_count, [](Limits& l, double v) { l.max_frame_fetches = v; }},
      {"max_frame_operations", LimitKind::number, 0, max_count, [](Limits& l, double v) { l.max_frame_operations = v; }},
      {"max_target_bytes", LimitKind::number, 0, max_count, [](Limits& l, double v) { l.max_target_bytes = v; }},
      {"times", LimitKind::times, 0, 1, [](Limits& l, double v) { l.times_must_decide = v != 0; }},
      {"max_picture_change", LimitKind::number, 0, largest_linear, [](Limits& l, double v) { l.max_picture_change = v; }},
      {"max_nonfinite_pixels", LimitKind::number, 0, max_pixels,
       [](Limits& l, double v) { l.max_nonfinite_pixels = static_cast<uint64_t>(v); }},
      {"same_image", LimitKind::flag, 0, 1, [](Limits& l, double v) { l.same_image = v != 0; }},
      {"min_psnr_db", LimitKind::number, 0, largest_psnr_db, in(&Limits::baseline, &ErrorLimits::min_psnr_db)},
      {"min_ssim", LimitKind::number, -1, 1, in(&Limits::baseline, &ErrorLimits::min_ssim)},
      {"max_flip", LimitKind::number, 0, 1, in(&Limits::baseline, &ErrorLimits::max_flip)},
      {"max_rmse_linear", LimitKind::number, 0, largest_linear, in(&Limits::baseline, &ErrorLimits::max_rmse_linear)},
      {"max_max_linear", LimitKind::number, 0, largest_linear, in(&Limits::baseline, &ErrorLimits::max_max_linear)},
      {"min_psnr_db_to_truth", LimitKind::number, 0, largest_psnr_db, in(&Limits::truth, &ErrorLimits::min_psnr_db)},
      {"min_ssim_to_truth", LimitKind::number, -1, 1, in(&Limits::truth, &ErrorLimits::min_ssim)},
      {"max_flip_to_truth", LimitKind::number, 0, 1, in(&Limits::truth, &ErrorLimits::max_flip)},
      {"max_rmse_linear_to_truth", LimitKind::number, 0, largest_linear, in(&Limits::truth, &ErrorLimits::max_rmse_linear)},
      {"max_max_linear_to_truth", LimitKind::number, 0, largest_linear, in(&Limits::truth, &ErrorLimits::max_max_linear)},
      {"psnr_db_tolerance", LimitKind::number, 0, largest_psnr_db, in(&ErrorTolerance::psnr_db)},
      {"ssim_tolerance", LimitKind::number, 0, 1, in(&ErrorTolerance::ssim)},
      {"flip_tolerance", LimitKind::number, 0, 1, in(&ErrorTolerance::flip)},
      {"rmse_linear_tolerance", LimitKind::number, 0, largest_linear, in(&ErrorTolerance::rmse_linear)},
      {"max_linear_tolerance", LimitKind::number, 0, largest_linear, in(&ErrorTolerance::max_linear)},
  };
  return keys;
}

const LimitKey& key_named(const std::string& name) {
  return *std::find_if(known_keys().begin(), known_keys().end(), [&](const LimitKey& key) { return name == key.name; });
}

double read_share(const TomlTable& table, const LimitKey& key) {
  const std::string text = table.string(key.name);
  double percent = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), percent);
  if (parsed.ec != std::errc() || std::string_view(parsed.ptr) != "%")
    throw table.error(key.name, fmt::format("'{}' must be a percentage such as \"3%\", or a share such as 0.03", text));
  const double share = percent / 100;
  if (share < key.low || share > key.high)
    throw table.error(key.name, fmt::format("'{}' must lie between {}% and {}%", text, key.low * 100, key.high * 100));
  return share;
}

double read_times(const TomlTable& table, const LimitKey& key) { return table.string(key.name) == "must_decide" ? 1 : 0; }

std::optional<double> read_value(const TomlTable& table, const LimitKey& key) {
  if (!table.has(key.name)) return std::nullopt;
  if (key.kind == LimitKind::times) return read_times(table, key);
  if (key.kind == LimitKind::flag) return *table.optional_bool(key.name) ? 1 : 0;
  if (key.kind == LimitKind::share && table.is_string(key.name)) return read_share(table, key);
  return table.optional_number(key.name);
}

TomlKey limit_key(const LimitKey& key) {
  if (key.kind == LimitKind::times)
    return {
        key.name, "whether times of a variant with equal counts must decide", {form::word({"must_decide", "may_stay_open"})}};
  if (key.kind == LimitKind::flag) return {key.name, "", {form::flag()}};
  if (key.kind == LimitKind::share)
    return {key.name, "a percentage such as \"3%\", or a share", {form::number(key.low, key.high), form::text("^[0-9.]+%$")}};
  return {key.name, "", {form::number(key.low, key.high)}};
}

}  // namespace

TomlFormPtr limits_form(const GateNames& names) {
  std::vector<TomlKey> keys;
  for (const LimitKey& key : known_keys()) keys.push_back(limit_key(key));
  const TomlFormPtr everywhere = form::make(keys);
  keys.push_back({"effect", "cells of this effect", {form::word(names.effects)}});
  keys.push_back({"variant", "cells of this variant", {form::word(names.variants)}});
  keys.push_back({"backend", "cells of this backend", {form::word(names.backends)}});
  return form::make({{"default", "limits of every cell", {form::table(everywhere)}},
                     {"limit", "limits of some cells; a later one wins", {form::tables(form::make(keys))}}});
}

LimitsFile::LimitsFile(const std::filesystem::path& file, const GateNames& names) {
  const TomlTable root = TomlTable::parse(file, "gate", limits_form(names));
  const auto read = [&](const TomlTable& table, bool selects) {
    Entry entry;
    if (selects) {
      entry.effect = table.optional_string("effect").value_or("");
      entry.variant = table.optional_string("variant").value_or("");
      entry.backend = table.optional_string("backend").value_or("");
    }
    for (const LimitKey& key : known_keys())
      if (const auto value = read_value(table, key)) entry.values.emplace_back(key.name, *value);
    table.check_keys();
    for (const auto& [name, value] : entry.values)
      for (const Entry& other : entries_)
        for (const auto& [other_name, other_value] : other.values)
          if (name == other_name && value != other_value && selects && entry.effect == other.effect &&
              entry.variant == other.variant && entry.backend == other.backend &&
              !(other.effect + other.variant + other.backend).empty())
            throw table.error(
                name, fmt::format("is set to {} here and to {} by an earlier [[limit]] for the same cells; keep one", value,
                                  other_value));
    if (selects && (entry.effect + entry.variant + entry.backend).empty())
      throw table.error({}, "names no effect, variant or backend; limits of every cell belong under [default]");
    entries_.push_back(std::move(entry));
  };
  read(root.table("default"), false);
  for (const TomlTable& limit : root.array_of_tables("limit")) read(limit, true);
  root.check_keys();
}

Limits LimitsFile::of(std::string_view effect, std::string_view variant, std::string_view backend) const {
  const auto fits = [](const std::string& selected, std::string_view name) { return selected.empty() || selected == name; };
  Limits limits;
  for (const Entry& entry : entries_)
    if (fits(entry.effect, effect) && fits(entry.variant, variant) && fits(entry.backend, backend))
      for (const auto& [name, value] : entry.values) key_named(name).set(limits, value);
  return limits;
}

}  // namespace lamina
