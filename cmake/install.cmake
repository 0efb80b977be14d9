# SPDX-License-Identifier: Apache-2.0
# Where everything goes: `cmake --install build/release --prefix DIR`, and a Debian package: `cmake --build build/release --target package`.
# harness/cli/home.cpp looks for the data here: ../share/lamina from the program's folder.
set(doc share/doc/lamina)
install(TARGETS lamina RUNTIME DESTINATION bin)
install(DIRECTORY variants shaders DESTINATION share/lamina PATTERN README.md EXCLUDE)
install(FILES packaging/copyright CHANGELOG.md DESTINATION ${doc})

# The pages lie to each other as in the source tree, so that their links hold.
install(FILES README.md DESTINATION ${doc})
file(GLOB_RECURSE pages CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} docs/* variants/*/README.md shaders/*/README.md)
foreach(page ${pages})
  cmake_path(GET page PARENT_PATH folder)
  install(FILES ${page} DESTINATION ${doc}/${folder})
endforeach()

# Made by the program, of what it parses and of the effects that it finds.
function(install_made what folder)
  install(CODE "execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=LAMINA_HOME $<TARGET_FILE:lamina>
    ${what} --out \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${folder}\" COMMAND_ERROR_IS_FATAL ANY)")
endfunction()
install_made(man share/man/man1)
install_made(schema share/lamina/schemas)
install(FILES packaging/completions/lamina.bash DESTINATION share/bash-completion/completions RENAME lamina)
install(FILES packaging/completions/_lamina DESTINATION share/zsh/vendor-completions)
install(FILES packaging/completions/lamina.fish DESTINATION share/fish/vendor_completions.d)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lamina)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "Lamina maintainers <maintainers@lamina.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "measures what real-time translucency techniques cost and lose")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
  "Lamina renders a full-quality path and cheaper variants of multi-layer
materials, fog, hair, glass and other translucent effects on Vulkan and
OpenGL. It times every pass, counts texture fetches and operations, measures
each variant's error, and writes a record and a report that opens in any
browser.
.
A gate for CI fails where a change makes a frame slower or less accurate.")
set(CPACK_PACKAGE_INSTALL_DIRECTORY lamina)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded at run time, so that no library names them: a Vulkan driver, OpenGL's for the backend egl, and the checker of --validation.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "mesa-vulkan-drivers | vulkan-icd")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, vulkan-validationlayers")
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/package_files.cmake)
include(CPack)
