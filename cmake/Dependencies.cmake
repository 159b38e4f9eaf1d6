# Everything comes from Debian 12; scripts/setup.sh installs it. README.md says what each is for.
#
# Both the build and the installed find_package(semantic_kiss) include this file, so that the two
# cannot differ. The build stops where something is missing; for a dependent project the package
# then counts as not found, with the reason. (Macros, so that return() leaves this file.)
macro(semantic_kiss_find)
  if(CMAKE_FIND_PACKAGE_NAME STREQUAL "semantic_kiss")
    find_dependency(${ARGV})
  else()
    find_package(${ARGV} REQUIRED)
  endif()
endmacro()

# Makes the target PkgConfig::NAME of the pkg-config module MODULE.
macro(semantic_kiss_find_module name module)
  if(CMAKE_FIND_PACKAGE_NAME STREQUAL "semantic_kiss")
    pkg_check_modules(${name} QUIET IMPORTED_TARGET ${module})
    if(NOT ${name}_FOUND)
      set(semantic_kiss_FOUND FALSE)
      set(semantic_kiss_NOT_FOUND_MESSAGE "pkg-config does not know ${module}")
      return()
    endif()
  else()
    pkg_check_modules(${name} REQUIRED IMPORTED_TARGET ${module})
  endif()
endmacro()

semantic_kiss_find(absl)
semantic_kiss_find(Ceres 2.1)
semantic_kiss_find(Eigen3 3.4 NO_MODULE)
semantic_kiss_find(gflags)
semantic_kiss_find(nlohmann_json)
semantic_kiss_find(Protobuf 3.21)
semantic_kiss_find(TBB)
semantic_kiss_find(PkgConfig)
semantic_kiss_find_module(cairo cairo)
semantic_kiss_find_module(deflate libdeflate)
semantic_kiss_find_module(glog libglog)
semantic_kiss_find_module(lua lua5.3)
