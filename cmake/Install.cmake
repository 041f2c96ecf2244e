# cmake --install, and the Debian package that cpack makes of it: programs in bin/ and lib/aoscore/, what they read in
# share/aoscore/, manual pages and completions made by the program itself.
include(GNUInstallDirs)
set(data ${CMAKE_INSTALL_DATADIR}/aoscore)

install(TARGETS aoscore RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
get_property(libraries GLOBAL PROPERTY AOSCORE_LIBRARIES)
# Not under the multiarch folder: core/processes/program_path.cpp looks in ../lib/aoscore.
install(TARGETS aoscore-import aoscore-shader-trial ${libraries} RUNTIME DESTINATION lib/aoscore LIBRARY DESTINATION lib/aoscore)

install(DIRECTORY contestants shaders scenes DESTINATION ${data} PATTERN "*.glb" EXCLUDE PATTERN "*.gltf" EXCLUDE)
install(DIRECTORY reports DESTINATION ${data} PATTERN out EXCLUDE PATTERN readme.png EXCLUDE)
install(FILES src/bench/skimage_ssim.py DESTINATION ${data}/src/bench)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
# The libraries of the page, each whole, with its licence.
file(READ package.json package)
string(JSON count LENGTH "${package}" dependencies)
math(EXPR last "${count} - 1")
foreach(i RANGE ${last})
    string(JSON name MEMBER "${package}" dependencies ${i})
    install(DIRECTORY node_modules/${name} DESTINATION ${data}/node_modules)
endforeach()

set(manual ${CMAKE_BINARY_DIR}/manual)
add_custom_command(OUTPUT ${manual}/aoscore.1 ${manual}/aoscore.bash ${manual}/_aoscore ${manual}/aoscore.fish
    COMMAND aoscore manual --into ${manual}
    COMMAND aoscore completion bash > ${manual}/aoscore.bash
    COMMAND aoscore completion zsh > ${manual}/_aoscore
    COMMAND aoscore completion fish > ${manual}/aoscore.fish
    DEPENDS aoscore
    COMMENT "Writing manual pages and completions")
add_custom_target(manual ALL DEPENDS ${manual}/aoscore.1)
install(DIRECTORY ${manual}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1")
install(FILES ${manual}/aoscore.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME aoscore)
install(FILES ${manual}/_aoscore DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${manual}/aoscore.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "aoscore")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "How far screen-space ambient occlusion is from ray-traced truth")
set(CPACK_PACKAGE_DESCRIPTION "Renders the ambient occlusion of a scene with rays and with every screen-space method, and says of each\nhow far it is from the truth, where, why, and at what cost.")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Loaded when something is drawn, so that no ELF header names it.
set(CPACK_DEBIAN_PACKAGE_DEPENDS libosmesa6)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libegl1")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
# The programs are built before: packing makes nothing of it anew.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
include(CPack)
