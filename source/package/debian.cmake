# 'cpack' in the build folder makes two Debian packages: springfit, which needs
# no compiler, and libspringfit-dev.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "The springfit developers")
set(CPACK_PACKAGE_CONTACT "The springfit developers")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME springfit)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
"springfit turns a mesh into springs that come as close as they can to its
finite elements, and measures how close. Scenes to begin with are in
/usr/share/springfit/parameters.")
# The libraries that the program is linked to, with their versions, by
# dpkg-shlibdeps; mpirun and a quick BLAS besides.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "openmpi-bin, libopenblas0-serial")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "gnuplot, paraview, python3-numpy")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libspringfit-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
"The springs and fits of springfit as a static library with headers and a CMake
package: find_package(springfit), springfit::springfit.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libeigen3-dev (>= 3.4), coinor-libipopt-dev")

include(CPack)
