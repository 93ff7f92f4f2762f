# Run by install() for the component `bundle`: copies every library that BUNDLE_PROGRAM and BUNDLE_LIBRARIES
# need, except those of the C and C++ runtime, to lib/plumbline, and their licenses to
# share/doc/plumbline/bundled.
#
# The C and C++ runtime isn't bundled. A process can't load a second libc, and a libstdc++ older than the one
# that the machine's GL driver was built with would keep that driver from loading. If the machine's glibc is
# new enough for the program, so is its libstdc++.
set(runtime "/(ld-linux[^/]*|lib(c|m|mvec|dl|rt|pthread|resolv|util|anl|stdc\\+\\+|gcc_s))\\.so\\.[0-9]+$")

find_program(PATCHELF patchelf)
if(NOT PATCHELF)
    message(FATAL_ERROR "patchelf is missing: the bundled libraries have to find each other (apt install patchelf)")
endif()
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${BUNDLE_PROGRAM} LIBRARIES ${BUNDLE_LIBRARIES}
    RESOLVED_DEPENDENCIES_VAR libraries POST_EXCLUDE_REGEXES "${runtime}")
foreach(library IN LISTS BUNDLE_LIBRARIES)
    if(NOT library MATCHES "plumbline_images") # already installed
        list(APPEND libraries ${library})
    endif()
endforeach()

set(prefix $ENV{DESTDIR}${CMAKE_INSTALL_PREFIX})
set(folder ${prefix}/lib/plumbline)
set(licenses ${prefix}/share/doc/plumbline/bundled)
file(MAKE_DIRECTORY ${folder} ${licenses})
set(patterns "")
foreach(library IN LISTS libraries)
    get_filename_component(name ${library} NAME)
    file(REAL_PATH ${library} file)
    file(COPY_FILE ${file} ${folder}/${name})
    # Each library searches its own folder. RUNPATH, not RPATH, because libraries that aren't bundled, such as
    # the machine's GL driver, must find their own dependencies.
    execute_process(COMMAND ${PATCHELF} --set-rpath $ORIGIN ${folder}/${name} COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX REPLACE "^/usr/" "*/" pattern ${file}) # dpkg lists some files by their path before /lib became a link
    list(APPEND patterns ${pattern})
endforeach()

execute_process(COMMAND dpkg-query -S ${patterns} OUTPUT_VARIABLE owners COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^:]+" packages "${owners}")
list(TRANSFORM packages STRIP)
list(REMOVE_DUPLICATES packages)
foreach(package IN LISTS packages)
    file(REAL_PATH /usr/share/doc/${package}/copyright file)
    file(COPY_FILE ${file} ${licenses}/${package})
endforeach()
execute_process(COMMAND dpkg-query -W ${packages} OUTPUT_FILE ${licenses}/packages.txt COMMAND_ERROR_IS_FATAL ANY)
