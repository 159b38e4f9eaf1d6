# cmake --install: headers, libraries, the binary, the Lua files, the manual, find_package(semantic_kiss).
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/semantic_kiss)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/semantic_kiss)
set(data_dir ${CMAKE_INSTALL_DATADIR}/semantic_kiss)

# One export set per namespace. The messages are a set of their own because both others use them
# and CMake wants what a set refers to loaded before it.
get_property(stages GLOBAL PROPERTY SEMANTIC_KISS_STAGES)
foreach(stage ${stages})
  get_target_property(export_set ${stage} SEMANTIC_KISS_EXPORT_SET)
  install(TARGETS ${stage} EXPORT ${export_set} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
endforeach()
install(EXPORT proto NAMESPACE semantic_kiss:: FILE protoTargets.cmake DESTINATION ${package_dir})
install(EXPORT cartographer NAMESPACE cartographer:: FILE cartographerTargets.cmake
        DESTINATION ${package_dir})
install(EXPORT semantic_kiss NAMESPACE semantic_kiss:: FILE semantic_kissTargets.cmake
        DESTINATION ${package_dir})

configure_package_config_file(cmake/semantic_kissConfig.cmake.in
  ${PROJECT_BINARY_DIR}/semantic_kissConfig.cmake
  INSTALL_DESTINATION ${package_dir} PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/semantic_kissConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/semantic_kissConfig.cmake
              ${PROJECT_BINARY_DIR}/semantic_kissConfigVersion.cmake
              cmake/Dependencies.cmake
        DESTINATION ${package_dir})

install(DIRECTORY cartographer semantic_kiss ${PROJECT_BINARY_DIR}/generated/cartographer
                  ${PROJECT_BINARY_DIR}/generated/semantic_kiss
        DESTINATION ${header_dir} FILES_MATCHING PATTERN "*.h")
install(DIRECTORY proto/ DESTINATION ${data_dir}/proto FILES_MATCHING PATTERN "*.proto")
install(FILES LICENSE NOTICE ${PROJECT_BINARY_DIR}/manual/options.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_BINARY_DIR}/manual/semantic_kiss.1
        DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_BINARY_DIR}/manual/semantic_kiss.bash RENAME semantic_kiss
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${PROJECT_BINARY_DIR}/manual/_semantic_kiss
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)

if(TARGET semantic_kiss)
  install(TARGETS semantic_kiss RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

# The binary looks for its Lua files in ../share/semantic_kiss beside its own folder, wherever it
# stands. The link makes that true of the build tree as well.
install(DIRECTORY configuration_files DESTINATION ${data_dir})
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/share/semantic_kiss)
file(CREATE_LINK ${PROJECT_SOURCE_DIR}/configuration_files
     ${PROJECT_BINARY_DIR}/share/semantic_kiss/configuration_files SYMBOLIC)
