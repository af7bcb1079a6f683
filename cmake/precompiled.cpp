// What cmake/Precompiled.cmake reads other libraries' headers for.
