// The precompiled header of the unit tests needs one file to be compiled with (CMakeLists.txt).
