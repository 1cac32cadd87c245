# SPDX-License-Identifier: BSD-3-Clause
# Installs the build, builds packaging/example against it and runs it on a phantom.
set(work ${BUILD_DIR}/tests/package)
file(REMOVE_RECURSE ${work})
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()

set(flags)
if(SANITIZER STREQUAL "address")
  set(flags -fsanitize=address,undefined)
elseif(SANITIZER STREQUAL "thread")
  set(flags -fsanitize=thread)
endif()
step(${CMAKE_COMMAND} --install ${BUILD_DIR} --component Development
     --prefix ${work}/installed)
step(${CMAKE_COMMAND} -S ${SOURCE_DIR}/packaging/example -B ${work}/build -G ${GENERATOR}
     -DCMAKE_PREFIX_PATH=${work}/installed -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${flags}
     -DCMAKE_BUILD_TYPE=Release)
step(${CMAKE_COMMAND} --build ${work}/build)
step(${CLI} phantom bifurcation --size 40 --radius 3 -o ${work}/phantom)
step(${work}/build/volume-to-stl ${work}/phantom/image.mha ${work}/vessels.stl)

# A binary STL is an 80 byte header, the number of triangles and 50 bytes for each.
file(SIZE ${work}/vessels.stl size)
math(EXPR rest "(${size} - 84) % 50")
if(size LESS 10084 OR NOT rest EQUAL 0)
  message(FATAL_ERROR "${work}/vessels.stl is no binary STL of a vessel: ${size} bytes")
endif()
