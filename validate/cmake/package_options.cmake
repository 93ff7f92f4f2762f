# CPack reads this file once for each package.
if(CPACK_GENERATOR STREQUAL "TGZ")
    set(CPACK_PACKAGE_FILE_NAME ${CPACK_PACKAGE_NAME}-${CPACK_PACKAGE_VERSION}-linux-x86_64)
    list(GET CPACK_INSTALL_CMAKE_PROJECTS 0 build) # each entry: build folder, project, component, destination
    list(APPEND CPACK_INSTALL_CMAKE_PROJECTS ${build} plumbline bundle /)
endif()
