// SPDX-License-Identifier: Apache-2.0
// What typed handles stand for. Ids are never given out twice, so that a stale one is caught instead of naming a stranger.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "harness/core/error.h"

namespace lamina {

template <class Id, class Item>
class Table {
 public:
  // `what` names an item in errors: "texture".
  explicit Table(std::string_view what) : what_(what) {}

  Id add(Item item) {
    const Id id{next_++};
    items_.emplace(id, std::move(item));
    return id;
  }
  // Throws Error(bad_input) for an id that was never given out or is destroyed; `subject` is who asks.
  Item& at(Id id, std::string_view subject) {
    const auto found = items_.find(id);
    if (found == items_.end())
      throw Error(ErrorKind::bad_input, "backend", std::string(subject),
                  fmt::format("names a {} that does not exist or is destroyed", what_));
    return found->second;
  }
  void erase(Id id) {
    at(id, "destroy");
    items_.erase(id);
  }
  size_t size() const { return items_.size(); }

 private:
  std::string_view what_;
  std::map<Id, Item> items_;
  uint32_t next_ = 0;
};

}  // namespace lamina
