# Ipopt by header and library, never by pkg-config: that would add the
# sequential MUMPS, whose dummy MPI_Init hides the real one. Whoever links
# libspringfit uses this file as well.
find_path(IPOPT_INCLUDE_DIR IpTNLP.hpp PATH_SUFFIXES coin coin-or)
find_library(IPOPT_LIBRARY ipopt)
mark_as_advanced(IPOPT_INCLUDE_DIR IPOPT_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Ipopt
  REQUIRED_VARS IPOPT_LIBRARY IPOPT_INCLUDE_DIR)

if(Ipopt_FOUND AND NOT TARGET springfit::ipopt)
  add_library(springfit::ipopt INTERFACE IMPORTED)
  target_include_directories(springfit::ipopt SYSTEM INTERFACE ${IPOPT_INCLUDE_DIR})
  target_compile_definitions(springfit::ipopt INTERFACE HAVE_CSTDDEF)
  target_link_libraries(springfit::ipopt INTERFACE ${IPOPT_LIBRARY})
endif()
