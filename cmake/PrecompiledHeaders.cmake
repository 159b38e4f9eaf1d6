# What most sources include and takes long to read, compiled once for all stages: it halves the time
# of a typical source. Sources include what they use nonetheless; the preset `asan` builds without
# this, so a forgotten include shows there.
option(SEMANTIC_KISS_PRECOMPILE "Compile common headers once for all stages" ON)

file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cc CONTENT "")
add_library(stage_precompiled OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/precompiled.cc)
target_link_libraries(stage_precompiled PRIVATE
  semantic_kiss_compiler_settings absl::statusor absl::str_format absl::strings Eigen3::Eigen
  protobuf::libprotobuf)
target_precompile_headers(stage_precompiled PRIVATE
  <algorithm> <functional> <map> <memory> <optional> <string> <utility> <vector>
  <Eigen/Core> <Eigen/Geometry> <absl/status/statusor.h> <absl/strings/str_cat.h>
  <absl/strings/str_format.h> <google/protobuf/message.h>)

function(use_precompiled_headers target)
  if(SEMANTIC_KISS_PRECOMPILE)
    target_precompile_headers(${target} REUSE_FROM stage_precompiled)
  endif()
endfunction()
