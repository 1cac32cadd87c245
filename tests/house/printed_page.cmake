# SPDX-License-Identifier: BSD-3-Clause
# PAGE is what CLI prints with COMMAND.
execute_process(COMMAND ${CLI} ${COMMAND} OUTPUT_VARIABLE now COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PAGE} page)
if(NOT now STREQUAL page)
  list(JOIN COMMAND " " words)
  message(FATAL_ERROR "the page is out of date, ${PAGE}: make it anew with "
                      "angiomesh-cli ${words} > ${PAGE}")
endif()
