# Language level, warnings, sanitizers and ccache: one place for all targets.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

option(SEMANTIC_KISS_WERROR "Treat warnings as errors" ON)
set(SEMANTIC_KISS_SANITIZE "" CACHE STRING "Value for -fsanitize, for example address,undefined")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  # A precompiled header carries time stamps that ccache would otherwise refuse.
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime
      ${CCACHE_PROGRAM})
endif()

add_library(semantic_kiss_compiler_settings INTERFACE)
target_compile_features(semantic_kiss_compiler_settings INTERFACE cxx_std_17)
target_compile_options(semantic_kiss_compiler_settings INTERFACE
  $<BUILD_INTERFACE:-Wall>
  $<BUILD_INTERFACE:-Wextra>
  $<BUILD_INTERFACE:-Wno-sign-compare>
  $<BUILD_INTERFACE:$<$<BOOL:${SEMANTIC_KISS_WERROR}>:-Werror>>)
if(SEMANTIC_KISS_SANITIZE)
  add_compile_options(-fsanitize=${SEMANTIC_KISS_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${SEMANTIC_KISS_SANITIZE})
endif()
