# add_stage(NAME [TREE tree] DEPS target...)
#
# Makes the library of the calling folder: every .cc and .h in it, no list to keep up to date. Only
# main.cc is left out: it is a program's, and a library with a main() would end up in tests. TREE
# is needed where the calling folder is itself the top of a tree. The target is <tree>_<folder>
# (cartographer_sensor), its alias <tree>::<folder>, which is also its name for projects that
# find_package(semantic_kiss).
function(add_stage name)
  cmake_parse_arguments(ARG "" "TREE" "DEPS" ${ARGN})
  set(tree ${ARG_TREE})
  if(NOT tree)
    get_filename_component(tree ${CMAKE_CURRENT_SOURCE_DIR} DIRECTORY)
    get_filename_component(tree ${tree} NAME)
  endif()
  set(target ${tree}_${name})
  file(GLOB sources CONFIGURE_DEPENDS *.cc)
  list(FILTER sources EXCLUDE REGEX "/main\\.cc$")
  file(GLOB headers CONFIGURE_DEPENDS *.h)
  if(sources)
    add_library(${target} STATIC ${sources} ${headers})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:semantic_kiss_compiler_settings>)
    use_precompiled_headers(${target})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(${tree}::${name} ALIAS ${target})
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/semantic_kiss>)
  target_compile_features(${target} ${scope} cxx_std_17)
  target_link_libraries(${target} ${scope} ${ARG_DEPS})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} SEMANTIC_KISS_EXPORT_SET ${tree})
  set_property(GLOBAL APPEND PROPERTY SEMANTIC_KISS_STAGES ${target})
endfunction()
