// SPDX-License-Identifier: Apache-2.0
#include "harness/shader/operations.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <numeric>

#include "harness/shader/spirv_module.h"

namespace lamina {
namespace {

constexpr std::array<std::string_view, operation_class_count> class_names = {
    "add",    "multiply", "fma",        "divide",        "root",  "sin",     "cos",     "tan",     "asin",
    "acos",   "atan",     "hyperbolic", "exp",           "log",   "pow",     "integer", "compare", "select",
    "branch", "convert",  "derivative", "interpolation", "input", "uniform", "storage", "image",   "query"};

// Of a value of this type, how many numbers or booleans it holds.
uint64_t components(const SpirvModule& module, uint32_t type_id) {
  const SpirvInstruction& type = module.definition(type_id);
  switch (type.op()) {
    case spv::OpTypeVector:
    case spv::OpTypeMatrix:
      return type.words[3] * components(module, type.words[2]);
    case spv::OpTypeArray:
      return module.definition(type.words[3]).words[3] * components(module, type.words[2]);
    case spv::OpTypeStruct: {
      uint64_t sum = 0;
      for (const uint32_t member : type.words.subspan(2)) sum += components(module, member);
      return sum;
    }
    case spv::OpTypeRuntimeArray:
      return 0;
    default:
      return 1;
  }
}

// The variable that a pointer leads into; null where that is a function's parameter.
const SpirvInstruction* variable_of(const SpirvModule& module, uint32_t pointer) {
  for (;;) {
    const SpirvInstruction& source = module.definition(pointer);
    switch (source.op()) {
      case spv::OpVariable:
        return &source;
      case spv::OpAccessChain:
      case spv::OpInBoundsAccessChain:
      case spv::OpCopyObject:
      case spv::OpImageTexelPointer:
        pointer = source.words[3];
        break;
      default:
        return nullptr;
    }
  }
}

// An instruction of GLSL.std.450 that is the same for every component of its result.
struct Alike {
  GLSLstd450 instruction;
  OperationClass operation;
  uint64_t times = 1;
};

class Reading {
  using enum OperationClass;

 public:
  Reading(const SpirvModule& module, const SpirvInstruction& instruction, Stage stage)
      : module_(module), i_(instruction), stage_(stage), n_(instruction.type == 0 ? 0 : components(module, instruction.type)) {}

  Operations operations() {
    const spv::Op op = i_.op();
    if (op == spv::OpExtInst)
      extended();
    else if (!memory() && !arithmetic() && !products())
      others();
    return done_;
  }

 private:
  // Components of the operand at this word.
  uint64_t components_at(size_t word) const { return components(module_, module_.definition(i_.words[word]).type); }

  void dot(uint64_t m) {
    done_[multiply] += m;
    done_[add] += m - 1;
  }

  // What a pointer leads to says which memory it is.
  void access(uint32_t pointer, uint64_t count) {
    const SpirvInstruction* variable = variable_of(module_, pointer);
    if (!variable) return;
    const uint32_t id = variable->result;
    switch (static_cast<spv::StorageClass>(variable->words[3])) {
      case spv::StorageClassInput: {
        if (module_.decoration(id, spv::DecorationBuiltIn)) return;
        const bool interpolated = stage_ == Stage::fragment && !module_.decoration(id, spv::DecorationFlat);
        done_[interpolated ? interpolation : input] += count;
        return;
      }
      case spv::StorageClassUniform: {
        const uint32_t block = module_.definition(variable->type).words[3];
        done_[module_.decoration(block, spv::DecorationBufferBlock) ? storage : uniform] += count;
        return;
      }
      case spv::StorageClassStorageBuffer:
        done_[storage] += count;
        return;
      case spv::StorageClassUniformConstant:
        if (i_.op() != spv::OpLoad) done_[image] += count;  // a load only takes the image's handle
        return;
      default:
        return;
    }
  }

  bool memory() {
    const spv::Op op = i_.op();
    if (op == spv::OpLoad)
      access(i_.words[3], n_);
    else if (op == spv::OpStore)
      access(i_.words[1], components_at(2));
    else if (op == spv::OpAtomicStore)
      access(i_.words[1], 1);
    else if (op >= spv::OpAtomicLoad && op <= spv::OpAtomicXor)
      access(i_.words[3], 1);
    else if (op == spv::OpImageRead || op == spv::OpImageWrite)
      done_[image] += 1;
    else
      return false;
    return true;
  }

