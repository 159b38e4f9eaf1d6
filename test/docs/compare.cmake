# Fails unless the option reference of the repository is what the declarations of the options give.
file(READ ${COMMITTED} committed)
file(READ ${GENERATED} generated)
if(NOT committed STREQUAL generated)
  message(FATAL_ERROR "docs/options.md is stale; renew it with: ninja -C build renew_options")
endif()
