# SPDX-License-Identifier: BSD-3-Clause
# Fails unless `program` prints exactly what stands in the file `expected`.
execute_process(COMMAND ${program} OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
file(READ ${expected} text)
if(NOT output STREQUAL text)
  message(FATAL_ERROR "expected\n${text}but ${program} printed\n${output}")
endif()