  // A class for every component of the result.
  bool arithmetic() {
    const spv::Op op = i_.op();
    const auto within = [op](spv::Op first, spv::Op last) { return op >= first && op <= last; };
    switch (op) {
      case spv::OpFNegate:
      case spv::OpFAdd:
      case spv::OpFSub:
        done_[add] += n_;
        return true;
      case spv::OpFMul:
      case spv::OpVectorTimesScalar:
      case spv::OpMatrixTimesScalar:
      case spv::OpOuterProduct:
        done_[multiply] += n_;
        return true;
      case spv::OpFDiv:
      case spv::OpFRem:
      case spv::OpFMod:
        done_[divide] += n_;
        return true;
      case spv::OpSelect:
        done_[select] += n_;
        return true;
      default:
        break;
    }
    if (within(spv::OpConvertFToU, spv::OpQuantizeToF16))
      done_[convert] += n_;
    else if (within(spv::OpDPdx, spv::OpFwidthCoarse))
      done_[derivative] += n_;
    else if (within(spv::OpSNegate, spv::OpSMod) || within(spv::OpIAddCarry, spv::OpSMulExtended) ||
             within(spv::OpShiftRightLogical, spv::OpBitCount))
      done_[integer] += n_;
    else if (within(spv::OpAny, spv::OpFUnordGreaterThanEqual))
      done_[compare] += n_;
    else
      return false;
    return true;
  }

  bool products() {
    switch (i_.op()) {
      case spv::OpDot:
        dot(components_at(3));
        return true;
      case spv::OpVectorTimesMatrix: {
        for (uint64_t column = 0; column < n_; ++column) dot(components_at(3));
        return true;
      }
      case spv::OpMatrixTimesVector: {
        for (uint64_t row = 0; row < n_; ++row) dot(components_at(4));
        return true;
      }
      case spv::OpMatrixTimesMatrix: {
        const uint64_t columns = module_.definition(module_.definition(i_.words[3]).type).words[3];  // of the left one
        for (uint64_t element = 0; element < n_; ++element) dot(columns);
        return true;
      }
      default:
        return false;
    }
  }

  void others() {
    const spv::Op op = i_.op();
    if (op == spv::OpBranchConditional || op == spv::OpSwitch) done_[branch] += 1;
    if (op >= spv::OpImageQuerySizeLod && op <= spv::OpImageQuerySamples) done_[query] += 1;
  }

  static constexpr Alike alike[] = {
      {GLSLstd450FAbs, add},
      {GLSLstd450FSign, add},
      {GLSLstd450Radians, multiply},
      {GLSLstd450Degrees, multiply},
      {GLSLstd450Fma, fma},
      {GLSLstd450Sqrt, root},
      {GLSLstd450InverseSqrt, root},
      {GLSLstd450Sin, sin},
      {GLSLstd450Cos, cos},
      {GLSLstd450Tan, tan},
      {GLSLstd450Asin, asin},
      {GLSLstd450Acos, acos},
      {GLSLstd450Atan, atan},
      {GLSLstd450Atan2, atan},
      {GLSLstd450Sinh, hyperbolic},
      {GLSLstd450Cosh, hyperbolic},
      {GLSLstd450Tanh, hyperbolic},
      {GLSLstd450Asinh, hyperbolic},
      {GLSLstd450Acosh, hyperbolic},
      {GLSLstd450Atanh, hyperbolic},
      {GLSLstd450Exp, exp},
      {GLSLstd450Exp2, exp},
      {GLSLstd450Log, log},
      {GLSLstd450Log2, log},
      {GLSLstd450Pow, pow},
      {GLSLstd450SAbs, integer},
      {GLSLstd450SSign, integer},
      {GLSLstd450UMin, integer},
      {GLSLstd450SMin, integer},
      {GLSLstd450UMax, integer},
      {GLSLstd450SMax, integer},
      {GLSLstd450UClamp, integer, 2},
      {GLSLstd450SClamp, integer, 2},
      {GLSLstd450FindILsb, integer},
      {GLSLstd450FindSMsb, integer},
      {GLSLstd450FindUMsb, integer},
      {GLSLstd450FMin, compare},
      {GLSLstd450FMax, compare},
      {GLSLstd450NMin, compare},
      {GLSLstd450NMax, compare},
      {GLSLstd450Step, compare},
      {GLSLstd450FClamp, compare, 2},
      {GLSLstd450NClamp, compare, 2},
      {GLSLstd450Round, convert},
      {GLSLstd450RoundEven, convert},
      {GLSLstd450Trunc, convert},
      {GLSLstd450Floor, convert},
      {GLSLstd450Ceil, convert},
      {GLSLstd450Fract, convert},
      {GLSLstd450Ldexp, convert},
      {GLSLstd450UnpackSnorm4x8, convert},
      {GLSLstd450UnpackUnorm4x8, convert},
      {GLSLstd450UnpackSnorm2x16, convert},
      {GLSLstd450UnpackUnorm2x16, convert},
      {GLSLstd450UnpackHalf2x16, convert},
      {GLSLstd450InterpolateAtCentroid, interpolation},
      {GLSLstd450InterpolateAtSample, interpolation},
      {GLSLstd450InterpolateAtOffset, interpolation},
  };

