# OpenImageIO::OpenImageIO. Debian's own config wants tools and headers the -dev package doesn't bring.
include(FindPackageHandleStandardArgs)
find_path(OpenImageIO_INCLUDE_DIR OpenImageIO/imageio.h)
find_library(OpenImageIO_LIBRARY OpenImageIO)
find_library(OpenImageIO_Util_LIBRARY OpenImageIO_Util)
find_package_handle_standard_args(OpenImageIO
    REQUIRED_VARS OpenImageIO_LIBRARY OpenImageIO_Util_LIBRARY OpenImageIO_INCLUDE_DIR
    REASON_FAILURE_MESSAGE "install libopenimageio-dev")
if(OpenImageIO_FOUND AND NOT TARGET OpenImageIO::OpenImageIO)
    find_package(Imath CONFIG REQUIRED)
    add_library(OpenImageIO::OpenImageIO UNKNOWN IMPORTED)
    set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
        IMPORTED_LOCATION ${OpenImageIO_LIBRARY} INTERFACE_INCLUDE_DIRECTORIES ${OpenImageIO_INCLUDE_DIR}
        INTERFACE_LINK_LIBRARIES "${OpenImageIO_Util_LIBRARY};Imath::Imath;fmt::fmt")
endif()
