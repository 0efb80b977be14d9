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

enum class Form : uint8_t { number, share, flag, times };  // share: "3%", or 0.03

struct LimitKey {
  const char* name;
  Form form;
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
      {"max_slowdown", Form::share, 1e-4, 10, [](Limits& l, double v) { l.max_slowdown = v; }},
      {"min_pass_share", Form::share, 0, 1, [](Limits& l, double v) { l.min_pass_share = v; }},
      {"max_drift", Form::share, 1e-4, 10, [](Limits& l, double v) { l.max_drift = v; }},
      {"max_ratio_drift", Form::share, 1e-4, 10, [](Limits& l, double v) { l.max_ratio_drift = v; }},
      {"max_extra_fetches", Form::share, 0, 1000, [](Limits& l, double v) { l.max_extra_fetches = v; }},
      {"max_extra_operations", Form::share, 0, 1000, [](Limits& l, double v) { l.max_extra_operations = v; }},
      {"max_frame_ms", Form::number, 0, max_count, [](Limits& l, double v) { l.max_frame_ms = v; }},
      {"max_frame_fetches", Form::number, 0, max_count, [](Limits& l, double v) { l.max_frame_fetches = v; }},
      {"max_frame_operations", Form::number, 0, max_count, [](Limits& l, double v) { l.max_frame_operations = v; }},
      {"max_target_bytes", Form::number, 0, max_count, [](Limits& l, double v) { l.max_target_bytes = v; }},
      {"times", Form::times, 0, 1, [](Limits& l, double v) { l.times_must_decide = v != 0; }},
      {"max_picture_change", Form::number, 0, largest_linear, [](Limits& l, double v) { l.max_picture_change = v; }},
      {"max_nonfinite_pixels", Form::number, 0, max_pixels,
       [](Limits& l, double v) { l.max_nonfinite_pixels = static_cast<uint64_t>(v); }},
      {"same_image", Form::flag, 0, 1, [](Limits& l, double v) { l.same_image = v != 0; }},
      {"min_psnr_db", Form::number, 0, largest_psnr_db, in(&Limits::baseline, &ErrorLimits::min_psnr_db)},
      {"min_ssim", Form::number, -1, 1, in(&Limits::baseline, &ErrorLimits::min_ssim)},
      {"max_flip", Form::number, 0, 1, in(&Limits::baseline, &ErrorLimits::max_flip)},
      {"max_rmse_linear", Form::number, 0, largest_linear, in(&Limits::baseline, &ErrorLimits::max_rmse_linear)},
      {"max_max_linear", Form::number, 0, largest_linear, in(&Limits::baseline, &ErrorLimits::max_max_linear)},
      {"min_psnr_db_to_truth", Form::number, 0, largest_psnr_db, in(&Limits::truth, &ErrorLimits::min_psnr_db)},
      {"min_ssim_to_truth", Form::number, -1, 1, in(&Limits::truth, &ErrorLimits::min_ssim)},
      {"max_flip_to_truth", Form::number, 0, 1, in(&Limits::truth, &ErrorLimits::max_flip)},
      {"max_rmse_linear_to_truth", Form::number, 0, largest_linear, in(&Limits::truth, &ErrorLimits::max_rmse_linear)},
      {"max_max_linear_to_truth", Form::number, 0, largest_linear, in(&Limits::truth, &ErrorLimits::max_max_linear)},
      {"psnr_db_tolerance", Form::number, 0, largest_psnr_db, in(&ErrorTolerance::psnr_db)},
      {"ssim_tolerance", Form::number, 0, 1, in(&ErrorTolerance::ssim)},
      {"flip_tolerance", Form::number, 0, 1, in(&ErrorTolerance::flip)},
      {"rmse_linear_tolerance", Form::number, 0, largest_linear, in(&ErrorTolerance::rmse_linear)},
      {"max_linear_tolerance", Form::number, 0, largest_linear, in(&ErrorTolerance::max_linear)},
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

double read_times(const TomlTable& table, const LimitKey& key) {
  const std::string text = table.string(key.name);
  if (text != "must_decide" && text != "may_stay_open")
    throw table.error(key.name, fmt::format("'{}' must be \"must_decide\" or \"may_stay_open\"", text));
  return text == "must_decide" ? 1 : 0;
}

std::optional<double> read_value(const TomlTable& table, const LimitKey& key) {
  if (!table.has(key.name)) return std::nullopt;
  if (key.form == Form::times) return read_times(table, key);
  if (key.form == Form::flag) return *table.optional_bool(key.name) ? 1 : 0;
  if (key.form == Form::share && table.is_string(key.name)) return read_share(table, key);
  return table.optional_number(key.name, key.low, key.high);
}

std::string read_name(const TomlTable& table, const char* what, const std::vector<std::string>& known) {
  const auto name = table.optional_string(what);
  if (!name) return "";
  if (std::find(known.begin(), known.end(), *name) == known.end()) throw table.error(what, unknown_name(what, *name, known));
  return *name;
}

}  // namespace

LimitsFile::LimitsFile(const std::filesystem::path& file, const GateNames& names) {
  const TomlTable root = TomlTable::parse(file, "gate");
  const auto read = [&](const TomlTable& table, bool selects) {
    Entry entry;
    if (selects) {
      entry.effect = read_name(table, "effect", names.effects);
      entry.variant = read_name(table, "variant", names.variants);
      entry.backend = read_name(table, "backend", names.backends);
    }
    for (const LimitKey& key : known_keys())
      if (const auto value = read_value(table, key)) entry.values.emplace_back(key.name, *value);
    table.refuse_unknown_keys();
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
  root.refuse_unknown_keys();
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
