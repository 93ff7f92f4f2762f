# Bundles the report's script and style from report/page/src with esbuild. Node and npm are needed for
# building only. If they or npm's registry aren't available, the program is built without the page, and its
# reports are plain pages that give the reason.
set(PLUMBLINE_REPORT_PAGE AUTO CACHE STRING "Bundle the interactive report: ON, OFF, or AUTO (if Node and npm are found)")
set_property(CACHE PLUMBLINE_REPORT_PAGE PROPERTY STRINGS AUTO ON OFF)

set(page_source ${CMAKE_CURRENT_SOURCE_DIR}/report/page)
set(page_build ${CMAKE_CURRENT_BINARY_DIR}/report_page)
set(oldest_node 18) # Debian 12's

# Installs the packages of the lock file in page_build; on failure sets page_problem to the reason.
function(prepare_page_packages)
    find_program(PLUMBLINE_NODE node)
    find_program(PLUMBLINE_NPM npm)
    if(NOT PLUMBLINE_NODE OR NOT PLUMBLINE_NPM)
        set(page_problem "Node.js and npm were missing (apt install nodejs npm)" PARENT_SCOPE)
        return()
    endif()
    execute_process(COMMAND ${PLUMBLINE_NODE} --version OUTPUT_VARIABLE version OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    string(REGEX REPLACE "^v" "" version "${version}")
    if(NOT version OR version VERSION_LESS oldest_node)
        set(page_problem "Node.js ${version} was found, ${oldest_node} or newer is needed" PARENT_SCOPE)
        return()
    endif()
    file(MAKE_DIRECTORY ${page_build})
    # The source folder contains no packages: the bundler reads it through links next to the packages.
    file(CREATE_LINK ${page_source}/src ${page_build}/src SYMBOLIC)
    file(CREATE_LINK ${page_source}/tsconfig.json ${page_build}/tsconfig.json SYMBOLIC)
    file(SHA256 ${page_source}/package-lock.json wanted)
    set(installed "")
    if(EXISTS ${page_build}/installed-lock)
        file(READ ${page_build}/installed-lock installed)
    endif()
    if(installed STREQUAL wanted)
        return()
    endif()
    message(STATUS "Fetching the report page's packages")
    foreach(file package.json package-lock.json)
        configure_file(${page_source}/${file} ${page_build}/${file} COPYONLY)
    endforeach()
    execute_process(COMMAND ${PLUMBLINE_NPM} ci --no-audit --no-fund --ignore-scripts
                    WORKING_DIRECTORY ${page_build} TIMEOUT 300
                    RESULT_VARIABLE failed OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(failed)
        string(REGEX MATCH "npm (error|ERR!)[^\n]*" problem "${output}")
        string(REGEX REPLACE "[\"\\]" "" problem "${problem}")
        set(page_problem "npm could not fetch its packages (${problem})" PARENT_SCOPE)
        return()
    endif()
    file(WRITE ${page_build}/installed-lock ${wanted})
endfunction()

set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${page_source}/package-lock.json)
set(page_problem "it was switched off (PLUMBLINE_REPORT_PAGE)")
if(NOT PLUMBLINE_REPORT_PAGE STREQUAL "OFF")
    set(page_problem "")
    prepare_page_packages()
    if(page_problem AND PLUMBLINE_REPORT_PAGE STREQUAL "ON")
        message(FATAL_ERROR "The report page can't be bundled: ${page_problem}")
    endif()
endif()

if(page_problem)
    set(PLUMBLINE_PAGE_BUILD "" CACHE INTERNAL "Folder where the page is bundled; empty if it isn't")
else()
    set(PLUMBLINE_PAGE_BUILD ${page_build} CACHE INTERNAL "Folder where the page is bundled; empty if it isn't")
endif()

# Defines for report/page_bundle.cpp the files of the page, or the reason why there is none.
function(embed_report_page)
    if(page_problem)
        message(WARNING "Reports will be plain pages: ${page_problem}")
        set(style ${page_source}/src/page.css)
        set(definitions "PLUMBLINE_NO_PAGE_REASON=\"${page_problem}\"")
        set(depends ${style})
    else()
        file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${page_source}/src/*)
        set(script ${page_build}/report.js)
        set(style ${page_build}/report.css)
        add_custom_command(OUTPUT ${script} ${style}
            COMMAND node_modules/.bin/esbuild src/main.ts --bundle --minify --preserve-symlinks --target=es2022 --charset=utf8
                    --log-level=warning --legal-comments=eof --outfile=${script}
            DEPENDS ${sources} ${page_build}/installed-lock
            WORKING_DIRECTORY ${page_build} COMMENT "Bundling the report page" VERBATIM)
        set(definitions "PLUMBLINE_PAGE_SCRIPT=\"${script}\"")
        set(depends ${script} ${style})
    endif()
    set_source_files_properties(report/page_bundle.cpp PROPERTIES OBJECT_DEPENDS "${depends}"
        COMPILE_DEFINITIONS "${definitions};PLUMBLINE_PAGE_STYLE=\"${style}\"")
endfunction()
