# SPDX-License-Identifier: GPL-2.0-or-later
# Installs the build tree BUILD under WORK, then configures, builds and runs the project CONSUMER.
file(REMOVE_RECURSE "${WORK}/prefix" "${WORK}/build" "${WORK}/refused")

function(must_work)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nstopped with ${status}:\n${output}")
  endif()
endfunction()

must_work(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
set(configure ${CMAKE_COMMAND} -S ${CONSUMER} -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D CMAKE_PREFIX_PATH=${WORK}/prefix)
must_work(${configure} -B ${WORK}/build -D WANTED=${VERSION})
must_work(${CMAKE_COMMAND} --build ${WORK}/build)
must_work(${WORK}/build/consumer)

execute_process(COMMAND ${configure} -B ${WORK}/refused -D WANTED=99.0
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
if(status EQUAL 0)
  message(FATAL_ERROR "version ${VERSION} passed for 99.0")
endif()
