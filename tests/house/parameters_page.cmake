# SPDX-License-Identifier: BSD-3-Clause
# docs/parameters.md is what `angiomesh-cli parameters --markdown` prints.
execute_process(COMMAND ${CLI} parameters --markdown OUTPUT_VARIABLE now COMMAND_ERROR_IS_FATAL ANY)
file(READ ${PAGE} page)
if(NOT now STREQUAL page)
  message(FATAL_ERROR "docs/parameters.md is out of date, ${PAGE}: make it anew with "
                      "angiomesh-cli parameters --markdown > docs/parameters.md")
endif()
