# SPDX-License-Identifier: BSD-3-Clause
# angiomesh_options(target): what every target of our own is compiled with.
# No contraction to fused multiply-add: results must be the same on every processor.
function(angiomesh_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow -Wpedantic -Wnon-virtual-dtor
                         -Woverloaded-virtual -Werror -ffp-contract=off)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
endfunction()

set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
if(ANGIOMESH_SANITIZER STREQUAL "address")
  # The checks that are woven in make GCC 12 take initialised variables for uninitialised ones.
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=undefined
                      -fno-omit-frame-pointer -Wno-maybe-uninitialized)
  add_link_options(-fsanitize=address,undefined)
elseif(ANGIOMESH_SANITIZER STREQUAL "thread")
  add_compile_options(-fsanitize=thread -fno-omit-frame-pointer)
  add_link_options(-fsanitize=thread)
elseif(NOT ANGIOMESH_SANITIZER STREQUAL "none")
  message(FATAL_ERROR "ANGIOMESH_SANITIZER is '${ANGIOMESH_SANITIZER}': use none, address or thread")
endif()

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()
