// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/private_counters.h"

namespace lamina {

void PrivateCounters::declare(uint32_t count) {
  count_ = count;
  const uint32_t array = code_.type(spv::OpTypeArray, {code_.uint_type(), code_.constant(count)});
  const uint32_t pointer = code_.type(spv::OpTypePointer, {spv::StorageClassPrivate, array});
  array_ = code_.new_id();
  emit(code_.globals, spv::OpVariable, {pointer, array_, spv::StorageClassPrivate});
}

uint32_t PrivateCounters::pointer_to(uint32_t index) {
  const uint32_t pointer = code_.type(spv::OpTypePointer, {spv::StorageClassPrivate, code_.uint_type()});
  return code_.value(spv::OpAccessChain, pointer, {array_, index});
}

void PrivateCounters::set(uint32_t index, uint32_t value) {
  const uint32_t pointer = pointer_to(index);
  emit(code_.body, spv::OpStore, {pointer, value});
}

void PrivateCounters::add(uint32_t index, uint32_t amount) {
  const uint32_t pointer = pointer_to(index), of_type = code_.uint_type();
  const uint32_t before = code_.value(spv::OpLoad, of_type, {pointer});
  emit(code_.body, spv::OpStore, {pointer, code_.value(spv::OpIAdd, of_type, {before, amount})});
}

uint32_t PrivateCounters::value(uint32_t index) { return code_.value(spv::OpLoad, code_.uint_type(), {pointer_to(index)}); }

}  // namespace lamina
