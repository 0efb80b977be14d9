# SPDX-License-Identifier: Apache-2.0
# What Debian's policy wants beside the installed files: compressed manual pages and change logs.
set(root "${CPACK_TEMPORARY_DIRECTORY}${CPACK_PACKAGING_INSTALL_PREFIX}")
set(doc ${root}/share/doc/lamina)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${doc}/changelog.Debian "lamina (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium

  * Upstream release; changelog.gz says what is new.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
file(RENAME ${doc}/CHANGELOG.md ${doc}/changelog)
file(GLOB compressed ${root}/share/man/man1/*.1)
execute_process(COMMAND gzip --best --no-name --force ${doc}/changelog ${doc}/changelog.Debian ${compressed} COMMAND_ERROR_IS_FATAL ANY)
