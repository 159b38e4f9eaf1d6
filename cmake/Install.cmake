# cmake --install: headers, libraries, the binary, the Lua files and find_package(semantic_kiss).