  void extended() {
    for (const Alike& one : alike)
      if (i_.words[4] == one.instruction) done_[one.operation] += one.times * n_;
    composed(5);
  }

  // Those whose definitions are several operations.
  void composed(size_t first) {  // word of the first operand
    switch (i_.words[4]) {
      case GLSLstd450Modf:
      case GLSLstd450ModfStruct:
      case GLSLstd450Frexp:
      case GLSLstd450FrexpStruct:
      case GLSLstd450PackSnorm4x8:
      case GLSLstd450PackUnorm4x8:
      case GLSLstd450PackSnorm2x16:
      case GLSLstd450PackUnorm2x16:
      case GLSLstd450PackHalf2x16:
        done_[convert] += components_at(first);
        break;
      case GLSLstd450FMix:  // x (1 - a) + y a
        done_[multiply] += 2 * n_;
        done_[add] += 2 * n_;
        break;
      case GLSLstd450SmoothStep:  // t = clamp((x - low) / (high - low), 0, 1); t t (3 - 2 t)
        done_[add] += 3 * n_;
        done_[divide] += n_;
        done_[compare] += 2 * n_;
        done_[multiply] += 3 * n_;
        break;
      case GLSLstd450Length:
        dot(components_at(first));
        done_[root] += 1;
        break;
      case GLSLstd450Distance:
        done_[add] += components_at(first);
        dot(components_at(first));
        done_[root] += 1;
        break;
      case GLSLstd450Cross:
        done_[multiply] += 6;
        done_[add] += 3;
        break;
      case GLSLstd450Normalize:
        dot(n_);
        done_[root] += 1;
        done_[multiply] += n_;
        break;
      case GLSLstd450FaceForward:
        dot(n_);
        done_[compare] += 1;
        done_[select] += n_;
        break;
      case GLSLstd450Reflect:  // i - 2 dot(n, i) n
        dot(n_);
        done_[multiply] += 1 + n_;
        done_[add] += n_;
        break;
      case GLSLstd450Refract:  // k = 1 - eta eta (1 - d d); k < 0 ? 0 : eta i - (eta d + sqrt(k)) n
        dot(n_);
        done_[multiply] += 4 + 2 * n_;
        done_[add] += 3 + n_;
        done_[compare] += 1;
        done_[root] += 1;
        break;
      case GLSLstd450Determinant:
        determinant(module_.definition(module_.definition(i_.words[first]).type).words[3]);
        break;
      case GLSLstd450MatrixInverse:
        inverse(module_.definition(i_.type).words[3]);
        break;
      default:
        break;
    }
  }

  // By cofactors of the first row, as the definition has it.
  void determinant(uint64_t size, uint64_t times = 1) {
    if (size < 2) return;
    done_[multiply] += times * size;
    done_[add] += times * (size - 1);
    if (size > 2) determinant(size - 1, times * size);
  }

  // Cofactors of all elements; the determinant from those of the first row; its inverse times each.
  void inverse(uint64_t size) {
    determinant(size - 1, size * size);
    dot(size);
    done_[divide] += 1;
    done_[multiply] += size * size;
  }

  const SpirvModule& module_;
  const SpirvInstruction& i_;
  const Stage stage_;
  const uint64_t n_;  // components of the result
  Operations done_;
};

}  // namespace

std::string_view name_of(OperationClass operation) { return class_names[static_cast<size_t>(operation)]; }

void Operations::add(const Operations& other, uint64_t times) {
  for (size_t k = 0; k < counts_.size(); ++k) counts_[k] += times * other.counts_[k];
}

uint64_t Operations::sum() const { return std::accumulate(counts_.begin(), counts_.end(), uint64_t{0}); }

std::vector<OperationClass> Operations::classes() const {
  std::vector<OperationClass> some;
  for (size_t k = 0; k < counts_.size(); ++k)
    if (counts_[k] > 0) some.push_back(static_cast<OperationClass>(k));
  return some;
}

std::map<std::string, uint64_t> Operations::by_name() const {
  std::map<std::string, uint64_t> named;
  for (const OperationClass operation : classes()) named.emplace(name_of(operation), (*this)[operation]);
  return named;
}

Operations operations_of(const SpirvModule& module, const SpirvInstruction& instruction, Stage stage) {
  return Reading(module, instruction, stage).operations();
}

}  // namespace lamina
