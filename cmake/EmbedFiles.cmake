# embed_files(TARGET NAMESPACE HEADER file...)
#
# Makes files part of a library: the generated HEADER has, in NAMESPACE, an array kEmbeddedFiles of
# EmbeddedFile{name, content}. A file is a path, or NAME=path if it is to have another name.
function(embed_files target namespace header)
  set(output ${PROJECT_BINARY_DIR}/generated/${header})
  set(depends)
  foreach(file ${ARGN})
    string(REGEX REPLACE "^[^/=]*=" "" path ${file})
    list(APPEND depends ${path})
  endforeach()
  list(JOIN ARGN "|" files)  # a list would fall apart on the command line
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -D OUTPUT=${output} -D NAMESPACE=${namespace} "-DFILES=${files}"
            -P ${PROJECT_SOURCE_DIR}/cmake/WriteEmbeddedFiles.cmake
    DEPENDS ${depends} ${PROJECT_SOURCE_DIR}/cmake/WriteEmbeddedFiles.cmake
    COMMENT "Embedding files in ${header}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
  target_include_directories(${target} PRIVATE ${PROJECT_BINARY_DIR}/generated)
endfunction()
