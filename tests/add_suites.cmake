# CTest reads this file before it runs tests. Each suite of a program is one test of CTest. The tests of a
# suite share a process, because loading the OpenGL driver (0.1 s) and OpenImageIO (0.2 s) is slow.
function(add_suites program labels)
    get_filename_component(name ${program} NAME)
    # Mesa leaks memory and unloads its driver, so no suppression can name it. Leaks are detected without GL
    # only.
    set(environment "")
    if(";${labels};" MATCHES ";gl;")
        set(environment "ASAN_OPTIONS=detect_leaks=0")
    endif()
    set(suites NOT_BUILT.)
    if(EXISTS ${program})
        execute_process(COMMAND ${program} --gtest_list_tests OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
        string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${listing}")
    endif()
    foreach(suite IN LISTS suites)
        string(STRIP "${suite}" suite)
        string(REGEX REPLACE "\\.$" "" test "${name}.${suite}")
        add_test(${test} ${program} --gtest_filter=${suite}*)
        # 77: tests were skipped (main.cpp).
        set_tests_properties(${test} PROPERTIES LABELS "${labels}" TIMEOUT 600 SKIP_RETURN_CODE 77
            ENVIRONMENT "${environment}")
    endforeach()
endfunction()
