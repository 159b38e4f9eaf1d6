# cmake -D BUILD=DIR -D WORK=DIR -D CXX=COMPILER -P run.cmake
#
# Installs the build tree BUILD below WORK, then configures, builds and runs the project of this
# folder against what was installed, and the installed program with an installed Lua file, and looks
# whether the manual came along. WORK is emptied first, so that a file which is no longer installed
# is missed.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(result)
    message(FATAL_ERROR "${ARGV} failed (${result}):\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
# Moved once, so that an absolute path in the package is found out.
file(RENAME ${WORK}/prefix ${WORK}/moved)
run(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build
    -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_PREFIX_PATH=${WORK}/moved)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
run(${WORK}/moved/bin/semantic_kiss config --config=semantic_kiss.lua)

foreach(file man/man1/semantic_kiss.1 doc/semantic_kiss/options.md
        bash-completion/completions/semantic_kiss zsh/site-functions/_semantic_kiss)
  if(NOT EXISTS ${WORK}/moved/share/${file})
    message(FATAL_ERROR "share/${file} is not installed")
  endif()
endforeach()
