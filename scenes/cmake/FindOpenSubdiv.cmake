# OpenSubdiv::osdCPU. Debian's OpenSubdivConfig.cmake asks for static libraries the package doesn't ship.
include(FindPackageHandleStandardArgs)
find_path(OpenSubdiv_INCLUDE_DIR opensubdiv/bfr/refinerSurfaceFactory.h)
find_library(OpenSubdiv_LIBRARY osdCPU)
find_package_handle_standard_args(OpenSubdiv REQUIRED_VARS OpenSubdiv_LIBRARY OpenSubdiv_INCLUDE_DIR
    REASON_FAILURE_MESSAGE "install libosd-dev (3.5 or later)")
if(OpenSubdiv_FOUND AND NOT TARGET OpenSubdiv::osdCPU)
    add_library(OpenSubdiv::osdCPU UNKNOWN IMPORTED)
    set_target_properties(OpenSubdiv::osdCPU PROPERTIES
        IMPORTED_LOCATION ${OpenSubdiv_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${OpenSubdiv_INCLUDE_DIR})
endif()
