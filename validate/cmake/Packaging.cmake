# Installation and packaging. There are two packages: a Debian package, which depends on the libraries it
# needs, and a tarball, which contains them. `./plumbline package`, or `cpack` in the build folder, makes
# both; `-G DEB` or `-G TGZ` only one.
#
# The program finds lib/plumbline and share/plumbline relative to its own location
# (scenes/core/data_folder.h), so the prefix may be moved.
install(TARGETS plumbline RUNTIME DESTINATION bin)
install(TARGETS plumbline_images LIBRARY DESTINATION lib/plumbline)
set_target_properties(plumbline PROPERTIES INSTALL_RPATH "$ORIGIN/../lib/plumbline")
set_target_properties(plumbline_images PROPERTIES INSTALL_RPATH "$ORIGIN")
# RUNPATH, which system libraries don't inherit: see bundle.cmake.
target_link_options(plumbline PRIVATE -Wl,--enable-new-dtags)
target_link_options(plumbline_images PRIVATE -Wl,--enable-new-dtags)

# Data read at run time.
install(DIRECTORY scenes/library DESTINATION share/plumbline/scenes PATTERN pictures EXCLUDE)
install(DIRECTORY realtime/shaders realtime/surfaces realtime/techniques DESTINATION share/plumbline/realtime)
install(DIRECTORY validate/report/page DESTINATION share/plumbline/validate/report
    FILES_MATCHING PATTERN "*.mustache" PATTERN src EXCLUDE)
install(DIRECTORY validate/studies DESTINATION share/plumbline/validate
    FILES_MATCHING PATTERN "*.toml" PATTERN pictures EXCLUDE)

# Documentation, with the images and pages it links to.
set(doc share/doc/plumbline)
install(FILES LICENSE DESTINATION ${doc} RENAME copyright)
install(FILES README.md DESTINATION ${doc})
foreach(folder scenes reference realtime realtime/bake validate validate/report validate/study)
    install(FILES ${folder}/README.md DESTINATION ${doc}/${folder})
endforeach()
install(DIRECTORY scenes/library/pictures DESTINATION ${doc}/scenes/library)
install(DIRECTORY validate/report/pictures DESTINATION ${doc}/validate/report)
install(DIRECTORY validate/studies/ DESTINATION ${doc}/validate/studies FILES_MATCHING
    PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg" PATTERN quadric EXCLUDE)

# The libraries of the tarball are a separate component: cmake --install build/release --component bundle.
set(BUNDLE_INPUTS "set(BUNDLE_PROGRAM [[$<TARGET_FILE:plumbline>]])
set(BUNDLE_LIBRARIES [[$<TARGET_FILE:plumbline_images>]])")
if(PLUMBLINE_GL)
    find_library(OSMESA_LIBRARY NAMES libOSMesa.so.8) # loaded at run time, so it isn't a link dependency
    if(OSMESA_LIBRARY)
        string(APPEND BUNDLE_INPUTS "\nlist(APPEND BUNDLE_LIBRARIES [[${OSMESA_LIBRARY}]])")
    endif()
endif()
install(CODE "${BUNDLE_INPUTS}" COMPONENT bundle EXCLUDE_FROM_ALL)
install(SCRIPT ${CMAKE_CURRENT_LIST_DIR}/bundle.cmake COMPONENT bundle EXCLUDE_FROM_ALL)

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/package_options.cmake) # the differences between the two packages
set(CPACK_PACKAGE_NAME plumbline)
set(CPACK_PACKAGE_VENDOR "Plumbline developers")
set(CPACK_PACKAGE_CONTACT "Plumbline developers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "compares GLSL relief techniques with ray-traced displacement")
set(CPACK_PACKAGE_DESCRIPTION
"Plumbline tessellates a mesh to its limit surface, displaces it and traces it;
draws the same scene with shaders that fake displacement (relief mapping, cone
stepping, quadric silhouettes and others); and measures the differences per
pixel: silhouette, depth, shadow. The reference reports its own error.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded or started at run time, only if needed.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "gnuplot-nox, libosmesa6")
include(CPack)
