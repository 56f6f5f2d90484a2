# What 'cmake --install' puts where: the program with its scenes and documents,
# and the library with what a compiler needs of it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS springfit COMPONENT program)
install(DIRECTORY parameters
  DESTINATION ${CMAKE_INSTALL_DATADIR}/springfit COMPONENT program)
install(PROGRAMS scripts/picture.py
  DESTINATION ${CMAKE_INSTALL_DATADIR}/springfit COMPONENT program)
# README.md calls the documents doc/...
install(FILES README.md CITATION.cff
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(FILES LICENSE RENAME copyright
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY doc examples
  DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program
  USE_SOURCE_PERMISSIONS PATTERN changelog EXCLUDE)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/springfit)
install(TARGETS springfit_library EXPORT springfitTargets COMPONENT development)
# Those of the rooms springs and fit and what they include: Eigen and no more.
install(DIRECTORY include/springfit/springs include/springfit/fit
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/springfit COMPONENT development
  PATTERN ipopt_application.h EXCLUDE)
# Where its user has AddressSanitizer, Eigen is to allocate as the library does.
target_compile_definitions(springfit_library INTERFACE
  $<INSTALL_INTERFACE:EIGEN_MALLOC_ALREADY_ALIGNED=1>)
target_sources(springfit_library INTERFACE
  $<INSTALL_INTERFACE:$<INSTALL_PREFIX>/${config_folder}/eigen_memory.cc>)
foreach(header cell_kind energy_term error plane_stress words)
  install(FILES include/springfit/core/${header}.h
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/springfit/core
    COMPONENT development)
endforeach()
install(EXPORT springfitTargets NAMESPACE springfit::
  DESTINATION ${config_folder} COMPONENT development)
configure_package_config_file(source/package/springfitConfig.cmake.in
  springfitConfig.cmake INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(springfitConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/springfitConfig.cmake
  ${PROJECT_BINARY_DIR}/springfitConfigVersion.cmake
  source/package/FindIpopt.cmake
  source/package/eigen_memory.cc
  DESTINATION ${config_folder} COMPONENT development)
install(FILES LICENSE RENAME copyright
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libspringfit-dev
  COMPONENT development)
install(FILES examples/CMakeLists.txt examples/bar.cc
  DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libspringfit-dev/examples
  COMPONENT development)
